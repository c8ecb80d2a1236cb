#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0
# scene_language.sh PROGRAM: the scene language's commands, from outside.
. "$(dirname "$0")/helpers.sh"

cat >"$folder/good.toml" <<'EOF'
# All kinds of things that are built.
[image]
width = 64
height = 48

[camera]
eye = [0, 2, 8]
look_at = [0, 1, 0]

[render]
max_depth = 5
samples = 1

[scene]
ambient = 0.3
background = "#203040"

[[light]]
position = [4, 6, 5]

[material.glass]
color = 0.05
specular = 0.5
refraction = 0.9
ior = 1.5

[[shape]]
kind = "sphere"
name = "ball"
material = "glass"
center = [0, 1, 0]
radius = 1

[[shape]]
kind = "polygon"
points = [[-5, 0, 5], [5, 0, 5], [5, 0, -5], [-5, 0, -5]]

[[shape]]
kind = "cylinder"
base = [2, 0, 0]
top = [2, 2, 0]
radius = 0.2
caps = false
EOF
cat >"$folder/window.toml" <<'EOF'
[camera]
kind = "window"
window = {center = [0, 0, 0], right = [2, 0, 0], up = [0, 2, 0]}
[[shape]]
kind = "triangle"
a = [0, 0, 0]
b = [1, 0, 0]
c = [0, 1, 0]
normals = [[0, 0, 1], [0, 1, 1], [1, 0, 1]]
[[shape]]
kind = "cone"
base = [0, 0, 0]
base_radius = 1
top = [0, 1, 0]
caps = false
EOF
printf '[[shape]]\nkind = "sphere"\ncenter = [0, 0, 0]\nradus = 1\nradius = 1\n' >"$folder/bad.toml"

# check: silent where all is well, else every problem with its place.
exactly 0 "" "$zraka" check "$folder/good.toml"
exactly 0 "" "$zraka" check scenes/lab/input.txt
exactly 1 "$folder/bad.toml:4:1: error: unknown field 'radus' of sphere
  radus = 1
  ^
  did you mean 'radius'?" "$zraka" check "$folder/bad.toml"
expect 1 "$folder/none.toml: error: cannot be read: No such file or directory" "$zraka" check "$folder/none.toml"

# A scene's own depth, shadows and profile hold where the command line says nothing.
hash_of() { "$zraka" render "$@" -o "$folder/a.png" --quiet --stats=json | grep sha256; }
[ "$(hash_of "$folder/good.toml")" = "$(hash_of "$folder/good.toml" --max-depth 5)" ] || fail "the scene's depth"
[ "$(hash_of "$folder/good.toml")" = "$(hash_of "$folder/good.toml" --max-depth 1)" ] && fail "the command line's depth"
sed 's/^samples = 1/shadows = "off"/' "$folder/good.toml" >"$folder/unshadowed.toml"
[ "$(hash_of "$folder/unshadowed.toml")" = "$(hash_of "$folder/good.toml")" ] && fail "shadows are not off"
sed 's/^samples = 1/profile = "lab"/' "$folder/good.toml" >"$folder/lab.toml"
[ "$(hash_of "$folder/lab.toml")" = "$(hash_of "$folder/good.toml" --profile lab)" ] || fail "the scene's profile"

# format and convert: the same picture.
"$zraka" format "$folder/good.toml" >"$folder/formatted.toml" || fail "format"
"$zraka" format "$folder/formatted.toml" -o "$folder/again.toml" || fail "format of what is formatted"
cmp -s "$folder/formatted.toml" "$folder/again.toml" || fail "the canonical form changes"
[ "$(hash_of "$folder/good.toml")" = "$(hash_of "$folder/formatted.toml")" ] || fail "format changes the picture"
for scene in scenes/lab/input.txt scenes/lab/bubble.txt scenes/nff/benzene.nff; do
  exactly 0 "" "$zraka" convert "$scene" "$folder/converted.toml"
  [ "$(hash_of "$scene" --width 80)" = "$(hash_of "$folder/converted.toml" --width 80)" ] || fail "$scene changes"
done
"$zraka" convert scenes/lab/input.txt "$folder/lab.toml" && "$zraka" convert "$folder/lab.toml" "$folder/back.txt" || fail "back"
[ "$(hash_of scenes/lab/input.txt --width 80)" = "$(hash_of "$folder/back.txt" --width 80)" ] || fail "input.txt changes"
exactly 0 "$folder/good.toml: warning: lost in NFF: the ambient light, which NFF's rule gives
$folder/good.toml: warning: lost in NFF: names
$folder/good.toml: warning: lost in NFF: the depth of rays
$folder/good.toml: warning: lost in NFF: materials: another share of the reflected ray than of the highlight
$folder/good.toml: warning: lost in NFF: materials: another ambient share than the diffuse one" \
  "$zraka" convert "$folder/good.toml" "$folder/good.nff"
