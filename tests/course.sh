#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0
# course.sh PROGRAM: what docs/course says is true. Its commands run, and once each; what stands in a ```text block is printed by the
# command above it; its pictures are what the commands make, pixel by pixel; its files and functions exist; every mistake of
# `zraka grade --list` has its section; chapters lead to the next and the previous one; and both languages say as much.
. "$(dirname "$0")/helpers.sh"
course=docs/course
mkdir "$folder/work"
cp -r scenes "$folder/work/"

# run COMMAND: the first time it runs; $printed is the file with what it printed. Of a report this is also its page.
declare -A printed_by=() made_by=()
run() {
  local command=$1 output code
  printed=${printed_by[$command]:-}
  [ -z "$printed" ] || return
  printed=$folder/printed.${#printed_by[@]}
  printed_by[$command]=$printed
  (cd "$folder/work" && eval "\"$zraka\" $command" >"$printed" 2>"$folder/errors" </dev/null)
  code=$?
  # 1 is what compare says of pictures that differ.
  [ $code = 0 ] || [[ $code = 1 && $command = compare* ]] || fail "$page: $command: $(head -n 1 "$folder/errors")"
  # Of two commands with one output the second would be judged by what the first has made, or the first by the second.
  output=$(grep -oE -- '(-o|--heat) [^ ]+' <<<"$command")
  if [ -n "$output" ]; then
    [ "${made_by[$output]:=${command% --lang hr}}" = "${command% --lang hr}" ] ||
      fail "$page: another command also writes $output: ${made_by[$output]}"
  fi
  [[ $command != report* ]] || page_of_report "$command" >>"$printed"
}
page_of_report() {
  local name=report output
  [[ $1 != *'--lang hr'* ]] || name=izvjestaj
  output=$(grep -oE -- '-o [^ ]+' <<<"$1")
  LC_ALL=C sed -E -e 's/<(p|li|h[1-6]|tr|figcaption|div)\b[^>]*>/\n/g; s/<[^>]*>//g' -e 's/\xc2\xa0|\xe2\x80\xaf/ /g' \
    -e 's/&lt;/</g; s/&gt;/>/g; s/&quot;/"/g; s/&#39;/'\''/g; s/&amp;/\&/g' "$folder/work/${output#-o }/$name.html"
}
# quoted COMMAND: the lines of $folder/block are in what it printed, in their order. Those of a mistake are not all printed without it.
quoted() {
  local missing right
  [ -s "$folder/block" ] || { fail "$page: an empty quotation of $1"; return; }
  missing=$(awk 'NR == FNR { want[++n] = $0; next } at < n && $0 == want[at + 1] { ++at }
                 END { if (at < n) print want[at + 1] }' "$folder/block" "$printed")
  [ -z "$missing" ] || fail "$page: $1 does not print, or not there: $missing"
  [[ $1 == explain*--mistake* ]] || return
  sed -n 2p "$printed" >"$folder/name"
  right=$(sed -E 's/ --mistake [a-z-]+//' <<<"$1")
  run "$right"
  grep -vxF -f "$folder/name" "$folder/block" | grep -qvxF -f "$printed" || fail "$page: the right program prints the same: $1"
}
# walk PAGE LANGUAGE: commands, and the blocks that follow them.
declare -A speaks=()
walk() {
  local page=$1 language=$2 command='' quoting=0 line verb
  while IFS= read -r line; do
    if [ $quoting = 1 ]; then
      if [ "$line" = '```' ]; then
        if [ -n "$command" ]; then
          run "$command"
          quoted "$command"
        fi
        command=''
        quoting=0
      else
        echo "$line" >>"$folder/block"
      fi
      continue
    fi
    case $line in
      '    ./run '*)
        command=${line#    ./run }
        verb=${command%% *}
        if [ -z "${speaks[$verb]:-}" ]; then
          speaks[$verb]=$("$zraka" "$verb" --help | grep -c -- '--lang')
        fi
        if [ "$language" = hr ] && [ "${speaks[$verb]}" != 0 ]; then
          [[ $command = *' --lang hr' ]] || fail "$page: not in Croatian: $command"
        fi
        # What Croatian words change in a file is for other tests; here they matter where they are quoted.
        [ -n "${printed_by[${command% --lang hr}]:-}" ] || run "$command"
        ;;
      '```text')
        quoting=1
        : >"$folder/block"
        [ -n "$command" ] || fail "$page: a quotation without a command"
        ;;
      '```'*) fail "$page: a block that is no quotation: $line" ;;
      '#'*) command='' ;;  # a quotation does not reach back over a heading
    esac
  done <"$page"
  [ $quoting = 0 ] || fail "$page: a block without an end"
}
# defines FILE FUNCTION: a line that is no comment has a type and then the function's name.
defines() {
  sed 's|//.*||' "$1" | grep -E "^ *[A-Za-z_][A-Za-z0-9_:<>&*, ]*[ &*>]$2\(" | grep -qvE '^ *(return|else|if)\b'
}
links() {
  local page=$1 link line function file
  for link in $(grep -oE '\]\([^)]*\)|src="[^"]*"' "$page" | sed -E 's/^(\]\(|src=")//; s/[)"]$//'); do
    [ -e "$(dirname "$page")/$link" ] || fail "$page: there is no $link"
  done
  while IFS= read -r line; do
    file=$(grep -oE '\[src/[^]]*\]' <<<"$line" | tr -d '[]')
    for function in $(grep -oE '`[a-z_]+\(\)`' <<<"$line" | tr -d '`()'); do
      [ -f "$file" ] && defines "$file" "$function" || fail "$page: $function() is not defined in $file"
    done
  done < <(sed -z 's/\n  \([^ ]\)/ \1/g' "$page" | grep '\[src/')
}
# outline PAGE: what it has in any language.
outline() {
  sed -n 's/ --lang hr$//; s/^    \.\/run /command /p' "$1"
  grep -oE 'pictures/[^")]*' "$1"
  grep -oE '`[a-z_]+\(\)`|\[src/[^]]*\]' "$1"
  grep -E '^### `' "$1"
  echo "$(grep -c '^## ' "$1") sections, $(grep -c '^### ' "$1") below them, $(grep -c '^|' "$1") rows, $(grep -c '^<details>' "$1") answers"
  echo "$(tr -cd '$' <"$1" | wc -c) signs of formulas, $(sed -n '/^```text/,/^```$/p' "$1" | wc -l) lines of quotations"
}
title() {
  sed -n 's/^# //p' "$1" | head -n 1
}
# paragraph: the first one of what comes in, as one line.
paragraph() {
  awk '!NF { exit } { printf "%s%s", space, $0; space = " " }'
}
# leads PAGES…: the chapters of $language, whose first and last paragraph lead to the next, the previous, the contents, the other language.
leads() {
  local i way page other contents=README.md word=Contents name=Hrvatski
  [ "$language" = en ] || { contents=README.hr.md word=Sadržaj name=English; }
  for i in "${!chapters[@]}"; do
    page=${chapters[i]}
    other=${others[i]:-no/page}
    way=''
    [ "$i" = 0 ] || way="[← $(title "${chapters[i - 1]}")]($(basename "${chapters[i - 1]}")) · "
    way+="[$word](../$contents) · "
    [ -z "${chapters[i + 1]:-}" ] || way+="[$(title "${chapters[i + 1]}") →]($(basename "${chapters[i + 1]}")) · "
    way+="[$name](../$(basename "$(dirname "$other")")/$(basename "$other"))"
    [ "$(paragraph <"$page")" = "$way" ] && [ "$(tac "$page" | sed '/^$/q' | tac | sed 1d | paragraph)" = "$way" ] ||
      fail "$page: its first and last paragraph are not: $way"
    [[ $(basename "$page") = $i-* && $(title "$page") = "$i. "* ]] || fail "$page is not chapter $i"
    sed -n "$((i + 1))p" <(grep -oE '\[[0-9]+\. [^]]*\]\([^)]*\)' "$course/$contents") |
      grep -qxF "[$(title "$page")]($language/$(basename "$page"))" || fail "$course/$contents does not lead to $page"
  done
}
# mistakes PAGES…: each has a section, in which it is rendered and explained.
mistakes() {
  local key section verb
  for key in $("$zraka" grade --list | cut -d ' ' -f 1); do
    section=$(sed -n "/^### \`$key\`\$/,/^##/{/^    /p}" "$@")
    for verb in render explain; do
      grep -qE "^    \./run $verb .*--mistake $key( |\$)" <<<"$section" || fail "$language: no section with $verb … --mistake $key"
    done
  done
}

