// SPDX-License-Identifier: Apache-2.0
#include "explain/parts.hpp"

#include <cmath>

#include "explain/optics_words.hpp"

namespace zraka {
namespace {

using Gain = std::array<double, 3>;

/// What clamp and medium leave of a hit's sum, channel by channel.
Gain left_of_sum(const Explanation& explanation, const ExplainedRay& ray) {
  Gain left{1, 1, 1};
  if (!ray.hit) return left;
  const Float3 brought = before_fog(explanation, ray);
  for (std::size_t c = 0; c < 3; ++c) {
    const double share = static_cast<double>(brought[c]) / static_cast<double>(ray.hit->sum[c]);
    if (std::isfinite(share)) left[c] = share;
  }
  return left;
}

}  // namespace

double Part::size() const {
  const double size = std::fabs(amount[0]) + std::fabs(amount[1]) + std::fabs(amount[2]);
  return std::isfinite(size) ? size : 0;
}

std::vector<Part> parts_of(const Explanation& explanation) {
  std::vector<Part> parts;
  for (std::size_t t = 0; t < explanation.trees.size(); ++t) {
    const RayTree& tree = explanation.trees[t];
    std::vector<Gain> gains(tree.rays.size());
    for (std::size_t r = 0; r < tree.rays.size(); ++r) {
      const ExplainedRay& ray = tree.rays[r];
      // Parents come before their children.
      Gain& gain = gains[r];
      gain = left_of_sum(explanation, ray);
      Gain of_ray{1, 1, 1};  // of what the ray brings
      for (std::size_t c = 0; c < 3; ++c) {
        if (ray.parent < 0)
          of_ray[c] /= static_cast<double>(explanation.trees.size());
        else
          of_ray[c] *= gains[static_cast<std::size_t>(ray.parent)][c] *
                       static_cast<double>(ray.shares[c]);
        gain[c] *= of_ray[c] * (ray.fog ? static_cast<double>(ray.fog->left) : 1.0);
      }
      const auto add_with = [&](const Gain& by, Source source, std::size_t light,
                                const Float3& term) {
        Part part{t, r, source, light, {}};
        for (std::size_t c = 0; c < 3; ++c) part.amount[c] = by[c] * static_cast<double>(term[c]);
        parts.push_back(part);
      };
      const auto add = [&](Source source, std::size_t light, const Float3& term) {
        add_with(gain, source, light, term);
      };
      Float3 of_fog{};
      if (ray.fog) {
        for (std::size_t c = 0; c < 3; ++c) of_fog[c] = ray.fog->color[c] * (1 - ray.fog->left);
        add_with(of_ray, Source::fog, 0, of_fog);
      }
      if (!ray.hit) {
        Float3 sky = ray.color;
        for (std::size_t c = 0; c < 3; ++c) sky[c] = sky[c] - of_fog[c];
        add_with(of_ray, Source::background, 0, sky);
        continue;
      }
      if (const auto& beyond = ray.hit->sky_beyond) {
        add(Source::background, 0, beyond->reflected);
        add(Source::background, 0, beyond->refracted);
      }
      add(explanation.terms.silhouette ? Source::silhouette : Source::ambient, 0, ray.hit->ambient);
      for (std::size_t l = 0; l < ray.hit->lights.size(); ++l) {
        const LightTerms& at = ray.hit->lights[l];
        if (at.diffuse) add(Source::diffuse, l, *at.diffuse);
        if (at.specular) add(Source::specular, l, *at.specular);
      }
    }
  }
  return parts;
}

}  // namespace zraka
