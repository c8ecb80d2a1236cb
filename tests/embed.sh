#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0
# embed.sh: a project that includes this one by add_subdirectory() and names no kind of build gets optimised code, and
# looks for nothing that the library itself does not need.
. "$(dirname "$0")/helpers.sh"
mkdir "$folder/project"
cat >"$folder/project/CMakeLists.txt" <<END
cmake_minimum_required(VERSION 3.23)
project(embeds LANGUAGES CXX)
add_subdirectory("$PWD" zraka)
add_executable(embeds main.cpp)
target_link_libraries(embeds PRIVATE zraka::zraka)
END
echo '#include <zraka/zraka.hpp>
int main() { return zraka::render(zraka::Scene()) ? 0 : 1; }' >"$folder/project/main.cpp"
cmake -G Ninja -S "$folder/project" -B "$folder/build" -DCMAKE_EXPORT_COMPILE_COMMANDS=ON >"$folder/words" 2>&1 ||
  fail "it cannot be configured: $(cat "$folder/words")"
commands=$folder/build/compile_commands.json
grep -qE -- '-O3.*zraka_isa_portable\.dir/(Unity|engine/kernel)' "$commands" || fail "the engine is not optimised"
grep -qE -- '-O3.*main\.cpp' "$commands" && fail "the project's own code gets our options"
for room in apps tests src/school bench; do
  grep -q "\"file\": \"$PWD/$room/" "$commands" && fail "$room/ is built, too"
done
for library in Freetype Fontconfig LibArchive qpdf CLI11 GTest embree benchmark; do
  grep -qiE "^(${library}_DIR|${library}_LIBRARY|${library}_INCLUDE)" "$folder/build/CMakeCache.txt" && fail "$library is looked for"
done

# Without a word about the kind of build, the project itself is optimised, too.
cmake -G Ninja -S . -B "$folder/plain" -DZRAKA_TESTS=OFF -DZRAKA_PROGRAM=OFF >"$folder/words" 2>&1 || fail "no library alone"
grep -q '^CMAKE_BUILD_TYPE:STRING=Release' "$folder/plain/CMakeCache.txt" || fail "a build without a kind is no release"
finish
