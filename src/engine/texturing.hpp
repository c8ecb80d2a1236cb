// SPDX-License-Identifier: Apache-2.0
// Textures of many hits at a time that lie in space, in lanes of doubles: what coefficients.cpp does
// hit by hit, to the same bits (engine/texturing.cpp).
#pragma once

#include "engine/engine.hpp"
#include "math/inline.hpp"
#include "textures/prepared_texture.hpp"

namespace zraka {

/// Hits of one material that has MaterialTextures::in_lanes, on shapes of one space.
struct HitsOfMaterial {
  const std::int32_t* hit;  ///< their numbers; kArrayPadding more may be read
  std::size_t count;
  const MaterialTextures* its;
  const PreparedTexture* textures;  ///< of the scene
  const Transform* to_shape;  ///< from the engine's frame
  double frame_scale;
};

/// Puts what a texture gives into a row of coefficients.
template <class R>
ZRAKA_INLINE void put(Coefficient coefficient, const TextureValue& value, R* row) {
  /// The columns of a coefficient, and how many.
  struct Columns {
    int first, count;
  };
  constexpr Columns kColumnsOf[] = {{kAmbient, 3},   {kDiffuse, 3},    {kSpecular, 3},
                                    {kShininess, 1}, {kReflection, 1}, {kRefraction, 1}};
  const auto [first, count] = kColumnsOf[static_cast<int>(coefficient)];
  if (count == 1) {
    row[first] = static_cast<R>((value.x + value.y + value.z) / 3);
    return;
  }
  row[first] = static_cast<R>(value.x);
  row[first + 1] = static_cast<R>(value.y);
  row[first + 2] = static_cast<R>(value.z);
}

}  // namespace zraka
