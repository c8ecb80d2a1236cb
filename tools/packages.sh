# SPDX-License-Identifier: Apache-2.0
# What has to be installed, by Debian's names. Sourced by tools/setup.sh.
build_packages="g++ cmake ninja-build pkg-config libhwy-dev libexpected-dev libtbb-dev libpng-dev zlib1g-dev libzstd-dev libjpeg-dev \
libopenexr-dev libfmt-dev libfreetype-dev libfontconfig-dev libcli11-dev nlohmann-json3-dev nettle-dev libarchive-dev libqpdf-dev fonts-dejavu-core"
# The Python module.
module_packages="python3 python3-dev python3-numpy pybind11-dev"
# What cpack asks which libraries a package needs.
pack_packages="dpkg-dev"
test_packages="libgtest-dev binutils libbenchmark-dev $module_packages $pack_packages"
# The rivals; without them benchmarks run with those that are there.
bench_packages="libbenchmark-dev python3 libembree-dev tachyon-bin-nox povray"
clang_packages="clang-19 libclang-rt-19-dev"
