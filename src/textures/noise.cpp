// SPDX-License-Identifier: Apache-2.0
// Clouds: a sum of octaves of noise, mapped to the colours from the first to the last.
#include <algorithm>

#include "textures/kinds.hpp"
#include "textures/perlin.hpp"

namespace zraka {
namespace {

TextureValue noise_value(const PreparedTexture& t, const TexturePlace& at) {
  const Fractal fractal{t.octaves, t.seed};
  const double height = fractal(at.point * (1 / t.size), greatest_width(at) / t.size);
  return t.ramp.value(0.5 + 0.5 * height);
}

void noise_values(const PreparedTexture& t, const TexturePlace& at, const V3<double>* points,
                  std::size_t count, TextureValue* values) {
  V3<double> in_grains[Fractal::kMostTogether]{};
  double heights[Fractal::kMostTogether];
  for (std::size_t i = 0; i < count; ++i) in_grains[i] = points[i] * (1 / t.size);
  const Fractal fractal{t.octaves, t.seed};
  fractal.at_each(in_grains, count, greatest_width(at) / t.size, heights);
  for (std::size_t i = 0; i < count; ++i) values[i] = t.ramp.value(0.5 + 0.5 * heights[i]);
}

void prepare_noise(const Texture&, PreparedTexture& texture) {
  texture.ramp = Ramp(Ramp::evenly(texture.colors), false, TextureWrap::clamp);
  const double step = texture.size * finest_grain(texture.octaves) / 32;
  texture.finest = {step, step, step};
}

}  // namespace

const TextureCode texture_kinds::noise = {noise_value, prepare_noise, {"noise", "šum"}, noise_values};

}  // namespace zraka
