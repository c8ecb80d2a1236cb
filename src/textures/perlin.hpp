// SPDX-License-Identifier: Apache-2.0
// Gradient noise (Perlin, "Improving noise", 2002), with a hash of a seed in place of a table.
#pragma once

#include <cstddef>
#include <cstdint>

#include "math/vec.hpp"

namespace zraka {

/// About -1 to 1 and 0 in the mean, with a grain of 1: 0 at whole numbers, twice differentiable.
double gradient_noise(const V3<double>& p, std::uint64_t seed);

/// A sum of octaves, each of half the grain and half the height before, of the spread of a single
/// one. Octaves whose grain is narrower than a footprint's width give what they are in the mean.
struct Fractal {
  int octaves = 1;  ///< 1 to 32
  std::uint32_t seed = 0;
  double operator()(const V3<double>& p, double width) const;
  /// The same at `count` places near each other, at most kMostTogether.
  static constexpr std::size_t kMostTogether = 6;
  void at_each(const V3<double>* p, std::size_t count, double width, double* values) const;
  /// Of absolute values: Perlin's turbulence.
  double turbulence(const V3<double>& p, double width) const;
};

/// The grain of the last octave.
double finest_grain(int octaves);

}  // namespace zraka
