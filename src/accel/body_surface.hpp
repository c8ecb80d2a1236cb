// SPDX-License-Identifier: Apache-2.0
// The surface of a body at a hit: one ray at a time, in double, the same for all instruction sets.
#pragma once

#include "math/vec.hpp"
#include "shapes/bodies/body.hpp"
#include "scene/frozen_bodies.hpp"

namespace zraka {

/// In the engine's frame.
struct BodyHit {
  double t;           ///< of the hit, as exactly as doubles are
  V3<double> point, normal;  ///< unit length, outwards
  double size;        ///< what the body's own unit is along the ray
  bool inside;        ///< the ray came from within
  std::int32_t body;  ///< the body whose surface it is: of CSG, its member
};

/// A crossing of a ray with a member of a CSG body, in the order of distance.
struct CsgCrossing {
  double t;
  std::int32_t body;  ///< the member
  bool enters;        ///< the member, or comes out of it
  bool whole;         ///< whether the ray is inside the whole behind it
};

/// A point of a body's surface in the engine's frame.
struct OnBody {
  BodySurface surface;
  double curvature;
};

namespace isa_oracle {
/// Of a body that is made of no others.
OnBody on_body(const FrozenBodies& bodies, std::int32_t body, const V3<double>& point);
/// The first hit in front of the origin of a body that is no instance; the ray must hit it.
BodyHit body_hit(const FrozenBodies& bodies, std::int32_t body, const V3<double>& origin,
                 const V3<double>& direction);
/// The crossings in front of the origin with all members, up to `most`; how many there are.
int csg_crossings(const FrozenBodies& bodies, std::int32_t body, const V3<double>& origin,
                  const V3<double>& direction, CsgCrossing* found, int most);
}  // namespace isa_oracle

}  // namespace zraka
