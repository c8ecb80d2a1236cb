// SPDX-License-Identifier: Apache-2.0
// Layers of colours that blend into each other, bent by turbulence (Perlin, "An image synthesizer",
// 1985).
#include "textures/bent.hpp"
#include "textures/kinds.hpp"

namespace zraka {
namespace {

TextureValue marble_value(const PreparedTexture& t, const TexturePlace& at) {
  const auto count = static_cast<double>(t.colors.size());
  const Bent x = layers_bent(t, at);
  return t.ramp.mean(x.at / count, x.width / count);
}

/// Each colour is pure at a whole number of sizes.
void prepare_marble(const Texture&, PreparedTexture& texture) {
  std::vector<V3<double>> round = texture.colors;
  round.push_back(round.front());
  texture.ramp = Ramp(Ramp::evenly(round), true, TextureWrap::repeat);
  texture.finest = finest_bent(texture);
}

}  // namespace

const TextureCode texture_kinds::marble = {marble_value, prepare_marble, {"marble", "mramor"}};

}  // namespace zraka
