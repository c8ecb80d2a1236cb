#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0
# report.sh PROGRAM: zraka report from outside: words, exit codes, files, the archive.
. "$(dirname "$0")/helpers.sh"
scene=scenes/lab/input.txt

# Wrong usage, bad input.
"$zraka" report --help | grep -q "Examples:" || fail "no examples"
exactly 2 "--output is required
Run 'zraka report --help' for more information." "$zraka" report $scene
exactly 2 "--lang: 'de' is not en or hr
Run 'zraka report --help' for more information." "$zraka" report $scene -o "$folder/x" --lang de
exactly 2 "--zip needs --author
Run 'zraka report --help' for more information." "$zraka" report $scene -o "$folder/x" --zip
exactly 1 "error: '12/..' has no letter for the archive's name
  --author takes a name in Latin letters, as in --author 'Ana Šarić'" "$zraka" report $scene -o "$folder/x" --author 12/.. --zip
exactly 1 "$folder/nowhere.txt: error: cannot be read: No such file or directory
  is the name right, and the folder?" \
  "$zraka" report "$folder/nowhere.txt" -o "$folder/x"
exactly 1 "$folder/nowhere.txt: pogreška: ne može se pročitati: nema takve datoteke ni mape
  jesu li ime i mapa točni?" \
  "$zraka" report "$folder/nowhere.txt" -o "$folder/x" --lang hr
[ -e "$folder/x" ] && fail "a folder without a report"
echo text >"$folder/file"
exactly 1 "$folder/file: error: cannot be made a folder: Not a directory" "$zraka" report $scene -o "$folder/file" --width 20
[ "$(cat "$folder/file")" = text ] || fail "the file is not as it was"

# A report in Croatian, with its archive.
"$zraka" report $scene -o "$folder/hr" --lang hr --author "Ana Šarić" --zip --width 60 >"$folder/words" || fail "no report"
zip="$folder/hr/OVO-V3-Rezultati-AnaŠarić.zip"
want="1-silueta.png 2-ambijentna.png razlika-1-2.png 3-difuzna.png razlika-2-3.png 4-spekularna.png razlika-3-4.png 5-sjene.png \
razlika-4-5.png 6-odbijene-zrake.png razlika-5-6.png 7-refraktirane-zrake.png razlika-6-7.png 8-slovo.png slovo.txt izvjestaj.html"
listed=$(python3 -m zipfile -l "$zip" | tail -n +2 | cut -d' ' -f1 | tr '\n' ' ')
[ "$listed" = "$want " ] || fail "the archive has: $listed"
python3 -m zipfile -t "$zip" | grep -q "Done testing" || fail "the archive is damaged"
mkdir "$folder/unpacked"
python3 -m zipfile -e "$zip" "$folder/unpacked" || fail "the archive cannot be unpacked"
for name in $want; do
  cmp -s "$folder/hr/$name" "$folder/unpacked/$name" || fail "$name is not what the archive has"
done
[ "$(wc -l <"$folder/words")" = 17 ] || fail "not a line for each file"
[ "$(ls "$folder/hr" | wc -l)" = 17 ] || fail "other files: $(ls "$folder/hr")"
grep -q "Autor: Ana Šarić" "$folder/hr/izvjestaj.html" || fail "no author"

# The stages are those of zraka render, the letter's scene is one.
"$zraka" render $scene -o "$folder/7.png" --width 60 -q && cmp "$folder/7.png" "$folder/hr/7-refraktirane-zrake.png" || fail "another picture"
"$zraka" render $scene -o "$folder/5.png" --stage shadows --width 60 -q && cmp "$folder/5.png" "$folder/hr/5-sjene.png" || fail "another stage"
"$zraka" render "$folder/hr/slovo.txt" -o "$folder/8.png" -q && cmp "$folder/8.png" "$folder/hr/8-slovo.png" || fail "another letter"

# Quiet, without an author, over an older report; no letter unless one is asked for.
[ -z "$("$zraka" report $scene -o "$folder/en" --width 30 -q 2>&1)" ] || fail "not quiet"
[ -e "$folder/en/8-letter.png" ] && fail "a letter nobody asked for"
"$zraka" report $scene -o "$folder/en" --width 30 --letter Đ -q || fail "no second report"
[ -e "$folder/en/8-letter.png" ] || fail "no letter"
grep -q "“Đ” built of" "$folder/en/report.html" || fail "the letter is not in the report"
"$zraka" report - -o "$folder/piped" --width 20 -q <$scene || fail "no report from standard input"

finish
