// SPDX-License-Identifier: Apache-2.0
#include "explain/parts.hpp"

#include <cmath>

namespace zraka {
namespace {

using Gain = std::array<double, 3>;

/// What a clamp leaves of a hit's sum, channel by channel.
Gain left_by_clamp(const ExplainedRay& ray) {
  Gain left{1, 1, 1};
  if (!ray.hit) return left;
  for (std::size_t c = 0; c < 3; ++c) {
    const double share = static_cast<double>(ray.color[c]) / static_cast<double>(ray.hit->sum[c]);
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
      gain = left_by_clamp(ray);
      for (std::size_t c = 0; c < 3; ++c) {
        if (ray.parent < 0) {
          gain[c] /= static_cast<double>(explanation.trees.size());
          continue;
        }
        const auto parent = static_cast<std::size_t>(ray.parent);
        gain[c] *= gains[parent][c] * static_cast<double>(ray.shares[c]);
      }
      const auto add = [&](Source source, std::size_t light, const Float3& term) {
        Part part{t, r, source, light, {}};
        for (std::size_t c = 0; c < 3; ++c) part.amount[c] = gain[c] * static_cast<double>(term[c]);
        parts.push_back(part);
      };
      if (!ray.hit) {
        add(Source::background, 0, ray.color);
        continue;
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
