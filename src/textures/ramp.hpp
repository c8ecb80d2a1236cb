// SPDX-License-Identifier: Apache-2.0
// Colours along a line, blended into each other, and their mean over a part of it.
#pragma once

#include <vector>
#include <zraka/textures.hpp>

#include "math/vec.hpp"

namespace zraka {

/// Colours from 0 to 1, and what comes before and after.
class Ramp {
 public:
  struct Knot {
    double at = 0;
    V3<double> color{};
  };
  /// Black.
  Ramp() : Ramp({{0, {}}, {1, {}}}, false, TextureWrap::clamp) {}
  /// Two knots or more that rise, the first at 0, the last at 1. `eased`: level at the knots.
  Ramp(std::vector<Knot> knots, bool eased, TextureWrap wrap);
  /// Knots as far from each other as any other two.
  static std::vector<Knot> evenly(const std::vector<V3<double>>& colors);

  V3<double> value(double s) const;
  /// Over the `width` around s.
  V3<double> mean(double s, double width) const;

 private:
  struct Part {
    std::size_t knot;      ///< the one before
    double length, share;  ///< of the part between the knots, and how much of it is before
  };
  Part part_at(double s) const;
  V3<double> integral_within(double s) const;
  V3<double> integral(double s) const;
  V3<double> mean_clamped(double s, double width) const;

  std::vector<Knot> knots_;
  std::vector<V3<double>> before_;  ///< the integral up to each knot
  bool eased_;
  TextureWrap wrap_;
};

}  // namespace zraka
