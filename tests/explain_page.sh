#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0
# explain_page.sh PROGRAM: the page of a pixel in a browser, Chromium, at the width of a desk and of a phone: its script draws every
# ray, nothing logs an error, nothing is wider than the window. Without Chromium the test is skipped (77).
. "$(dirname "$0")/helpers.sh"
find_browser
"$zraka" explain scenes/lab/input.txt 230 250 -o "$folder/pixel.html" --lang hr || fail "no page"
# What the page knows about itself, for --dump-dom to show.
cat >"$folder/probe.js" <<'JS'
<script>
addEventListener('error', (e) => { document.documentElement.dataset.error = e.message; });
addEventListener('load', () => {
  document.querySelector('[data-fold=open]').click();
  document.querySelector('[data-view=side]').click();
  document.querySelector('#space .touch').dispatchEvent(new MouseEvent('click'));
  document.documentElement.dataset.wide = document.documentElement.scrollWidth - document.documentElement.clientWidth;
  document.documentElement.dataset.open = document.querySelectorAll('details[open]').length;
  document.documentElement.dataset.chosen = document.querySelectorAll('.ray.chosen').length;
  document.documentElement.dataset.images = [...document.images].filter((i) => i.naturalWidth > 0).length;
});
</script>
JS
rays=$(grep -c '<details' "$folder/pixel.html")
for width in 1280 500; do
  browse "$folder/pixel.html" $width
  for want in 'data-ready="[1-9][0-9]*"' "data-open=\"$rays\"" 'data-chosen="1"' 'data-images="2"' 'data-wide="0"'; do
    echo "$root" | grep -q "$want" || fail "no $want at $width: $root"
  done
  sed 's/base64,[^"]*//g' "$folder/dom" | grep -q 'NaN' && fail "the drawing has no numbers at $width"
done
finish
