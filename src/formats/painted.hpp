// SPDX-License-Identifier: Apache-2.0
// Colours at the corners of triangles, as a texture.
#pragma once

#include <functional>
#include <vector>
#include <zraka/textures.hpp>

namespace zraka {

/// A texture with two by two texels for each triangle, from whose middles the colours of its
/// corners are blended; the fourth makes that linear. `colors` has nine numbers for each triangle,
/// and `put_uvs` gets the triangles' number and corners.
Texture painted_texture(const std::vector<float>& colors,
                        const std::function<void(std::size_t, const CornerUvs&)>& put_uvs);

}  // namespace zraka
