#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""tachyon_scenes.py ZRAKA FOLDER [ROUNDS [SIDE]]: Tachyon's own scenes, drawn by Tachyon and by zraka in turns.

FOLDER holds .dat scenes (Debian's package tachyon-doc has some). Each is drawn SIDE pixels wide and high (512), one ray
a pixel, by as many threads as there are. Prints for each scene the shapes, the medians of what both programs say that
rendering took, those of whole processes, and the share of pixels all of whose channels differ by at most 8 of 255. What
one of the two does not draw is left out, with the reason.
"""
import math
import pathlib
import re
import statistics
import subprocess
import sys
import tempfile
import time


def pixels(path):
    data = path.read_bytes()
    header = re.match(rb"P6\s+(?:#.*\n)?(\d+)\s+(\d+)\s+(\d+)\s", data)
    return data[header.end():]


def run(command):
    begin = time.perf_counter()
    done = subprocess.run([str(word) for word in command], capture_output=True, text=True, timeout=600)
    return time.perf_counter() - begin, done.stdout + done.stderr


def alike(a, b):
    if len(a) != len(b):
        return 0.0
    near = sum(abs(a[i] - b[i]) <= 8 and abs(a[i + 1] - b[i + 1]) <= 8 and abs(a[i + 2] - b[i + 2]) <= 8
               for i in range(0, len(a), 3))
    return 300 * near / len(a)


class Absent(Exception):
    pass


def measure(zraka, scene, folder, rounds, side):
    theirs, ours = folder / "tachyon.ppm", folder / "zraka.ppm"
    tachyon = ["tachyon", scene, "-aasamples", 0, "-res", side, side, "-format", "PPM", "-o", theirs]
    own = [zraka, "render", scene, "--profile", "tachyon", "--samples", 1, "--width", side, "--height", side, "--stats",
           "-o", ours]
    times = {"tachyon": [], "zraka": [], "whole tachyon": [], "whole zraka": []}
    shapes = 0
    for _ in range(rounds):
        for picture in theirs, ours:
            picture.unlink(missing_ok=True)
        whole, words = run(tachyon)
        found = re.search(r"Ray Tracing Time:\s*([\d.]+) seconds", words)
        objects = re.search(r"contains (\d+)\s+(?:bounded\s+)?object", words)
        if not found or not theirs.is_file():
            raise Absent("Tachyon draws nothing")
        shapes = int(objects[1]) if objects else 0
        times["tachyon"].append(float(found[1]))
        times["whole tachyon"].append(whole)
        whole, words = run(own)
        found = re.search(r"render ([\d.]+) (ms|s)\b", words)
        if not found or not ours.is_file():
            raise Absent(words.strip().splitlines()[0] if words.strip() else "zraka draws nothing")
        times["zraka"].append(float(found[1]) * (0.001 if found[2] == "ms" else 1))
        times["whole zraka"].append(whole)
    return shapes, {name: 1000 * statistics.median(each) for name, each in times.items()}, \
        alike(pixels(theirs), pixels(ours))


def main():
    if not 3 <= len(sys.argv) <= 5:
        sys.exit(__doc__)
    zraka, scenes = sys.argv[1], sorted(pathlib.Path(sys.argv[2]).glob("*.dat"))
    rounds = int(sys.argv[3]) if len(sys.argv) > 3 else 5
    side = int(sys.argv[4]) if len(sys.argv) > 4 else 512
    print("| scene | shapes | Tachyon, ms | zraka, ms | × | whole processes, × | pixels |\n|---|--:|--:|--:|--:|--:|--:|")
    ratios = []
    with tempfile.TemporaryDirectory() as folder:
        for scene in scenes:
            try:
                shapes, ms, same = measure(zraka, scene, pathlib.Path(folder), rounds, side)
            except Absent as reason:
                print(f"{scene.stem}: {reason}", file=sys.stderr, flush=True)
                continue
            ratio = ms["tachyon"] / ms["zraka"]
            print(f"| {scene.stem} | {shapes} | {ms['tachyon']:.1f} | {ms['zraka']:.1f} | {ratio:.1f} | "
                  f"{ms['whole tachyon'] / ms['whole zraka']:.1f} | {same:.1f} % |", flush=True)
            if same >= 95:
                ratios.append((shapes, ratio))
    for least in 0, 1000:
        some = [ratio for shapes, ratio in ratios if shapes > least]
        if some:
            mean = math.exp(sum(map(math.log, some)) / len(some))
            print(f"\nOf more than {least} shapes, 95 % of the pixels alike: {len(some)} scenes, geometric mean {mean:.1f}, "
                  f"least {min(some):.1f}")


if __name__ == "__main__":
    main()
