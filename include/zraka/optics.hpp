// SPDX-License-Identifier: Apache-2.0
// What light does at surfaces and inside of bodies, beyond Phong's coefficients.
#pragma once

#include <array>
#include <cstdint>
#include <zraka/values.hpp>

namespace zraka {

/// The highlight: (R·V)^n (Phong 1975), or (N·H)^n with H halfway between light and viewer (Blinn
/// 1977).
enum class Highlight : std::uint8_t { phong, blinn };

/// How the angle moves light from refraction to reflection: not at all; by Fresnel's equations for
/// unpolarised light; by Schlick's approximation of them (1994).
enum class Fresnel : std::uint8_t { off, exact, schlick };

/// How the index of refraction depends on the wavelength λ, in micrometres.
struct Dispersion {
  enum class Kind : std::uint8_t {
    none,
    abbe,      ///< by Cauchy's first two terms, so that (n_d - 1)/(n_F - n_C) is number[0] and n_d is the ior
    cauchy,    ///< n = A + B/λ² + C/λ⁴
    sellmeier  ///< n² = 1 + Σ Bi·λ²/(λ² - Ci); numbers are B1, B2, B3, C1, C2, C3, Ci in µm²
  };
  Kind kind = Kind::none;
  std::array<double, 6> numbers{};
  friend bool operator==(const Dispersion&, const Dispersion&) = default;
};

}  // namespace zraka
