// SPDX-License-Identifier: Apache-2.0
// Tubes of colours around an axis, in turn.
#include "textures/bent.hpp"
#include "textures/kinds.hpp"
#include "textures/turns.hpp"

namespace zraka {
namespace {

TextureValue rings_value(const PreparedTexture& t, const TexturePlace& at) {
  const Bent x = rings_bent(t, at);
  return color_in_turn(t.colors, x.at, x.width, tolerance(t, at));
}

void prepare_rings(const Texture&, PreparedTexture& texture) {
  texture.finest = finest_bent(texture);
}

}  // namespace

const TextureCode texture_kinds::rings = {rings_value, prepare_rings, {"rings", "prstenovi"}};

}  // namespace zraka
