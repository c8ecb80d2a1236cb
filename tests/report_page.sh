#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0
# report_page.sh PROGRAM: the report in a browser, Chromium, at the width of a desk and of a phone: all pictures are there, nothing logs an
# error, nothing is wider than the window. Without Chromium the test is skipped (77).
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
"$zraka" report scenes/lab/input.txt -o "$folder" --lang hr --author "Ana Šarić" --width 200 -q || fail "no report"
cat >"$folder/probe.js" <<'JS'
<script>
addEventListener('error', (e) => { document.documentElement.dataset.error = e.message; });
addEventListener('load', () => {
  const root = document.documentElement;
  root.dataset.wide = root.scrollWidth - root.clientWidth;
  root.dataset.images = [...document.images].filter((i) => i.naturalWidth === 200).length;
  root.dataset.stages = document.querySelectorAll('article h3').length;
  root.dataset.formulas = [...document.querySelectorAll('math')].filter((m) => m.getBoundingClientRect().height > 10 && m.scrollWidth <= m.clientWidth).length;
});
</script>
JS
sed "/<head>/r $folder/probe.js" "$folder/izvjestaj.html" >"$folder/probed.html"
for width in 1280 500; do
  timeout -k 5 120 "$browser" --headless --no-sandbox --disable-gpu --user-data-dir="$folder/profile" \
    --window-size=$width,900 --virtual-time-budget=3000 --enable-logging=stderr --dump-dom \
    "file://$folder/probed.html" >"$folder/dom" 2>"$folder/log" </dev/null || fail "the browser ended with $?"
  grep -i CONSOLE "$folder/log" && fail "the page logs errors at $width"
  root=$(grep -o '<html[^>]*>' "$folder/dom" | head -n 1)
  for want in 'data-wide="0"' 'data-images="14"' 'data-stages="7"' 'data-formulas="7"'; do
    echo "$root" | grep -q "$want" || fail "no $want at $width: $root"
  done
  echo "$root" | grep -q 'data-error' && fail "a script failed at $width: $root"
done
[ $failed = 0 ] && echo "all well"
exit $failed
