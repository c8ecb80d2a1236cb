#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0
# compare.sh PROGRAM: zraka compare from outside: exit codes, words, JSON, heat maps, the page.
. "$(dirname "$0")/helpers.sh"

"$zraka" render scenes/lab/input.txt -o "$folder/a.png" --width 60 || fail "render"
"$zraka" render scenes/lab/input.txt -o "$folder/b.png" --width 60 --stage shadows || fail "render"
"$zraka" render scenes/lab/input.txt -o "$folder/wide.png" --width 80 --height 60 || fail "render"
printf 'P6 3 1 255\n\x0a\x14\x1e\x00\x00\x00\xff\xff\xff' >"$folder/x.ppm"
printf 'P6 3 1 255\n\x0a\x14\x1e\x00\x03\x00\xff\xff\xff' >"$folder/y.ppm"
printf 'PF 1 1 -1\n\x00\x00\x00\x3f\x00\x00\x00\x3f\x00\x00\x00\x3f' >"$folder/half.pfm"
printf 'P6 1 1 255\n\x80\x80\x80' >"$folder/linear.ppm"
printf 'P6 1 1 255\n\xbc\xbc\xbc' >"$folder/srgb.ppm"

# Exit codes as diff has them.
expect 0 "The pictures are equal." "$zraka" compare "$folder/a.png" "$folder/a.png"
expect 1 "differ." "$zraka" compare "$folder/a.png" "$folder/b.png"
expect 1 "1 of 3 pixels (33.33 %) differ." "$zraka" compare "$folder/x.ppm" "$folder/y.ppm"
expect 0 "at most 3 of 255, within the tolerance of 3." "$zraka" compare "$folder/x.ppm" "$folder/y.ppm" --tolerance 3
expect 1 "differ by more than 2.5 of 255" "$zraka" compare "$folder/x.ppm" "$folder/y.ppm" --tolerance 2.5
expect 0 "50 % are allowed" "$zraka" compare "$folder/x.ppm" "$folder/y.ppm" --allow 0.5
expect 1 "The pictures have different sizes." "$zraka" compare "$folder/a.png" "$folder/wide.png"
expect 1 "no heat map and no page were written" "$zraka" compare "$folder/a.png" "$folder/wide.png" --html "$folder/no.html"
[ -e "$folder/no.html" ] && fail "a page of pictures that cannot be compared"
expect 2 "cannot be read: No such file or directory" "$zraka" compare "$folder/a.png" "$folder/nowhere.png"
expect 2 "is no picture of a known kind" "$zraka" compare "$folder/a.png" scenes/lab/input.txt
head -c 500 "$folder/a.png" >"$folder/cut.png"
expect 2 "cut.png: error: is no PNG that can be read: the file ends too early" "$zraka" compare "$folder/cut.png" "$folder/a.png"
printf 'P6 40000 40000 255\n' >"$folder/huge.ppm"
expect 2 "is too large: 40000×40000 pixels" "$zraka" compare "$folder/huge.ppm" "$folder/a.png"
expect 2 "B is required" "$zraka" compare "$folder/a.png"
expect 2 "--tolerance" "$zraka" compare "$folder/a.png" "$folder/b.png" --tolerance 256
expect 2 "--allow" "$zraka" compare "$folder/a.png" "$folder/b.png" --allow 2
expect 2 "--format" "$zraka" compare "$folder/a.png" "$folder/b.png" --format xml
expect 2 "Only one of the pictures can be standard input." "$zraka" compare - -
expect 2 "Only one output can be standard output." "$zraka" compare "$folder/a.png" "$folder/b.png" --heat - --html -
expect 2 "a.png: error: would be written over an input of this command" "$zraka" compare "$folder/a.png" "$folder/b.png" --heat "$folder/a.png"
expect 2 "b.png: error: would be written over an input of this command" "$zraka" compare "$folder/a.png" "$folder/b.png" --html "$folder/b.png"
expect 2 "'heat.jpg' is not the name of a PNG" "$zraka" compare "$folder/a.png" "$folder/b.png" --heat heat.jpg
expect 2 "does its folder exist?" "$zraka" compare "$folder/a.png" "$folder/b.png" --heat "$folder/no/heat.png"
expect 2 "does its folder exist?" "$zraka" compare "$folder/a.png" "$folder/b.png" --html "$folder/no/page.html"
expect 2 "standard output: error: cannot be written" bash -c "'$zraka' compare '$folder/a.png' '$folder/b.png' >/dev/full"
"$zraka" compare - "$folder/a.png" <"$folder/a.png" >/dev/null || fail "standard input"

