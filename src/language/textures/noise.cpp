// SPDX-License-Identifier: Apache-2.0
#include "language/textures.hpp"

namespace zraka::language {
namespace {

constexpr Field kNoiseFields[] = {
    texture_fields::colors("from the least to the most"),
    texture_fields::size("the grain"),
    texture_fields::octaves(),
    texture_fields::seed(),
    texture_fields::mapping(),
    texture_fields::transform(),
};

}  // namespace

constexpr Kind texture::noise =
    texture_kind<TextureKind::noise>("noise", "noise", "Clouds: noise between colours.", kNoiseFields);

}  // namespace zraka::language
