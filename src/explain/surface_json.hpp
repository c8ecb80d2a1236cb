// SPDX-License-Identifier: Apache-2.0
// What there is to say of a hit besides its light, for programs.
#pragma once

#include <zraka/explain.hpp>

#include "core/json.hpp"

namespace zraka {

/// The fewest digits that give the float back, so that 0.1f is printed as 0.1.
Json number_json(float v);
Json number_json(const Float3& v);
Json point_json(const Vec3& v);

/// "shape", and "name" where it has one.
Json shape_json(const NamedShape& shape);

/// Adds the members that a path has; none for most.
void add_path(const ExplainedPath& path, Json& json);
/// Adds what there is of a hit: its path, crossings, transform, own space, textures.
void add_surface(const ExplainedHit& hit, Json& json);

}  // namespace zraka
