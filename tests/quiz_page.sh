#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0
# quiz_page.sh PROGRAM: the quiz in a browser, Chromium, at the width of a desk and of a phone: the first choice of each question
# counts, is marked, and unfolds the answer; nothing logs an error, nothing is wider than the window. Without Chromium the test is
# skipped (77).
. "$(dirname "$0")/helpers.sh"
find_browser
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
images=$(grep -c '<img' "$folder/quiz.html")
for width in 1280 500; do
  browse "$folder/quiz.html" $width
  for want in 'data-before="Točnih odgovora: 0 od 10; 0 open"' 'data-after="Točnih odgovora: 4 od 10; 10 open, 10 good, 6 bad"' \
    'data-again="Točnih odgovora: 0 od 10; 0 open, 0 marks"' "data-images=\"$images\"" 'data-wide="0"'; do
    echo "$root" | grep -q "$want" || fail "no $want at $width: $root"
  done
done
finish
