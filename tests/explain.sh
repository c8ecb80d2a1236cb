#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0
# explain.sh PROGRAM: zraka explain from outside: words, exit codes, files.
. "$(dirname "$0")/helpers.sh"
scene=scenes/lab/input.txt

# Usage.
expect 0 "Examples:" "$zraka" explain --help
for bad in -1 a 1.5 "" " 3" 3x; do
  exactly 2 "X: '$bad' is not a whole number, 0 or more
Run 'zraka explain --help' for more information." "$zraka" explain $scene "$bad" 5
  exactly 2 "Y: '$bad' is not a whole number, 0 or more
Run 'zraka explain --help' for more information." "$zraka" explain $scene 5 "$bad"
done
expect 2 "Y is required" "$zraka" explain $scene 5
expect 2 "--lang: 'de' is not en or hr" "$zraka" explain $scene 5 5 --lang de
expect 2 "--format: 'pdf' is not text, json or html" "$zraka" explain $scene 5 5 --format pdf
expect 2 "'8' is not a stage" "$zraka" explain $scene 5 5 --stage 8

# Bad input.
exactly 1 "error: pixel (400, 399) is outside of the picture of 400×400 pixels
  columns go from 0 to 399 from the left, rows from 0 to 399 from the top" "$zraka" explain $scene 400 399
expect 1 "pixel (4294967295, 0) is outside of the picture of 400×400 pixels" "$zraka" explain $scene 99999999999999999999 0
expect 1 "pixel (30, 30) is outside of the picture of 20×20 pixels" "$zraka" explain $scene 30 30 --width 20
expect 1 "cannot be read: No such file or directory" "$zraka" explain "$folder/nowhere.txt" 1 1
exactly 1 "$folder/nowhere.txt: pogreška: ne može se pročitati: nema takve datoteke ni mape
  jesu li ime i mapa točni?" "$zraka" explain "$folder/nowhere.txt" 1 1 --lang hr
expect 1 "No space left on device" "$zraka" explain $scene 1 1 -o /dev/full
expect 1 "does its folder exist?" "$zraka" explain $scene 1 1 -o "$folder/no/pixel.json"

# The words, plain when piped; colours on a terminal unless NO_COLOR forbids.
"$zraka" explain $scene 180 290 >"$folder/text" || fail "explain"
[ "$(tail -n 1 "$folder/text")" = "Dark because the shadow ray to light 1 hits sphere 3 'staklo' at t = 0.396; only the ambient component remains." ] ||
  fail "the last line is: $(tail -n 1 "$folder/text")"
grep -q $'\x1b' "$folder/text" && fail "colours in a pipe"
[ "$("$zraka" explain $scene 180 290 --lang hr | tail -n 1)" = "Tamno jer zraka za ispitivanje sjene prema svjetlu 1 pogađa kuglu 3 'staklo' za t = 0,396; ostaje samo ambijentna komponenta." ] ||
  fail "the last line in Croatian"
if script -qec true /dev/null </dev/null >/dev/null 2>&1; then  # needs pseudo-terminals
  on_terminal() { TERM=xterm script -qec "$*" /dev/null </dev/null; }
  on_terminal "$zraka" explain $scene 180 290 | grep -q $'\x1b' || fail "no colours on a terminal"
  on_terminal env NO_COLOR=1 "$zraka" explain $scene 180 290 | grep -q $'\x1b' && fail "colours in spite of NO_COLOR"
fi
expect 0 "stage 2: ambient component" "$zraka" explain $scene 180 290 --stage ambient
expect 0 "lower right corner" "$zraka" explain $scene 180 290 --profile spd
for isa in $("$zraka" --version | sed -n 's/^this machine has://p'); do
  "$zraka" explain $scene 180 290 --isa "$isa" | cmp -s - "$folder/text" || fail "$isa explains otherwise"
done

# JSON, by name or by option.
"$zraka" explain $scene 180 290 -o "$folder/pixel.json" || fail "json"
"$zraka" explain $scene 180 290 --format json | cmp -s - "$folder/pixel.json" || fail "--format json is not .json"
for key in color tree words pixel profile background lights; do
  grep -q "^ \"$key\": " "$folder/pixel.json" || fail "JSON has no $key"
done

