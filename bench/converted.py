#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""converted.py BUILD [SUBJECT...]: scenes that `zraka convert` has written, drawn by Tachyon and by POV-Ray.

Each subject is a small scene. Prints the table of docs/convert.md: the share of pixels all of whose channels lie within
8/255 of zraka's picture, which is made by the same rules (one ray through the middle of a pixel). What the conversion
says is lost stands behind it.
"""
import json
import os
import pathlib
import subprocess
import sys

import beside

SIZE = (320, 240)
COMMON = """
[image]
width = 320
height = 240
[scene]
ambient = 0.5
background = [0.2, 0.3, 0.5]
[material.floor]
color = [0.6, 0.5, 0.4]
[material.red]
color = [0.7, 0.2, 0.15]
specular = 0.4
shininess = 40
[material.green]
color = [0.2, 0.6, 0.25]
[material.mirror]
color = 0.2
reflection = 0.6
[material.glass]
color = 0.05
refraction = 0.8
ior = 1.5
[material.clear]
color = [0.3, 0.1, 0.1]
refraction = 0.6
[[shape]]
kind = "plane"
material = "floor"
point = [0, 0, 0]
normal = [0, 1, 0]
"""
CAMERA = """
[camera]
eye = [3, 4, 9]
look_at = [0, 1, 0]
fov_deg = 40
"""
LIGHT = """
[[light]]
position = [6, 9, 7]
color = 0.9
"""
MATT = LIGHT + CAMERA


def shape(kind, material, **values):
    lines = [f'[[shape]]\nkind = "{kind}"\nmaterial = "{material}"']
    return "\n".join(lines + [f"{key} = {value}" for key, value in values.items()]) + "\n"


def ball(material, x, y=1, z=0, radius=1):
    return shape("sphere", material, center=[x, y, z], radius=radius)


def painted(texture):
    return (MATT + f'[texture.paint]\n{texture}\n[material.painted]\ncolor = "paint"\n'
            + shape("sphere", "painted", center=[0, 1, 0.01], radius=1))


BALLS = ball("red", -2) + ball("green", 0.3, 0.7, 1, 0.7) + ball("red", 2.2)
GRADIENT = "{kind = 'gradient', bottom = [0.8, 0.8, 0.9], top = [0.2, 0.3, 0.8]}"
SOLIDS = "{kind = 'box', min = [-1, 0, -1], max = [1, 1.8, 1]}, {kind = 'sphere', center = [0, 1.8, 0.6], radius = 0.9}"
SUBJECTS = {
    "spheres": MATT + BALLS,
    "cylinders": MATT + shape("cylinder", "green", base=[-2, 0, 0], top=[-1.5, 2, 0], radius=0.6)
    + shape("cylinder", "red", base=[1, 0.6, 1], top=[2.5, 0.8, -1], radius=0.5),
    "cones": MATT + shape("cone", "green", base=[-1.5, 0, 0], base_radius=1, top=[-1.5, 2.2, 0])
    + shape("cone", "red", base=[1.5, 0, 0], base_radius=1, top=[1.5, 1.5, 0], top_radius=0.4),
    "triangles": MATT + shape("triangle", "green", a=[-2, 0, 0], b=[0, 0.2, 1], c=[-1, 2, 0])
    + shape("triangle", "red", a=[0.5, 0, 0], b=[2.5, 0, -1], c=[1, 2, 0.5]),
    "smooth triangles": MATT + shape("triangle", "red", a=[-2, 0, 0], b=[2, 0.2, 1], c=[0, 2.6, 0],
                                     normals=[[-1, 0, 1], [1, 0, 1], [0, 1, 1]]),
    "polygons": MATT + shape("polygon", "green", points=[[-2, 0, 0], [2, 0, 0], [2, 2, 0], [0, 0.7, 0], [-2, 2, 0]]),
    "boxes": MATT + shape("box", "green", min=[-2, 0, -1], max=[-0.5, 1.5, 0.5])
    + shape("box", "red", min=[0, 0, 0], max=[1, 1, 1],
            transform='[{rotate = [0, 1, 0], by_deg = 30}, {translate = [1, 0.2, 0]}]'),
    "tori": MATT + shape("torus", "red", center=[0, 1, 0], normal=[0.3, 1, 0.5], radius=1.2, tube_radius=0.4),
    "ellipsoids, superellipsoids": MATT + shape("ellipsoid", "green", center=[-1.5, 0.8, 0], radii=[1, 0.8, 0.6])
    + shape("superellipsoid", "red", center=[1.5, 0.9, 0], radii=[1, 0.9, 0.8], exponents=[0.4, 0.5]),
    "capsules, discs, rings": MATT + shape("capsule", "red", base=[-2, 0.5, 0], top=[-1, 1.5, 0], radius=0.4)
    + shape("disc", "green", center=[1.2, 1, 0], normal=[0.3, 0.4, 1], radius=1, inner_radius=0.4),
    "a difference": MATT + shape("difference", "green", of=f"[{SOLIDS}]"),
    "a group, three times": MATT + "[group.pair]\nshape = [" + SOLIDS + "]\n"
    + "".join(shape("instance", "green", of='"pair"', transform=f"[{{scale = {s}}}, {{translate = [{x}, 0, 0]}}]")
              for s, x in ((0.6, -2), (0.8, 0), (0.5, 2))),
    "mirrors": MATT + ball("mirror", -1.2) + ball("red", 1.2) + ball("mirror", 0.2, 0.5, 1.5, 0.5),
    "glass": MATT + '[render]\nshadows = "transparent"\n' + ball("glass", -1.2) + ball("red", 1.2),
    "clear, not bent": MATT + '[render]\nshadows = "transparent"\n' + ball("clear", -1.2) + ball("red", 1.2),
    "three lights": CAMERA + LIGHT + "[[light]]\nposition = [-7, 5, 4]\ncolor = [0.3, 0.3, 0.5]\n"
    '[[light]]\nkind = "directional"\ndirection = [0, -1, -0.3]\ncolor = 0.2\n' + BALLS,
    "a spot": CAMERA + '[[light]]\nkind = "spot"\nposition = [4, 6, 4]\ntarget = [0, 0, 0]\ninner_deg = 12\n'
    "outer_deg = 25\n" + BALLS,
    "light that fades": CAMERA + "[[light]]\nposition = [3, 5, 3]\nattenuation = [1, 0, 0.02]\n" + BALLS,
    "a light of some size": CAMERA + '[[light]]\nkind = "rectangle"\ncorner = [4, 8, 4]\nedge_u = [2, 0, 0]\n'
    "edge_v = [0, 0, 2]\nsamples = 64\n" + BALLS,
    "parallel rays": LIGHT + '[camera]\nkind = "orthographic"\neye = [3, 4, 9]\nlook_at = [0, 1, 0]\nheight = 6\n' + BALLS,
    "a panorama": LIGHT + '[camera]\nkind = "panorama"\neye = [0, 1.5, 5]\nlook_at = [0, 1, 0]\n' + BALLS,
    "a fisheye": LIGHT + '[camera]\nkind = "fisheye"\neye = [0, 1.5, 5]\nlook_at = [0, 1, 0]\nfov_deg = 120\n' + BALLS,
    "a lens": LIGHT + "[camera]\neye = [3, 4, 9]\nlook_at = [0, 1, 0]\nfov_deg = 40\naperture = 0.5\nfocus = [0, 1, 1]\n"
    "[render]\nsamples = 64\n" + BALLS,
    "a gradient": MATT + ball("mirror", 0),
    "a checker": painted('kind = "checker"\ncolors = [0.9, [0.1, 0.1, 0.3]]\nsize = 0.5'),
    "stripes": painted('kind = "stripes"\ncolors = [0.9, 0.5, [0.1, 0.1, 0.3]]\nsize = 0.4\ndirection = [1, 0.3, 0.5]'),
    "rings": painted('kind = "rings"\ncolors = [0.9, [0.1, 0.1, 0.3]]\nsize = 0.2\ndirection = [0.3, 1, 0.8]'),
    "colours that repeat": painted('kind = "gradient"\ncolors = [0.9, [0.1, 0.1, 0.3]]\nwrap = "repeat"\n'
                                   "direction = [1, 0.3, 0.5]"),
    "a picture": painted('kind = "image"\nfile = "picture.ppm"\nmapping = "solid"\nfilter = "bilinear"'),
}


def run(command, folder):
    done = subprocess.run([str(part) for part in command], cwd=folder, capture_output=True, text=True,
                          env={**os.environ, "HOME": str(folder)})
    return done.returncode, done.stdout + done.stderr


def within(zraka, ours, theirs, folder):
    code, words = run([zraka, "compare", "--tolerance", 8, "--format", "json", ours, theirs], folder)
    if code > 1:
        return words.splitlines()[0] if words else "?"
    found = json.loads(words)
    return f"{100 * (1 - found['over']['share']):.1f} %"


def draw(zraka, rival, scene, profile, folder):
    stem = scene.stem
    ending = "dat" if rival == "tachyon" else "pov"
    code, words = run([zraka, "convert", scene.name, f"{stem}.{ending}"], folder)
    lost = [line.split(": ", 3)[3] if line.count(": ") > 2 else line for line in words.splitlines()
            if "the profile" not in line]
    if code != 0:
        return "–", lost
    ours, theirs = f"{stem}-{rival}-zraka.png", f"{stem}-{rival}.png"
    (folder / theirs).unlink(missing_ok=True)
    run([zraka, "render", scene.name, "-o", ours, "--profile", profile, "-q"], folder)
    if rival == "tachyon":
        _, said = run(["tachyon", f"{stem}.dat", "-o", theirs, "-format", "PNG"], folder)
    else:
        _, said = run(["povray", f"+I{stem}.pov", f"+O{theirs}", f"+W{SIZE[0]}", f"+H{SIZE[1]}", "-D", "-V", "-A",
                       "+FN8", "File_Gamma=srgb"], folder)
    if not (folder / theirs).exists():
        return f"no picture: {said[-300:]}", lost
    return within(zraka, ours, theirs, folder), lost


def main():
    if len(sys.argv) < 2:
        sys.exit(__doc__)
    build = pathlib.Path(sys.argv[1]).resolve()
    folder = build / "converted"
    folder.mkdir(exist_ok=True)
    beside.write_picture(folder / "picture.ppm")
    print("| scene | Tachyon | POV-Ray | what is lost |\n|---|--:|--:|---|")
    for i, (name, text) in enumerate(SUBJECTS.items()):
        if sys.argv[2:] and name not in sys.argv[2:]:
            continue
        scene = folder / f"scene{i}.toml"
        whole = COMMON + text
        if name == "a gradient":
            whole = whole.replace("[0.2, 0.3, 0.5]", GRADIENT)
        scene.write_text(whole)
        tachyon, lost = draw(build / "zraka", "tachyon", scene, "tachyon", folder)
        povray, lost_too = draw(build / "zraka", "povray", scene, "physical", folder)
        said = [f"Tachyon: {'; '.join(lost)}"] * bool(lost) + [f"POV-Ray: {'; '.join(lost_too)}"] * bool(lost_too)
        print(f"| {name} | {tachyon} | {povray} | {'. '.join(said)} |", flush=True)


main()
