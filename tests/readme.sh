#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0
# readme.sh PROGRAM: every command that README.md shows with arguments runs, and its picture of an error is true.
set -u
zraka=$1
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
cp -r scenes "$folder/"
mkdir "$folder/docs" && cp -r docs/examples "$folder/docs/"
cp scenes/lab/input.txt "$folder/input.txt"
lines=$(sed -n 's/^    \.\/run \([a-z][^#]*\).*/\1/p' README.md)
[ "$(echo "$lines" | wc -l)" -ge 6 ] || { echo "README.md shows too few commands"; exit 1; }
cd "$folder" || exit 1
"$zraka" stages scenes/lab/input.txt -o pictures >words 2>&1 || { cat words; exit 1; }  # as ./run without arguments
while read -r line; do
  # shellcheck disable=SC2086
  "$zraka" $line >words 2>&1 </dev/null
  code=$?
  # 1 is what compare says of pictures that differ.
  [ $code = 0 ] || [[ $code = 1 && $line = compare* ]] || { echo "FAILED: zraka $line"; cat words; exit 1; }
done <<<"$lines"
sed -i 's|radius => 0.95:|radius => o.5:|' input.txt
"$zraka" info input.txt >words 2>&1
cd - >/dev/null
want=$(sed -n '/^    input.txt:/,/\^$/p' README.md | sed 's/^    //')
[ "$want" = "$(head -n 3 "$folder/words")" ] || { echo "README.md's error is not:"; cat "$folder/words"; exit 1; }
