// SPDX-License-Identifier: Apache-2.0
// Primitives moved by a transform: the engine has them in the world.
#pragma once

#include <zraka/scene.hpp>

namespace zraka::language {

/// Of spheres and cones by transforms that keep balls round.
Sphere baked(const Sphere& sphere, const Transform& transform);
Cone baked(const Cone& cone, const Transform& transform);
Triangle baked(const Triangle& triangle, const Transform& transform);
/// Normals go by the inverse's transpose, so that they stand on the surface still. The transform
/// has to have an inverse.
SmoothTriangle baked(const SmoothTriangle& triangle, const Transform& transform);

}  // namespace zraka::language
