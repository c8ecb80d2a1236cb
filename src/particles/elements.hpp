// SPDX-License-Identifier: Apache-2.0
// What pictures of molecules know of the chemical elements.
#pragma once

#include <cstdint>
#include <string_view>

namespace zraka {

struct Element {
  std::string_view symbol;
  /// In ångström. Of the main groups by Bondi ("van der Waals Volumes and Radii", 1964), where he
  /// has none by Mantina et al. ("Consistent van der Waals Radii for the Whole Main Group", 2009);
  /// of all others by Alvarez ("A cartography of the van der Waals territories", 2013), and 2.4
  /// where nobody has measured.
  float van_der_waals;
  /// In ångström: Cordero et al. ("Covalent radii revisited", 2008), of low spin where spin tells;
  /// 1.6 beyond curium.
  float covalent;
  std::uint32_t rgb;  ///< sRGB, as Jmol has it: Corey, Pauling and Koltun's colours, extended
};

/// The element of an atomic number from 1 to 109; nullptr for any other.
const Element* element_of_number(unsigned number);

/// The element that a label begins with: of two letters where these are a symbol and the second is
/// small ("Ca2+", "Fe1"), else of the first letter ("CA", "H12"), else of two capitals ("MG1").
/// Deuterium is hydrogen. nullptr if it is none.
const Element* element_of_label(std::string_view label);

/// The element whose symbol the whole text is, in capitals or not; nullptr if it is none.
const Element* element_of_symbol(std::string_view symbol);

}  // namespace zraka
