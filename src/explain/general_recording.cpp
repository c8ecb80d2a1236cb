// SPDX-License-Identifier: Apache-2.0
#include "explain/general_recording.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "explain/camera_rays.hpp"
#include "render/isa.hpp"

namespace zraka {
namespace {

bool same_way(const HitPath& a, const HitPath& b) {
  return a.group == b.group && a.slot == b.slot && a.depth == b.depth &&
         std::equal(a.instance, a.instance + a.depth, b.instance);
}

}  // namespace

GeneralRecorder::GeneralRecorder(const FrozenScene<float>& scene, const TraceSettings& settings,
                                 std::int32_t batch, Recording<float>& recording)
    : scene_(scene),
      settings_(settings),
      memory_(batch, scene, settings),
      recording_(recording),
      passed_(static_cast<std::size_t>(batch)) {}

void GeneralRecorder::trace(const TileRect& tile) {
  RayCounts counts;
  memory_.general->workspace().listener = this;
  put_camera_rays(scene_, tile, 0, workspace());
  trace_rays(kernel_of(Isa::portable), scene_, settings_, memory_, counts);
}

bool GeneralRecorder::absorbs(std::size_t h) const {
  return states_[h].medium >= 0 && scene_.optics->materials[states_[h].medium].absorbs();
}

bool GeneralRecorder::is_dark(std::size_t h) const {
  const V3<float>& arrives = sums_[h].radiance;
  return scene_.optics->lights[light_].kind == LightKind::spot && arrives.x == 0 &&
         arrives.y == 0 && arrives.z == 0;
}

void GeneralRecorder::at_hits(const Level<float>& level, const Scratch<float>& scratch,
                              const general::GeneralWorkspace<float>& workspace,
                              const V3<float>*) {
  states_ = workspace.hits[depth_of(level)].data();
  recording_.at_hits(recording_.reader, level, scratch);
}

void GeneralRecorder::at_passed(const general::Passed<float>& passed) {
  if (passed.slot < 0) return;
  std::vector<Body>& bodies = passed_[static_cast<std::size_t>(passed.hit)];
  const bool stops = passed.share.x == 0 && passed.share.y == 0 && passed.share.z == 0;
  const auto known = std::find_if(bodies.begin(), bodies.end(), [&](const Body& body) {
    return body.slot == passed.slot && body.stops == stops && same_way(body.path, *passed.path);
  });
  if (known == bodies.end())
    bodies.push_back({passed.slot, passed.sample, *passed.path, passed.distance, stops});
  else if (passed.sample < known->sample)
    known->sample = passed.sample, known->distance = passed.distance;
}

void GeneralRecorder::at_light(std::int32_t light, const Level<float>& level,
                               const general::LightSum<float>* sums) {
  const Scratch<float>& s = workspace().scratch;
  light_ = light;
  sums_ = sums;
  const auto keep = [&](Quantity term, std::size_t h, double value) {
    recording_.terms[static_cast<int>(term)][h] = static_cast<float>(value);
  };
  std::size_t shadow_rays = 0;
  for (std::size_t h = 0; h < static_cast<std::size_t>(level.hit_count); ++h) {
    const general::LightSum<float>& sum = sums[h];
    keep(Quantity::light_distance, h, sum.distance);
    keep(Quantity::l_n, h, sum.l_n);
    keep(Quantity::r_v, h, sum.cosine);
    keep(Quantity::highlight, h, sum.highlight);
    const bool unchecked = !settings_.terms.shadows && sum.facing > 0;
    s.lit[h] = sum.lit > 0 || unchecked ? 1.0f : 0.0f;
    if (sum.facing == 0) continue;
    const std::size_t i = shadow_rays++;
    s.shadow_ray_hit[i] = static_cast<std::int32_t>(h);
    s.sdistance[i] = std::numeric_limits<float>::infinity();
    recording_.blocker[i] = -1;
    recording_.blocker_t[i] = s.sdistance[i];
    const Body* by = nullptr;
    for (const Body& body : passed_[h])
      if (body.stops && (by == nullptr || body.sample < by->sample)) by = &body;
    if (sum.lit > 0 || by == nullptr) continue;
    recording_.blocker[i] = by->slot;
    recording_.blocker_t[i] = static_cast<float>(by->distance);
    if (recording_.blocker_path != nullptr) recording_.blocker_path[i] = by->path;
  }
  recording_.at_light(recording_.reader, light, shadow_rays, level, s);
  for (std::size_t h = 0; h < static_cast<std::size_t>(level.hit_count); ++h) passed_[h].clear();
}

void GeneralRecorder::at_children(const Level<float>& level, const Level<float>& next,
                                  const general::GeneralWorkspace<float>& workspace) {
  children_ = workspace.rays[depth_of(level) + 1].data();
  for (std::size_t h = 0; h < static_cast<std::size_t>(level.hit_count); ++h) {
    const auto keep = [&](Quantity term, double value) {
      recording_.terms[static_cast<int>(term)][h] = static_cast<float>(value);
    };
    keep(Quantity::cosine, states_[h].cosine);
    keep(Quantity::ratio, states_[h].ratio);
    keep(Quantity::quarter_d, states_[h].quarter_d);
    keep(Quantity::along_normal, std::sqrt(std::fmax(states_[h].quarter_d, 0.0)) -
                                     states_[h].ratio * states_[h].cosine);
  }
  recording_.at_children(recording_.reader, level, next);
}

void GeneralRecorder::at_fold(const Level<float>& level,
                              const general::GeneralWorkspace<float>&) {
  recording_.at_fold(recording_.reader, level);
}

void TileRecorder::trace(const TileRect& tile) {
  if (general_) return general_->trace(tile);
  RayCounts counts;
  record_tile()(scene_, settings_, tile, memory_->workspace(), counts, ignored_.data(),
                static_cast<std::size_t>(tile.width), terms_.recording());
}

}  // namespace zraka
