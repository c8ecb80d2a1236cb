// SPDX-License-Identifier: Apache-2.0
// Rings around an axis as in a log: each goes through the colours, and back more quickly.
#include "textures/bent.hpp"
#include "textures/kinds.hpp"

namespace zraka {
namespace {

TextureValue wood_value(const PreparedTexture& t, const TexturePlace& at) {
  const Bent x = rings_bent(t, at);
  return t.ramp.mean(x.at, x.width);
}

/// Early wood turns to late wood slowly, and winter is short.
void prepare_wood(const Texture&, PreparedTexture& texture) {
  std::vector<Ramp::Knot> knots = Ramp::evenly(texture.colors);
  for (Ramp::Knot& knot : knots) knot.at *= 0.8;
  knots.push_back({1, texture.colors.front()});
  texture.ramp = Ramp(knots, true, TextureWrap::repeat);
  texture.finest = finest_bent(texture);
}

}  // namespace

const TextureCode texture_kinds::wood = {wood_value, prepare_wood, {"wood", "drvo"}};

}  // namespace zraka
