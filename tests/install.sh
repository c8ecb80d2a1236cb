#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0
# install.sh BUILD C++: what is installed from a build tree can be used from outside, with CMake and with pkg-config, also
# after it was moved; it shows its API and nothing else, and brings no libraries that only the school needs.
. "$(dirname "$0")/helpers.sh"
build=$1 compiler=$2
for component in library dev; do
  cmake --install "$build" --prefix "$folder/first" --component $component >"$folder/words" 2>&1 ||
    fail "$component cannot be installed: $(cat "$folder/words")"
done
mv "$folder/first" "$folder/usr"
library=$(find "$folder/usr" -name 'libzraka.so.*.*.*')
[ -n "$library" ] || fail "no shared library is installed"
libraries=$(dirname "$library")
export LD_LIBRARY_PATH=$libraries

# Headers stand alone, without a warning.
for standard in c++20 c++23; do
  for header in "$folder"/usr/include/zraka/*.hpp; do
    echo "#include <zraka/$(basename "$header")>"
  done >"$folder/all.cpp"
  "$compiler" -std=$standard -Wall -Wextra -Wpedantic -Werror -fsyntax-only -I "$folder/usr/include" "$folder/all.cpp" ||
    fail "the headers do not compile as $standard"
done

# Symbols: the API's, of the namespace zraka, and none of what is inside.
nm -DC --defined-only "$library" | cut -d' ' -f3- >"$folder/symbols"
contains "$folder/symbols" 'zraka::render(zraka::Scene const&, zraka::RenderOptions const&)'
grep -v '^zraka::' "$folder/symbols" && fail "symbols of others are shown"
grep -E 'zraka::(isa_(avx|portable|oracle)|language::|freeze|prepare)' "$folder/symbols" && fail "symbols from inside are shown"
readelf -d "$library" | grep -q 'SONAME.*libzraka\.so\.[0-9]*\.[0-9]*\]' || fail "the library's name has no version"

cmake -G Ninja -S tests/consumer -B "$folder/consumer" -DCMAKE_CXX_COMPILER="$compiler" -DCMAKE_BUILD_TYPE=Debug \
  -DCMAKE_PREFIX_PATH="$folder/usr" >"$folder/words" 2>&1 && cmake --build "$folder/consumer" >>"$folder/words" 2>&1 ||
  fail "no program by CMake: $(cat "$folder/words")"
"$folder/consumer/consumer" >"$folder/cmake.txt" || fail "CMake's program ends with $?"
contains "$folder/cmake.txt" "error: "
ldd "$folder/consumer/consumer" >"$folder/needed"
grep -qF "$libraries/libzraka.so" "$folder/needed" || fail "it runs with another library than the one installed"
grep -iE 'fontconfig|archive|freetype|qpdf' "$folder/needed" && fail "it loads what only the school needs"

export PKG_CONFIG_PATH=$libraries/pkgconfig
# shellcheck disable=SC2046
"$compiler" -std=c++20 tests/consumer/main.cpp -o "$folder/by_pkg_config" $(pkg-config --cflags --libs zraka) ||
  fail "no program by pkg-config"
"$folder/by_pkg_config" >"$folder/pkg_config.txt" || fail "pkg-config's program ends with $?"
cmp "$folder/cmake.txt" "$folder/pkg_config.txt" || fail "the two programs differ"
finish
