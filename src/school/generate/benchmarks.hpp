// SPDX-License-Identifier: Apache-2.0
// Scenes of any size for benchmarks, straight into a file in NFF.
#pragma once

#include <cstdint>
#include <string>
#include <zraka/diagnostic.hpp>

namespace zraka {

/// What generate_benchmark() can make; `size` means something else for each.
struct Benchmark {
  const char* name;
  const char* what;  ///< for --help, the meaning of size included
  int smallest, usual, largest;
};
inline constexpr Benchmark kBenchmarks[] = {
    {"sphereflake",
     "a sphere with nine smaller ones on it, SIZE times over: (9^(SIZE+1) - 1)/8 spheres", 0, 4, 8},
    {"lattice", "(SIZE + 1)³ spheres in a cubic lattice, joined by cylinders", 1, 12, 200},
    {"rings", "a pyramid of SIZE layers of balls, each of six rings of five spheres and cylinders",
     1, 7, 60},
    {"spheres", "10^SIZE mirroring and matt spheres anywhere in a cube", 0, 4, 8},
    {"terrain", "a landscape of 2·4^SIZE triangles", 1, 6, 12},
    {"tetra", "a tetrahedron of tetrahedra of tetrahedra…, 4^SIZE triangles", 1, 6, 12},
};

/// Writes the benchmark of that name to a file. Fails on an unknown name, a size out of its range,
/// and output that cannot be written.
Result<void> generate_benchmark(const std::string& name, int size, std::uint32_t seed,
                                const std::string& path);

}  // namespace zraka
