# SPDX-License-Identifier: Apache-2.0
# Installs what is missing and builds a preset. Sourced by ./run and ./test.

say() { printf 'zraka: %s\n' "$*" >&2; }
give_up() {
  say "$*"
  exit 1
}

missing_packages() {
  # Asks the package database once; a package that it does not know counts as missing.
  local package have
  have=" $(dpkg-query -W -f='${Package}:${db:Status-Status} ' "$@" 2>/dev/null) "
  for package in "$@"; do
    case "$have" in *" $package:installed "*) ;; *) printf '%s ' "$package" ;; esac
  done
}

install_packages() {
  local missing as_root="" log
  if ! command -v dpkg-query >/dev/null || ! command -v apt-get >/dev/null; then
    for tool in cmake ninja c++; do
      command -v "$tool" >/dev/null ||
        give_up "this system has no apt-get and $tool is missing; install by hand what tools/packages.sh lists."
    done
    return
  fi
  missing=$(missing_packages "$@")
  [ -z "$missing" ] && return
  if [ "$(id -u)" != 0 ]; then
    command -v sudo >/dev/null ||
      give_up "these packages are missing and there is no sudo to install them: $missing"
    as_root="sudo"
  fi
  say "installing $missing"
  log=$(mktemp)
  if ! $as_root env DEBIAN_FRONTEND=noninteractive apt-get install -y --no-install-recommends $missing \
      >"$log" 2>&1; then
    # An old or empty package list is the usual reason.
    if ! $as_root env DEBIAN_FRONTEND=noninteractive sh -c \
        "apt-get update && apt-get install -y --no-install-recommends $missing" >"$log" 2>&1; then
      tail -n 5 "$log" >&2
      rm -f "$log"
      give_up "the packages could not be installed (is there a network?): $missing"
    fi
  fi
  rm -f "$log"
}

check_compiler() {
  local version
  [ -n "${CXX:-}" ] && return
  version=$(g++ -dumpversion 2>/dev/null) || give_up "there is no g++; install it or name a compiler with CXX=."
  [ "${version%%.*}" -ge 12 ] ||
    give_up "g++ $version is too old: 12 or newer is needed; install one and name it with CXX=g++-12."
}

# build PRESET TESTS [TARGET…]: with TESTS=ON also the tests, which need packages of their own.
build() {
  local preset=$1 tests=$2 log=build/$1/build.log
  shift 2
  mkdir -p "build/$preset"
  if [ ! -f "build/$preset/build.ninja" ] ||
    { [ "$tests" = ON ] && ! grep -q '^ZRAKA_TESTS:BOOL=ON' "build/$preset/CMakeCache.txt"; }; then
    case $preset in clang | asan | fuzz) ;; *) check_compiler ;; esac
    cmake --preset "$preset" -DZRAKA_TESTS="$tests" >"$log" 2>&1 || {
      cat "$log" >&2
      rm -f "build/$preset/CMakeCache.txt" "build/$preset/build.ninja"
      give_up "CMake could not prepare the build; its words are above."
    }
  fi
  if [ -t 2 ]; then
    ninja -C "build/$preset" --quiet "$@" >&2 || give_up "the build failed; the compiler's words are above."
  else
    ninja -C "build/$preset" "$@" >"$log" 2>&1 || {
      grep -v '^\[' "$log" | head -n 60 >&2
      give_up "the build failed; all of the compiler's words are in $log."
    }
  fi
}
