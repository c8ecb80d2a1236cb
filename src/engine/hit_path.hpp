// SPDX-License-Identifier: Apache-2.0
// The way to what a ray has hit, where instances and CSG stand between it and the scene.
#pragma once

#include <cstdint>
#include <zraka/limits.hpp>

#include "textures/texture_point.hpp"

namespace zraka {

/// Kept only where somebody asks for it: in scenes with textures, and for explanations.
struct HitPath {
  const void* group;  ///< the FrozenScene of the group that the shape stands in; nullptr: the scene
  std::int32_t slot;  ///< the shape's there
  std::int32_t body;  ///< of a body, its index; of CSG, that of the member whose surface it is
  std::int32_t depth;                    ///< so many instances are on the way
  double to_frame[12];  ///< from the group's frame to the engine's: three columns and the origin
  std::int32_t instance[kMostNested];    ///< their bodies' indices, the outermost first
};

/// Of a hit of a material that has textures, or has children in a scene that has some, what its
/// children's cones come from.
struct HitCone {
  /// Of the ray's cone there, in the engine's frame; below 0 past the focus of a lens.
  double width;
  double curvature;  ///< of the surface, 1 over its radius, in the engine's frame
};

}  // namespace zraka
