#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""convergence.py ZRAKA [SVG]: how fast smooth edges come: the error of pixels that a disc and a triangle cut, against
the number of samples, for Sobol's points, grids, and chance. Prints a table; with SVG draws it as well.

The right picture has 64 by 64 samples a pixel. Chance is pairs of points, each pair under a seed of its own, that know
nothing of the other pairs.
"""
import array
import math
import pathlib
import subprocess
import sys
import tempfile

SCENE = """
[image]
width = 64
height = 64
[camera]
kind = "orthographic"
eye = [0, 0, 5]
look_at = [0, 0, 0]
height = 2
[scene]
ambient = 1
background = [0, 0, 0]
[material.white]
ambient = 1
diffuse = 0
[[shape]]
kind = "sphere"
material = "white"
center = [-0.283, 0.311, 0]
radius = 0.6173
[[shape]]
kind = "triangle"
material = "white"
a = [-0.871, -0.923, 0]
b = [0.917, -0.713, 0]
c = [0.733, 0.819, 0]
"""
COUNTS = [4, 16, 36, 64, 144, 256]


class Renderer:
    def __init__(self, program, folder):
        self.program, self.scene, self.out = program, folder / "scene.toml", folder / "out.pfm"
        self.scene.write_text(SCENE)

    def picture(self, *options):
        done = subprocess.run([self.program, "render", self.scene, "-o", self.out, "-q", *map(str, options)],
                              capture_output=True, text=True)
        if done.returncode != 0:
            sys.exit(done.stderr)
        values = array.array("f")
        values.frombytes(self.out.read_bytes().split(b"\n", 3)[3])
        return values[::3]


def error(picture, right):
    edge = [i for i, v in enumerate(right) if 0.001 < v < 0.999]
    return math.sqrt(sum((picture[i] - right[i]) ** 2 for i in edge) / len(edge))


def measured(render):
    right = render.picture("--grid", 64)
    rows = {"chance": [], "grid": [], "Sobol": []}
    for n in COUNTS:
        pairs = [render.picture("--samples", 2, "--seed", 1000 + i) for i in range(n // 2)]
        rows["chance"].append(error([sum(of) / len(pairs) for of in zip(*pairs)], right))
        side = math.isqrt(n)
        rows["grid"].append(error(render.picture("--grid", side), right))
        some = [error(render.picture("--samples", n, "--seed", seed), right) for seed in (1, 2, 3)]
        rows["Sobol"].append(sum(some) / len(some))
    return rows


def order(errors):
    """The slope of the line through the logarithms."""
    x, y = [math.log(n) for n in COUNTS], [math.log(e) for e in errors]
    mx, my = sum(x) / len(x), sum(y) / len(y)
    return sum((a - mx) * (b - my) for a, b in zip(x, y)) / sum((a - mx) ** 2 for a in x)


def draw(rows, path):
    width, height, left, bottom, top = 600, 360, 60, 310, 20
    low, high = math.log10(min(min(r) for r in rows.values())), math.log10(max(max(r) for r in rows.values()))
    low, high = math.floor(low * 2) / 2, math.ceil(high * 2) / 2
    x = lambda n: left + (math.log(n) - math.log(COUNTS[0])) / (math.log(COUNTS[-1]) - math.log(COUNTS[0])) * 400
    y = lambda e: top + (high - math.log10(e)) / (high - low) * (bottom - top)
    parts = [f'<svg xmlns="http://www.w3.org/2000/svg" viewBox="0 0 {width} {height}" font-family="sans-serif" '
             f'font-size="12"><rect width="{width}" height="{height}" fill="white"/>']
    for n in COUNTS:
        parts.append(f'<path d="M{x(n):.1f} {top}V{bottom}" stroke="#ddd"/>'
                     f'<text x="{x(n):.1f}" y="{bottom + 16}" text-anchor="middle">{n}</text>')
    for half in range(round(low * 2), round(high * 2) + 1):
        at = 10 ** (half / 2)
        parts.append(f'<path d="M{left} {y(at):.1f}H{left + 400}" stroke="#ddd"/>')
        parts.append(f'<text x="{left - 6}" y="{y(at) + 4:.1f}" text-anchor="end">{at:.2g}</text>')
    for (name, errors), color in zip(rows.items(), ("#b03030", "#3060b0", "#208040")):
        points = " ".join(f"{x(n):.1f},{y(e):.1f}" for n, e in zip(COUNTS, errors))
        parts.append(f'<polyline points="{points}" fill="none" stroke="{color}" stroke-width="2"/>')
        parts.append(f'<text x="{left + 408}" y="{y(errors[-1]) + 4:.1f}" fill="{color}">{name} '
                     f'n^{order(errors):.2f}</text>')
    parts.append(f'<text x="{left + 200}" y="{height - 12}" text-anchor="middle">samples a pixel</text>')
    parts.append(f'<text transform="translate(16 {(top + bottom) / 2}) rotate(-90)" text-anchor="middle">'
                 'error of pixels on edges</text></svg>\n')
    path.write_text("\n".join(parts))


def main():
    if len(sys.argv) < 2:
        sys.exit(__doc__)
    with tempfile.TemporaryDirectory() as folder:
        rows = measured(Renderer(pathlib.Path(sys.argv[1]).resolve(), pathlib.Path(folder)))
    print("samples   " + "".join(f"{n:>9}" for n in COUNTS) + "   order")
    for name, errors in rows.items():
        print(f"{name:<10}" + "".join(f"{e:9.5f}" for e in errors) + f"{order(errors):8.2f}")
    if len(sys.argv) > 2:
        draw(rows, pathlib.Path(sys.argv[2]))


main()
