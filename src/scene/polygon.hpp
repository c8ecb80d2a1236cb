// SPDX-License-Identifier: Apache-2.0
// Polygons, cut into triangles.
#pragma once

#include <array>
#include <cstdint>
#include <vector>
#include <zraka/values.hpp>

namespace zraka {

/// Triangles (indices of corners) that cover a planar polygon, which may be concave, in time that
/// grows with the square of its corners. A polygon that crosses itself is cut somehow. Fewer than
/// three corners give none.
std::vector<std::array<std::uint32_t, 3>> triangulate(const std::vector<Vec3>& corners);

}  // namespace zraka
