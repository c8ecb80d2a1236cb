// SPDX-License-Identifier: Apache-2.0
// Shapes that shadow rays go through, whatever they are made of: those of materials that throw no
// shadow, such as the balls that show where lights are.
#pragma once

#include "accel/ray_lanes.hpp"

namespace zraka::ZRAKA_ISA {

template <class R, class Shape>
ZRAKA_INLINE bool is_shadowless(const FrozenScene<R>& scene, const FrozenShapes<R, Shape>& shapes,
                                std::int32_t i) {
  return scene.shadowless != nullptr && scene.shadowless[shapes.material[i]] != 0;
}

/// Of the shapes from one on, a bit each, those that throw shadows.
template <class R, class Shape>
ZRAKA_INLINE std::uint32_t that_throw_shadows(const FrozenScene<R>& scene,
                                              const FrozenShapes<R, Shape>& shapes,
                                              std::int32_t first, std::uint32_t which) {
  if (scene.shadowless == nullptr) return which;
  std::uint32_t throwing = 0;
  for (; which != 0; which &= which - 1)
    if (!is_shadowless(scene, shapes, first + __builtin_ctz(which)))
      throwing |= which & (0u - which);
  return throwing;
}

}  // namespace zraka::ZRAKA_ISA
