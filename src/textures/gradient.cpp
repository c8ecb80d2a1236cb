// SPDX-License-Identifier: Apache-2.0
// Colours evenly from 0 to a length along a direction, each blended into the next.
#include <algorithm>
#include <cmath>

#include "textures/kinds.hpp"

namespace zraka {
namespace {

TextureValue gradient_value(const PreparedTexture& t, const TexturePlace& at) {
  double s = dot(at.point, t.direction) / t.size;
  // Where the last colour meets the first, as borders of cells.
  const double next = std::floor(s + tolerance(t, at));
  if (t.wrap == TextureWrap::repeat) s = std::max(s, next);
  return t.ramp.mean(s, width_along(at, t.direction) / t.size);
}

void prepare_gradient(const Texture&, PreparedTexture& texture) {
  texture.ramp = Ramp(Ramp::evenly(texture.colors), false, texture.wrap);
  const double step = texture.size / (64 * static_cast<double>(texture.colors.size()));
  texture.finest = {step, step, step};
}

}  // namespace

const TextureCode texture_kinds::gradient = {gradient_value, prepare_gradient, {"gradient", "prijelaz boja"}};

}  // namespace zraka
