// SPDX-License-Identifier: Apache-2.0
// Which term of which ray gives the pixel how much of its colour.
#pragma once

#include <array>
#include <vector>
#include <zraka/explain.hpp>

namespace zraka {

enum class Source { background, fog, silhouette, ambient, diffuse, specular };

/// One term of one ray, as far as it reaches the pixel: times the shares of all rays on its way,
/// and scaled down where a clamp took its part. All parts together are the pixel's colour, but for
/// rounding.
struct Part {
  std::size_t tree = 0, ray = 0;
  Source source = Source::background;
  std::size_t light = 0;  ///< of a diffuse or specular term
  std::array<double, 3> amount{};

  double size() const;  ///< sum of the channels' magnitudes
};

std::vector<Part> parts_of(const Explanation& explanation);

}  // namespace zraka
