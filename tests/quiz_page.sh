#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0
# quiz_page.sh PROGRAM: the quiz in a browser, Chromium, at the width of a desk and of a phone: the first choice of each question
# counts, is marked, and unfolds the answer; nothing logs an error, nothing is wider than the window. Without Chromium the test is
# skipped (77).
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
"$zraka" quiz scenes/lab/input.txt -o "$folder/quiz.html" --lang hr --width 120 -q || fail "no quiz"
cat >"$folder/probe.js" <<'JS'
<script>
addEventListener('error', (e) => { document.documentElement.dataset.error = e.message; });
addEventListener('load', () => {
  const root = document.documentElement;
  const count = (what) => document.querySelectorAll(what).length;
  const score = () => document.querySelector('.score output').textContent;
  root.dataset.before = `${score()}; ${count('details[open]')} open`;
  // Four right, six wrong; a second choice changes nothing.
  [...document.querySelectorAll('article')].forEach((question, i) => {
    const right = Number(question.querySelector('[data-right]').dataset.right);
    const choices = question.querySelectorAll('.choice');
    choices[i < 4 ? right : (right + 1) % choices.length].click();
    choices[right].click();
  });
  root.dataset.after = `${score()}; ${count('details[open]')} open, ${count('.good')} good, ${count('.bad')} bad`;
  root.dataset.images = [...document.images].filter((i) => i.naturalWidth === 120).length;
  root.dataset.wide = root.scrollWidth - root.clientWidth;
  document.querySelector('.score button').click();
  root.dataset.again = `${score()}; ${count('details[open]')} open, ${count('.verdict')} marks`;
});
</script>
JS
sed "/<head>/r $folder/probe.js" "$folder/quiz.html" >"$folder/probed.html"
images=$(grep -c '<img' "$folder/quiz.html")
for width in 1280 500; do
  timeout -k 5 120 "$browser" --headless --no-sandbox --disable-gpu --user-data-dir="$folder/profile" \
    --window-size=$width,900 --virtual-time-budget=3000 --enable-logging=stderr --dump-dom \
    "file://$folder/probed.html" >"$folder/dom" 2>"$folder/log" </dev/null || fail "the browser ended with $?"
  grep -i CONSOLE "$folder/log" && fail "the page logs errors at $width"
  root=$(grep -o '<html[^>]*>' "$folder/dom" | head -n 1)
  for want in 'data-before="Točnih odgovora: 0 od 10; 0 open"' 'data-after="Točnih odgovora: 4 od 10; 10 open, 10 good, 6 bad"' \
    'data-again="Točnih odgovora: 0 od 10; 0 open, 0 marks"' "data-images=\"$images\"" 'data-wide="0"'; do
    echo "$root" | grep -q "$want" || fail "no $want at $width: $root"
  done
  echo "$root" | grep -q 'data-error' && fail "a script failed at $width: $root"
done
[ $failed = 0 ] && echo "all well"
exit $failed
