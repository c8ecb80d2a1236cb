// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <zraka/optics.hpp>
namespace zraka {
double refractive_index(const Dispersion& dispersion, double ior, double wavelength_um);
}  // namespace zraka
