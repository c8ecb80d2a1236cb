#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0
# quick.sh ZRAKA PROGRAMS: everything of the benchmarks once and tiny, so that they cannot rot. Times are not judged;
# bits, pictures and tables are. Exit code 77: skipped.
set -u
zraka=$1
programs=$2
cd "$(dirname "$(readlink -f "$0")")" || exit 1
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
failed=0
fail() {
  echo "FAILED: $*"
  failed=1
}

command -v python3 >/dev/null || { echo "skipped: python3 is not there (package python3)"; exit 77; }
export PYTHONDONTWRITEBYTECODE=1
macro() { python3 macro --zraka "$zraka" --programs "$programs" "$@"; }

macro --quick --markdown --threads 2 --json "$folder/times.json" >"$folder/tables" 2>"$folder/words" ||
  fail "the macro benchmark: $(cat "$folder/words")"
cat "$folder/tables"
for title in "Render alone" "Whole process" "Growth" "Scaling" "sphereflake:2@64, 92 shapes"; do
  grep -q "^$title" "$folder/tables" || fail "no table '$title'"
done
[ "$(grep -c '^| terrain:3@64 |' "$folder/tables")" -ge 3 ] || fail "no rows for terrain:3@64"
python3 - "$folder/times.json" <<'END' || fail "the JSON: see above"
import json, sys
record = json.load(open(sys.argv[1]))
runs = [run for entry in record["contest"] if entry["program"] == "zraka" for run in entry["runs"]]
assert len(runs) == 7 and all(run["render"] > 0 and len(run["sha256"]) == 64 for run in runs), runs
assert all(entry["seconds_per_ray"] > 0 for entry in record["growth"])
END

# Rays counted by trying every shape in double, beside the engine's.
for size in rings:1 lattice:2 sphereflake:2 terrain:3; do
  "$zraka" generate "${size%:*}" --size "${size#*:}" -o "$folder/${size%:*}.nff" || fail "no scene $size"
done
cat >"$folder/glass.nff" <<'END'
b 0.1 0.3 0.6
v
from 3 0.4 2
at 0 0 0
up 0 0 1
angle 40
hither 0.1
resolution 128 128
l 4 3 9
l -2 -5 4
f 1 0.8 0.3 1 0 10 0 1
p 4
9 9 -1
-9 9 -1
-9 -9 -1
9 -9 -1
f 0.9 0.9 1 0.1 0.2 30 0.8 1.5
s 0 0 0 1
s 0.5 1.6 -0.4 0.6
END
for scene in rings lattice sphereflake terrain glass; do
  "$zraka" render "$folder/$scene.nff" --profile spd --stats=json -o "$folder/$scene.png" >"$folder/stats" 2>&1 ||
    fail "no counts of $scene: $(cat "$folder/stats")"
  "$programs/count_rays" "$folder/$scene.nff" >"$folder/counts" || fail "count_rays of $scene"
  python3 - "$folder/stats" "$folder/counts" <<'END' || fail "other counts of $scene: $(cat "$folder/stats" "$folder/counts")"
import json, sys
stats = json.load(open(sys.argv[1]))
rays = stats["rays"]
ours = {
    "rays that hit": stats["hits"],
    "later rays": rays["reflected"] + rays["refracted"],
    "shadow rays": rays["shadow"],
}
theirs = {name.strip(): int(count) for name, count in (line.rsplit(None, 1) for line in open(sys.argv[2]))}
theirs["rays that hit"] = theirs["rays from the eye that hit"] + theirs["later rays that hit"]
assert theirs["rays from the eye that hit"] > 1000
for name, count in ours.items():
    assert abs(count - theirs[name]) <= 2 + 0.0005 * count, name
END
done
"$programs/count_rays" "$folder/glass.nff" --nearest 0.2 --outward-normals | diff -q - "$folder/counts" >/dev/null &&
  fail "other rules, same counts"

# Embree's rival draws the same picture with each instruction set that Embree offers here.
if [ -x "$programs/embree_rival" ]; then
  isas=$("$programs/embree_rival" --list-isas)
  [ -n "$isas" ] || fail "Embree offers no instruction set"
  for isa in $isas; do
    for scene in rings lattice sphereflake terrain glass; do
      "$programs/embree_rival" "$folder/$scene.nff" --isa "$isa" -o "$folder/rival.png" >"$folder/rival" &&
        "$programs/compare_pictures" "$folder/$scene.png" "$folder/rival.png" >"$folder/difference" ||
        fail "the Embree rival with $isa and $scene"
      python3 - "$isa" "$folder/rival" "$folder/difference" <<'END' || fail "Embree's picture of $scene with $isa: see above"
import json, sys
packet = json.load(open(sys.argv[2]))["packet"]
different = json.load(open(sys.argv[3]))["different"]
assert packet == {"sse2": 4, "sse4.2": 4, "avx": 8, "avx2": 8, "avx512": 16}[sys.argv[1]], f"{packet} rays in a packet"
assert different <= 0.01, f"{100 * different:.1f} % of the pixels differ"
END
    done
  done
else
  echo "without the Embree rival: it was not built (package libembree-dev)"
fi

# What it says when something is wrong.
expect() {
  local text=$1
  shift
  macro "$@" >"$folder/words" 2>&1 && fail "exit code 0: $*"
  grep -qF -- "$text" "$folder/words" || fail "no '$text' from $*: $(head -c 300 "$folder/words")"
}
expect "'cube' names no scene" --quick --scenes cube --rivals ''
expect "'vray' is no rival" --rivals vray
expect "nowhere.nff is no file" nowhere.nff --rivals ''
mkdir "$folder/changed"
cp -r macro rivals "$folder/changed/"
sed 's/"picture": "......../"picture": "00000000/' pins.json >"$folder/changed/pins.json"
mkdir "$folder/scenes" && cp -r ../scenes/lab "$folder/scenes/"
python3 "$folder/changed/macro" --zraka "$zraka" --programs "$programs" --rivals '' --rounds 1 --scenes terrain:3@64 \
  >"$folder/words" 2>&1 && fail "a changed picture is not noticed"
grep -q "terrain:3@64: the picture has changed" "$folder/words" || fail "a changed picture: $(cat "$folder/words")"

if [ -x "$programs/micro_benchmarks" ]; then
  "$programs/micro_benchmarks" --benchmark_min_time=0.0001 --benchmark_format=csv >"$folder/micro" 2>/dev/null ||
    fail "the micro-benchmarks"
  for part in intersect nearest blocked surfaces light spawn fold power build prepare read; do
    grep -q "^\"$part/" "$folder/micro" || fail "no micro-benchmark of $part"
  done
else
  echo "without the micro-benchmarks: they were not built (package libbenchmark-dev)"
fi
exit $failed
