// SPDX-License-Identifier: Apache-2.0
// Mistakes that are made before the first ray or after the last; those between are the engine's
// (engine/mistaken_rules.hpp).
#pragma once

#include <zraka/render.hpp>

namespace zraka {

/// The scene as somebody reads it who makes the mistake of the options.
Scene mistaken_scene(Scene scene, const RenderOptions& options);
/// Profile and depth as they become by the options' mistake.
RenderOptions mistaken_options(RenderOptions options);
/// The finished picture with the mistake.
void apply_mistake(Image& image, Mistake mistake);

}  // namespace zraka
