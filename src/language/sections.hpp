// SPDX-License-Identifier: Apache-2.0
// The list of sections, in the order in which they are read and written.
#pragma once

#include "language/section.hpp"

/// X(name): every section, in sections/NAME.cpp.
#define ZRAKA_SECTIONS(X) \
  X(image)                \
  X(camera)               \
  X(render)               \
  X(texture)              \
  X(scene)                \
  X(cut)                  \
  X(light)                \
  X(material)             \
  X(group)                \
  X(shape)

namespace zraka::language {

namespace section {
#define ZRAKA_DECLARE(name) extern const Section name;
ZRAKA_SECTIONS(ZRAKA_DECLARE)
#undef ZRAKA_DECLARE
}  // namespace section

inline constexpr const Section* kSections[] = {
#define ZRAKA_ADDRESS(name) &section::name,
    ZRAKA_SECTIONS(ZRAKA_ADDRESS)
#undef ZRAKA_ADDRESS
};

}  // namespace zraka::language
