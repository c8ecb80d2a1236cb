#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0
# isa_symbols.sh LIBRARY SCHOOL: the engine's object files define nothing outside their own namespaces, so that no inline
# function compiled for one instruction set is what another one's code calls; and what most time goes into is in the engine
# alone, so that no copy that is optimised less is what the engine calls.
set -u
library=$1 school=$2
status=0
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
# A set's files are compiled together, or apart where ZRAKA_TOGETHER is off.
check() {  # OBJECT NUMBER SYMBOLS: the members of this name that define such a symbol are so many
  local object=$1 wanted=$2 defines=$3 found=0 i members
  members=$(ar t "$library" | grep -c "^$object\$")
  for ((i = 1; i <= members; i++)); do
    (cd "$folder" && ar xN "$i" "$library" "$object")
    nm -C --defined-only "$folder/$object" | grep -qE "$defines" || continue
    found=$((found + 1))
    # Functions and objects that the linker might share between files: weak ones, and all global ones.
    foreign=$(nm -C --defined-only "$folder/$object" | awk '$2 ~ /^[TWVBDRu]$/' | cut -c20- |
      grep -vE 'isa_(avx512|avx2|portable|oracle)' || true)
    if [ -n "$foreign" ]; then
      echo "$object $i defines symbols that are not its own:"
      echo "$foreign"
      status=1
    fi
  done
  [ "$found" = "$wanted" ] || { echo "$found $object with $defines in $library: expected $wanted"; status=1; }
}
if ar t "$library" | grep -q '^kernel\.cpp\.o$'; then
  check kernel.cpp.o 4 'isa_[a-z0-9]+::kKernel$'
  check services.cpp.o 4 'isa_[a-z0-9]+::kServices$'
  check shading.cpp.o 4 'isa_[a-z0-9]+::'
  check hit_lanes.cpp.o 4 'isa_[a-z0-9]+::'
else
  check unity_1_cxx.cxx.o 4 'isa_[a-z0-9]+::kKernel$'
fi
check record_kernel.cpp.o 1 'isa_portable::'
library=$school
if ar t "$library" | grep -q '^mistaken_kernel\.cpp\.o$'; then
  check mistaken_kernel.cpp.o 2 'isa_[a-z0-9]+::kMistakenKernel$'
  check mistaken_record_kernel.cpp.o 1 'isa_portable::'
else
  check unity_1_cxx.cxx.o 2 'isa_[a-z0-9]+::kMistakenKernel$'
fi
copies=$(nm -C --defined-only "$school" 2>/dev/null |
  grep -oE 'isa_[a-z0-9]+::(nearest_in_hierarchy|blocked_in_hierarchy|trace_shadow_rays)<' | sort | uniq -c)
if [ -n "$copies" ]; then
  echo "$school has copies of what engine/once.hpp lists:"
  echo "$copies"
  status=1
fi
exit $status
