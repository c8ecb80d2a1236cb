#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""bodies.py BUILD [ROUNDS]: ellipsoids, boxes, tori and CSG by zraka and by POV-Ray.

Grids of 9 and of 900 of each, turned every which way, a third of them mirrors, on a plane; and the pairs of bodies and
CSG. Both draw each scene without antialiasing on all threads, in turns; times are the processor's, of a picture of
1280×960 above those of one of 8×6, so that loading and building are not among them. Medians of ROUNDS, 3 if it is not
said. The pictures that are compared are those of 640×480 (bench/pair.py has the rules).
"""
import math
import pathlib
import random
import resource
import statistics
import subprocess
import sys

import pair

HERE = pathlib.Path(__file__).resolve().parent
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
[[light]]
position = [6, 9, 7]
color = [0.8, 0.8, 0.8]
[material.floor]
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
[[shape]]
kind = "plane"
material = "floor"
point = [0, 0, 0]
normal = [0, 1, 0]
"""
BODIES = {
    "ellipsoids": lambda s: f'kind = "ellipsoid"\ncenter = [0, 0, 0]\nradii = [{s}, {s * 0.6}, {s * 0.4}]\n',
    "boxes": lambda s: f'kind = "box"\nmin = [{-s * 0.7}, {-s * 0.5}, {-s * 0.4}]\n'
                       f'max = [{s * 0.7}, {s * 0.5}, {s * 0.4}]\n',
    "tori": lambda s: f'kind = "torus"\ncenter = [0, 0, 0]\nnormal = [0.3, 1, 0.4]\nradius = {s * 0.7}\n'
                      f'tube_radius = {s * 0.3}\n',
    "CSG": lambda s: 'kind = "difference"\nof = [\n'
                     f'  {{kind = "box", min = [{-s * 0.7}, {-s * 0.7}, {-s * 0.7}], '
                     f'max = [{s * 0.7}, {s * 0.7}, {s * 0.7}]}},\n'
                     f'  {{kind = "sphere", center = [0, 0, {s * 0.7}], radius = {s * 0.5}}},\n'
                     f'  {{kind = "cylinder", base = [0, {-s}, 0], top = [0, {s}, 0], radius = {s * 0.3}}},\n]\n',
}


def grid(body, side):
    random.seed(side)
    text, size = HEAD, 4 / side
    for i in range(side * side):
        x, z = (8 * (k + 0.5) / side - 4 for k in divmod(i, side))
        text += (f'[[shape]]\nmaterial = "{random.choice(["red", "red", "mirror"])}"\n'
                 f"transform = [{{rotate = [0.3, 1, 0.2], by_deg = {random.randrange(360)}}}, "
                 f"{{translate = [{x}, {size}, {z}]}}]\n{body(size)}")
    return text


def processor_seconds(command, folder):
    before = resource.getrusage(resource.RUSAGE_CHILDREN)
    done = subprocess.run(command, cwd=folder, capture_output=True, text=True)
    if done.returncode != 0:
        sys.exit(f"{command[0]} failed:\n{done.stdout}{done.stderr}")
    after = resource.getrusage(resource.RUSAGE_CHILDREN)
    return after.ru_utime + after.ru_stime - before.ru_utime - before.ru_stime


def main():
    if len(sys.argv) < 2:
        sys.exit(__doc__)
    build = pathlib.Path(sys.argv[1]).resolve()
    rounds = int(sys.argv[2]) if len(sys.argv) > 2 else 3
    folder = build / "bodies"
    folder.mkdir(exist_ok=True)
    scenes = {}
    for name, body in BODIES.items():
        for side in (3, 30):
            scene = folder / f"{name}-{side * side}.toml"
            scene.write_text(grid(body, side))
            scenes[f"{side * side} {name}"] = scene
    for name in ("bodies", "csg"):
        scenes[f"pairs/{name}.toml"] = HERE / "pairs" / f"{name}.toml"

    ratios = []
    print("| scene | POV-Ray, ms | zraka, ms | × | AVX2, ms | × | equal |\n|---|--:|--:|--:|--:|--:|--:|")
    for name, scene in scenes.items():
        stem = folder / scene.stem
        pair.seconds([build / "bench" / "write_povray", scene, f"{stem}.pov"], folder)

        def zraka(size, *more, output=f"{stem}-zraka.ppm"):
            return [build / "zraka", "render", scene, "-o", output, "--profile", "physical", "--max-depth", "4",
                    "--width", str(size[0]), "--height", str(size[1]), *more]

        def povray(size):
            return ["povray", f"+I{stem}.pov", f"+O{stem}-povray.png", f"+W{size[0]}", f"+H{size[1]}", "-D", "-V", "-A",
                    "+FN8", "File_Gamma=srgb"]

        ways = [povray, zraka, lambda size: zraka(size, "--isa", "avx2")]
        times = [[], [], []]
        for _ in range(rounds):
            for way, found in zip(ways, times):
                found.append(processor_seconds(way((1280, 960)), folder) - processor_seconds(way((8, 6)), folder))
        theirs, ours, avx2 = (statistics.median(t) for t in times)
        processor_seconds(povray((640, 480)), folder)
        processor_seconds(zraka((640, 480), output=f"{stem}-zraka.png"), folder)
        equal, _ = pair.differences(pair.read_png(pathlib.Path(f"{stem}-zraka.png")),
                                    pair.read_png(pathlib.Path(f"{stem}-povray.png")))
        ratios.append((theirs / ours, theirs / avx2))
        print(f"| {name} | {1000 * theirs:.0f} | {1000 * ours:.0f} | {theirs / ours:.1f} | {1000 * avx2:.0f} | "
              f"{theirs / avx2:.1f} | {100 * equal:.2f} % |", flush=True)
    means = [math.exp(statistics.mean(math.log(r[k]) for r in ratios)) for k in (0, 1)]
    print(f"| **geometric mean** | | | **{means[0]:.1f}** | | **{means[1]:.1f}** | |")


if __name__ == "__main__":
    main()
