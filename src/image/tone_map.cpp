// SPDX-License-Identifier: Apache-2.0
#include "image/tone_map.hpp"

#include <algorithm>
#include <cmath>

#include "math/elementary.hpp"

namespace zraka {
namespace {

/// Whole stops are exact.
double power_of_two(double exponent) {
  const double whole = std::floor(exponent);
  return std::ldexp(elementary::pow(2, exponent - whole), static_cast<int>(whole));
}

/// Light so bright that sums and squares of it would not be finite is no brighter than this.
constexpr double kBrightest = 1e30;

/// Reinhard's curve over luminance, which keeps hues: L·(1 + L/white²)/(1 + L).
void map_reinhard(double* rgb, double white) {
  const double luminance = 0.2126 * rgb[0] + 0.7152 * rgb[1] + 0.0722 * rgb[2];  // Rec. 709
  const double scale = (1 + luminance / (white * white)) / (1 + luminance);
  for (int c = 0; c < 3; ++c) rgb[c] *= scale;
}

/// Hable's curve with his constants: shoulder, linear part and its angle, toe.
double hable(double x) {
  constexpr double a = 0.15, b = 0.50, c = 0.10, d = 0.20, e = 0.02, f = 0.30;
  return (x * (a * x + c * b) + d * e) / (x * (a * x + b) + d * f) - e / f;
}

}  // namespace

std::optional<ToneCurve> tone_curve_named(std::string_view name) {
  for (std::size_t i = 0; i < kToneCurveNames.size(); ++i)
    if (name == kToneCurveNames[i]) return static_cast<ToneCurve>(i);
  return std::nullopt;
}

ToneMapper::ToneMapper(const ToneMapping& mapping)
    : curve_(mapping.curve),
      scale_(power_of_two(mapping.exposure)),
      white_(mapping.white > 0                      ? mapping.white
             : mapping.curve == ToneCurve::reinhard ? kReinhardWhite
                                                    : kFilmicWhite) {}

void ToneMapper::apply(float* pixels, std::size_t count) const {
  constexpr double kHableBias = 2;  // his exposure before the curve
  for (std::size_t i = 0; i < count; ++i, pixels += 3) {
    double rgb[3];
    for (int c = 0; c < 3; ++c) {
      const double light = static_cast<double>(pixels[c]) * scale_;
      rgb[c] = light > 0 ? std::min(light, kBrightest) : 0;
    }
    if (curve_ == ToneCurve::reinhard) map_reinhard(rgb, white_);
    if (curve_ == ToneCurve::filmic)
      for (double& v : rgb) v = hable(kHableBias * v) / hable(white_ * kHableBias);
    for (int c = 0; c < 3; ++c) pixels[c] = static_cast<float>(std::clamp(rgb[c], 0.0, 1.0));
  }
}

}  // namespace zraka
