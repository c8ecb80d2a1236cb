// SPDX-License-Identifier: Apache-2.0
#include "language/textures.hpp"

namespace zraka::language {
namespace {

void begin_wood(Texture& texture) {
  texture.direction = {0, 1, 0};
  texture.turbulence = 0.2;
}

constexpr Field kWoodFields[] = {
    texture_fields::colors("of a ring, from the inside to the outside"),
    texture_fields::size("the width of a ring"),
    texture_fields::direction("the trunk, through the origin"),
    texture_fields::turbulence(),
    texture_fields::octaves(),
    texture_fields::seed(),
    texture_fields::mapping(),
    texture_fields::transform(),
};

}  // namespace

constexpr Kind texture::wood = texture_kind<TextureKind::wood, begin_wood>(
    "wood", "wood", "A tree's rings, bent by noise.", kWoodFields);

}  // namespace zraka::language
