// SPDX-License-Identifier: Apache-2.0
// [group.NAME]: not built yet.
#include "language/sections.hpp"

namespace zraka::language {

constexpr Section section::group = {.key = "group",
                                    .form = Section::Form::named,
                                    .text = "Shapes that instances put into the scene."};

}  // namespace zraka::language
