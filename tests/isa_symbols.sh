#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0
# isa_symbols.sh LIBRARY: the engine's object files define nothing outside their own namespaces, so that no inline
# function compiled for one instruction set is what another one's code calls.
set -u
library=$1
status=0
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
for object in kernel.cpp.o:4 services.cpp.o:4 shading.cpp.o:4 record_kernel.cpp.o:1; do
  wanted=${object#*:} object=${object%:*}
  members=$(ar t "$library" | grep -c "^$object\$")
  [ "$members" = "$wanted" ] || { echo "$members $object in $library: expected $wanted"; status=1; }
  for ((i = 1; i <= members; i++)); do
    (cd "$folder" && ar xN "$i" "$library" "$object")
    symbols=$(nm -C --defined-only "$folder/$object" | cut -c20-)
    # Functions and objects that the linker might share between files: weak ones, and all global ones.
    foreign=$(nm -C --defined-only "$folder/$object" | awk '$2 ~ /^[TWVBDRu]$/' | cut -c20- |
      grep -vE 'isa_(avx512|avx2|portable|oracle)' || true)
    if [ -n "$foreign" ]; then
      echo "$object $i defines symbols that are not its own:"
      echo "$foreign"
      status=1
    fi
    [ -n "$symbols" ] || { echo "$object $i has no symbols"; status=1; }
  done
done
exit $status