# in_order FOLDER: its chapters, 10 after 9.
in_order() {
  printf '%s\n' "$1"/*.md | sort -V
}
for language in en hr; do
  contents=$course/README.md
  [ $language = en ] || contents=$course/README.hr.md
  mapfile -t chapters < <(in_order "$course/$language")
  if [ $language = en ]; then mapfile -t others < <(in_order $course/hr); else mapfile -t others < <(in_order $course/en); fi
  for page in "$contents" "${chapters[@]}"; do
    walk "$page" $language
    links "$page"
  done
  leads
  mistakes "${chapters[@]}"
done
chapters=("$course/README.hr.md" "${chapters[@]}")
others=("$course/README.md" "${others[@]}")
[ "${#chapters[@]}" = "${#others[@]}" ] || fail "the languages have ${#others[@]} and ${#chapters[@]} pages"
for i in "${!chapters[@]}"; do
  [ -n "${others[i]:-}" ] || continue
  diff <(outline "${others[i]}") <(outline "${chapters[i]}") >"$folder/diff" ||
    { fail "${others[i]} and ${chapters[i]} differ:"; cat "$folder/diff"; }
done

for picture in "$course/pictures/"*; do
  name=$(basename "$picture")
  grep -qF "pictures/$name\"" "$course"/*/*.md || grep -qF "pictures/$name)" "$course"/*/*.md || fail "no chapter shows $picture"
  made=$folder/work/$name
  [ -e "$made" ] || made=$folder/work/stages/$name
  if [ -e "$made" ]; then
    "$zraka" compare "$picture" "$made" --quiet || fail "$picture is not what its command makes"
  else
    fail "no command makes $picture"
  fi
done
[ "$(cat "$course/pictures/"* | wc -c)" -le 1600000 ] || fail "the pictures take more than 1.6 MB"
finish
