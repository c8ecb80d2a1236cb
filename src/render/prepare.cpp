// SPDX-License-Identifier: Apache-2.0
#include "render/prepare.hpp"

#include <fmt/format.h>

#include "accel/build.hpp"

namespace zraka {
namespace {

/// So many shapes are asked one by one as fast as through a hierarchy.
constexpr std::uint64_t kFewShapes = 16;

}  // namespace

Diagnostics check_request(const Scene& scene, const RenderOptions& options) {
  Diagnostics found;
  const auto in_range = [&](const char* what, int value, int low, int high) {
    if (value < low || value > high)
      found.push_back(
          {.message = fmt::format("{} {} is out of range: {} to {}", what, value, low, high)});
  };
  in_range("depth", options.max_depth, 0, kMaxDepth);
  in_range("number of threads", options.threads, 0, kMaxThreads);
  in_range("tile side", options.tile, 0, kMaxTile);
  for (Diagnostic& problem : check(scene)) found.push_back(std::move(problem));
  return found;
}

TraceSettings settings_of(const RenderOptions& options) {
  return {options.terms, options.max_depth, options.profile.clamp_levels,
          options.profile.mirror_when_total};
}

template <class R>
PreparedScene<R> prepare(const Scene& scene, const Profile& profile) {
  PreparedScene<R> prepared{frame_of(scene), {}, nullptr};
  if (scene.shape_count() > kFewShapes) {
    std::vector<BuildRef> refs = references_to(scene, prepared.frame);
    prepared.hierarchy = build_hierarchy(refs, kKinds);
  }
  prepared.store = freeze<R>(scene, profile, prepared.frame, prepared.hierarchy);
  return prepared;
}

template PreparedScene<float> prepare<float>(const Scene&, const Profile&);
template PreparedScene<double> prepare<double>(const Scene&, const Profile&);

}  // namespace zraka
