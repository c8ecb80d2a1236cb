#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0
# shells.sh PROGRAM: what bash, zsh and fish complete, and the manual pages, follow from the options.
. "$(dirname "$0")/helpers.sh"
zraka=$1
for shell in bash zsh fish; do
  "$zraka" help --completions $shell >"$folder/$shell" || fail "no completions for $shell"
done
"$zraka" help --completions tcsh 2>"$folder/words" && fail "tcsh is known"
contains "$folder/words" "'tcsh' is not bash, zsh or fish"

# What bash proposes for the words.
proposed() {
  bash -c '. "$1"; shift; COMP_WORDS=("$@"); COMP_CWORD=$(($# - 1)); compopt() { :; }; _zraka; echo "${COMPREPLY[@]}"' \
    - "$folder/bash" "$@"
}
proposes() {  # EXPECTED WORD…
  local expected=$1 got
  shift
  got=$(proposed "$@")
  [ "$got" = "$expected" ] || fail "after '$*' bash proposes '$got', not '$expected'"
}
proposes "report" zraka rep
proposes "letter" zraka generate let
proposes "--profile" zraka render scene.toml --prof
proposes "lab physical spd tachyon" zraka render --profile ""
proposes "physical" zraka render scene.toml --profile ph
proposes "--stats --stats=text --stats=json" zraka render --stats
proposes "normal-outward" zraka stages --mistake normal-o
proposes "sphere" zraka help spher
proposes "" zraka render ""       # names of files
proposes "" zraka render --width ""

# Every option of every command is proposed, and has its place in a manual page.
"$zraka" help --manual "$folder/manual" || fail "no manual"
commands=$(proposed zraka "")
[ "$(wc -w <<<"$commands")" -gt 12 ] || fail "few commands: $commands"
for command in $commands; do
  page="$folder/manual/zraka-$command.1"
  contains "$page" ".TH ZRAKA"
  for option in $("$zraka" "$command" --help | grep -o '^  \(-[a-z],\)\?--[a-z-]*' | grep -o -e '--.*'); do
    [[ " $(proposed zraka "$command" "$option") " == *" $option "* ]] || fail "$command $option is not completed"
    grep -qF -e "${option//-/\\-}" "$page" || fail "$command $option is not in its manual page"
  done
done
contains "$folder/manual/zraka-render.1" "zraka render scenes/lab/input.txt"
contains "$folder/manual/zraka-tachyon.1" "aasamples N"
if command -v man >/dev/null; then
  man --warnings -l "$folder"/manual/*.1 2>"$folder/words" >/dev/null
  [ -s "$folder/words" ] && fail "man warns: $(cat "$folder/words")"
fi

# The other shells read theirs, where they are installed.
if command -v zsh >/dev/null; then
  zsh -n "$folder/zsh" || fail "zsh cannot read its completions"
fi
if command -v fish >/dev/null; then
  fish -n "$folder/fish" || fail "fish cannot read its completions"
  got=$(XDG_CONFIG_HOME=$folder fish -c "source $folder/fish; complete -C 'zraka render --profile ph'" 2>/dev/null | head -n 1)
  [ "${got%%[[:space:]]*}" = physical ] || fail "fish proposes '$got'"
  got=$(XDG_CONFIG_HOME=$folder fish -c "source $folder/fish; complete -C 'zraka generate sphere'" 2>/dev/null | cut -f1 | tr '\n' ' ')
  [ "$got" = "sphereflake spheres " ] || fail "fish proposes '$got'"
fi
finish
