// SPDX-License-Identifier: Apache-2.0
// Listens to the renderer's own steps on a tile of one pixel.
#include "explain/tree_reader.hpp"

#include <fmt/format.h>

#include <cmath>
#include <limits>

#include "explain/general_reader.hpp"
#include "explain/hit_reader.hpp"
#include "render/workspace.hpp"

namespace zraka {
namespace {

/// Builds the tree of one ray from what the steps tell. Each level has to come in one batch.
class TreeReader {
 public:
  TreeReader(const Stand& stand, const TraceSettings& settings, std::int32_t batch)
      : stand_(stand),
        settings_(settings),
        hit_reader_(stand.scene, *stand.prepared.store, stand.prepared.frame),
        workspace_(batch, settings.max_depth, true, true),
        terms_(batch, *this, true),
        first_(static_cast<std::size_t>(settings.max_depth) + 2) {}

  /// Puts a sample's ray to where read() takes it from. False if there is none.
  bool place_sample(std::int32_t x, std::int32_t y, std::uint32_t sample) {
    const SampleRays<float> samples(stand_.frozen().camera, stand_.options.profile,
                                    stand_.options.sampling, stand_.frozen().textures != nullptr);
    workspace_.workspace().levels[0].ray_count = 1;
    return samples.make(x, y, sample, workspace_.workspace(), 0) !=
           SampleRays<float>::Made::nothing;
  }

  /// False if the tree does not fit.
  bool read(const TileRect& pixel) {
    RayCounts counts;
    if (!stand_.plain()) {
      record_rays()(stand_.frozen(), settings_, workspace_.workspace(), counts, terms_.recording());
      return !terms_.recording().stop;
    }
    Float3 ignored{};
    (stand_.variation.record == nullptr ? record_tile() : *stand_.variation.record)(
        stand_.frozen(), settings_, pixel, workspace_.workspace(), counts, ignored.data(), 1,
        terms_.recording());
    return !terms_.recording().stop;
  }
  RayTree& tree() { return tree_; }
  const TooLarge& too_large() const { return too_large_; }
  bool shadow_rays_disagree() const { return shadow_rays_disagree_; }

  void at_hits(const Level<float>& level, const Scratch<float>& s);
  void at_light(std::int32_t light, std::size_t shadow_rays, const Level<float>& level,
                const Scratch<float>& s);
  void at_children(const Level<float>& level, const Level<float>& next);
  void at_fold(const Level<float>& level);

 private:
  /// A ray of the next level.
  struct Awaited {
    RayKind kind;
    int parent;
    double weight;
    Float3 shares{1, 1, 1};
  };

  std::size_t depth_of(const Level<float>& level) {
    return static_cast<std::size_t>(&level - workspace_.workspace().levels);
  }
  std::size_t ray_of_hit(const Level<float>& level, std::size_t h) {
    return first_[depth_of(level)] + static_cast<std::size_t>(level.hits.ray[h]);
  }
  ExplainedHit& hit(const Level<float>& level, std::size_t h) {
    return *tree_.rays[ray_of_hit(level, h)].hit;
  }
  /// What comes of a light to a hit, if nothing blocks it.
  Float3 arriving(std::int32_t index, std::size_t h) const {
    const FrozenLight<float>& light = stand_.frozen().lights[index];
    const V3<float> c =
        light.fading.any ? light.color * terms_.at(Quantity::strength, h) : light.color;
    return {c.x, c.y, c.z};
  }
  /// Whether children of the level's hits, which are too deep to be traced, have the sky's colour.
  bool sees_beyond(const Level<float>& level) {
    return settings_.sky_beyond && !settings_.terms.silhouette &&
           depth_of(level) == static_cast<std::size_t>(settings_.max_depth);
  }
  std::optional<SkyBeyond> sky_beyond(const Level<float>& level, std::size_t h) const;
  ExplainedHit surface(const Level<float>& level, const Scratch<float>& s, std::size_t h) const;
  Absence absence(float share, bool in_stage) const;