# Rays for 3-D programs.
"$zraka" explain $scene 230 250 --rays "$folder/rays.obj" >/dev/null || fail "--rays obj"
[ "$(grep -c '^l ' "$folder/rays.obj")" -ge 12 ] || fail "rays.obj has too few rays"
"$zraka" explain $scene 230 250 --rays "$folder/rays.gltf" >/dev/null || fail "--rays gltf"
grep -q '"shadow-ray-blocked"' "$folder/rays.gltf" || fail "rays.gltf has no shadow rays"
expect 2 "--rays: 'rays.png' is not the name of a .obj or a .gltf" "$zraka" explain $scene 5 5 --rays rays.png
expect 1 "does its folder exist?" "$zraka" explain $scene 5 5 --rays "$folder/no/rays.obj"

# Influence of a shape.
expect 0 "Sphere 3 'staklo' has a part in" "$zraka" influence $scene staklo
cp "$folder/words" "$folder/by_name"
expect 0 "by refracted ray → refracted ray" "$zraka" influence $scene sphere 2
expect 0 "Kugla 3 'staklo' ima udjela u" "$zraka" influence $scene kugla 3 --lang hr
"$zraka" influence $scene Sphere 3 | cmp -s - "$folder/by_name" || fail "the number is not the name"
expect 0 '"through_glass":' "$zraka" influence $scene sphere 3 --format json
expect 0 "orange seen from the eye" "$zraka" influence $scene staklo -o "$folder/marked.png"
[ "$(head -c 4 "$folder/marked.png" | tail -c 3)" = PNG ] || fail "no picture of influence"
"$zraka" influence $scene staklo -o - | cmp -s - "$folder/marked.png" || fail "influence to standard output"
exactly 1 "error: the scene has no shape 'zelen'
  it has sphere 1 to sphere 7; names are 'tlo', 'zrcalo', 'staklo', 'crvena', 'zuta', 'zelena', 'modra'" \
  "$zraka" influence $scene zelen
expect 2 "NAME" "$zraka" influence $scene

# Groups, CSG and textures.
cat >"$folder/room.toml" <<'TOML'
[image]
width = 60
height = 60
[camera]
eye = [0, 1, 5]
look_at = [0, 0.5, 0]
fov_deg = 30
[[light]]
position = [4, 6, 5]
[material.tiled]
color = {kind = "checker", colors = [[0.9, 0.9, 0.9], [0.1, 0.1, 0.1]], size = 0.5}
[group.chair]
shape = [{kind = "box", name = "seat", min = [-0.4, 0.4, -0.4], max = [0.4, 0.5, 0.4]}]
[[shape]]
kind = "plane"
material = "tiled"
point = [0, 0, 0]
normal = [0, 1, 0]
[[shape]]
kind = "instance"
name = "left"
of = "chair"
transform = [{translate = [-0.5, 0, 0]}]
[[shape]]
kind = "difference"
name = "cup"
of = [{kind = "sphere", center = [0.6, 0.4, 0], radius = 0.4},
      {kind = "sphere", name = "hollow", center = [0.6, 0.6, 0.3], radius = 0.3}]
TOML
room=$folder/room.toml
expect 0 "way: instance 1 'left' (group 'chair') → box 1 'seat'" "$zraka" explain "$room" 20 32
expect 0 "put: primjerak 1 'left' (skupina 'chair') → kvadar 1 'seat'" "$zraka" explain "$room" 20 32 --lang hr
expect 0 "on the surface of member 2 of 2 (difference): sphere 'hollow'" "$zraka" explain "$room" 42 28
expect 0 "texture 1 (checker): ka = kd = (0.9, 0.9, 0.9)" "$zraka" explain "$room" 34 55
expect 0 "Box 1 'seat' (group 'chair') has a part in" "$zraka" influence "$room" chair/seat
expect 0 "Kvadar 1 'seat' (skupina 'chair') ima udjela u" "$zraka" influence "$room" seat --lang hr
expect 0 '"group": "chair"' "$zraka" influence "$room" seat --format json
expect 0 "Compound solid 1 'cup' has a part in" "$zraka" influence "$room" hollow
exactly 1 "error: the scene has no shape 'arm'
  it has plane 1, csg 1, instance 1; names are 'cup', 'left'; groups are 'chair': say GROUP/NAME for a shape in one" \
  "$zraka" influence "$room" arm

finish
