// SPDX-License-Identifier: Apache-2.0
#include "language/textures.hpp"

namespace zraka::language {
namespace {

constexpr Field kCheckerFields[] = {
    texture_fields::colors("that of the cube from the origin to [size, size, size], and the other",
                           2),
    texture_fields::size("the cubes' side"),
    texture_fields::mapping(),
    texture_fields::repeat_u(),
    texture_fields::repeat_v(),
    texture_fields::offset_u(),
    texture_fields::offset_v(),
    texture_fields::transform(),
};

}  // namespace

constexpr Kind texture::checker =
    texture_kind<TextureKind::checker>("checker", "checker",
                                       "Cubes of two colours, of which no two with a side in "
                                       "common have the same; over u and v, squares.",
                                       kCheckerFields);

}  // namespace zraka::language
