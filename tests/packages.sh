#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0
# packages.sh PROGRAM BUILD: Debian's packages hold what they should and name what they need, and the archive's program runs from
# where it is unpacked with its own libraries. packaging/try installs them on a bare system.
. "$(dirname "$0")/helpers.sh"
build=$2
command -v dpkg-shlibdeps >/dev/null || exit 77
for generator in DEB TGZ; do
  cpack --config "$build/CPackConfig.cmake" -G $generator -B "$folder/packages" >"$folder/words" 2>&1 ||
    fail "no packages by $generator: $(tail -n 5 "$folder/words")"
done

# holds PACKAGE PATTERN…: its files.
holds() {
  local package=$1 pattern
  shift
  dpkg-deb -c "$folder"/packages/${package}_*.deb | sed 's/.* \.\///' >"$folder/files"
  for pattern in "$@"; do
    grep -qE "^usr/$pattern( |$)" "$folder/files" || fail "$package has no $pattern"
  done
}
holds zraka bin/zraka bin/zraka-tachyon share/man/man1/zraka-render.1.gz share/man/man1/zraka-tachyon.1.gz \
  share/bash-completion/completions/zraka share/zsh/vendor-completions/_zraka share/fish/vendor_completions.d/zraka.fish \
  share/zraka/scene.schema.json share/doc/zraka/copyright share/doc/zraka/changelog.Debian.gz
holds 'libzraka[0-9]*' 'lib/(.*/)?libzraka.so.[0-9]+.[0-9]+.[0-9]+'
grep -q 'include/' "$folder/files" && fail "the library's package has headers"
holds libzraka-dev include/zraka/zraka.hpp include/zraka/school/school.hpp 'lib/(.*/)?libzraka.a' 'lib/(.*/)?libzraka.so' \
  'lib/(.*/)?cmake/zraka/zraka-config.cmake' 'lib/(.*/)?pkgconfig/zraka.pc'
if [ -d "$build/python" ]; then
  holds python3-zraka lib/python3/dist-packages/zraka/__init__.py 'lib/python3/dist-packages/zraka/_zraka.*.so'
fi
dpkg-deb -f "$folder"/packages/zraka_*.deb Depends >"$folder/depends"
for library in libtbb12 libpng16 libstdc++6; do contains "$folder/depends" $library; done
dpkg-deb --fsys-tarfile "$folder"/packages/zraka_*.deb | tar -xO ./usr/bin/zraka >"$folder/installed"
readelf -d "$folder/installed" | grep -E 'RPATH|RUNPATH' && fail "the installed program looks for libraries elsewhere"
if command -v lintian >/dev/null; then
  # Where libraries are is the prefix's doing, which is /usr in packaging/pack.
  lintian "$folder"/packages/*.deb 2>/dev/null | grep '^[EW]:' |
    grep -v pkg-config-unavailable-for-cross-compilation && fail "lintian complains"
fi

mkdir "$folder/elsewhere"
tar -xzf "$folder"/packages/zraka-*.tar.gz -C "$folder/elsewhere"
mv "$folder"/elsewhere/zraka-* "$folder/elsewhere/here"
unpacked=$folder/elsewhere/here/bin/zraka
ldd "$unpacked" | grep -vE 'linux-vdso|ld-linux|/lib(c|m|dl|pthread|rt)\.so' | grep -v "$folder/elsewhere" &&
  fail "the archive's program takes libraries of the system"
"$unpacked" render scenes/lab/input.txt -o "$folder/unpacked.png" --width 64 || fail "the archive's program does not run"
"$zraka" render scenes/lab/input.txt -o "$folder/built.png" --width 64
cmp "$folder/unpacked.png" "$folder/built.png" || fail "the archive's program draws another picture"
finish
