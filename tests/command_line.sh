#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0
# command_line.sh PROGRAM: the program as people meet it: exit codes, words, files that stay whole.
. "$(dirname "$0")/helpers.sh"
scene=scenes/lab/input.txt

# Help and version.
expect 0 "Examples:" "$zraka" --help
for command in render stages explain influence info generate "generate letter" compare; do
  # shellcheck disable=SC2086
  expect 0 "Example" "$zraka" $command --help
done
expect 0 "in use:" "$zraka" --version
expect 0 "in use: portable" env ZRAKA_ISA=portable "$zraka" --version

# Wrong usage.
expect 2 "A subcommand is required" "$zraka"
expect 2 "'rendr' is no command: did you mean render?" "$zraka" rendr "$scene"
expect 2 "'xyzzy' is no command: there are render, stages, explain" "$zraka" xyzzy "$scene"
expect 2 "'lettr' is no command of 'zraka generate': did you mean letter?" "$zraka" generate lettr
expect 2 "'zraka render' has no option --widht: did you mean --width?" "$zraka" render "$scene" --widht 200
expect 2 "Run 'zraka render --help' for more information." "$zraka" render "$scene" --widht 200 -o "$folder/a.png"
expect 2 "'zraka render' takes no further argument: what is 'b'?" "$zraka" render a b -o "$folder/a.png"
"$zraka" render --help >"$folder/help" && "$zraka" help render | cmp -s - "$folder/help" || fail "help render is not render --help"
expect 0 "Usage: zraka generate letter" "$zraka" help generate letter
expect 2 "'no' is no command" "$zraka" help no
expect 1 "standard output: error: cannot be written" bash -c "'$zraka' --help >/dev/full"
for command in grade report influence quiz; do
  expect 2 "has no option --mistake" "$zraka" "$command" "$scene" "$scene" --mistake no-power
done
for name in p.tif p.toml p.txt p.svg; do
  expect 2 "'$name' is not the name of a picture that can be written: known are .png, .exr, .ppm, .pfm, .jpg, .jpeg, .hdr" "$zraka" render "$scene" -o $name
done
expect 2 "'flake.png' is not the name of an NFF file" "$zraka" generate sphereflake -o flake.png
expect 1 "standard output: error: cannot be written" bash -c "'$zraka' info $scene >/dev/full"
for question in --help "render --help" --version "help compare"; do
  expect 1 "standard output: error: cannot be written" bash -c "'$zraka' $question >/dev/full"
done
expect 2 "--frobnicate" "$zraka" render "$scene" -o "$folder/a.png" --frobnicate
expect 2 "--output is required" "$zraka" render "$scene"
expect 2 "'9' is not a stage" "$zraka" render "$scene" -o "$folder/a.png" --stage 9
expect 2 "--max-depth" "$zraka" render "$scene" -o "$folder/a.png" --max-depth -1
expect 2 "'mmx' is not avx512, avx2 or portable" "$zraka" render "$scene" -o "$folder/a.png" --isa mmx
# Samples, filters, parts of pictures.
wrong() { expect 2 "$1" "$zraka" render "$scene" -o "$folder/a.png" "${@:2}"; }
wrong "--samples, --grid and --adaptive exclude each other: give one of them" --samples 4 --grid 2
wrong "--samples: '0' is not a number from 1 to 65536" --samples 0
wrong "--grid: '257' is not a number from 1 to 256" --grid 257
for list in 4 8,4 0,4 4,8,2 4,8,0.1,1 4,65537 a,b 4,; do
  wrong "--adaptive: '$list' is not MIN,MAX or MIN,MAX,CONTRAST: 1 or more, MIN or more, 0 to 1" --adaptive $list
done
wrong "--filter: 'cubic' is not box, tent, gauss or mitchell" --filter cubic
wrong "--quality: 'best' is not draft, good or final" --quality best
wrong "--shadows: 'soft' is not opaque, transparent or off" --shadows soft
wrong "--seed: '-1' is not a whole number from 0 to 4294967295" --seed -1
wrong "--wavelengths: '65' is not a number from 1 to 64" --wavelengths 65
wrong "--min-contribution: '-1' is not a number from 0" --min-contribution -1
for list in 1,2,3 1,2,3,-4 a 1,2,3,4,5; do
  wrong "--crop: '$list' is not X,Y,WIDTH,HEIGHT in whole pixels" --crop $list
done
expect 1 "the crop of 20×20 pixels from (390, 0) on is not within the picture of 400×400 pixels" \
  "$zraka" render "$scene" -o "$folder/a.png" --crop 390,0,20,20