expect 0 "picture     64 × 48 pixels" "$zraka" info "$folder/good.nff"
exactly 1 "$folder/good.toml: error: the course's input.txt format cannot say where this scene's window is: it knows squares in the plane z = 0 around the origin" \
  "$zraka" convert "$folder/good.toml" - --to lab

# Shapes, groups, CSG and textures: formatted, the same; and what other formats lose of them.
cp fuzz/corpus/scene_language/breadth.toml "$folder/breadth.toml"
exactly 0 "" "$zraka" check "$folder/breadth.toml"
"$zraka" format "$folder/breadth.toml" >"$folder/broad.toml" || fail "format of breadth"
"$zraka" format "$folder/broad.toml" >"$folder/again.toml" || fail "format of what is formatted"
cmp -s "$folder/broad.toml" "$folder/again.toml" || fail "the canonical form of breadth changes"
[ "$(hash_of "$folder/breadth.toml" --width 80)" = "$(hash_of "$folder/broad.toml" --width 80)" ] || fail "format changes breadth"
expect 0 "warning: lost in NFF: shapes: instance" "$zraka" convert "$folder/breadth.toml" "$folder/breadth.nff"

# Lights, cameras, optics, sampling and skies: the same.
for scene in optics views; do
  cp "fuzz/corpus/scene_language/$scene.toml" "$folder/$scene.toml"
  exactly 0 "" "$zraka" check "$folder/$scene.toml"
  "$zraka" format "$folder/$scene.toml" >"$folder/optically.toml" || fail "format of $scene"
  "$zraka" format "$folder/optically.toml" >"$folder/again.toml" || fail "format of what is formatted"
  cmp -s "$folder/optically.toml" "$folder/again.toml" || fail "the canonical form of $scene changes"
done
expect 0 "warning: lost in NFF: materials: dispersion" "$zraka" convert "$folder/optics.toml" "$folder/optics.nff"
expect 1 "NFF cannot say what this scene's camera is: it knows pinholes alone" "$zraka" convert "$folder/views.toml" "$folder/views.nff"

# Files that a scene names: in its folder, or outside where that is allowed.
mkdir -p "$folder/inside"
printf 'P3 1 1 255 255 0 0\n' | tee "$folder/red.ppm" >"$folder/inside/red.ppm"
printf '[texture.t]\nkind = "image"\nfile = "red.ppm"\n' >"$folder/inside/good.toml"
printf '[texture.t]\nkind = "image"\nfile = "../red.ppm"\n' >"$folder/inside/out.toml"
exactly 0 "" "$zraka" info "$folder/inside/good.toml"
exactly 1 "$folder/inside/out.toml:3:8: error: file of image texture: '../red.ppm' lies outside of the scene's folder
  file = \"../red.ppm\"
         ^
  put it beside the scene, or allow it with --allow-outside" "$zraka" info "$folder/inside/out.toml"
exactly 0 "" "$zraka" info "$folder/inside/out.toml" --allow-outside
exactly 0 "" "$zraka" format "$folder/inside/out.toml" --allow-outside
exactly 0 "" "$zraka" convert "$folder/inside/out.toml" - --to toml --allow-outside
exactly 0 "$folder/moved.toml: warning: names the picture ../red.ppm, which is not beside it
  names of files start at the scene's folder" "$zraka" format "$folder/inside/out.toml" --allow-outside -o "$folder/moved.toml"
exactly 0 "" "$zraka" render "$folder/inside/out.toml" --allow-outside --quiet --width 8 -o "$folder/a.png"
expect 1 "is no format that can be written" "$zraka" convert "$folder/good.toml" "$folder/good.obj"
cp "$folder/good.toml" "$folder/own.toml"
expect 1 "would be written over an input of this command" "$zraka" format "$folder/own.toml" -o "$folder/own.toml"
cmp -s "$folder/good.toml" "$folder/own.toml" || fail "a scene was overwritten"

# help: keywords of the language beside commands.
expect 0 "its radius: a number greater than 0" "$zraka" help sphere
expect 0 "--max-depth" "$zraka" help render
expect 0 "the rules of light" "$zraka" help render section
expect 0 "Keywords of the scene language: image, camera, perspective" "$zraka" help
expect 2 "'shpere' is no command and no keyword of the scene language
Did you mean 'sphere'?" "$zraka" help shpere
"$zraka" help --pages "$folder/pages" || fail "pages"
diff -r "$folder/pages" docs/scene-language -x README.md || fail "docs/scene-language is not what zraka help --pages writes"

