// SPDX-License-Identifier: Apache-2.0
#include "formats/losses.hpp"

#include <fmt/format.h>

#include <algorithm>

namespace zraka {

void Losses::count(std::string_view what, std::uint64_t times) {
  if (times == 0) return;
  const auto found = std::find_if(counts_.begin(), counts_.end(),
                                  [&](const auto& count) { return count.first == what; });
  if (found == counts_.end())
    counts_.emplace_back(what, times);
  else
    found->second += times;
}

void Losses::defaults(const Scene& scene, const RenderDefaults& of_format) {
  count("the profile", scene.defaults.profile != of_format.profile);
  count("the depth of rays", scene.defaults.max_depth != of_format.max_depth);
  count("how many rays a pixel has, or their filter",
        !(scene.defaults.sampling == of_format.sampling));
  count("that there are no shadows", scene.defaults.shadows != of_format.shadows);
}

void Losses::textures(const Material& material) {
  count("materials: textures", material.textures.size());
  count("materials: bumps and maps of normals", material.normals.kind != NormalUse::Kind::none);
}

Diagnostics Losses::diagnostics(std::string_view format) const {
  Diagnostics all;
  for (const auto& [what, times] : counts_)
    all.push_back({.severity = Severity::warning,
                   .message = times == 1
                                  ? fmt::format("lost in {}: {}", format, what)
                                  : fmt::format("lost in {}: {} ({} times)", format, what, times)});
  return all;
}

}  // namespace zraka
