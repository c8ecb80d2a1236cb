#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0
# make_pictures.sh PROGRAM: brings pages beside it up to date with what the program does. Every scene of a ```toml block
# below a line <!-- picture: NAME -->, with the page's <!-- head --> before it, is drawn into a folder of pictures; every
# table below a line <!-- keys: KIND --> becomes that of the language's reference; the one below <!-- thresholds --> is
# measured.
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

# draw PAGE FOLDER: the latter is in pictures/.
draw() {
  local scenes=$folder/${1%.md} scene
  mkdir -p "pictures/$2"
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
    "$zraka" render "$scenes/drawn/$name.toml" -o "pictures/$2/$name.png" >"$folder/words" 2>&1 ||
      { echo "$1: $name:"; cat "$folder/words"; exit 1; }
  done
}

# write_thresholds PAGE: what min_contribution saves, and what it costs.
write_thresholds() {
  local scene name t rays all
  number() { sed -n "s/.*\"$1\": \([0-9.e-]*\).*/\1/p" "$2" | head -n 1; }
  {
    echo '| scene | t | reflected and refracted rays | saved | a pixel lacks at most | largest error | mean error |'
    echo '|---|--:|--:|--:|--:|--:|--:|'
    for scene in lab/input.txt lab/bubble.txt lab/tinted.toml; do
      name=$(basename "$scene")
      all=
      for t in 0 1/1024 1/255 1/64; do
        "$zraka" render "../scenes/$scene" -o "$folder/$name.${t//\//.}.png" --width 160 --samples 1 --max-depth 12 \
          --min-contribution "$(awk "BEGIN { print $t }")" --stats=json -q >"$folder/stats"
        rays=$(($(number reflected "$folder/stats") + $(number refracted "$folder/stats")))
        all=${all:-$rays}
        "$zraka" compare "$folder/$name.0.png" "$folder/$name.${t//\//.}.png" --format json >"$folder/compared" || true
        awk -v scene="$name" -v t="$t" -v rays="$rays" -v all="$all" -v largest="$(number largest "$folder/compared")" \
          -v mean="$(number mean "$folder/compared")" -v most="$(number most "$folder/stats")" \
          'BEGIN { printf "| %s | %s | %d | %.0f %% | %.3f | %d | %.4f |\n", scene, t, rays, 100 - 100 * rays / all, most, largest, mean }'
      done
    done
  } >"$folder/table"
  awk -v table="$folder/table" '
    skipping && (/^\|/ || /^$/) { next }
    skipping { skipping = 0; print "" }
    { print }
    /^<!-- thresholds -->$/ { print ""; while ((getline line < table) > 0) print line; skipping = 1 }' "$1" >"$folder/page"
  cmp -s "$folder/page" "$1" || cp "$folder/page" "$1"
}

# draw_particles NAME OPTION…: a file of examples, by options of the command line.
draw_particles() {
  local name=$1
  shift
  mkdir -p pictures/particles
  "$zraka" render "examples/$name" -o "pictures/particles/${name%.*}.png" -q "$@"
}

write_tables shapes.md '[[shape]]'
write_tables textures.md '[texture.NAME]'
write_tables lights.md '[[light]]'
draw shapes.md shapes
draw textures.md shapes
draw lights.md lights
draw glass.md glass
draw_particles caffeine.xyz --width 640 --depth-cue --outlines 2 --quality good
draw_particles cluster.csv --width 640 --cut 0.3,0.2,1,0.5 --color-by temperature --color-map plasma --outlines 1
write_thresholds depth.md
