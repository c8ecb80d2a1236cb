// SPDX-License-Identifier: Apache-2.0
// Layers and rings that turbulence bends, for those kinds that are made of them.
#pragma once

#include "textures/prepared_texture.hpp"

namespace zraka {

/// Where a place lies among layers, counted from 0, and how many of them the footprint sees.
struct Bent {
  double at = 0, width = 0;
};

/// Layers across the texture's direction.
Bent layers_bent(const PreparedTexture& texture, const TexturePlace& at);
/// Rings around the texture's direction. Along it noise is stretched, as rings of wood are.
Bent rings_bent(const PreparedTexture& texture, const TexturePlace& at);

/// PreparedTexture::finest of both.
V3<double> finest_bent(const PreparedTexture& texture);

}  // namespace zraka
