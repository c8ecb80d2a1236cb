#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0
# Includes point one way: a room of src/ may use those of lower rank, itself, and the public API. core and math, of the lowest
# rank, know nothing of each other.
set -u
cd "$(dirname "$0")/.."
status=0
complain() {
  echo "$1"
  status=1
}
rank() {
  case $1 in
    core) echo 1 ;; math) echo 1 ;; image) echo 2 ;; shapes) echo 2 ;; textures) echo 2 ;; materials) echo 2 ;; sampling) echo 2 ;;
    scene) echo 3 ;; compare) echo 3 ;; mesh) echo 4 ;; particles) echo 4 ;; language) echo 5 ;; formats) echo 6 ;; accel) echo 4 ;; cameras) echo 4 ;; engine) echo 5 ;; render) echo 6 ;; school) echo 8 ;; *) echo 7 ;;
  esac
}
for file in $(find src -name '*.hpp' -o -name '*.cpp'); do
  room=$(echo "$file" | cut -d/ -f2)
  for included in $(sed -n 's/^ *#include "\([a-z_]*\)\/.*/\1/p' "$file" | sort -u); do
    [ "$included" = "$room" ] && continue
    [ -d "src/$included" ] || complain "$file includes $included/, which is no room of src/"
    [ "$(rank "$included")" -lt "$(rank "$room")" ] || complain "$file: $room/ must not include $included/"
  done
done
# The engine's steps are its own: other rooms include only what it takes and gives.
for file in $(grep -rlE '#include "engine/(trace_tile|kernel)' src apps --include='*.[ch]pp'); do
  case $file in src/engine/* | src/school/mistakes/*) ;; *) complain "$file: only the engine's own files, and the kernel of mistakes, see its insides" ;; esac
done
# The public API stands on its own.
for file in $(grep -rlE '#include "' include); do complain "$file includes a header of src/"; done
exit $status
