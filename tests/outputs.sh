#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0
# outputs.sh PROGRAM: what the program writes: never over what it reads, nothing that steers a terminal, nothing half where a signal ends it.
. "$(dirname "$0")/helpers.sh"
scene=$folder/scene.txt
cp scenes/lab/input.txt "$scene"
mkdir "$folder/ana" "$folder/class" "$folder/pictures"
"$zraka" render "$scene" --width 40 -q -o "$folder/ana/7.png" || fail "render"
cp "$folder/ana/7.png" "$folder/7.png"
(cd "$folder/ana" && python3 -m zipfile -c ../class/ana.zip 7.png)
cp -r "$folder/ana" "$folder/class/iva"
echo '{}' >"$folder/rubric.json"
ln -s scene.txt "$folder/link.html"
ln "$scene" "$folder/hard.html"
for name in pictures/1-silhouette.png pictures/contact-sheet.png pictures/difference-1-2.png pictures/report.html pictures/picture-1.png; do
  ln -s ../scene.txt "$folder/$name"
done
sums() {
  find "$folder" -type f ! -name words -exec sha256sum {} + | sort
}
before=$(sums)

# refuses CODE COMMAND…: the answer tells why, and no file has changed.
over="would be written over an input of this command: it needs another name"
refuses() {
  local code=$1
  shift
  expect "$code" "$over" "$zraka" "$@"
  [ "$(sums)" = "$before" ] || { fail "a file changed: $*"; before=$(sums); }
}
for output in "$scene" "$folder/link.html" "$folder/hard.html" "$folder/ana/../scene.txt"; do
  refuses 1 explain "$scene" 10 10 --width 40 -o "$output"
  refuses 1 grade "$scene" "$folder/ana" --width 40 -o "$output"
  refuses 1 quiz "$scene" --width 40 --format html -o "$output"
  refuses 1 quiz "$scene" --width 40 -o "$folder/new.html" --answers "$output"
done
ln -s scene.txt "$folder/link.png"
ln -s scene.txt "$folder/link.gltf"
before=$(sums)
refuses 1 render "$scene" --width 40 -o "$folder/link.png"
refuses 1 influence "$scene" sphere 1 --width 40 -o "$folder/link.png"
refuses 1 explain "$scene" 10 10 --width 40 --rays "$folder/link.gltf"
refuses 1 stages "$scene" --width 40 -o "$folder/pictures"
refuses 1 report "$scene" --width 40 -o "$folder/pictures"
refuses 1 quiz "$scene" --width 40 --format json --pictures "$folder/pictures" -o -
refuses 1 grade "$scene" "$folder/ana" --width 40 -o "$folder/ana/7.png"
refuses 1 grade "$scene" "$folder/ana/7.png" --width 40 -o "$folder/ana/7.png"
refuses 1 grade "$scene" "$folder/class/ana.zip" --width 40 -o "$folder/class/ana.zip"
refuses 1 grade "$scene" "$folder/class" --all --width 40 -o "$folder/class/iva/7.png"
refuses 1 grade "$scene" "$folder/class" --all --width 40 -o "$folder/class/ana.zip"
refuses 1 grade "$scene" "$folder/ana" --rubric "$folder/rubric.json" --width 40 -o "$folder/rubric.json"
refuses 2 compare "$folder/7.png" "$folder/ana/7.png" --heat "$folder/7.png"
refuses 2 compare "$folder/7.png" "$folder/ana/7.png" --html "$folder/ana/7.png"
font=$(fc-match -f '%{file}' sans:bold) && cp "$font" "$folder/font.txt" && before=$(sums)
refuses 1 generate letter A --font "$folder/font.txt" -o "$folder/font.txt"
expect 1 "$over" bash -c "'$zraka' render - --width 40 -o '$folder/link.png' <'$scene'"
expect 1 "would be written twice" "$zraka" explain "$scene" 10 10 --width 40 -o "$folder/x.obj" --rays "$folder/x.obj"
expect 2 "would be written twice" "$zraka" compare "$folder/7.png" "$folder/7.png" --heat "$folder/x.png" --html "$folder/x.png"

