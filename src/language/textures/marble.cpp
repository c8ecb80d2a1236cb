// SPDX-License-Identifier: Apache-2.0
#include "language/textures.hpp"

namespace zraka::language {
namespace {

void begin_marble(Texture& texture) {
  texture.turbulence = 1;
}

constexpr Field kMarbleFields[] = {
    texture_fields::colors("in turns, one blending into the next"),
    texture_fields::size("the width of a vein"),
    texture_fields::direction("across the veins"),
    texture_fields::turbulence(),
    texture_fields::octaves(),
    texture_fields::seed(),
    texture_fields::mapping(),
    texture_fields::transform(),
};

}  // namespace

constexpr Kind texture::marble = texture_kind<TextureKind::marble, begin_marble>(
    "marble", "marble", "Veins: soft stripes that noise bends.", kMarbleFields);

}  // namespace zraka::language
