// SPDX-License-Identifier: Apache-2.0
// Fog that tells how far things are.
#pragma once

#include <zraka/scene.hpp>

namespace zraka {

/// Gives a scene fog of its background's colour, by depth from the eye: none at what is nearest of
/// its shapes, so much that a fifth is left of the farthest's light. Shapes without an end do not
/// count. False where nothing is in front of the eye.
bool add_depth_cue(Scene& scene);

}  // namespace zraka
