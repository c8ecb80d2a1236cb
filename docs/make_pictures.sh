#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0
# make_pictures.sh PROGRAM: brings shapes.md and textures.md beside it up to date with what the program does. Every
# scene of a ```toml block below a line <!-- picture: NAME -->, with the page's <!-- head --> before it, is drawn into
# pictures/shapes/NAME.png; every table below a line <!-- keys: KIND --> becomes that of the language's reference.
set -eu
zraka=$(realpath "$1")
cd "$(dirname "$0")"
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
mkdir "$folder/pages"
"$zraka" help --pages "$folder/pages" >"$folder/words"

# write_tables PAGE SECTION: the tables of the kinds that the reference has below the heading SECTION.
write_tables() {
  awk -v section="## $2" '
    NR == FNR {
      if (/^## /) { within = $0 == section; kind = "" }
      if (within && /^### /) { kind = $2; seen = 0 }
      if (kind != "" && /^\|/ && seen != 2) { table[kind] = table[kind] $0 "\n"; seen = 1 }
      else if (seen == 1) seen = 2
      next
    }
    skipping && (/^\|/ || /^$/) { next }
    skipping { skipping = 0; print "" }
    { print }
    /^<!-- keys: / {
      if (!($3 in table)) { print FILENAME ": the language has no " $3 >"/dev/stderr"; exit 1 }
      printf "\n%s", table[$3]
      skipping = 1
    }' "$folder/pages/reference.md" "$1" >"$folder/page"
  cmp -s "$folder/page" "$1" || cp "$folder/page" "$1"
}

# draw PAGE
draw() {
  local scenes=$folder/${1%.md} scene
  mkdir "$scenes" "$scenes/drawn"
  cp examples/* "$scenes/drawn/"
  awk -v folder="$scenes" '
    /^<!-- head -->$/ { name = "head"; next }
    /^<!-- picture: / { name = "scene." $3; next }
    /^```toml$/ && name != "" { out = folder "/" name; printf "" >out; next }
    /^```$/ { out = name = "" }
    out != "" { print >out }' "$1"
  for scene in "$scenes"/scene.*; do
    name=${scene##*/scene.}
    cat "$scenes/head" "$scene" >"$scenes/drawn/$name.toml"
    "$zraka" render "$scenes/drawn/$name.toml" -o "pictures/shapes/$name.png" >"$folder/words" 2>&1 ||
      { echo "$1: $name:"; cat "$folder/words"; exit 1; }
  done
}

mkdir -p pictures/shapes
write_tables shapes.md '[[shape]]'
write_tables textures.md '[texture.NAME]'
draw shapes.md
draw textures.md
