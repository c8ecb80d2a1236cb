// SPDX-License-Identifier: Apache-2.0
// What can be wrong with how the parts of a scene refer to each other: transforms, groups, members
// of CSG, textures.
#pragma once

#include <functional>
#include <string>
#include <zraka/scene.hpp>

namespace zraka {

/// Groups may be in groups, these in others, so many in all.
inline constexpr int kMostGroupLevels = 32;

/// Of noise: the last of so many has a grain that no double tells from a point.
inline constexpr int kMostOctaves = 32;

using Complain = std::function<void(std::string message, std::string hint)>;
/// Tells each problem; false if there is any. Whatever walks over transforms, groups and members
/// needs a scene that this finds nothing wrong with. The scene's own primitives are not looked at
/// here, nor the materials of its own bodies.
bool check_references(const Scene& scene, const Complain& complain);

/// "" where all is well with a transform.
std::string problem_of(const Transform& transform);

}  // namespace zraka
