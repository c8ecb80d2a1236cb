// SPDX-License-Identifier: Apache-2.0
#include "render/prepare.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <vector>

#include "accel/build.hpp"

namespace zraka {
namespace {

/// So many shapes are asked one by one as fast as through a hierarchy; so many if there are bodies
/// among them, which take long to ask.
constexpr std::uint64_t kFewShapes = 16, kFewBodies = 1;

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
  if (options.transparent && !options.sampling.is_single())
    found.push_back({.message = "a transparent picture has one sample a pixel"});
  for (Diagnostic& problem : check(scene)) found.push_back(std::move(problem));
  return found;
}

TraceSettings settings_of(const RenderOptions& options, const Frame& frame, int variation) {
  return {options.terms,
          options.max_depth,
          options.profile.clamp_levels,
          options.profile.mirror_when_total,
          variation,
          static_cast<float>(frame.world_length(1))};
}

namespace {

/// Builds the hierarchy of a scene's shapes, or of a group's.
template <class R>
void add_hierarchy(FrozenStore<R>& store, BuiltHierarchy& hierarchy) {
  const std::vector<std::int32_t> kind_starts = kind_starts_of(store.scene);
  const auto count = static_cast<std::size_t>(kind_starts.back());
  if (count > (store.scene.bodies.bounded > 0 ? kFewBodies : kFewShapes)) {
    BuildRefs refs(count);
    refer_to(store.scene, refs.data());
    hierarchy = build_hierarchy(std::move(refs), kind_starts);
    // Slots outside of the hierarchy come after all leaves.
    if (!hierarchy.rank.empty())
      for (std::int32_t i = store.scene.bodies.bounded; i < store.scene.bodies.count; ++i)
        hierarchy.rank.push_back(store.scene.bodies.first_slot + i);
  }
  reorder_by_leaf(store, hierarchy);
  hierarchy.order = {};
}

template <class R>
void finish(PreparedScene<R>& prepared) {
  FrozenStore<R>& store = *prepared.store;
  store.group_hierarchies.resize(store.groups.size());
  for (std::size_t i = 0; i < store.groups.size(); ++i) {
    add_hierarchy(*store.group_stores[i], store.group_hierarchies[i]);
    store.groups[i] = store.group_stores[i]->scene;
  }
  add_hierarchy(store, prepared.hierarchy);
}

}  // namespace

template <class R>
PreparedScene<R> prepare(const Scene& scene, const Profile& profile) {
  PreparedScene<R> prepared{frame_of(scene), {}, nullptr};
  prepared.store = freeze<R>(scene, profile, prepared.frame);
  finish(prepared);
  return prepared;
}

template <class R>
PreparedScene<R> prepare(Scene&& scene, const Profile& profile) {
  PreparedScene<R> prepared{frame_of(scene), {}, nullptr};
  prepared.store = freeze<R>(scene, profile, prepared.frame);
  scene = Scene();
  finish(prepared);
  return prepared;
}

template PreparedScene<float> prepare<float>(const Scene&, const Profile&);
template PreparedScene<double> prepare<double>(const Scene&, const Profile&);
template PreparedScene<float> prepare<float>(Scene&&, const Profile&);
template PreparedScene<double> prepare<double>(Scene&&, const Profile&);

}  // namespace zraka
