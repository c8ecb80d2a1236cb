#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""bodies.py BUILD [ROUNDS]: ellipsoids, boxes, tori and CSG by zraka and by POV-Ray.

Grids of 9 and of 900 of each, turned every which way, a third of them mirrors, on a plane; and the pairs of bodies and
CSG. Medians of ROUNDS, 3 if it is not said; beside.py says what is measured.
"""
import pathlib
import random

import beside

HERE = pathlib.Path(__file__).resolve().parent
HEAD = beside.HEAD + beside.LIGHT + beside.MATERIALS + beside.FLOOR
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


def main():
    build, rounds = beside.arguments(__doc__)
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
    beside.table(build, folder, scenes, rounds)


if __name__ == "__main__":
    main()
