// SPDX-License-Identifier: Apache-2.0
#include "engine/general/wavelengths.hpp"

#include <algorithm>

#include "math/elementary.hpp"

namespace zraka {
namespace {

/// The colour matching functions of the CIE 1931 observer, by sums of bells (Wyman, Sloan and
/// Shirley 2013, "Simple Analytic Approximations to the CIE XYZ Color Matching Functions").
void cie_1931(double nm, double (&xyz)[3]) {
  const auto bell = [&](double middle, double below, double above) {
    const double t = (nm - middle) / (nm < middle ? below : above);
    return elementary::exp(-0.5 * t * t);
  };
  xyz[0] = 1.056 * bell(599.8, 37.9, 31.0) + 0.362 * bell(442.0, 16.0, 26.7) -
           0.065 * bell(501.1, 20.4, 26.2);
  xyz[1] = 0.821 * bell(568.8, 46.9, 40.5) + 0.286 * bell(530.9, 16.3, 31.1);
  xyz[2] = 1.217 * bell(437.0, 11.8, 36.0) + 0.681 * bell(459.0, 26.0, 13.8);
}

/// From XYZ to linear sRGB (IEC 61966-2-1).
constexpr double kToRgb[3][3] = {{3.2404542, -1.5371385, -0.4985314},
                                 {-0.9692660, 1.8760108, 0.0415560},
                                 {0.0556434, -0.2040259, 1.0572252}};
constexpr double kFirst = 390, kLast = 710;  // nm; beyond, the eye sees next to nothing

}  // namespace

Wavelengths wavelengths_in(int count) {
  constexpr int kSteps = 16;  // a part
  Wavelengths all;
  all.count = std::clamp(count, 1, kMaxWavelengths);
  const double width = (kLast - kFirst) / all.count;
  double weight[kMaxWavelengths][3]{}, sum[3]{};
  for (int i = 0; i < all.count; ++i) {
    all.um[i] = (kFirst + (i + 0.5) * width) / 1000;
    for (int s = 0; s < kSteps; ++s) {
      double xyz[3];
      cie_1931(kFirst + (i + (s + 0.5) / kSteps) * width, xyz);
      for (int c = 0; c < 3; ++c)
        weight[i][c] += kToRgb[c][0] * xyz[0] + kToRgb[c][1] * xyz[1] + kToRgb[c][2] * xyz[2];
    }
    for (int c = 0; c < 3; ++c) sum[c] += weight[i][c];
  }
  for (int i = 0; i < all.count; ++i)
    for (int c = 0; c < 3; ++c) all.weight[i][c] = static_cast<float>(weight[i][c] / sum[c]);
  return all;
}

}  // namespace zraka
