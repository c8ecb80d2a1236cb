#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""features.py BUILD [ROUNDS]: what scenes have beyond the lab's, one thing at a time, by zraka and by POV-Ray.

Nine and 900 spheres on a plane, a third of them mirrors, and the same with another light, another material or a texture
on the floor; and pairs of this folder. POV-Ray knows pictures in no smaller sizes: what is far away looks otherwise
there. Medians of ROUNDS, 3 if it is not said; beside.py says what is measured.
"""
import pathlib
import random

import beside

HERE = pathlib.Path(__file__).resolve().parent
SPOT = """[[light]]
kind = "spot"
position = [6, 9, 7]
target = [0, 0, 0]
inner_deg = 15
outer_deg = 30
color = [0.8, 0.8, 0.8]
"""
SUN = """[[light]]
kind = "directional"
direction = [-0.6, -0.9, -0.7]
color = [0.8, 0.8, 0.8]
"""
SOFT = """[[light]]
kind = "rectangle"
corner = [5, 9, 6]
edge_u = [2, 0, 0]
edge_v = [0, 0, 2]
samples = 16
color = [0.8, 0.8, 0.8]
"""
SHADOWS = '[render]\nshadows = "transparent"\n'
GLASS = """[material.glass]
ambient = 0
diffuse = 0
specular = 0.5
shininess = 100
ior = 1.5
"""
CLEAR = GLASS + "refraction = 0.999\n"
FRESNEL = GLASS + 'refraction = 1\nfresnel = "exact"\n'
SYRUP = FRESNEL + "absorption = [0.3, 0.1, 0.2]\n"
PRISM = CLEAR + "dispersion = {abbe = 25}\n"
TILES = '[texture.tiles]\nkind = "checker"\ncolors = [[0.9, 0.9, 0.9], [0.1, 0.1, 0.1]]\nsize = 2\n' \
        "transform = [{translate = [0, 1, 0]}]\n"
PICTURE = '[texture.tiles]\nkind = "image"\nfile = "picture.ppm"\nmapping = "solid"\n' \
          "transform = [{scale = 4}, {rotate = [1, 0, 0], by_deg = -90}]\n"


def spheres(side, materials):
    random.seed(side)
    text, size = "", 4 / side
    for i in range(side * side):
        x, z = (8 * (k + 0.5) / side - 4 for k in divmod(i, side))
        text += (f'[[shape]]\nkind = "sphere"\nmaterial = "{random.choice(materials)}"\n'
                 f"center = [{x}, {size}, {z}]\nradius = {size * 0.8}\n")
    return text


def scene(side, light=beside.LIGHT, head="", glass="", texture="", floor=beside.MATERIALS):
    materials = ("red", "glass", "mirror") if glass else ("red", "red", "mirror")
    return (beside.HEAD.replace("[scene]", head + "[scene]") + light + texture + floor + glass + beside.FLOOR +
            spheres(side, materials))


def painted(name):
    return beside.MATERIALS.replace("ambient = 0.2\ndiffuse = 0.6", f'color = "{name}"', 1)


FEATURES = {
    "a point's light, mirrors": {},
    "a spot's light": {"light": SPOT},
    "directional light": {"light": SUN},
    "soft shadows, 16 samples": {"light": SOFT},
    "glass, transparent shadows": {"head": SHADOWS, "glass": CLEAR},
    "glass, Fresnel": {"head": SHADOWS, "glass": FRESNEL},
    "glass that absorbs": {"head": SHADOWS, "glass": SYRUP},
    "glass, 12 wavelengths": {"head": SHADOWS, "glass": PRISM},
    "a checker": {"texture": TILES, "floor": painted("tiles")},
    "a picture": {"texture": PICTURE + 'filter = "bilinear"\n', "floor": painted("tiles")},
    "a picture in smaller sizes": {"texture": PICTURE, "floor": painted("tiles")},
}


def main():
    build, rounds = beside.arguments(__doc__)
    folder = build / "features"
    folder.mkdir(exist_ok=True)
    beside.write_picture(folder / "picture.ppm")
    scenes, smooth = {}, []
    for number, (name, parts) in enumerate(FEATURES.items()):
        for side in (3, 30):
            path = folder / f"{number}-{side * side}.toml"
            path.write_text(scene(side, **parts))
            scenes[f"{side * side} spheres, {name}"] = path
            if not parts:
                smooth.append(f"{side * side} spheres, 16 rays a pixel")
                scenes[smooth[-1]] = path
    for name in ("glass", "instances", "refraction"):
        scenes[f"pairs/{name}.toml"] = HERE / "pairs" / f"{name}.toml"
    beside.table(build, folder, scenes, rounds, smooth)


if __name__ == "__main__":
    main()
