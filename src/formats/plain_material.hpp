// SPDX-License-Identifier: Apache-2.0
// What writers do with what their formats have no words for.
#pragma once

#include <vector>
#include <zraka/scene.hpp>

namespace zraka {

/// A texture's mean colour.
Color mean_of(const Texture& texture);

/// Which materials shapes have, of the scene, its groups and CSG.
std::vector<bool> used_materials(const Scene& scene);

/// The material with means for its textures.
Material without_textures(const Scene& scene, Material material);

/// The scene's camera, moved so that rays through the middles of pixels are those of its profile.
Camera with_central_rays(const Scene& scene);

}  // namespace zraka
