#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0
# explain_page.sh PROGRAM: the page of a pixel in a browser, Chromium, at the width of a desk and of a phone: its script draws every
# ray, nothing logs an error, nothing is wider than the window. Without Chromium the test is skipped (77).
set -u
zraka=$1
browser=$(command -v chromium || command -v chromium-browser) || exit 77
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
failed=0
fail() {
  echo "FAILED: $*"
  failed=1
}
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
sed "/<head>/r $folder/probe.js" "$folder/pixel.html" >"$folder/probed.html"
rays=$(grep -c '<details' "$folder/pixel.html")
for width in 1280 500; do
  timeout -k 5 120 "$browser" --headless --no-sandbox --disable-gpu --user-data-dir="$folder/profile" \
    --window-size=$width,900 --virtual-time-budget=3000 --enable-logging=stderr --dump-dom \
    "file://$folder/probed.html" >"$folder/dom" 2>"$folder/log" </dev/null || fail "the browser ended with $?"
  grep -i CONSOLE "$folder/log" && fail "the page logs errors at $width"
  root=$(grep -o '<html[^>]*>' "$folder/dom" | head -n 1)
  for want in 'data-ready="[1-9][0-9]*"' "data-open=\"$rays\"" 'data-chosen="1"' 'data-images="2"' 'data-wide="0"'; do
    echo "$root" | grep -q "$want" || fail "no $want at $width: $root"
  done
  echo "$root" | grep -q 'data-error' && fail "a script failed at $width: $root"
  grep -q 'NaN' "$folder/dom" && fail "the drawing has no numbers at $width"
done
[ $failed = 0 ] && echo "all well"
exit $failed
