// SPDX-License-Identifier: Apache-2.0
// [texture.NAME]: not built yet.
#include "language/sections.hpp"

namespace zraka::language {

constexpr Section section::texture = {.key = "texture",
                                      .form = Section::Form::named,
                                      .text = "Colours that differ from point to point."};

}  // namespace zraka::language
