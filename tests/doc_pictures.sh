#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0
# doc_pictures.sh PROGRAM: docs/shapes.md and the like are what the program does. Each kind of the language has a section
# with its keys and a picture; tables and pictures are byte for byte what docs/make_pictures.sh makes. So are the pictures
# of the scenes in scenes/, whose files check finds no fault with.
. "$(dirname "$0")/helpers.sh"

cp -r docs scenes "$folder/"
docs=$folder/docs
pages="shapes textures lights glass depth"
folders="shapes lights glass particles"
for drawn in $folders; do rm -f "$docs/pictures/$drawn"/*; done
bash "$docs/make_pictures.sh" "$zraka" >"$folder/words" 2>&1 || fail "docs/make_pictures.sh: $(cat "$folder/words")"
for page in $pages; do
  diff "docs/$page.md" "$docs/$page.md" >"$folder/diff" ||
    { fail "docs/$page.md has other tables than docs/make_pictures.sh makes"; head -n 20 "$folder/diff"; }
  for link in $(grep -oE '\]\([^)#]*|src="[^"]*"' "docs/$page.md" | sed -E 's/^(\]\(|src=")//; s/"$//'); do
    [ -e "docs/$link" ] || fail "docs/$page.md: there is no $link"
  done
done
for drawn in $folders; do
  diff -rq "docs/pictures/$drawn" "$docs/pictures/$drawn" ||
    fail "docs/pictures/$drawn is not what docs/make_pictures.sh makes"
  for picture in "docs/pictures/$drawn"/*; do
    grep -qF "pictures/$drawn/$(basename "$picture")\"" docs/*.md || fail "no page shows $picture"
  done
done

# kinds SECTION: those of the program's own reference.
mkdir "$folder/pages"
"$zraka" help --pages "$folder/pages" >"$folder/words" || fail "zraka help --pages"
kinds() {
  awk -v section="## $1" '/^## / { within = $0 == section } within && /^### / { print $2 }' "$folder/pages/reference.md"
}
# sections PAGE SECTION LEAST: each kind has one, of LEAST or more, with a picture and its keys.
sections() {
  local kind count=0
  for kind in $(kinds "$2"); do
    count=$((count + 1))
    sed -n "/^## $kind\$/,/^## /p" "$1" >"$folder/section"
    grep -qF 'src="pictures/' "$folder/section" || fail "$1: no section '## $kind' with a picture"
    grep -qxF "<!-- keys: $kind -->" "$folder/section" || fail "$1: the section '## $kind' has no keys"
  done
  [ $count -ge "$3" ] || fail "the reference has $count kinds below $2"
}
sections docs/shapes.md '[[shape]]' 16
sections docs/textures.md '[texture.NAME]' 8
sections docs/lights.md '[[light]]' 6

for scene in scenes/*.toml; do
  name=$(basename "$scene" .toml)
  # Those whose pixels have several rays are as small as README shows them.
  small=()
  [ -z "$(sed -n '/^\[render\]/,/^$/{/^samples/p}' "$scene")" ] || small=(--width 240)
  exactly 0 "" "$zraka" check "$scene"
  exactly 0 "" "$zraka" render "$scene" -o "$folder/$name.png" "${small[@]}"
  cmp "$folder/$name.png" "docs/pictures/$name.png" || fail "docs/pictures/$name.png is not what $scene draws"
done
finish
