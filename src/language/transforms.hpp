// SPDX-License-Identifier: Apache-2.0
// Transforms as lists of steps.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <zraka/scene.hpp>

#include "language/problems.hpp"
#include "language/toml.hpp"

namespace zraka::language {

/// By an angle round an axis through the origin, as a right hand's fingers curl round its thumb.
/// Quarters of a turn are exact.
Transform rotation(const Vec3& axis, double degrees);

/// [{scale = 2}, …], each step after those before it; none, and the problem told at its place, if
/// it is no such list or makes all that it moves flat. `what` is what it is of: "sphere".
std::optional<Transform> read_transform(const toml::Node& node, std::string_view key,
                                        std::string_view what, Problems& problems);

/// What read_transform() expects.
std::string expected_transform();
/// Whether read_transform() can give it.
bool is_readable(const Transform& transform);

/// As a list of one step.
std::string text_of(const Transform& transform);

/// The index of a transform for Object::transform. Equal ones share it; that which moves nothing
/// has 0.
struct Input;
std::uint32_t index_of(const Transform& transform, Input& input);

}  // namespace zraka::language