expect 0 "cut     666 rays not traced; a pixel lacks at most 0.0172, on average" "$zraka" render "$scene" \
  -o "$folder/c.png" --width 60 --min-contribution 0.01 --stats
expect 0 '"cut": {' "$zraka" render "$scene" -o "$folder/c.png" --width 60 --stats=json
expect 0 "samples 5" "$zraka" render "$scene" -o "$folder/c.png" --width 60 --samples 5 --stats
expect 0 '"samples_per_pixel": 4.0' "$zraka" render "$scene" -o "$folder/c.png" --width 60 --grid 2 --stats=json
same() {
  "$zraka" render "$scene" -o "$folder/c.png" --width 60 $1 && "$zraka" render "$scene" -o "$folder/d.png" --width 60 $2 &&
    cmp -s "$folder/c.png" "$folder/d.png" || fail "'$1' and '$2' differ"
}
same "--quality draft" "--max-depth 2"
same "--quality good" "--adaptive 4,16"
same "--quality final" "--samples 64 --filter gauss"
same "--quality final --samples 2 --filter box" "--samples 2"
same "--shadows off --stage 5" "--stage 4"
expect 1 "which is no instruction set" env ZRAKA_ISA=mmx "$zraka" render "$scene" -o "$folder/a.png"
expect 2 "'x.jpg' is not the name of a PNG" "$zraka" influence "$scene" sphere 1 -o x.jpg
[ -e "$folder/a.png" ] && fail "a picture of a render that failed"
cp "$scene" "$folder/own"
expect 1 "would be written over an input of this command" "$zraka" render "$folder/own" -o "$folder/own"
cmp -s "$scene" "$folder/own" || fail "a scene was overwritten"

# Bytes of a picture are nothing for a terminal; script gives the program one.
if command -v script >/dev/null; then
  expect 2 "'-' is not for a terminal, which shows no PNG" script -qec "'$zraka' render $scene -o -" /dev/null
fi

# Pictures: silent when piped, the same by number and by name of a stage.
"$zraka" render "$scene" -o "$folder/a.png" >"$folder/words" 2>&1 || fail "render"
[ -s "$folder/words" ] && fail "render is not silent: $(cat "$folder/words")"
"$zraka" render "$scene" -o - >"$folder/b.png" || fail "standard output"
cmp -s "$folder/a.png" "$folder/b.png" || fail "standard output gives another picture"
"$zraka" render <(cat "$scene") -o "$folder/b.png" || fail "a pipe"
cmp -s "$folder/a.png" "$folder/b.png" || fail "a pipe gives another picture"
[ "$(head -c 4 "$folder/a.png" | tail -c 3)" = PNG ] || fail "no PNG"
"$zraka" render "$scene" -o "$folder/4.png" --stage 4 && "$zraka" render "$scene" -o "$folder/s.png" --stage specular
cmp -s "$folder/4.png" "$folder/s.png" || fail "stage 4 is not stage specular"
cmp -s "$folder/4.png" "$folder/a.png" && fail "stage 4 is the whole picture"
"$zraka" render - -o "$folder/b.png" <"$scene" || fail "standard input"
cmp -s "$folder/a.png" "$folder/b.png" || fail "standard input gives another picture"

# Particles, packed or not, from a file or from standard input.
molecule=docs/examples/caffeine.xyz
exactly 0 "$molecule: note: 24 particles; light, camera and colours are chosen here
  a scene with a shape of kind 'particles' chooses otherwise: zraka help particles" \
  "$zraka" render "$molecule" -o "$folder/molecule.png" --width 64
gzip -c "$molecule" | "$zraka" render - -o "$folder/unpacked.png" --width 64 -q || fail "gzip on standard input"
cmp -s "$folder/molecule.png" "$folder/unpacked.png" || fail "gzip gives another picture"

# Cuts, depth, outlines and legends; what does not go together is said.
cluster=docs/examples/cluster.csv
"$zraka" render "$cluster" -o "$folder/plain.ppm" --width 64 -q --color-by temperature || fail "--color-by"
for look in "--cut=-1,0,0,-2.5" "--cut 0,0,1,0,1,0,0,3 --cut-eye-only" --depth-cue "--outlines 2" "--color-map grey"; do
  # shellcheck disable=SC2086
  "$zraka" render "$cluster" -o "$folder/look.ppm" --width 64 -q --color-by temperature $look || fail "$look"
  cmp -s "$folder/plain.ppm" "$folder/look.ppm" && fail "$look changes nothing"
