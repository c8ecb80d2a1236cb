// SPDX-License-Identifier: Apache-2.0
#include "school/report/listener.hpp"

#include <algorithm>

#include "engine/tile_order.hpp"
#include "render/isa.hpp"

namespace zraka {

void RayTally::add(const RayTally& more) {
  points += more.points;
  later_points += more.later_points;
  unlit += more.unlit;
  lights.resize(std::max(lights.size(), more.lights.size()));
  for (std::size_t i = 0; i < more.lights.size(); ++i) {
    lights[i].facing += more.lights[i].facing;
    lights[i].away += more.lights[i].away;
    lights[i].blocked += more.lights[i].blocked;
    lights[i].dark += more.lights[i].dark;
    lights[i].partly += more.lights[i].partly;
    lights[i].dimmed += more.lights[i].dimmed;
  }
  entering += more.entering;
  leaving += more.leaving;
  total_entering += more.total_entering;
  total_leaving += more.total_leaving;
  ended_reflected += more.ended_reflected;
  ended_refracted += more.ended_refracted;
  absorbed += more.absorbed;
  fresnel += more.fresnel;
  split += more.split;
  deepest = std::max(deepest, more.deepest);
  for (const auto& [what, count] : more.pixels) pixels[what] += count;
  for (int i = 0; i < 2; ++i) total_box[i] = std::min(total_box[i], more.total_box[i]);
  for (int i = 2; i < 4; ++i) total_box[i] = std::max(total_box[i], more.total_box[i]);
}

StageListener::StageListener(const FrozenScene<float>& scene, const TraceSettings& settings,
                             bool corners, std::int32_t width, std::int32_t height,
                             std::int32_t batch)
    : scene_(scene),
      settings_(settings),
      more_(corners ? 1 : 0),
      width_(width),
      height_(height),
      recorder_(scene, settings, batch, *this),
      roots_(static_cast<std::size_t>(settings.max_depth) + 1),
      refracted_(roots_.size()) {
  tally_.lights.resize(static_cast<std::size_t>(scene.light_count));
}

std::size_t StageListener::root(std::size_t depth, const Level<float>& level,
                                std::size_t hit) const {
  return roots_[depth][static_cast<std::size_t>(level.done + level.hits.ray[hit])];
}

float StageListener::material(const Scratch<float>& s, std::size_t hit,
                              MaterialColumn column) const {
  return s.coefficients[s.row[hit] * kMaterialReals + column];
}

void StageListener::note(Tie tie, std::int32_t slot, std::int32_t on, std::size_t root) {
  constexpr std::size_t kMany = std::size_t{1} << 20;
  const TileRect& of = places_[root];
  for (std::int32_t y = of.y; y < of.y + of.height; ++y)
    for (std::int32_t x = of.x; x < of.x + of.width; ++x)
      notes_.push_back({tie, slot, on, static_cast<std::uint32_t>(y * tile_.width + x)});
  if (notes_.size() > kMany) leave_each_once();
}

void StageListener::leave_each_once() {
  std::sort(notes_.begin(), notes_.end());
  notes_.erase(std::unique(notes_.begin(), notes_.end()), notes_.end());
}

void StageListener::at_hits(const Level<float>& level, const Scratch<float>& s) {
  const std::size_t depth = depth_of(level);
  if (depth == 0) reached_.assign(static_cast<std::size_t>(level.hit_count), false);
  const bool last = depth == static_cast<std::size_t>(settings_.max_depth);
  tally_.deepest = std::max(tally_.deepest, depth);
  for (std::size_t h = 0; h < static_cast<std::size_t>(level.hit_count); ++h) {
    const auto ray = static_cast<std::size_t>(level.hits.ray[h]);
    const std::int32_t slot = s.slot[ray];
    const std::size_t from = root(depth, level, h);
    if (depth == 0) {
      first_slot_[from] = slot;
      if (settings_.terms.silhouette) note(Tie::seen, slot, -1, from);
    } else if (!refracted_[depth][static_cast<std::size_t>(level.done) + ray]) {
      note(Tie::mirrored, slot, -1, from);
    } else if (s.inside[h] == 0 || material(s, h, kRefraction) == 0) {
      note(Tie::seen_through, slot, -1, from);
    }
    if (!counts_[from]) continue;
    ++(depth == 0 ? tally_.points : tally_.later_points);
    if (recorder_.general() != nullptr && recorder_.general()->absorbs(h)) ++tally_.absorbed;
    if (!last || settings_.terms.silhouette) continue;
    if (settings_.terms.reflection && material(s, h, kReflection) != 0) ++tally_.ended_reflected;
    if (settings_.terms.refraction && material(s, h, kRefraction) != 0) ++tally_.ended_refracted;
  }
}

/// What only the general engine has.
void StageListener::count_light(RayTally::Light& facts, std::size_t h) const {
  const GeneralRecorder& general = *recorder_.general();
  const general::LightSum<float>& sum = general.sum(h);
  if (general.is_dark(h)) ++facts.dark;
  if (!settings_.terms.shadows || sum.lit == 0) return;
  if (sum.lit < sum.facing) ++facts.partly;
  const std::vector<GeneralRecorder::Body>& passed = general.passed(h);
  if (std::any_of(passed.begin(), passed.end(), [](const auto& body) { return !body.stops; }))
    ++facts.dimmed;
}

void StageListener::at_light(std::int32_t light, std::size_t shadow_rays, const Level<float>& level,
                             const Scratch<float>& s) {
  if (depth_of(level) > 0) return;
  RayTally::Light& facts = tally_.lights[static_cast<std::size_t>(light)];
  const auto hits = static_cast<std::size_t>(level.hit_count);
  const auto counted = [&](std::size_t h) { return counts_[root(0, level, h)] ? 1u : 0u; };
  const bool lean = recorder_.general() == nullptr;
  for (std::size_t h = 0; h < hits; ++h) {
    // The lean engine has no shadow rays outside of a spot's cone.
    const bool dark = lean && recorder_.terms().is_dark(scene_.lights[light], h);
    (dark ? facts.facing : facts.away) += counted(h);
    if (dark) facts.dark += counted(h);
    if (s.lit[h] > 0) reached_[h] = true;
  }
  for (std::size_t i = 0; i < shadow_rays; ++i) {
    const auto h = static_cast<std::size_t>(s.shadow_ray_hit[i]);
    facts.facing += counted(h);
    facts.away -= counted(h);
    if (recorder_.general() != nullptr) {
      if (counted(h) != 0) count_light(facts, h);
      if (recorder_.general()->is_dark(h)) continue;
    }
    if (s.lit[h] > 0) continue;
    facts.blocked += counted(h);
    const std::int32_t by = recorder_.terms().blocker(i, s), on = s.slot[level.hits.ray[h]];
    const std::size_t from = root(0, level, h);
    if (by < 0) continue;
    note(Tie::shadow_by, by, -1, from);
    note(Tie::shadow_on, by, on, from);
    note(Tie::shadow_by, kAnyShape, -1, from);
  }
  if (light + 1 < scene_.light_count) return;
  for (std::size_t h = 0; h < hits; ++h)
    if (!reached_[h]) tally_.unlit += counted(h);
}

void StageListener::at_children(const Level<float>& level, const Level<float>& next) {
  const std::size_t depth = depth_of(level);
  const auto begin = static_cast<std::size_t>(level.done);
  const Scratch<float>& s = recorder_.workspace().scratch;
  const GeneralRecorder* const general = recorder_.general();
  roots_[depth + 1].resize(static_cast<std::size_t>(next.ray_count));
  refracted_[depth + 1].resize(static_cast<std::size_t>(next.ray_count));
  for (std::size_t h = 0; h < static_cast<std::size_t>(level.hit_count); ++h) {
    const std::size_t parent = begin + static_cast<std::size_t>(level.hits.ray[h]);
    recorder_.each_child(level, h, [&](std::int32_t index, bool refracted) {
      const auto child = static_cast<std::size_t>(index);
      roots_[depth + 1][child] = roots_[depth][parent];
      refracted_[depth + 1][child] = refracted_[depth][parent] || refracted;
      tally_.deepest = std::max(tally_.deepest, depth + 1);
    });
    if (!settings_.terms.refraction || material(s, h, kRefraction) == 0) continue;
    const std::size_t from = root(depth, level, h);
    const bool leaves = s.inside[h] > 0;
    const bool total = !(recorder_.terms().at(Quantity::quarter_d, h) >= 0);
    if (total) {
      note(Tie::total, s.slot[level.hits.ray[h]], -1, from);
      note(Tie::total, kAnyShape, -1, from);
    }
    if (!counts_[from]) continue;
    if (general != nullptr && general->state(h).split) ++tally_.split;
    if (general != nullptr && general->has_fresnel(h)) ++tally_.fresnel;
    if (total)
      ++(leaves ? tally_.total_leaving : tally_.total_entering);
    else
      ++(leaves ? tally_.leaving : tally_.entering);
  }
}

void StageListener::read(const TileRect& tile, std::vector<std::int32_t>& seen) {
  tile_ = tile;
  const TileRect rays{tile.x, tile.y, tile.width + more_, tile.height + more_};
  places_.clear();
  counts_.clear();
  // A corner belongs to the pixels right and below, left and above of it; it counts in one tile.
  const bool right_edge = tile.x + tile.width == width_;
  const bool bottom_edge = tile.y + tile.height == height_;
  each_pixel(rays, [&](std::int32_t x, std::int32_t y) {
    const std::int32_t left = std::max(0, x - more_), top = std::max(0, y - more_);
    places_.push_back({left, top, std::min(x, tile.width - 1) - left + 1,
                       std::min(y, tile.height - 1) - top + 1});
    counts_.push_back((x < tile.width || right_edge) && (y < tile.height || bottom_edge));
  });
  roots_[0].resize(places_.size());
  for (std::size_t i = 0; i < places_.size(); ++i) roots_[0][i] = static_cast<std::uint32_t>(i);
  refracted_[0].assign(places_.size(), false);
  first_slot_.assign(places_.size(), kNothingSeen);

  recorder_.trace(rays);

  const auto index = [&](std::int32_t x, std::int32_t y) {
    return static_cast<std::size_t>(tile.y + y) * static_cast<std::size_t>(width_) +
           static_cast<std::size_t>(tile.x + x);
  };
  constexpr std::int32_t kUnset = INT32_MIN;
  each_pixel(tile, [&](std::int32_t x, std::int32_t y) { seen[index(x, y)] = kUnset; });
  for (std::size_t i = 0; i < places_.size(); ++i)
    for (std::int32_t y = places_[i].y; y < places_[i].y + places_[i].height; ++y)
      for (std::int32_t x = places_[i].x; x < places_[i].x + places_[i].width; ++x) {
        std::int32_t& there = seen[index(x, y)];
        there = there == kUnset || there == first_slot_[i] ? first_slot_[i] : kSeveralSeen;
      }

  leave_each_once();
  for (const auto& [tie, slot, on, pixel] : notes_) {
    ++tally_.pixels[{tie, slot, on}];
    if (tie != Tie::total) continue;
    const std::int32_t x = tile.x + static_cast<std::int32_t>(pixel) % tile.width;
    const std::int32_t y = tile.y + static_cast<std::int32_t>(pixel) / tile.width;
    std::int32_t* box = tally_.total_box;
    box[0] = std::min(box[0], x), box[1] = std::min(box[1], y);
    box[2] = std::max(box[2], x), box[3] = std::max(box[3], y);
  }
  notes_.clear();
}

}  // namespace zraka
