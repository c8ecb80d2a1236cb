// SPDX-License-Identifier: Apache-2.0
// What shapes are called.
#pragma once

#include <fmt/format.h>

#include <string>
#include <zraka/scene.hpp>

#include "shapes/shapes.hpp"

namespace zraka {

/// "sphere 3": as diagnostics call it, counted from 1.
inline std::string plain_name(const ShapeId& id) {
  constexpr const char* kNames[] = {
#define ZRAKA_NAME(Type, plural) ShapeTraits<Type>::kName,
      ZRAKA_SHAPES(ZRAKA_NAME)
#undef ZRAKA_NAME
  };
  return fmt::format("{} {}", kNames[id.kind], std::uint64_t{id.index} + 1);
}

}  // namespace zraka
