// SPDX-License-Identifier: Apache-2.0
#include "language/textures.hpp"

namespace zraka::language {
namespace {

constexpr Field kGradientFields[] = {
    texture_fields::colors("evenly along it"),
    texture_fields::size("its length"),
    texture_fields::direction("the way from the first colour, at the origin, to the last"),
    texture_fields::wrap("what is beyond its end"),
    texture_fields::mapping(),
    texture_fields::transform(),
};

}  // namespace

constexpr Kind texture::gradient = texture_kind<TextureKind::gradient>(
    "gradient", "gradient", "From colour to colour along a line.", kGradientFields);

}  // namespace zraka::language
