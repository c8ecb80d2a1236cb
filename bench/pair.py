#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""pair.py BUILD [SCENE...]: the same scenes by zraka and by POV-Ray, pixel by pixel.

Each scene is translated by write_povray and drawn by both without antialiasing, through the centres of pixels. A pixel
counts as equal if every channel lies within 4/255 of what POV-Ray has there or beside it, for edges may fall on
either side. Says the share of equal pixels, the mean difference and the times, best of three taken in turns.
"""
import pathlib
import re
import struct
import subprocess
import sys
import time
import zlib

HERE = pathlib.Path(__file__).resolve().parent


def read_png(path):
    """Rows of bytes, three a pixel, of a PNG of 8 bits without interlace."""
    data = path.read_bytes()
    at, packed, width, height, kind = 8, b"", 0, 0, 0
    while at < len(data):
        size, name = struct.unpack(">I4s", data[at:at + 8])
        body = data[at + 8:at + 8 + size]
        if name == b"IHDR":
            width, height, bits, kind = struct.unpack(">IIBB", body[:10])
            assert bits == 8 and kind in (2, 6), f"{path}: {bits} bits of kind {kind}"
        elif name == b"IDAT":
            packed += body
        at += 12 + size
    step = 3 if kind == 2 else 4
    raw, rows, before = zlib.decompress(packed), [], bytearray(width * step)
    for y in range(height):
        start = y * (width * step + 1)
        how, line = raw[start], bytearray(raw[start + 1:start + 1 + width * step])
        for i in range(len(line)):
            left = line[i - step] if i >= step else 0
            up, corner = before[i], before[i - step] if i >= step else 0
            if how == 1:
                line[i] = (line[i] + left) & 255
            elif how == 2:
                line[i] = (line[i] + up) & 255
            elif how == 3:
                line[i] = (line[i] + (left + up) // 2) & 255
            elif how == 4:
                guess = left + up - corner
                a, b, c = abs(guess - left), abs(guess - up), abs(guess - corner)
                line[i] = (line[i] + (left if a <= b and a <= c else up if b <= c else corner)) & 255
        rows.append(line if step == 3 else bytearray(b for i, b in enumerate(line) if i % 4 != 3))
        before = line
    return width, height, rows


def differences(ours, theirs, tolerance=4):
    """The share of equal pixels, and the mean difference of all channels."""
    width, height, a = ours
    assert (width, height) == theirs[:2], "the pictures have different sizes"
    b, unequal, total = theirs[2], 0, 0
    for y in range(height):
        near = [b[i] for i in range(max(0, y - 1), min(height, y + 2))]
        for x in range(width):
            total += sum(abs(a[y][3 * x + c] - b[y][3 * x + c]) for c in range(3))
            if all(abs(a[y][3 * x + c] - b[y][3 * x + c]) <= tolerance for c in range(3)):
                continue
            mine = a[y][3 * x:3 * x + 3]
            unequal += not any(all(abs(mine[c] - row[3 * i + c]) <= tolerance for c in range(3))
                               for row in near for i in range(max(0, x - 1), min(width, x + 2)))
    return 1 - unequal / (width * height), total / (3 * width * height)


def seconds(command, folder):
    start = time.monotonic()
    done = subprocess.run(command, cwd=folder, capture_output=True, text=True)
    if done.returncode != 0:
        sys.exit(f"{command[0]} failed:\n{done.stdout}{done.stderr}")
    return time.monotonic() - start, done.stdout + done.stderr


def pair(build, scene, folder):
    stem = scene.stem
    seconds([build / "bench" / "write_povray", scene, folder / f"{stem}.pov"], folder)
    ours, theirs = folder / f"{stem}-zraka.png", folder / f"{stem}-povray.png"
    width, height = re.search(r"width = (\d+)\s+height = (\d+)", scene.read_text()).groups()
    best = [1e9, 1e9, 1e9]
    for _ in range(3):
        best[0] = min(best[0], seconds([build / "zraka", "render", scene, "-o", ours, "--profile", "physical",
                                        "--max-depth", "4"], folder)[0])
        took, words = seconds(["povray", f"+I{stem}.pov", f"+O{theirs.name}", f"+W{width}", f"+H{height}", "-D", "-V",
                               "-A", "+FN8", "File_Gamma=srgb"], folder)
        best[1] = min(best[1], took)
        found = re.search(r"Trace Time:.*\(([\d.]+) seconds\)", words)
        best[2] = min(best[2], float(found[1]) if found else took)
    equal, mean = differences(read_png(ours), read_png(theirs))
    print(f"{stem:<14} {100 * equal:8.3f} % equal  mean {mean:6.3f}/255  zraka {best[0]:6.3f} s  "
          f"POV-Ray {best[1]:6.3f} s (trace {best[2]:6.3f} s)", flush=True)
    return equal >= 0.998 and mean < 2


def main():
    if len(sys.argv) < 2:
        sys.exit(__doc__)
    build = pathlib.Path(sys.argv[1]).resolve()
    scenes = [pathlib.Path(s).resolve() for s in sys.argv[2:]] or sorted((HERE / "pairs").glob("*.toml"))
    folder = build / "pairs"
    folder.mkdir(exist_ok=True)
    good = [pair(build, scene, folder) for scene in scenes]
    sys.exit(0 if all(good) else 1)


if __name__ == "__main__":
    main()
