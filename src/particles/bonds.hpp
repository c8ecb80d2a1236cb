// SPDX-License-Identifier: Apache-2.0
// Which atoms are bonded, by how near they are.
#pragma once

#include <array>
#include <optional>
#include <vector>

#include "particles/particles.hpp"

namespace zraka {

/// Pairs of atoms that are at most 0.45 ångström farther apart than their covalent radii together,
/// and at least 0.4 (O'Boyle et al., "Open Babel", 2011), each pair once, the lower index first, in
/// order; in time that grows with their number alone. Takes radii by the index of species: 0 has no
/// bonds. None where atoms are denser than matter is, for then the pairs are too many.
std::optional<std::vector<std::array<std::uint32_t, 2>>> find_bonds(
    const std::vector<Object<Sphere>>& atoms, const std::vector<float>& covalent);

}  // namespace zraka
