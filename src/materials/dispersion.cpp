// SPDX-License-Identifier: Apache-2.0
#include "materials/dispersion.hpp"

#include <cmath>

namespace zraka {
namespace {

constexpr double inverse_square(double wavelength) {
  return 1 / (wavelength * wavelength);
}

}  // namespace

double refractive_index(const Dispersion& dispersion, double ior, double wavelength_um) {
  const auto& k = dispersion.numbers;
  const double inverse = inverse_square(wavelength_um);
  switch (dispersion.kind) {
    case Dispersion::Kind::none:
      break;
    case Dispersion::Kind::abbe: {
      const double b = (ior - 1) / (k[0] * (inverse_square(kLineF) - inverse_square(kLineC)));
      return ior + b * (inverse - inverse_square(kLineD));
    }
    case Dispersion::Kind::cauchy:
      return k[0] + (k[1] + k[2] * inverse) * inverse;
    case Dispersion::Kind::sellmeier: {
      const double square = wavelength_um * wavelength_um;
      double sum = 1;
      for (std::size_t i = 0; i < 3; ++i)
        if (k[i] != 0) sum += k[i] * square / (square - k[i + 3]);
      return std::sqrt(sum);
    }
  }
  return ior;
}

double abbe_number(const Dispersion& dispersion, double ior) {
  const auto index = [&](double line) { return refractive_index(dispersion, ior, line); };
  return (index(kLineD) - 1) / (index(kLineF) - index(kLineC));
}

bool has_index(const Dispersion& dispersion, double ior) {
  const auto good = [&](double wavelength) {
    const double index = refractive_index(dispersion, ior, wavelength);
    return std::isfinite(index) && index > 0;
  };
  constexpr int kSteps = 94;  // of 5 nm
  for (int i = 0; i <= kSteps; ++i)
    if (!good(kShortestSeen + (kLongestSeen - kShortestSeen) * i / kSteps)) return false;
  return good(kLineD);
}

}  // namespace zraka
