// SPDX-License-Identifier: Apache-2.0
// Glasses, crystals, plastics and liquids by name, with the index that was measured.
#pragma once

#include <span>
#include <string_view>
#include <zraka/optics.hpp>

namespace zraka {

struct Glass {
  std::string_view name;
  Dispersion dispersion;
  std::string_view source;  ///< of the coefficients: who and when

  double ior() const;  ///< at the line d
};

/// All of them, in the order in which people are told.
std::span<const Glass> glasses();

/// By its name, in any case; nullptr where there is none.
const Glass* glass_named(std::string_view name);

}  // namespace zraka
