// SPDX-License-Identifier: Apache-2.0
// How the index of refraction depends on the wavelength.
#pragma once

#include <zraka/optics.hpp>

namespace zraka {

/// Fraunhofer's lines that glasses are described by, in µm: F and C of hydrogen, d of helium.
inline constexpr double kLineF = 0.4861327, kLineD = 0.5875618, kLineC = 0.6562725;
/// What the eye sees, in µm, amply.
inline constexpr double kShortestSeen = 0.36, kLongestSeen = 0.83;

/// The index at a wavelength in µm of a material whose index at the line d is `ior`; Cauchy's and
/// Sellmeier's formulas say it without. Not a number, or infinite, where a formula has none.
double refractive_index(const Dispersion& dispersion, double ior, double wavelength_um);

/// (n_d - 1)/(n_F - n_C)
double abbe_number(const Dispersion& dispersion, double ior);

/// Whether there is a finite index above 0 at all wavelengths that are seen.
bool has_index(const Dispersion& dispersion, double ior);

}  // namespace zraka
