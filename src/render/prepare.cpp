// SPDX-License-Identifier: Apache-2.0
#include "render/prepare.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include "accel/build.hpp"
#include "engine/general/wavelengths.hpp"
#include "scene/freeze_lights.hpp"
#include "scene/reals.hpp"

namespace zraka {
namespace {

/// So many shapes are asked one by one as fast as through a hierarchy; so many if there are bodies
/// among them, which take long to ask.
constexpr std::uint64_t kFewShapes = 16, kFewBodies = 1;

}  // namespace

namespace {

/// Words for what is wrong with sampling, and "" if nothing is.
std::string problem_with(const Sampling& sampling) {
  const int most = sampling.kind == Sampling::Kind::grid ? kMaxGrid : kMaxSamples;
  if (sampling.count < 1 || sampling.count > most)
    return fmt::format("{} {} is out of range: 1 to {}",
                       sampling.kind == Sampling::Kind::grid ? "grid" : "number of samples",
                       sampling.count, most);
  if (sampling.kind != Sampling::Kind::adaptive) return "";
  if (sampling.most < sampling.count || sampling.most > kMaxSamples)
    return fmt::format("greatest number of samples {} is out of range: {} to {}", sampling.most,
                       sampling.count, kMaxSamples);
  if (!(sampling.contrast >= 0 && sampling.contrast <= 1))
    return fmt::format("contrast {} is out of range: 0 to 1", sampling.contrast);
  return "";
}

/// The same of a crop.
std::string problem_with(const PixelRect& crop, const Resolution& size) {
  if (crop.width == 0 || crop.height == 0) return "the crop has no pixels";
  if (std::uint64_t{crop.x} + crop.width > size.width ||
      std::uint64_t{crop.y} + crop.height > size.height)
    return fmt::format(
        "the crop of {}×{} pixels from ({}, {}) on is not within the picture of "
        "{}×{} pixels",
        crop.width, crop.height, crop.x, crop.y, size.width, size.height);
  return "";
}

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
  in_range("width of outlines", options.outlines, 0, kMaxOutlines);
  in_range("number of wavelengths", options.wavelengths, 1, kMaxWavelengths);
  if (!(options.min_contribution >= 0 && std::isfinite(options.min_contribution)))
    found.push_back({.message = fmt::format("least contribution {} is out of range: 0 or more",
                                            options.min_contribution)});
  if (std::string problem = problem_with(options.sampling); !problem.empty())
    found.push_back({.message = std::move(problem)});
  if (options.crop)
    if (std::string problem = problem_with(*options.crop, scene.resolution); !problem.empty())
      found.push_back({.message = std::move(problem)});
  for (Diagnostic& problem : check(scene)) found.push_back(std::move(problem));
  return found;
}

namespace {

/// Builds the hierarchy of a scene's shapes, or of a group's.
template <class R>
void add_hierarchy(FrozenStore<R>& store, BuiltHierarchy& hierarchy, const RenderOptions& options) {
  if (is_cancelled(options)) return;
  const std::vector<std::int32_t> kind_starts = kind_starts_of(store.scene);
  const auto count = static_cast<std::size_t>(kind_starts.back());
  if (count > (store.scene.bodies.bounded > 0 ? kFewBodies : kFewShapes)) {
    BuildRefs refs(count);
    refer_to(store.scene, refs.data());
    hierarchy = build_hierarchy(std::move(refs), kind_starts, options.cancel);
    if (is_cancelled(options)) return;
    // Slots outside of the hierarchy come after all leaves.
    if (!hierarchy.rank.empty())
      for (std::int32_t i = store.scene.bodies.bounded; i < store.scene.bodies.count; ++i)
        hierarchy.rank.push_back(store.scene.bodies.first_slot + i);
  }
  reorder_by_leaf(store, hierarchy);
  hierarchy.order = {};
}

template <class R>
void finish(PreparedScene<R>& prepared, const RenderOptions& options) {
  FrozenStore<R>& store = *prepared.store;
  store.group_hierarchies.resize(store.groups.size());
  for (std::size_t i = 0; i < store.groups.size(); ++i) {
    add_hierarchy(*store.group_stores[i], store.group_hierarchies[i], options);
    store.groups[i] = store.group_stores[i]->scene;
  }
  add_hierarchy(store, prepared.hierarchy, options);
  add_opaque_scene(store, options.shadows == Shadows::transparent);
}

/// Whether what is asked for is beyond the lean engine, whatever the scene's optics.
bool asks_for_more(const RenderOptions& options) {
  return options.shadows == Shadows::transparent || options.min_contribution > 0;
}

/// No ray brings more than this, by any channel.
double brightest_of(const FrozenOptics& optics, const RenderOptions& options,
                    const Wavelengths& waves) {
  // The parts of split light are of all channels together, of some less than nothing.
  double parts = 1;
  for (int c = 0; c < 3 && optics.dispersive; ++c) {
    double sum = 0;
    for (int i = 0; i < waves.count; ++i) sum += std::fabs(static_cast<double>(waves.weight[i][c]));
    parts = std::max(parts, sum);
  }
  const double shares = optics.most_shares * parts;
  const auto shown = [&](double light) {
    return std::max(optics.most_sky, options.profile.clamp_levels ? std::min(light, 1.0) : light);
  };
  double most = shown(optics.most_local);
  for (int level = 0; level < options.max_depth && shares > 0; ++level)
    most = shown(optics.most_local + shares * most);
  return most;
}

}  // namespace

bool needs_general_engine(const Scene& scene, const RenderOptions& options) {
  return has_optics(scene) || asks_for_more(options);
}

bool is_beyond_the_lab(const Scene& scene, const RenderOptions& options) {
  return needs_general_engine(scene, options) || options.profile.sky_beyond ||
         std::any_of(scene.lights.begin(), scene.lights.end(), fades) ||
         std::any_of(scene.materials.begin(), scene.materials.end(), [](const Material& m) {
           return m.highlight != Highlight::phong || !m.casts_shadow;
         });
}

template <class R>
TraceSettings settings_of(const RenderOptions& options, const PreparedScene<R>& prepared,
                          const Variation& variation) {
  TraceSettings settings;
  settings.terms = options.terms;
  settings.terms.shadows = options.terms.shadows && options.shadows != Shadows::off;
  settings.max_depth = options.max_depth;
  settings.clamp_levels = options.profile.clamp_levels;
  settings.mirror_when_total = options.profile.mirror_when_total;
  settings.sky_beyond = options.profile.sky_beyond;
  settings.variation = variation.number;
  settings.unit = static_cast<float>(prepared.frame.world_length(1));
  const FrozenOptics* const optics = prepared.store->scene.optics;
  if (optics == nullptr) return settings;
  settings.filter_surfaces = options.profile.filter_surfaces;
  settings.transparent_shadows = options.shadows == Shadows::transparent;
  settings.min_contribution = options.min_contribution;
  settings.seed = options.sampling.seed;
  settings.wavelengths = wavelengths_in(options.wavelengths);
  settings.brightest = brightest_of(*optics, options, settings.wavelengths);
  if (variation.vary_settings) variation.vary_settings(settings);
  return settings;
}

template <class R>
PreparedScene<R> prepare(const Scene& scene, const RenderOptions& options) {
  PreparedScene<R> prepared{frame_of(scene), {}, nullptr};
  prepared.store = freeze<R>(scene, options.profile, prepared.frame, asks_for_more(options));
  finish(prepared, options);
  return prepared;
}

template <class R>
PreparedScene<R> prepare_with_room(const Scene& scene, const RenderOptions& options, R room) {
  PreparedScene<R> prepared{frame_of(scene), {}, nullptr};
  prepared.store = freeze<R>(scene, options.profile, prepared.frame, asks_for_more(options));
  FrozenCamera<R>& camera = prepared.store->scene.camera;
  const FrozenCamera<R> own = camera;
  camera.beyond = std::max(camera.beyond, room);
  finish(prepared, options);
  camera = own;
  return prepared;
}

template <class R>
PreparedScene<R> prepare(Scene&& scene, const RenderOptions& options) {
  PreparedScene<R> prepared{frame_of(scene), {}, nullptr};
  prepared.store = freeze<R>(scene, options.profile, prepared.frame, asks_for_more(options));
  scene = Scene();
  finish(prepared, options);
  return prepared;
}

#define ZRAKA_FOR(R)                                                                     \
  template PreparedScene<R> prepare<R>(const Scene&, const RenderOptions&);              \
  template PreparedScene<R> prepare<R>(Scene&&, const RenderOptions&);                   \
  template PreparedScene<R> prepare_with_room<R>(const Scene&, const RenderOptions&, R); \
  template TraceSettings settings_of(const RenderOptions&, const PreparedScene<R>&, const Variation&);
ZRAKA_FOR_REALS(ZRAKA_FOR)
#undef ZRAKA_FOR

}  // namespace zraka
