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

/// Of lanes, a bit each, those whose shapes throw shadows; index(lane) is a lane's.
template <class R, class Shape, class Index>
ZRAKA_INLINE std::uint32_t that_throw_shadows(const FrozenScene<R>& scene,
                                              const FrozenShapes<R, Shape>& shapes,
                                              std::uint32_t lanes, const Index& index) {
  if (scene.shadowless == nullptr) return lanes;
  std::uint32_t throwing = 0;
  for (; lanes != 0; lanes &= lanes - 1)
    if (!is_shadowless(scene, shapes, index(__builtin_ctz(lanes))))
      throwing |= lanes & (0u - lanes);
  return throwing;
}

}  // namespace zraka::ZRAKA_ISA
