# SPDX-License-Identifier: Apache-2.0
# For the scripts beside it, whose first argument is the program: $zraka, a $folder of their own, and words for what they expect.
# shellcheck shell=bash
set -u
zraka=${1-}
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
failed=0

fail() {
  echo "FAILED: $*"
  failed=1
}
# expect CODE TEXT COMMAND…: the exit code, and text that standard error or output has.
expect() {
  local code=$1 text=$2 got
  shift 2
  "$@" >"$folder/words" 2>&1 </dev/null
  got=$?
  [ "$got" = "$code" ] || fail "exit code $got instead of $code: $* ($(head -c 300 "$folder/words"))"
  grep -qF -- "$text" "$folder/words" || fail "no '$text' from: $* ($(head -c 300 "$folder/words"))"
}
# exactly CODE TEXT COMMAND…: the exit code, and all that standard error says.
exactly() {
  local code=$1 text=$2 got words
  shift 2
  words=$("$@" 2>&1 >/dev/null </dev/null)
  got=$?
  [ "$got" = "$code" ] || fail "exit code $got instead of $code: $*"
  [ "$words" = "$text" ] || fail "'$words' instead of '$text' from: $*"
}
# contains FILE TEXT
contains() {
  grep -qF -- "$2" "$1" || { fail "no '$2' in"; cat "$1"; }
}
# open_page SIGN ADDRESS WIDTH: opens the page in Chromium and puts it into $folder/dom as it is after its scripts, and what Chromium says into
# $folder/log. Up to five times till the page carries SIGN, the mark of a script that has ended: the browser's clock doesn't wait for images
# that a busy machine is slow to decode.
open_page() {
  for _ in 1 2 3 4 5; do
    timeout -k 5 120 "$browser" --headless --no-sandbox --disable-gpu --user-data-dir="$folder/profile" --window-size="$3",900 \
      --virtual-time-budget=5000 --enable-logging=stderr --dump-dom "$2" >"$folder/dom" 2>"$folder/log" </dev/null || return 2
    grep -qF -- "$1" "$folder/dom" && return 0
  done
  echo "five times without $1"
  return 1
}
# browse PAGE WIDTH: opens the page with $folder/probe.js, which writes what it finds into the data of <html>, data-wide among them, and
# puts the page's first tag into $root. A script that fails, and what the page logs, are failures.
find_browser() {
  browser=$(command -v chromium || command -v chromium-browser) || exit 77
}
browse() {
  sed "/<head>/r $folder/probe.js" "$1" >"$folder/probed.html"
  open_page 'data-wide="' "file://$folder/probed.html" "$2" || fail "the page at $2 has not come"
  grep -i CONSOLE "$folder/log" && fail "the page logs errors at $2"
  root=$(grep -o '<html[^>]*>' "$folder/dom" | head -n 1)
  echo "$root" | grep -q 'data-error' && fail "a script failed at $2: $root"
}
# finish: the last line of a script.
finish() {
  [ $failed = 0 ] && echo "all well"
  exit $failed
}
