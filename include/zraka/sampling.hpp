// SPDX-License-Identifier: Apache-2.0
// How many rays a pixel has, where they go through it, and what becomes of them.
#pragma once

#include <cstdint>

namespace zraka {

/// How samples become a pixel; the reconstruction filter's radius in pixels is ½, 1, 1.5 and 2.
enum class PixelFilter : std::uint8_t { box, tent, gauss, mitchell };

struct Sampling {
  enum class Kind : std::uint8_t {
    sobol,    ///< `count` points of Sobol's sequence, scrambled as Owen does; 1: the pixel's centre
    grid,     ///< `count` by `count`, in the middles of equal squares
    adaptive  ///< `count`, and up to `most` where neighbours or samples differ by more than `contrast`
  };
  Kind kind = Kind::sobol;
  int count = 1;
  int most = 64;
  double contrast = 0.02;
  PixelFilter filter = PixelFilter::box;
  std::uint32_t seed = 0;
  /// One ray through each pixel's centre, or its corner where the profile says so.
  bool is_single() const { return kind != Kind::adaptive && count == 1 && filter == PixelFilter::box; }
  friend bool operator==(const Sampling&, const Sampling&) = default;
};

}  // namespace zraka