done
if fc-match -f '%{file}' sans:bold >"$folder/font"; then
  "$zraka" render "$cluster" -o "$folder/legend.ppm" --width 64 -q --color-by temperature --legend || fail "--legend"
  python3 - "$folder/plain.ppm" "$folder/legend.ppm" <<'END' || fail "--legend is not beside the picture"
import sys

def rows(path):
    magic, width, height, most, pixels = open(path, "rb").read().split(maxsplit=4)
    width = 3 * int(width)
    return width, [pixels[i:i + width] for i in range(0, len(pixels), width)]

(width, plain), (wider, legend) = rows(sys.argv[1]), rows(sys.argv[2])
sys.exit(wider <= width or any(row[:width] != own for row, own in zip(legend, plain)))
END
fi
expect 2 "--cut: '0,0,0,1' is not X,Y,Z,D with commas between the numbers" "$zraka" render "$cluster" -o "$folder/x.png" --cut 0,0,0,1
expect 2 "--cut-eye-only is for --cut, which is not there" "$zraka" explain "$cluster" 1 1 --cut-eye-only
expect 2 "--color-map is for --color-by with a column" "$zraka" render "$cluster" -o "$folder/x.png" --color-map grey
expect 2 "--legend makes the picture wider: it does not go with --transparent" \
  "$zraka" render "$cluster" -o "$folder/x.png" --legend --transparent
expect 1 "there are no colours that --legend could explain" "$zraka" render "$cluster" -o "$folder/x.png" --legend
expect 1 "--color-by is for files of particles alone" "$zraka" render "$scene" -o "$folder/x.png" --color-by temperature
printf '[scene]\nfog = {kind = "linear", start = 1, end = 9, color = 1}\n[[shape]]\nkind = "plane"\npoint = [0, -1, 0]\nnormal = [0, 1, 0]\n' >"$folder/fog.toml"
expect 1 "the scene has fog, and --depth-cue would be another" "$zraka" render "$folder/fog.toml" -o "$folder/x.png" --depth-cue
sed -i 1,2d "$folder/fog.toml"
expect 1 "nothing is in front of the eye that could fade" "$zraka" render "$folder/fog.toml" -o "$folder/x.png" --depth-cue
expect 0 "this is the cap of cut 1" "$zraka" explain "$cluster" 640 360 --cut 0,0,1,0.1 -q
expect 0 "An outline goes over this pixel" "$zraka" explain "$scene" 0 0 --width 2 --height 2 --outlines 8

# Scenes of other programs, by what they hold.
for model in scenes/gltf/octahedra.gltf scenes/nff/benzene.nff scenes/tachyon/water.dat; do
  "$zraka" info "$model" 2>/dev/null >"$folder/named"
  gzip -c "$model" | "$zraka" info - 2>/dev/null | cmp -s - "$folder/named" || fail "$model on standard input"
done
printf 'OFF\n3 1 0\n0 0 0\n1 0 0\n0 1 0\n3 0 1 2\n' >"$folder/mesh"
expect 0 "note: 1 triangle; light and camera are chosen here" "$zraka" render "$folder/mesh" -o "$folder/mesh.png" --width 32
expect 0 "lost in POV-Ray" "$zraka" convert scenes/lab/input.txt "$folder/scene.pov"
expect 2 "--to: 'obj' is not nff, toml, tachyon, povray or lab" "$zraka" convert scenes/lab/input.txt - --to obj
for isa in $("$zraka" --version | sed -n 's/^this machine has://p'); do
  "$zraka" render "$scene" -o "$folder/b.png" --isa "$isa" --threads 1 --tile 5 || fail "$isa"
  cmp -s "$folder/a.png" "$folder/b.png" || fail "$isa gives other bytes"
done
expect 0 '"camera": 100,' "$zraka" render "$scene" -o "$folder/b.png" --width 010 --stats=json  # not octal
expect 0 '"isa": "portable"' "$zraka" render "$scene" -o "$folder/b.png" --isa portable --stats=json
words=$("$zraka" render "$scene" -o "$folder/b.png" --width 500 --threads 8 2>&1) || fail "8 threads"
[ -z "$words" ] || fail "8 threads say: $words"
for key in load build render write camera shadow reflected refracted hits scene accel threads isa sha256; do
  grep -q "\"$key\"" "$folder/words" || fail "--stats=json has no $key"
done
expect 0 "sha256" "$zraka" render --stats "$scene" -o "$folder/b.png"

