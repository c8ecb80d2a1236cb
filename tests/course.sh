#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0
# course.sh PROGRAM: what docs/course says is true. Its commands run, what it quotes from them is what they print, its files and
# functions exist, and both languages have the same pictures, functions and commands.
set -u
zraka=$1
root=$PWD
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
failed=0
fail() {
  echo "FAILED: $*"
  failed=1
}
cp -r scenes "$folder/"
for page in docs/course/README.md docs/course/README.hr.md; do
  # Commands, and the quotations that follow them.
  : >"$folder/printed"
  quoting=0
  while IFS= read -r line; do
    case $line in
      '    ./run '*)
        command=${line#    ./run }
        (cd "$folder" && eval "\"$zraka\" $command" >printed 2>errors </dev/null) ||
          fail "$page: $command: $(head -n 1 "$folder/errors")"
        ;;
      '```text') quoting=1 ;;
      '```') quoting=0 ;;
      *)
        [ $quoting = 0 ] || grep -qxF -- "$line" "$folder/printed" || fail "$page: nothing prints: $line"
        ;;
    esac
  done <"$page"
  # Links and functions.
  for link in $(grep -o ']([^)]*)' "$page" | sed 's/](\(.*\))/\1/'); do
    [ -e "docs/course/$link" ] || fail "$page: there is no $link"
  done
  grep -o '`[a-z_]*()`[^]]*\[src/[^]]*\]' "$page" >"$folder/functions"
  while IFS= read -r pair; do
    file=${pair##*[}
    file=${file%]}
    for function in $(echo "$pair" | grep -o '`[a-z_]*()`' | tr -d '`()'); do
      grep -q "\b$function(" "$root/$file" || fail "$page: there is no $function() in $file"
    done
  done <"$folder/functions"
  [ "$(wc -l <"$folder/functions")" -ge 12 ] || fail "$page names too few functions"
done
for page in docs/course/README.md docs/course/README.hr.md; do
  [ "$(grep -c '^```text' "$page")" = 7 ] || fail "$page quotes $(grep -c '^```text' "$page") answers, not 7"
done
for what in '](pictures[^)]*)' '`[a-z_]*()`' '^    \./run .*' '^## [0-9]*'; do
  diff <(grep -o -- "$what" docs/course/README.md | sed 's/ --lang hr//') \
    <(grep -o -- "$what" docs/course/README.hr.md | sed 's/ --lang hr//') >"$folder/diff" ||
    { fail "the languages differ:"; cat "$folder/diff"; }
done
[ $failed = 0 ] && echo "all well"
exit $failed