# Quiet: not a word, only the code.
"$zraka" compare "$folder/a.png" "$folder/b.png" --quiet >"$folder/words" 2>&1
[ $? = 1 ] && [ ! -s "$folder/words" ] || fail "--quiet: $(cat "$folder/words")"

# The numbers in words and in JSON.
expect 1 "largest   3 of 255" "$zraka" compare "$folder/x.ppm" "$folder/y.ppm"
expect 1 "first     (1, 0): (0, 0, 0) against (0, 3, 0)" "$zraka" compare "$folder/x.ppm" "$folder/y.ppm"
expect 1 "where     columns 1 to 1, rows 0 to 0" "$zraka" compare "$folder/x.ppm" "$folder/y.ppm"
expect 1 "SSIM      none" "$zraka" compare "$folder/x.ppm" "$folder/y.ppm"
expect 1 '"largest": 3.0,' "$zraka" compare "$folder/x.ppm" "$folder/y.ppm" --format json
for text in '"within": false' '"same_size": true' '"pixels": 1' '"left": 1' '"ssim": null' '"unit": "1/255"' \
    '"format": "PPM"' '"rmse": 1.0'; do
  grep -qF -- "$text" "$folder/words" || fail "no $text in JSON: $(cat "$folder/words")"
done
expect 0 '"psnr_db": null' "$zraka" compare "$folder/a.png" "$folder/a.png" --format json
expect 1 '"same_size": false' "$zraka" compare "$folder/a.png" "$folder/wide.png" --format json
cp "$folder/a.png" "$folder/$(printf 'na\xffme.png')"
expect 0 '"within": true' "$zraka" compare "$folder"/na*me.png "$folder/a.png" --format json

# Floats against integers: the curve is asked for, and a hint where the other one fits.
expect 0 "A's light went through the sRGB curve" "$zraka" compare "$folder/half.pfm" "$folder/srgb.ppm"
expect 1 "compare with --transfer linear" "$zraka" compare "$folder/half.pfm" "$folder/linear.ppm"
expect 0 "A's light was taken as it is" "$zraka" compare "$folder/half.pfm" "$folder/linear.ppm" --transfer linear

# Heat maps and the page are whole, and the same each time.
"$zraka" compare "$folder/a.png" "$folder/b.png" -q --heat "$folder/heat.png" --html "$folder/page.html"
[ $? = 1 ] || fail "--heat and --html"
expect 0 "The pictures are equal." "$zraka" compare "$folder/heat.png" "$folder/heat.png"
grep -qF "60 × 60 pixels, PNG" "$folder/words" || fail "the heat map's size"
"$zraka" compare "$folder/a.png" "$folder/b.png" -q --heat "$folder/flip.png" --heat-of flip
expect 1 "differ" "$zraka" compare "$folder/heat.png" "$folder/flip.png"
"$zraka" compare "$folder/a.png" "$folder/b.png" --html - >"$folder/again.html"
cmp -s "$folder/page.html" "$folder/again.html" || fail "the page differs from one run to the next"
grep -q "</html>" "$folder/page.html" || fail "the page has no end"
grep -qE 'https?:|src="[^d]|url\(|@import' "$folder/page.html" && fail "the page wants something from outside"
grep -qF "$folder" "$folder/page.html" && fail "the page tells the names of folders"

# In a browser, where there is one: the page starts, shows the worst pixel, and reports no error.
browser=$(command -v chromium || command -v chromium-browser || command -v google-chrome || true)
if [ -n "$browser" ]; then
  "$zraka" compare "$folder/x.ppm" "$folder/y.ppm" -q --html "$folder/small.html"
  for view in slider side blink difference flip; do
    open_page 'data-ready="yes"' "file://$folder/small.html#$view" 900 || fail "the page as $view has not come"
    for text in 'data-ready="yes"' "data-view=\"$view\"" 'id="value-place">(1, 0)<' '+3, 0'; do
      grep -qF -- "$text" "$folder/dom" || fail "the page as $view has no $text"
    done
    grep -i 'CONSOLE' "$folder/log" && fail "the page as $view writes to the console"
  done
else
  echo "no browser: the page has not been opened"
fi

finish
