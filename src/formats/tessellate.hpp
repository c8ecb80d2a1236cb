// SPDX-License-Identifier: Apache-2.0
// Triangles for round shapes, where a format knows no better.
#pragma once

#include <vector>
#include <zraka/bodies.hpp>
#include <zraka/shapes.hpp>

namespace zraka {

/// Triangles near the surface of an ellipsoid, frustum, disc, torus, capsule or superellipsoid, and
/// those of a box without round edges, in the space that it is described in: at most some thousand,
/// with the surface's own normals. None for other bodies.
std::vector<SmoothTriangle> tessellated(const AnyBody& body);

}  // namespace zraka
