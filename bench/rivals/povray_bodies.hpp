// SPDX-License-Identifier: Apache-2.0
// Bodies, CSG and instances in POV-Ray's language.
#pragma once

#include "scene_writer.hpp"

namespace zraka::rivals {

/// Which of POV-Ray's textures an object has, as text.
using TextureOf = std::string (*)(std::uint32_t material);

/// Adds all bodies of a scene, after its groups.
void add_bodies(const Scene& scene, TextureOf texture, Text& out);

}  // namespace zraka::rivals
