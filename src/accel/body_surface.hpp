// SPDX-License-Identifier: Apache-2.0
// The surface of a body at a hit: one ray at a time, in double, the same for all instruction sets.
#pragma once

#include "math/vec.hpp"
#include "scene/frozen_bodies.hpp"

namespace zraka {

/// In the engine's frame, but for u and v.
struct BodyHit {
  double t;           ///< of the hit, as exactly as doubles are
  V3<double> point, normal;  ///< unit length, outwards
  V3<double> along_u, along_v;  ///< how the point moves with u and v
  double u, v;
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

namespace isa_oracle {
/// The first hit in front of the origin of a body that is no instance; the ray must hit it.
BodyHit body_hit(const FrozenBodies& bodies, std::int32_t body, const V3<double>& origin,
                 const V3<double>& direction);
/// The crossings in front of the origin with all members, up to `most`; how many there are.
int csg_crossings(const FrozenBodies& bodies, std::int32_t body, const V3<double>& origin,
                  const V3<double>& direction, CsgCrossing* found, int most);
}  // namespace isa_oracle

}  // namespace zraka
