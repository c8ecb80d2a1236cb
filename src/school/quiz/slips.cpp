// SPDX-License-Identifier: Apache-2.0
#include "school/quiz/slips.hpp"

namespace zraka {
namespace {

/// What the colour of a hit is made of, for one thing of it to be changed.
struct Recipe {
  Float3 ambient{}, diffuse{}, specular{};  ///< the last two of all lights together
  float k1 = 0, k2 = 0;                     ///< 0 where there is no such ray
  Float3 reflected{}, refracted{};

  Float3 sum() const {
    Float3 sum{};
    for (std::size_t c = 0; c < 3; ++c)
      sum[c] = ambient[c] + diffuse[c] + specular[c] + k1 * reflected[c] + k2 * refracted[c];
    return sum;
  }
};

void add(Float3& to, const Float3& term) {
  for (std::size_t c = 0; c < 3; ++c) to[c] += term[c];
}

Recipe recipe_of(const Explanation& explanation) {
  const std::vector<ExplainedRay>& rays = explanation.trees.front().rays;
  const ExplainedHit& hit = *rays.front().hit;
  Recipe recipe{.ambient = hit.ambient};
  for (const LightTerms& at : hit.lights) {
    if (at.diffuse) add(recipe.diffuse, *at.diffuse);
    if (at.specular) add(recipe.specular, *at.specular);
  }
  const auto take = [&](const Child& child, float& share, Float3& color) {
    if (child.ray < 0) return;
    share = child.share;
    color = rays[static_cast<std::size_t>(child.ray)].color;
  };
  take(hit.reflected, recipe.k1, recipe.reflected);
  take(hit.refracted, recipe.k2, recipe.refracted);
  return recipe;
}

/// The diffuse terms as they are where L·N is left out.
Float3 diffuse_without_cosine(const Explanation& explanation) {
  const ExplainedHit& hit = *explanation.trees.front().rays.front().hit;
  Float3 diffuse{};
  for (std::size_t i = 0; i < hit.lights.size(); ++i)
    for (std::size_t c = 0; c < 3 && hit.lights[i].diffuse; ++c)
      diffuse[c] += explanation.lights[i].color[c] * hit.kd[c];
  return diffuse;
}

/// A value above 1 as the lowest byte of its integer.
std::array<std::uint8_t, 3> wrapped(const Float3& color) {
  std::array<std::uint8_t, 3> bytes{};
  for (std::size_t c = 0; c < 3; ++c) {
    const double value = 255 * static_cast<double>(color[c]) + 0.5;
    bytes[c] = value > 0 && value < 65536
                   ? static_cast<std::uint8_t>(static_cast<unsigned>(value) & 255)
                   : std::uint8_t{0};
  }
  return bytes;
}

}  // namespace

std::array<std::uint8_t, 3> stored_color(const Float3& color, Transfer transfer) {
  std::array<std::uint8_t, 3> bytes{};
  for (std::size_t c = 0; c < 3; ++c)
    bytes[c] = static_cast<std::uint8_t>(quantize(color[c], transfer, 8));
  return bytes;
}

std::vector<Slip> slips_of(const Explanation& explanation,
                           const std::optional<Explanation>& unshadowed) {
  std::vector<Slip> slips;
  const Transfer transfer = explanation.profile.transfer;
  const Recipe right = recipe_of(explanation);
  const auto changed = [&](Word what, const auto& change) {
    Recipe recipe = right;
    change(recipe);
    slips.push_back({what, stored_color(recipe.sum(), transfer)});
  };
  if (explanation.terms.ambient) changed(Word::slip_no_ambient, [](Recipe& r) { r.ambient = {}; });
  if (explanation.terms.diffuse) {
    changed(Word::slip_no_diffuse, [](Recipe& r) { r.diffuse = {}; });
    changed(Word::slip_no_cosine,
            [&](Recipe& r) { r.diffuse = diffuse_without_cosine(explanation); });
  }
  if (explanation.terms.specular)
    changed(Word::slip_no_specular, [](Recipe& r) { r.specular = {}; });
  if (unshadowed) {
    const Recipe lit = recipe_of(*unshadowed);
    changed(Word::slip_no_shadow, [&](Recipe& r) {
      r.diffuse = lit.diffuse;
      r.specular = lit.specular;
    });
  }
  const Child& reflected = explanation.trees.front().rays.front().hit->reflected;
  const Child& refracted = explanation.trees.front().rays.front().hit->refracted;
  if (reflected.ray >= 0) {
    changed(Word::slip_no_reflected, [](Recipe& r) { r.k1 = 0; });
    changed(Word::slip_k1, [](Recipe& r) { r.k1 = 1; });
  }
  if (refracted.ray >= 0) {
    changed(Word::slip_no_refracted, [](Recipe& r) { r.k2 = 0; });
    changed(Word::slip_k2, [](Recipe& r) { r.k2 = 1; });
  }
  if (reflected.ray >= 0 && refracted.ray >= 0)
    changed(Word::slip_swapped, [](Recipe& r) { std::swap(r.k1, r.k2); });
  if (transfer == Transfer::linear)
    slips.push_back({Word::slip_wrapped, wrapped(right.sum())});
  else
    slips.push_back({Word::slip_no_curve, stored_color(right.sum(), Transfer::linear)});
  return slips;
}

}  // namespace zraka