# Names with what steers a terminal: raw for programs, shown for people, escaped in JSON.
odd=$folder/$'odd\e]0;x\a\u202e'
mkdir "$odd"
cp "$folder/7.png" "$odd/7.png"
cp "$scene" "$odd/scene.txt"
"$zraka" stages "$odd/scene.txt" --width 40 -o "$odd/stages" >"$folder/words" || fail "stages"
contains "$folder/words" "$odd/stages/1-silhouette.png"
# on_terminal COMMAND…: standard output and standard error are one; fails where it gets a control but line ends.
on_terminal() {
  python3 - "$@" >"$folder/seen" <<'PY' || fail "reaches a terminal from: $*"
import os, pty, re, sys
got = b""
def read(descriptor):
    global got
    part = os.read(descriptor, 65536)
    got += part
    return part
os.environ["TERM"] = "dumb"
pty.spawn(sys.argv[1:], read, lambda descriptor: b"")
text = got.decode()
sys.exit(bool(re.search("[^\\S\\n\\r\\t ]|[\x00-\x08\x0b\x0c\x0e-\x1f\x7f-\x9f\u202e]", text.replace("\u00a0", " "))) or "odd" not in text)
PY
}
on_terminal "$zraka" stages "$odd/scene.txt" --width 40 -o "$odd/stages"
on_terminal "$zraka" report "$odd/scene.txt" --width 40 -o "$odd/report"
on_terminal "$zraka" quiz "$odd/scene.txt" --width 40 --questions 1 -o "$odd/quiz.html"
on_terminal "$zraka" explain "$odd/scene.txt" 10 10 --width 40
on_terminal "$zraka" explain "$odd/scene.txt" 10 10 --width 40 --format json
on_terminal "$zraka" compare "$odd/7.png" "$odd/7.png"
on_terminal "$zraka" compare "$odd/7.png" "$odd/7.png" --format json
on_terminal "$zraka" compare "$odd/7.png" "$odd/scene.txt"
on_terminal "$zraka" grade "$scene" --width 40 "$odd"
on_terminal "$zraka" grade "$scene" --width 40 "$odd" --format json
on_terminal "$zraka" info "$odd/7.png"
on_terminal "$zraka" render "$odd/none.txt" -o "$folder/x.png"
on_terminal "$zraka" $'odd\e[31m\u202e'
on_terminal "$zraka" info $'odd\e[31m\u202e'
on_terminal "$zraka" info scenes $'odd\e[31m\u202e'
on_terminal "$zraka" render "$scene" -o x.png --threads $'odd\e[31m\u202e'
on_terminal "$zraka" render "$scene" -o x.png --stage $'odd\e[31m\u202e'
on_terminal "$zraka" render "$scene" -o x.png $'--odd\e[31m\u202e'
"$zraka" compare "$odd/7.png" "$odd/7.png" --format json >"$folder/json"
python3 -c 'import json, sys; assert json.load(open(sys.argv[1]))["a"]["file"] == sys.argv[2]' "$folder/json" "$odd/7.png" || fail "another name in JSON"

# Why a grade fails is said where its page goes elsewhere.
echo "no picture" >"$folder/bad.png"
exactly 1 "$folder/bad.png: error: is no picture of a known kind
  PNG, JPEG, BMP, TGA, PPM, PGM, PFM, Radiance HDR and OpenEXR can be read" "$zraka" grade "$scene" "$folder/bad.png" -o "$folder/bad.html"

# Signals: the exit code that shells give them, at once, and no half file.
for signal in INT:130 TERM:143 HUP:129 QUIT:131; do
  "$zraka" render "$scene" -o "$folder/slow.png" --width 11000 --max-depth 20 &
  sleep 0.3
  kill -"${signal%:*}" $!
  wait $!
  got=$?
  [ $got = "${signal#*:}" ] || fail "SIG${signal%:*} ends with $got"
done
[ "$(find "$folder" -name 'slow*' | wc -l)" = 0 ] || fail "a signal leaves a file"
finish
