// SPDX-License-Identifier: Apache-2.0
// What is asked of bodies one ray at a time, in double, the same for all instruction sets.
#pragma once

#include "math/vec.hpp"
#include "shapes/bodies/body.hpp"
#include "scene/frozen_bodies.hpp"

namespace zraka {

/// A crossing of a ray with a member of a CSG body, in the order of distance.
struct CsgCrossing {
  double t;
  std::int32_t body;  ///< the member
  bool enters;        ///< the member, or comes out of it
  bool whole;         ///< whether the ray is inside the whole behind it
};

namespace isa_oracle {
/// A point of the surface of a body that is made of no others, in the engine's frame.
BodySurface on_body(const FrozenBodies& bodies, std::int32_t body, const V3<double>& point);
/// 1 over the least radius there, roughly: how much it spreads what it mirrors. The same everywhere.
double curvature_of_body(const FrozenBodies& bodies, std::int32_t body);
/// What surface() says of a body that is made of no others: Placement's numbers, a point in its own
/// space.
V3<double> own_normal(std::uint8_t type, const double* numbers, const V3<double>& point);
/// The crossings in front of the origin with all members, up to `most`; how many there are.
int csg_crossings(const FrozenBodies& bodies, std::int32_t body, const V3<double>& origin,
                  const V3<double>& direction, CsgCrossing* found, int most);
}  // namespace isa_oracle

}  // namespace zraka
