#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0
# picture_files.sh PROGRAM: pictures in all formats as the program writes them, read by itself and by other people's programs.
. "$(dirname "$0")/helpers.sh"
scene=scenes/lab/input.txt
draw() {
  "$zraka" render "$scene" --width 90 -q "$@" || fail "render $*"
}

# The same picture in every format, as near as each can be.
draw -o "$folder/a.png"
draw -o "$folder/16.png" --bits 16
draw -o "$folder/a.ppm"
draw -o "$folder/16.ppm" --bits 16
draw -o "$folder/a.exr" --bits 32
draw -o "$folder/half.exr"
draw -o "$folder/a.pfm"
draw -o "$folder/a.hdr"
draw -o "$folder/a.jpeg" --jpeg-quality 100
for pair in a.png:a.ppm 16.png:16.ppm a.exr:a.pfm; do
  "$zraka" compare "$folder/${pair%:*}" "$folder/${pair#*:}" >"$folder/words" || fail "$pair differ: $(cat "$folder/words")"
done
for name in a.exr half.exr a.pfm a.hdr a.jpeg; do
  "$zraka" compare "$folder/a.png" "$folder/$name" --transfer linear --tolerance 5 >"$folder/words" || fail "$name differs: $(cat "$folder/words")"
done
"$zraka" compare "$folder/a.png" "$folder/a.exr" --transfer linear >"$folder/words" || fail "a PNG and its OpenEXR differ: $(cat "$folder/words")"
draw -o "$folder/physical.png" --profile physical --bits 16
draw -o "$folder/physical.exr" --profile physical --bits 32
"$zraka" compare "$folder/physical.png" "$folder/physical.exr" --transfer srgb >"$folder/words" || fail "a PNG of the sRGB curve and its OpenEXR differ: $(cat "$folder/words")"

# Tone mapping is the integers' own.
draw -o "$folder/dark.png" --exposure -2
draw -o "$folder/filmic.png" --tone-map filmic --white 3
draw -o "$folder/clamp.png" --tone-map clamp
cmp -s "$folder/a.png" "$folder/clamp.png" || fail "clamp is not what there is without an option"
cmp -s "$folder/a.png" "$folder/dark.png" && fail "--exposure does nothing"
cmp -s "$folder/a.png" "$folder/filmic.png" && fail "--tone-map does nothing"

# Layers: others make no difference to the colours; nor does who computes them.
draw -o "$folder/layers.exr" --bits 32 --layers all
"$zraka" compare "$folder/a.exr" "$folder/layers.exr" >"$folder/words" || fail "layers change the picture"
draw -o "$folder/again.exr" --bits 32 --layers all --threads 1 --tile 7 --isa portable
cmp -s "$folder/layers.exr" "$folder/again.exr" || fail "layers depend on threads, tiles or the instruction set"
draw -o "$folder/cut.png" --transparent
draw -o "$folder/cut.exr" --transparent --layers depth,object-id

# What does not go together.
exactly 2 "--transparent is for .png, .exr, and not for JPEG
Run 'zraka render --help' for more information." "$zraka" render "$scene" -o "$folder/x.jpg" --transparent
exactly 2 "--layers is for .exr, and not for PNG
Run 'zraka render --help' for more information." "$zraka" render "$scene" -o - --layers depth
expect 2 "--bits 16 is not for JPEG, which has 8" "$zraka" render "$scene" -o "$folder/x.jpg" --bits 16
expect 2 "--bits 8 is not for OpenEXR, which has 16 or 32" "$zraka" render "$scene" -o "$folder/x.exr" --bits 8
expect 2 "'12' is not 8, 16 or 32" "$zraka" render "$scene" -o "$folder/x.png" --bits 12
expect 2 "--tone-map is for .png, .ppm, .jpg, and not for OpenEXR" "$zraka" render "$scene" -o "$folder/x.exr" --tone-map filmic
expect 2 "--exposure is for .png, .ppm, .jpg, and not for PFM" "$zraka" render "$scene" -o "$folder/x.pfm" --exposure 1
expect 2 "'hable' is not clamp, reinhard or filmic" "$zraka" render "$scene" -o "$folder/x.png" --tone-map hable
expect 2 "--white is for --tone-map reinhard and filmic" "$zraka" render "$scene" -o "$folder/x.png" --white 2
expect 2 "--jpeg-quality is for .jpg, and not for PNG" "$zraka" render "$scene" -o "$folder/x.png" --jpeg-quality 90
expect 2 "'101' is not a number from 1 to 100" "$zraka" render "$scene" -o "$folder/x.jpg" --jpeg-quality 101
for list in colour depth, ,depth "depth normal" ""; do
  expect 2 "'$list' is not a list of depth, position, normal, uv, object-id, material-id, rays, tree-depth, cryptomatte, with commas between them, or all" \
    "$zraka" render "$scene" -o "$folder/x.exr" --layers "$list"
done
expect 2 "--layers shows the right picture: it does not go with --mistake" "$zraka" render "$scene" -o "$folder/x.exr" --layers all --mistake no-power
[ "$(find "$folder" -name 'x.*' | wc -l)" = 0 ] || fail "a picture of wrong usage"

# A failure leaves the old file.
for ending in png exr ppm pfm jpg hdr; do
  echo old >"$folder/old.$ending"
  expect 1 "error" bash -c "ulimit -f 8; trap '' XFSZ; '$zraka' render '$scene' -q -o '$folder/old.$ending' --width 400"
  [ "$(cat "$folder/old.$ending")" = old ] || fail "a failure changed a .$ending"
done
[ "$(find "$folder" -name 'old.*' | wc -l)" = 6 ] || fail "a failure leaves a file"

# Other people's programs.
if command -v identify >/dev/null; then
  # is FILE WANTED FORMAT
  is() {
    local got
    got=$(identify -format "$3" "$folder/$1" 2>"$folder/words") || fail "identify cannot read $1: $(cat "$folder/words")"
    [ "$got" = "$2" ] || fail "identify says '$got' of $1, not '$2'"
  }
  is cut.png "PNG 90 90 8 True" "%m %w %h %z %A" || is cut.png "PNG 90 90 8 Blend" "%m %w %h %z %A"
  is 16.png "PNG 90 90 16" "%m %w %h %z"
  is 16.ppm "PPM 90 90 16" "%m %w %h %z"
  is a.jpeg "JPEG 90 90 100" "%m %w %h %Q"
else
  echo "without ImageMagick's identify: not tried"
fi
if command -v pfmtopam >/dev/null && command -v pamtopnm >/dev/null; then
  pfmtopam <"$folder/a.pfm" 2>/dev/null | pamtopnm >"$folder/netpbm.ppm" || fail "netpbm cannot read a PFM"
  "$zraka" compare "$folder/a.png" "$folder/netpbm.ppm" >"$folder/words" || fail "netpbm reads another PFM: $(cat "$folder/words")"
else
  echo "without netpbm: not tried"
fi
if python3 -c 'import OpenEXR' 2>/dev/null; then
  python3 - "$folder/cut.exr" <<'PY' || fail "OpenEXR's Python reads another file"
import sys, OpenEXR
channels = OpenEXR.InputFile(sys.argv[1]).header()["channels"]
sys.exit(sorted(channels) != ["A", "B", "G", "R", "Z", "objectId.X"])
PY
else
  echo "without OpenEXR for Python: not tried"
fi
finish