# The schema, where there are Node, ajv and a Python that reads TOML: it accepts what the reader accepts, and nothing else.
"$zraka" schema -o "$folder/schema.json" || fail "schema"
modules=${NODE_PATH:-}:/usr/share/nodejs:$(npm root -g 2>/dev/null)
if NODE_PATH=$modules node -e 'require("ajv")' 2>/dev/null && python3 -c 'import tomllib' 2>/dev/null; then
  valid() {
    python3 -c 'import json, sys, tomllib; json.dump(tomllib.load(open(sys.argv[1], "rb")), sys.stdout)' "$1" >"$folder/scene.json" &&
      NODE_PATH=$modules node -e '
        const fs = require("fs"), Ajv = require("ajv").default ?? require("ajv");
        const [schema, scene] = process.argv.slice(1).map((f) => JSON.parse(fs.readFileSync(f)));
        const valid = new Ajv({allErrors: true}).compile(schema);
        if (!valid(scene)) { console.log(JSON.stringify(valid.errors)); process.exit(1); }
      ' "$folder/schema.json" "$folder/scene.json" >"$folder/words" 2>&1
  }
  "$zraka" convert scenes/nff/benzene.nff "$folder/benzene.toml"
  for scene in good window formatted unshadowed converted benzene breadth broad optics optically views; do
    valid "$folder/$scene.toml" || fail "the schema refuses $scene.toml: $(head -c 500 "$folder/words")"
  done
  # One line of a good scene made wrong, each a way of its own.
  for wrong in 's/radius = 1/radius = 0/' 's/radius = 1/radus = 1/' 's/^radius = 1$//' 's/"sphere"/"torus"/' 's/width = 64/width = 6.5/' \
    's/"#203040"/"blue"/' 's/samples = 1/samples = 0/' 's/center = .*/center = [1, 2]/' 's/\[scene\]/[scenes]/' 's/name = "ball"/name = 3/' \
    's/max_depth = 5/max_depth = 201/' 's/caps = false/caps = 0/' 's/look_at = .*/look_at = "here"/'; do
    sed "$wrong" "$folder/good.toml" >"$folder/wrong.toml"
    valid "$folder/wrong.toml" && fail "the schema accepts $wrong"
    expect 1 "error" "$zraka" check "$folder/wrong.toml"
  done
  for wrong in 's/{scale = \[1, 2, 1\]}/{scale = [1, 2]}/' 's/by_deg = 45/by_degrees = 45/' 's/colors = .*/colors = [1]/' 's/"mirror"/"mirrored"/' \
    's/{kind = "sphere", center = \[3, 1, 1\], radius = 0.8/{kind = "polygon", points = [[0, 0, 0], [1, 0, 0], [0, 1, 0]]/' \
    's/octaves = 5/octaves = 0/' 's/\[0.25, 1\]\]/[0.25]]/' 's/{kind = "box", min/{kind = "box", mini/' 's/shape = \[{/shape = [3, {/' \
    's/^inner_radius = .*/inner_radius = -1/' 's/bump = .*/bump = {height = 1}/' 's/\[0, 1, 1, 3\]\]/[0, 1, 1]]/'; do
    sed "$wrong" "$folder/breadth.toml" >"$folder/wrong.toml"
    cmp -s "$folder/wrong.toml" "$folder/breadth.toml" && fail "nothing is made wrong by $wrong"
    valid "$folder/wrong.toml" && fail "the schema accepts $wrong"
    expect 1 "error" "$zraka" check "$folder/wrong.toml"
  done
  for wrong in 's/contrast = 0.02/contrast = -1/' 's/\[4, 64\]/[4.5, 64]/' 's/bottom = /button = /' 's/"gradient"/"radient"/' \
    's/attenuation = .*/attenuation = [0, 0, 0]/' 's/outer_deg = 20/outer_deg = 181/' 's/^center = \[-3, 6, -3\]$//' \
    's/{abbe = 50}/{abbe = 0}/' 's/{abbe = 50}/{abbe = 50, cauchy = [1, 0, 0]}/' 's/cauchy = \[1.3, /cauchy = [/' 's/"exact"/"exactly"/' \
    's/priority = 1/priority = 1.5/' 's/"mitchell"/"sinc"/' 's/seed = 7/seed = -7/' 's/aperture = 0.1/aperture = -0.1/'; do
    sed "$wrong" "$folder/optics.toml" >"$folder/wrong.toml"
    cmp -s "$folder/wrong.toml" "$folder/optics.toml" && fail "nothing is made wrong by $wrong"
    valid "$folder/wrong.toml" && fail "the schema accepts $wrong"
    expect 1 "error" "$zraka" check "$folder/wrong.toml"
  done
else
  echo "the schema is not checked: there is no Node with ajv, or no Python that reads TOML"
fi
finish
