#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0
# report_page.sh PROGRAM: the report in a browser, Chromium, at the width of a desk and of a phone: all pictures are there, nothing logs an
# error, nothing is wider than the window. Without Chromium the test is skipped (77).
. "$(dirname "$0")/helpers.sh"
find_browser
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
for width in 1280 500; do
  browse "$folder/izvjestaj.html" $width
  for want in 'data-wide="0"' 'data-images="14"' 'data-stages="7"' 'data-formulas="7"'; do
    echo "$root" | grep -q "$want" || fail "no $want at $width: $root"
  done
done
finish