  const Stand& stand_;
  const TraceSettings& settings_;
  HitReader hit_reader_;
  WorkspaceMemory<float> workspace_;
  RecordedTerms terms_;
  RayTree tree_;
  std::vector<std::size_t> first_;  ///< index of each level's first ray in the tree
  std::vector<Awaited> awaited_{{RayKind::camera, -1, 1.0}};
  TooLarge too_large_;
  bool shadow_rays_disagree_ = false;
};

/// Why a hit on the deepest level, or in a stage without such rays, has no child.
Absence TreeReader::absence(float share, bool in_stage) const {
  if (share == 0) return Absence::share;
  return in_stage && !settings_.terms.silhouette ? Absence::depth : Absence::stage;
}

ExplainedHit TreeReader::surface(const Level<float>& level, const Scratch<float>& s,
                                 std::size_t h) const {
  const auto ray = static_cast<std::size_t>(level.hits.ray[h]);
  const float* m = s.coefficients + s.row[h] * kMaterialReals;
  ExplainedHit hit;
  hit.shape = stand_.named(s.slot[ray]);
  hit.distance = stand_.length(s.t[ray]);
  hit.point = stand_.world_point(s.px[h], s.py[h], s.pz[h]);
  hit.normal = {s.nx[h], s.ny[h], s.nz[h]};
  const float seen = s.nx[h] * s.vx[h] + s.ny[h] * s.vy[h] + s.nz[h] * s.vz[h];
  const bool turns = settings_.variation == 0 || seen >= 0;
  hit.flipped = turns && s.inside[h] > 0;
  hit.ka = {m[kAmbient], m[kAmbient + 1], m[kAmbient + 2]};
  hit.kd = {m[kDiffuse], m[kDiffuse + 1], m[kDiffuse + 2]};
  hit.ks = {m[kSpecular], m[kSpecular + 1], m[kSpecular + 2]};
  hit.shininess = m[kShininess];
  hit.highlight = m[kBlinn] > 0 ? Highlight::blinn : Highlight::phong;
  hit.k1 = m[kReflection];
  hit.k2 = m[kRefraction];
  hit.reflection = {hit.k1, hit.k1, hit.k1};
  hit.refraction = {hit.k2, hit.k2, hit.k2};
  hit.ambient = {level.hits.r[h], level.hits.g[h], level.hits.b[h]};
  hit.reflected.absence = absence(hit.k1, settings_.terms.reflection);
  hit.refracted.absence = absence(hit.k2, settings_.terms.refraction);
  hit_reader_.read(level, s, h, ray, hit);
  return hit;
}

void TreeReader::at_hits(const Level<float>& level, const Scratch<float>& s) {
  const std::size_t first = first_[depth_of(level)] = tree_.rays.size();
  for (std::size_t i = 0; i < awaited_.size(); ++i) {
    const RayArrays<float>& rays = level.rays;
    tree_.rays.push_back({.kind = awaited_[i].kind,
                          .depth = static_cast<int>(depth_of(level)),
                          .parent = awaited_[i].parent,
                          .weight = awaited_[i].weight,
                          .shares = awaited_[i].shares,
                          .origin = stand_.world_point(rays.ox[i], rays.oy[i], rays.oz[i]),
                          .direction = {rays.dx[i], rays.dy[i], rays.dz[i]}});
  }
  awaited_.clear();
  const auto hits = static_cast<std::size_t>(level.hit_count);
  for (std::size_t h = 0; h < hits; ++h)
    tree_.rays[first + static_cast<std::size_t>(level.hits.ray[h])].hit = surface(level, s, h);
  const std::uint64_t terms =
      std::uint64_t{tree_.rays.size()} * static_cast<std::uint64_t>(stand_.frozen().light_count);
  if (terms <= kMaxExplainedTerms) return;
  too_large_ = {depth_of(level), first, tree_.rays.size() - first, terms};
  terms_.recording().stop = true;
}

void TreeReader::at_light(std::int32_t light, std::size_t shadow_rays, const Level<float>& level,
                          const Scratch<float>& s) {
  if (terms_.recording().stop) return;
  const Terms& stage = settings_.terms;
  const auto hits = static_cast<std::size_t>(level.hit_count);
  const bool far =
      stand_.scene.lights[static_cast<std::size_t>(light)].kind == LightKind::directional;
  const auto of_light = [&](std::size_t h) -> LightTerms& {
    return hit(level, h).lights[static_cast<std::size_t>(light)];
  };
  for (std::size_t h = 0; h < hits; ++h)
    hit(level, h).lights.push_back(
        {.reach = terms_.is_dark(stand_.frozen().lights[light], h) ? Reach::dark : Reach::behind,
         .distance = far ? std::numeric_limits<double>::infinity()
                         : stand_.length(terms_.at(Quantity::light_distance, h)),
         .to_light = terms_.three_at(Quantity::to_light, h),
         .l_n = terms_.at(Quantity::l_n, h),
         .arriving = arriving(light, h)});
  for (std::size_t i = 0; i < shadow_rays; ++i) {
    const auto h = static_cast<std::size_t>(s.shadow_ray_hit[i]);
    LightTerms& at = of_light(h);
    at.reach = Reach::unchecked;
    if (!stage.shadows) continue;
    const std::int32_t blocker = terms_.blocker(i, s);
    at.reach = blocker < 0 ? Reach::lit : Reach::blocked;
    if (blocker >= 0)
      at.blocker = {stand_.named(blocker), stand_.length(terms_.blocker_distance(i)),
                    hit_reader_.path(terms_.blocker_path(i, stand_.frozen()))};
    shadow_rays_disagree_ = shadow_rays_disagree_ || (blocker < 0) != (s.lit[h] > 0);
  }
  for (std::size_t h = 0; h < hits; ++h) {
    LightTerms& at = of_light(h);
    const bool lit = s.lit[h] > 0;
    if (stage.diffuse && lit) at.diffuse = terms_.three_at(Quantity::diffuse, h);
    if (!stage.specular) continue;
    // A varied rule may add the specular term of a light that does not reach the hit.
    const bool shines = terms_.at(Quantity::shines, h) > 0;
    if (lit || shines) at.r_v = terms_.at(Quantity::r_v, h);
    if (!shines) continue;
    at.highlight = terms_.at(Quantity::highlight, h);
    at.specular = terms_.three_at(Quantity::specular, h);
  }
}

void TreeReader::at_children(const Level<float>& level, const Level<float>& next) {
  const auto more = static_cast<std::size_t>(next.ray_count);
  const std::size_t first_of_next = tree_.rays.size();
  if (first_of_next + more > kMaxExplainedRays || next.ray_count > workspace_.workspace().batch) {
    if (!terms_.recording().stop) too_large_ = {depth_of(level) + 1, first_of_next, more, 0};
    terms_.recording().stop = true;
  }
  if (terms_.recording().stop) return;

  awaited_.resize(more);
  const auto hits = static_cast<std::size_t>(level.hit_count);
  for (std::size_t h = 0; h < hits; ++h) {
    const std::size_t parent = ray_of_hit(level, h);
    ExplainedHit& at = *tree_.rays[parent].hit;
    const Terms& stage = settings_.terms;
    if (stage.refraction && at.k2 != 0) {
      const float quarter_d = terms_.at(Quantity::quarter_d, h);
      const float cosine = terms_.at(Quantity::cosine, h);
      at.snell = {.cosine = settings_.variation == 0 ? std::fabs(cosine) : cosine,
                  .ratio = terms_.at(Quantity::ratio, h),
                  .quarter_d = quarter_d,
                  .total = !(quarter_d >= 0)};
      if (at.snell->total) at.refracted.absence = Absence::total;
      if (level.hits.refracted[h] >= 0) at.snell->a = terms_.at(Quantity::along_normal, h);
    }
    const auto take = [&](Child& child, float share, std::int32_t index, RayKind kind) {
      if (index < 0) return;
      child = {share, {share, share, share}, static_cast<int>(first_of_next) + index};
      awaited_[static_cast<std::size_t>(index)] = {
          kind, static_cast<int>(parent), tree_.rays[parent].weight * static_cast<double>(share),
          {share, share, share}};
    };
    take(at.reflected, level.hits.reflection[h], level.hits.reflected[h], RayKind::reflected);
    take(at.refracted, level.hits.refraction[h], level.hits.refracted[h], RayKind::refracted);
  }
}

std::optional<SkyBeyond> TreeReader::sky_beyond(const Level<float>& level, std::size_t h) const {
  const V3<float>& sky = stand_.frozen().background;
  const auto share_of_sky = [&](float share) -> Float3 {
    return {sky.x * share, sky.y * share, sky.z * share};
  };
  const SkyBeyond beyond{share_of_sky(level.hits.reflection[h]),
                         share_of_sky(level.hits.refraction[h])};
  if (beyond.reflected == Float3{} && beyond.refracted == Float3{}) return std::nullopt;
  return beyond;
}

void TreeReader::at_fold(const Level<float>& level) {
  if (terms_.recording().stop) return;
  const std::size_t first = first_[depth_of(level)];
  for (std::size_t i = 0; i < static_cast<std::size_t>(level.ray_count); ++i)
    tree_.rays[first + i].color = {level.rays.r[i], level.rays.g[i], level.rays.b[i]};
  for (std::size_t h = 0; h < static_cast<std::size_t>(level.hit_count); ++h) {
    hit(level, h).local = {level.hits.r[h], level.hits.g[h], level.hits.b[h]};
    hit(level, h).sum = terms_.three_at(Quantity::unclamped, h);
    if (sees_beyond(level)) hit(level, h).sky_beyond = sky_beyond(level, h);
  }
}

}  // namespace

Result<RayTree> read_tree(const Stand& stand, const TraceSettings& settings, std::uint32_t x,
                          std::uint32_t y, std::uint32_t sample) {
  const TileRect pixel{static_cast<std::int32_t>(x), static_cast<std::int32_t>(y), 1, 1};
  TooLarge too_large;
  const auto nothing = [&] {
    return failure("", fmt::format("the camera sees nothing at pixel ({}, {})", x, y),
                   "a fisheye camera sees up to half a turn from its view");
  };
  for (std::int32_t batch = 64; batch <= kMaxExplainedRays; batch *= 16) {
    if (stand.frozen().optics != nullptr) {
      std::optional<RayTree> tree =
          read_general_tree(stand, settings, {pixel.x, pixel.y, sample}, batch, too_large);
      if (!tree) continue;
      if (tree->rays.empty()) return nothing();
      return std::move(*tree);
    }
    TreeReader reader(stand, settings, batch);
    if (!stand.plain() && !reader.place_sample(pixel.x, pixel.y, sample))
      return nothing();
    if (!reader.read(pixel)) {
      too_large = reader.too_large();
      continue;
    }
    if (reader.shadow_rays_disagree())
      return failure(
          "",
          fmt::format("pixel ({}, {}): a shadow ray and a nearest hit disagree about a shape", x,
                      y),
          "this is a bug in zraka; please report it with the scene");
    return std::move(reader.tree());
  }
  if (too_large.terms > 0)
    return failure("",
                   fmt::format("the ray tree of pixel ({}, {}) has too many terms of light to be "
                               "explained: {} rays and {} lights; {} terms fit",
                               x, y, too_large.rays + too_large.more, stand.frozen().light_count,
                               kMaxExplainedTerms),
                   "ask for fewer levels with a smaller depth");
  return failure(
      "",
      fmt::format("the ray tree of pixel ({}, {}) is too large to be explained: its "
                  "first {} levels have {} rays, the next has {}; {} fit",
                  x, y, too_large.levels, too_large.rays, too_large.more, +kMaxExplainedRays),
      "ask for fewer levels with a smaller depth");
}

}  // namespace zraka
