// SPDX-License-Identifier: Apache-2.0
// From light without bounds to values of 0…1.
#pragma once

#include <cstddef>
#include <zraka/write_image.hpp>

namespace zraka {

/// A ToneMapping, ready for pixels. Sums, products and quotients only, besides 2^exposure, which is
/// our own: the same bits on every machine.
class ToneMapper {
 public:
  explicit ToneMapper(const ToneMapping& mapping);

  /// Whether values stay as they are until they are clamped.
  bool does_nothing() const { return curve_ == ToneCurve::clamp && scale_ == 1; }
  /// `count` pixels of three values each. What is no light, NaN or below 0, becomes 0.
  void apply(float* pixels, std::size_t count) const;

 private:
  ToneCurve curve_;
  double scale_, white_;
};

}  // namespace zraka
