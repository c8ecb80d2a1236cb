#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0
# grade_page.sh PROGRAM: the page of a grade in a browser, Chromium, at the width of a desk and of a phone: all pictures are there, nothing
# logs an error, nothing is wider than the window. Without Chromium the test is skipped (77).
. "$(dirname "$0")/helpers.sh"
find_browser
mkdir "$folder/ana"
for stage in 1 4 6; do
  "$zraka" render scenes/lab/input.txt --width 120 --stage $stage --mistake half-vector -o "$folder/ana/$stage.png" -q || fail "render"
done
"$zraka" grade scenes/lab/input.txt --width 120 "$folder/ana" --lang hr -o "$folder/ana.html" || fail "no page"
cat >"$folder/probe.js" <<'JS'
<script>
addEventListener('error', (e) => { document.documentElement.dataset.error = e.message; });
addEventListener('load', () => {
  const root = document.documentElement;
  root.dataset.wide = root.scrollWidth - root.clientWidth;
  root.dataset.images = [...document.images].filter((i) => i.naturalWidth === 120).length;
  root.dataset.stages = document.querySelectorAll('article h2').length;
  root.dataset.marks = document.querySelectorAll('.mark').length;
});
</script>
JS
for width in 1280 500; do
  browse "$folder/ana.html" $width
  for want in 'data-wide="0"' 'data-images="9"' 'data-stages="7"' 'data-marks="12"'; do
    echo "$root" | grep -q "$want" || fail "no $want at $width: $root"
  done
done
finish
