// SPDX-License-Identifier: Apache-2.0
// Layers of colours across a direction, in turn.
#include "textures/kinds.hpp"
#include "textures/turns.hpp"

namespace zraka {
namespace {

TextureValue stripes_value(const PreparedTexture& t, const TexturePlace& at) {
  const double width = width_along(at, t.direction) / t.size;
  return color_in_turn(t.colors, dot(at.point, t.direction) / t.size, width, tolerance(t, at));
}

}  // namespace

const TextureCode texture_kinds::stripes = {stripes_value, nullptr, {"stripes", "pruge"}};

}  // namespace zraka