# Bad input: an answer at once, exit code 1, nothing written.
bad() {
  local text=$1
  shift
  rm -f "$folder/bad.png"
  expect 1 "$text" timeout 5 "$zraka" render "$@" -o "$folder/bad.png"
  [ -e "$folder/bad.png" ] && fail "a picture of bad input: $*"
}
bad "cannot be read: No such file or directory" "$folder/nowhere.txt"
bad "is a folder, not a file" "$folder"
: >"$folder/empty.txt"
bad "the file is empty" "$folder/empty.txt"
head -c 100000 /dev/urandom >"$folder/noise.txt"
bad "the file is not text" "$folder/noise.txt"
printf '0,0,2:2:400:0,2,-2:1000000000:' >"$folder/many.txt"
bad "has room for 0 at most" "$folder/many.txt"
printf '0,0,2:2:1000000000:0,2,-2:0' >"$folder/large.txt"
bad "expected 11585 at most" "$folder/large.txt"
bad "too large: at most 134217728 pixels fit" "$scene" --width 1000000
if [ "$(id -u)" != 0 ]; then
  "$zraka" generate sphereflake --size 2 -o "$folder/flake.nff"
  exactly 0 "" bash -c "ulimit -u 1; exec '$zraka' render '$folder/flake.nff' -o '$folder/b.png' --threads 1 --stats"
  expect 1 "the system starts no more threads for this user" \
    bash -c "ulimit -u 1; exec '$zraka' render '$folder/flake.nff' -o '$folder/b.png' --threads 2"
  cp "$scene" "$folder/secret.txt" && chmod 000 "$folder/secret.txt"
  bad "cannot be read: Permission denied" "$folder/secret.txt"
fi
expect 1 "the file is empty" "$zraka" info "$folder/empty.txt"

# Output that cannot be written: exit code 1, the old file as it was.
expect 2 "is not the name of a picture" "$zraka" render "$scene" -o "$folder/a.nff"
expect 1 "does its folder exist?" "$zraka" render "$scene" -o "$folder/no/a.png"
expect 1 "it is a folder" "$zraka" render "$scene" -o "$folder"
expect 1 "/dev/full: error: cannot be written: No space left on device" "$zraka" render "$scene" -o /dev/full
expect 1 "standard output: error: cannot be written: No space left on device" \
  bash -c "'$zraka' render $scene -o - >/dev/full"
echo old >"$folder/old.png"
expect 1 "error" bash -c "ulimit -f 8; '$zraka' render $scene -o '$folder/old.png'"
[ "$(cat "$folder/old.png")" = old ] || fail "a failed write changed the old file"
[ "$(find "$folder" -name 'old.png*' | wc -l)" = 1 ] || fail "a failed write left a file behind"

# Stages: seven pictures, six differences, one sheet.
expect 0 "contact-sheet.png" "$zraka" stages "$scene" -o "$folder/stages/deep" --width 60
cp "$folder/words" "$folder/stages.out"
[ "$(find "$folder/stages/deep" -name '*.png' | wc -l)" = 14 ] || fail "stages wrote $(ls "$folder/stages/deep")"
# It counts the pixels that its files differ in.
for pair in 1-silhouette:2-ambient 2-ambient:3-diffuse 3-diffuse:4-specular; do
  counted=$("$zraka" compare "$folder/stages/deep/${pair%:*}.png" "$folder/stages/deep/${pair#*:}.png" | sed -n '1s/ of .*//p')
  grep -qF ": $counted of 3 600 pixels change" "$folder/stages.out" || fail "stages says not that $counted pixels change"
done
expect 1 "cannot be made a folder" "$zraka" stages "$scene" -o "$folder/old.png"

# Letters.
"$zraka" generate letter Đ -o "$folder/letter.txt" || fail "generate letter"
expect 0 "spheres" "$zraka" info "$folder/letter.txt"
expect 1 "no visible letter" "$zraka" generate letter " " -o "$folder/none.txt"
printf '[[light]]\nkind = "directional"\ndirection = [-3, -4, -5]\n[[light]]\nkind = "disc"\ncenter = [1, 2, 3]\n' \
  >"$folder/lights.toml"
expect 0 "light       directional, towards (-3, -4, -5)" "$zraka" info "$folder/lights.toml"
expect 0 "light       disc, at (1, 2, 3)" "$zraka" info "$folder/lights.toml"
expect 0 '"sphere"' "$zraka" info "$folder/letter.txt" --format json

# Ctrl-C: at once, exit code 130, no half file.
"$zraka" render "$scene" -o "$folder/slow.png" --width 11000 --max-depth 20 &
sleep 0.3
kill -INT $!
wait $!
[ $? = 130 ] || fail "Ctrl-C does not end with 130"
[ "$(find "$folder" -name 'slow.png*' | wc -l)" = 0 ] || fail "Ctrl-C leaves a file"

finish
