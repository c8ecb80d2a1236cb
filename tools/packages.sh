# SPDX-License-Identifier: Apache-2.0
# What has to be installed, by Debian's names. Sourced by tools/setup.sh.
build_packages="g++ cmake ninja-build pkg-config libhwy-dev libexpected-dev libtbb-dev libpng-dev libfmt-dev \
libfreetype-dev libfontconfig-dev libcli11-dev nlohmann-json3-dev libmd-dev fonts-dejavu-core"
test_packages="libgtest-dev binutils"
clang_packages="clang-19"
