# SPDX-License-Identifier: Apache-2.0
"""What bodies.py and features.py share: scenes drawn by zraka and by POV-Ray in turns, and a line of a table for each.

Both draw each scene on all threads, without antialiasing unless the scene is said to have it, which is 16 rays a pixel
then, whatever they find; times are the processor's, of a picture of 1280×960 above
those of one of 8×6, so that loading and building are not among them. The pictures that are compared are those of
640×480 (pair.py has the rules).
"""
import math
import pathlib
import random
import resource
import statistics
import subprocess
import sys

import pair

HEAD = """[image]
width = 640
height = 480
[camera]
eye = [3, 7, 12]
look_at = [0, 0.3, 0]
fov_deg = 40
[scene]
ambient = 0.5
background = [0.2, 0.3, 0.5]
"""
LIGHT = """[[light]]
position = [6, 9, 7]
color = [0.8, 0.8, 0.8]
"""
MATERIALS = """[material.floor]
ambient = 0.2
diffuse = 0.6
[material.red]
ambient = [0.2, 0.05, 0.05]
diffuse = [0.7, 0.2, 0.15]
specular = 0.4
shininess = 40
[material.mirror]
ambient = 0.05
diffuse = 0.2
reflection = 0.6
"""
FLOOR = """[[shape]]
kind = "plane"
material = "floor"
point = [0, 0, 0]
normal = [0, 1, 0]
"""


def write_picture(path, side=512):
    """Soft waves with a fine grain: what is far away has something to alias."""
    random.seed(1)
    pixels = bytearray()
    for y in range(side):
        for x in range(side):
            wave = 128 + 60 * math.sin(2 * math.pi * x / 64) * math.cos(2 * math.pi * y / 128)
            pixels += bytes(min(255, int(wave + random.random() * 60 + tone)) for tone in (0, 15, 30))
    path.write_bytes(b"P6\n%d %d\n255\n" % (side, side) + pixels)


def processor_seconds(command, folder):
    before = resource.getrusage(resource.RUSAGE_CHILDREN)
    done = subprocess.run(command, cwd=folder, capture_output=True, text=True)
    if done.returncode != 0:
        sys.exit(f"{command[0]} failed:\n{done.stdout}{done.stderr}")
    after = resource.getrusage(resource.RUSAGE_CHILDREN)
    return after.ru_utime + after.ru_stime - before.ru_utime - before.ru_stime


# Sixteen rays a pixel, in a grid as POV-Ray's without jitter.
ZRAKAS_SMOOTH = ["--grid", "4"]
POVRAYS_SMOOTH = ["+AM1", "+A0.0", "+R4", "-J"]


def measure(build, folder, scene, rounds, is_smooth=False):
    """POV-Ray's, zraka's and zraka's time by AVX2, and the share of equal pixels."""
    stem = folder / scene.stem
    pair.seconds([build / "bench" / "write_povray", scene, f"{stem}.pov"], folder)

    def zraka(size, *more, output=f"{stem}-zraka.ppm"):
        return [build / "zraka", "render", scene, "-o", output, "--profile", "physical", "--max-depth", "4",
                "--width", str(size[0]), "--height", str(size[1]), *(ZRAKAS_SMOOTH if is_smooth else ()), *more]

    def povray(size):
        return ["povray", f"+I{stem}.pov", f"+O{stem}-povray.png", f"+W{size[0]}", f"+H{size[1]}", "-D", "-V",
                "+FN8", "File_Gamma=srgb", *(POVRAYS_SMOOTH if is_smooth else ("-A",))]

    ways = [povray, zraka, lambda size: zraka(size, "--isa", "avx2")]
    times = [[], [], []]
    for _ in range(rounds):
        for way, found in zip(ways, times):
            found.append(processor_seconds(way((1280, 960)), folder) - processor_seconds(way((8, 6)), folder))
    processor_seconds(povray((640, 480)), folder)
    processor_seconds(zraka((640, 480), output=f"{stem}-zraka.png"), folder)
    equal, _ = pair.differences(pair.read_png(pathlib.Path(f"{stem}-zraka.png")),
                                pair.read_png(pathlib.Path(f"{stem}-povray.png")))
    return *(statistics.median(t) for t in times), equal


def table(build, folder, scenes, rounds, smooth=()):
    """Prints a line for each of {name: scene}, and the means; scenes whose name is in `smooth` have 16 rays a pixel."""
    folder.mkdir(exist_ok=True)
    ratios = []
    print("| scene | POV-Ray, ms | zraka, ms | × | AVX2, ms | × | equal |\n|---|--:|--:|--:|--:|--:|--:|")
    for name, scene in scenes.items():
        theirs, ours, avx2, equal = measure(build, folder, scene, rounds, name in smooth)
        ratios.append((theirs / ours, theirs / avx2))
        print(f"| {name} | {1000 * theirs:.0f} | {1000 * ours:.0f} | {theirs / ours:.1f} | {1000 * avx2:.0f} | "
              f"{theirs / avx2:.1f} | {100 * equal:.2f} % |", flush=True)
    means = [math.exp(statistics.mean(math.log(r[k]) for r in ratios)) for k in (0, 1)]
    print(f"| **geometric mean** | | | **{means[0]:.1f}** | | **{means[1]:.1f}** | |")


def arguments(words):
    """The build's folder and the rounds."""
    if len(sys.argv) < 2:
        sys.exit(words)
    return pathlib.Path(sys.argv[1]).resolve(), int(sys.argv[2]) if len(sys.argv) > 2 else 3
