// SPDX-License-Identifier: Apache-2.0
#include "language/textures.hpp"

namespace zraka::language {
namespace {

void begin_rings(Texture& texture) {
  texture.direction = {0, 1, 0};
}

constexpr Field kRingsFields[] = {
    texture_fields::colors("in turns, from the axis on"),
    texture_fields::size("the width of one"),
    texture_fields::direction("the axis, through the origin"),
    texture_fields::turbulence(),
    texture_fields::octaves(),
    texture_fields::seed(),
    texture_fields::mapping(),
    texture_fields::transform(),
};

}  // namespace

constexpr Kind texture::rings = texture_kind<TextureKind::rings, begin_rings>(
    "rings", "rings", "Tubes round an axis, whose colours take turns.", kRingsFields);

}  // namespace zraka::language
