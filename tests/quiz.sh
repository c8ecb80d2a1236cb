#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0
# quiz.sh PROGRAM: zraka quiz from outside: words, exit codes, files, and answers that stay out of the quiz.
. "$(dirname "$0")/helpers.sh"
scene=$PWD/scenes/lab/input.txt
more="
Run 'zraka quiz --help' for more information."
cd "$folder" || exit 1
small="--width 32"

# Wrong usage.
"$zraka" quiz --help | grep -q "Examples:" || fail "no examples"
"$zraka" quiz --help | grep -q -- "--mistake" && fail "--mistake is offered"
exactly 2 "SCENE is required$more" "$zraka" quiz
exactly 2 "--kind: 'shape' is not stage, mistake or color$more" "$zraka" quiz "$scene" --kind shape
exactly 2 "--questions: '0' is not a number from 1 to 100$more" "$zraka" quiz "$scene" --questions 0
exactly 2 "--format: 'pdf' is not html, json or text$more" "$zraka" quiz "$scene" --format pdf
exactly 2 "--lang: 'de' is not en or hr$more" "$zraka" quiz "$scene" --lang de
exactly 2 "--pictures goes with --format json or text: a page has its pictures in it$more" "$zraka" quiz "$scene" --pictures p
exactly 2 "--format text needs --pictures FOLDER for what is asked about pictures, or --kind color$more" "$zraka" quiz "$scene" --format text
exactly 2 "--answers needs a file of its own$more" "$zraka" quiz "$scene" --answers quiz.html
for bad in -1 1.5 x 18446744073709551616; do
  exactly 2 "--seed: '$bad' is not a whole number, 0 or more$more" "$zraka" quiz "$scene" --seed $bad
done

# Bad input, bad output.
exactly 1 "nowhere.txt: error: cannot be read: No such file or directory
  is the name right, and the folder?" "$zraka" quiz nowhere.txt
sed 's/objekata u sceni => 7/objekata u sceni => 0/; /<parametri 1/,$d' "$scene" >empty.txt
exactly 1 "error: nothing can be asked of this picture: no term and no mistake shows in it
  a quiz needs shapes that the eye sees, and light on them" "$zraka" quiz empty.txt $small
exactly 1 "error: a quiz's pictures have 9000000 pixels each: 4194304 at most
  ask for smaller pictures with --width" "$zraka" quiz "$scene" --width 3000
"$zraka" quiz "$scene" $small -o /dev/full 2>/dev/null
[ $? = 1 ] || fail "a full device"
[ "$(ls)" = empty.txt ] || fail "files without a quiz: $(ls)"
exactly 0 "$scene: warning: 2 of 9 questions: the scene gives no more of these kinds" \
  "$zraka" quiz "$scene" $small --stage diffuse --kind stage --questions 9
[ -z "$("$zraka" quiz "$scene" $small --stage diffuse --kind stage --questions 9 -q 2>&1)" ] || fail "not quiet"

# A page; the same seed gives the same one, another seed another.
rm quiz.html
[ "$("$zraka" quiz "$scene" $small)" = quiz.html ] || fail "not the page's name"
"$zraka" quiz "$scene" $small -o - --threads 1 >again.html 2>/dev/null
cmp quiz.html again.html || fail "another page"
"$zraka" quiz - $small -o piped.html -q <"$scene" || fail "no quiz from standard input"
cmp <(sed 's/Scene: [^,]*//' quiz.html) <(sed 's/Scene: [^,]*//' piped.html) || fail "another page from standard input"
"$zraka" quiz "$scene" $small -o other.html --seed 2 -q
cmp -s quiz.html other.html && fail "the seed counts for nothing"
[ "$(grep -c '<article' quiz.html)" = 10 ] && [ "$(grep -c '<details' quiz.html)" = 10 ] || fail "not ten questions with answers"
grep -q 'https\?://' quiz.html && fail "the page needs the network"

# Answers apart: nothing of them in the quiz.
"$zraka" quiz "$scene" $small -o test.html --answers answers.html --seed 5150 >names || fail "no answers"
[ "$(cat names)" = "test.html
answers.html" ] || fail "other names: $(cat names)"
grep -qE '<script|<details|data-right|5150|Missing:|changes most|stored as' test.html && fail "the test tells its answers"
[ "$(grep -c 'class="right"' answers.html)" = 10 ] || fail "not ten answers"
grep -q "Seed: 5150" answers.html || fail "the answers have no seed"

# JSON, with pictures in it and beside it.
"$zraka" quiz "$scene" $small -o quiz.json -q || fail "no JSON"
"$zraka" quiz "$scene" $small --format json --pictures shown >files.json || fail "no JSON with files"
"$zraka" quiz "$scene" $small -o test.json --answers answers.json -q || fail "no JSON without answers"
python3 - <<'PY' || fail "the JSON"
import base64, json
quiz, files, test, answers = (json.load(open(f + '.json')) for f in ('quiz', 'files', 'test', 'answers'))
assert len(quiz) == len(files) == len(test) == len(answers) == 10
for q, f, t, a in zip(quiz, files, test, answers):
    for shown, file in zip(q['pictures'], f['pictures']):
        assert base64.b64decode(shown['src'].split(',')[1]) == open(file['src'], 'rb').read()
    assert q['choices'][q['answer']]['text'] == a['right'] and q['reason'] == a['reason']
    assert set(t) <= {'kind', 'question', 'pictures', 'facts', 'choices'}
    assert t['choices'] == q['choices']
    if q['kind'] == 'color':
        assert [s is None for s in q['slips']] == [i == q['answer'] for i in range(len(q['choices']))]
PY
rm -r shown

# Text, in Croatian.
"$zraka" quiz "$scene" $small --format text --kind color --questions 3 --lang hr >text || fail "no text"
grep -q "^1. Koje je boje piksel (" text && grep -q "^Odgovori$" text || fail "the text is: $(cat text)"
"$zraka" quiz "$scene" $small -o quiz.txt --pictures shown --answers - >text || fail "no text with pictures"
grep -q "^Answers$" text && ! grep -q "^Answers$" quiz.txt || fail "the answers are in the wrong file"
[ -e shown/picture-1.png ] && grep -q "shown/picture-1.png" quiz.txt || fail "no pictures"

finish
