// SPDX-License-Identifier: Apache-2.0
// Cubes of two colours, from the origin of the texture on.
#include "textures/kinds.hpp"
#include "textures/turns.hpp"

namespace zraka {
namespace {

/// The first colour where the sum of the cells floor(p/size) is even. Each axis gives a sign, or,
/// where a footprint is wide, the mean of one; their product is exact for a box along the axes.
TextureValue checker_value(const PreparedTexture& t, const TexturePlace& at) {
  const double below = tolerance(t, at);
  const auto sign = [&](double p, const V3<double>& axis) {
    return sign_in_turn(p / t.size, width_along(at, axis) / t.size, below);
  };
  const double product =
      sign(at.point.x, {1, 0, 0}) * sign(at.point.y, {0, 1, 0}) * sign(at.point.z, {0, 0, 1});
  const double first = 0.5 + 0.5 * product;
  return t.colors[0] * first + t.colors[1] * (1 - first);
}

}  // namespace

const TextureCode texture_kinds::checker = {checker_value, nullptr, {"checker", "šahovnica"}};

}  // namespace zraka
