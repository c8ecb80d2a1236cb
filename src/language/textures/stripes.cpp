// SPDX-License-Identifier: Apache-2.0
#include "language/textures.hpp"

namespace zraka::language {
namespace {

constexpr Field kStripesFields[] = {
    texture_fields::colors("in turns, from the origin on"),
    texture_fields::size("the width of one"),
    texture_fields::direction("across the stripes"),
    texture_fields::mapping(),
    texture_fields::transform(),
};

}  // namespace

constexpr Kind texture::stripes = texture_kind<TextureKind::stripes>(
    "stripes", "stripes", "Layers of colours that take turns.", kStripesFields);

}  // namespace zraka::language
