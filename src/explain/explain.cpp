// SPDX-License-Identifier: Apache-2.0
// From the engine's arrays to a RayTree: listens to the renderer's own steps on a tile of one
// pixel.
#include <fmt/format.h>

#include <new>
#include <zraka/explain.hpp>

#include "explain/recording.hpp"
#include "explain/tile_listeners.hpp"
#include "render/corners.hpp"
#include "render/isa.hpp"
#include "render/prepare.hpp"
#include "render/variation.hpp"
#include "render/workspace.hpp"

namespace zraka {
namespace {

/// What all pixels of a scene share.
struct Stand {
  const Scene& scene;
  RenderOptions options;
  TraceSettings settings;
  PreparedScene<float> prepared;
  const Kernel<float>* kernel;
  Variation variation;

  const FrozenScene<float>& frozen() const { return prepared.store->scene; }
  NamedShape named(std::int32_t slot) const {
    const ShapeId id = shape_in_slot(frozen(), slot);
    const auto name = scene.names.find(id);
    return {id, name == scene.names.end() ? std::string() : name->second};
  }
  Vec3 world_point(float x, float y, float z) const {
    return prepared.frame.world_point(
        {static_cast<double>(x), static_cast<double>(y), static_cast<double>(z)});
  }
  double length(float framed) const {
    return prepared.frame.world_length(static_cast<double>(framed));
  }
};

Float3 float3(const V3<float>& v) {
  return {v.x, v.y, v.z};
}

/// Where a tree stopped because it does not fit.
struct TooLarge {
  std::size_t levels = 0, rays = 0, more = 0;  ///< whole levels, their rays, the next level's
  std::uint64_t terms = 0;                     ///< of light, if they are what is too much
};

/// Builds the tree of one ray from what the steps tell. Each level has to come in one batch.
class TreeReader {
 public:
  TreeReader(const Stand& stand, std::int32_t batch)
      : stand_(stand),
        workspace_(batch, stand.settings.max_depth),
        terms_(batch, *this),
        first_(static_cast<std::size_t>(stand.settings.max_depth) + 2) {}

  /// False if the tree does not fit.
  bool read(const TileRect& pixel) {
    RayCounts counts;
    Float3 ignored{};
    (stand_.variation.record == nullptr ? record_tile() : *stand_.variation.record)(
        stand_.frozen(), stand_.settings, pixel, workspace_.workspace(), counts, ignored.data(), 1,
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
  ExplainedHit surface(const Level<float>& level, const Scratch<float>& s, std::size_t h) const;
  Absence absence(float share, bool in_stage) const;

  const Stand& stand_;
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
  return in_stage && !stand_.settings.terms.silhouette ? Absence::depth : Absence::stage;
}

ExplainedHit TreeReader::surface(const Level<float>& level, const Scratch<float>& s,
                                 std::size_t h) const {
  const auto ray = static_cast<std::size_t>(level.hits.ray[h]);
  const float* m = stand_.frozen().materials + s.material[h] * kMaterialReals;
  ExplainedHit hit;
  hit.shape = stand_.named(s.slot[ray]);
  hit.distance = stand_.length(s.t[ray]);
  hit.point = stand_.world_point(s.px[h], s.py[h], s.pz[h]);
  hit.normal = {s.nx[h], s.ny[h], s.nz[h]};
  const float seen = s.nx[h] * s.vx[h] + s.ny[h] * s.vy[h] + s.nz[h] * s.vz[h];
  const bool turns = stand_.settings.variation == 0 || seen >= 0;
  hit.flipped = turns && s.inside[h] > 0;
  hit.ka = {m[kAmbient], m[kAmbient + 1], m[kAmbient + 2]};
  hit.kd = {m[kDiffuse], m[kDiffuse + 1], m[kDiffuse + 2]};
  hit.ks = {m[kSpecular], m[kSpecular + 1], m[kSpecular + 2]};
  hit.shininess = m[kShininess];
  hit.k1 = m[kReflection];
  hit.k2 = m[kRefraction];
  hit.ambient = {level.hits.r[h], level.hits.g[h], level.hits.b[h]};
  hit.reflected.absence = absence(hit.k1, stand_.settings.terms.reflection);
  hit.refracted.absence = absence(hit.k2, stand_.settings.terms.refraction);
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
  const Terms& stage = stand_.settings.terms;
  const auto hits = static_cast<std::size_t>(level.hit_count);
  const auto of_light = [&](std::size_t h) -> LightTerms& {
    return hit(level, h).lights[static_cast<std::size_t>(light)];
  };
  for (std::size_t h = 0; h < hits; ++h)
    hit(level, h).lights.push_back(
        {.reach = Reach::behind,
         .distance = stand_.length(terms_.at(Quantity::light_distance, h)),
         .to_light = terms_.three_at(Quantity::to_light, h),
         .l_n = terms_.at(Quantity::l_n, h)});
  for (std::size_t i = 0; i < shadow_rays; ++i) {
    const auto h = static_cast<std::size_t>(s.shadow_ray_hit[i]);
    LightTerms& at = of_light(h);
    at.reach = Reach::unchecked;
    if (!stage.shadows) continue;
    const std::int32_t blocker = terms_.blocker(i, s);
    at.reach = blocker < 0 ? Reach::lit : Reach::blocked;
    if (blocker >= 0)
      at.blocker = {stand_.named(blocker), stand_.length(terms_.blocker_distance(i))};
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
    const Terms& stage = stand_.settings.terms;
    if (stage.refraction && at.k2 != 0) {
      const float quarter_d = terms_.at(Quantity::quarter_d, h);
      at.snell = {.cosine = terms_.at(Quantity::cosine, h),
                  .ratio = terms_.at(Quantity::ratio, h),
                  .quarter_d = quarter_d,
                  .total = !(quarter_d >= 0)};
      if (at.snell->total) at.refracted.absence = Absence::total;
      if (level.hits.refracted[h] >= 0) at.snell->a = terms_.at(Quantity::along_normal, h);
    }
    const auto take = [&](Child& child, float share, std::int32_t index, RayKind kind) {
      if (index < 0) return;
      child = {share, static_cast<int>(first_of_next) + index, Absence::none};
      awaited_[static_cast<std::size_t>(index)] = {
          kind, static_cast<int>(parent), tree_.rays[parent].weight * static_cast<double>(share)};
    };
    take(at.reflected, level.hits.reflection[h], level.hits.reflected[h], RayKind::reflected);
    take(at.refracted, level.hits.refraction[h], level.hits.refracted[h], RayKind::refracted);
  }
}

void TreeReader::at_fold(const Level<float>& level) {
  if (terms_.recording().stop) return;
  const std::size_t first = first_[depth_of(level)];
  for (std::size_t i = 0; i < static_cast<std::size_t>(level.ray_count); ++i)
    tree_.rays[first + i].color = {level.rays.r[i], level.rays.g[i], level.rays.b[i]};
  for (std::size_t h = 0; h < static_cast<std::size_t>(level.hit_count); ++h) {
    hit(level, h).local = {level.hits.r[h], level.hits.g[h], level.hits.b[h]};
    hit(level, h).sum = terms_.three_at(Quantity::unclamped, h);
  }
}

/// The tree of the ray through a corner or the centre of a pixel.
Result<RayTree> read_tree(const Stand& stand, std::uint32_t x, std::uint32_t y) {
  const TileRect pixel{static_cast<std::int32_t>(x), static_cast<std::int32_t>(y), 1, 1};
  TooLarge too_large;
  for (std::int32_t batch = 64; batch <= kMaxExplainedRays; batch *= 16) {
    TreeReader reader(stand, batch);
    if (!reader.read(pixel)) {
      too_large = reader.too_large();
      continue;
    }
    if (reader.shadow_rays_disagree())
      return failure(
          "",
          fmt::format("pixel ({}, {}): a feeler and a nearest hit disagree about a shape", x, y),
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

/// All of a pixel: one tree, or those of its four corners and their mean.
Result<Explanation> read_pixel(const Stand& stand, std::uint32_t x, std::uint32_t y) {
  Explanation explanation{.x = x,
                          .y = y,
                          .resolution = stand.scene.resolution,
                          .terms = stand.options.terms,
                          .profile = stand.options.profile,
                          .max_depth = stand.options.max_depth,
                          .ambient_light = float3(stand.frozen().ambient_light),
                          .background = float3(stand.frozen().background)};
  for (std::size_t i = 0; i < stand.scene.lights.size(); ++i)
    explanation.lights.push_back(
        {stand.scene.lights[i].position, float3(stand.frozen().lights[i].color)});
  const std::uint32_t corners = stand.options.profile.average_corners ? 2 : 1;
  for (std::uint32_t j = 0; j < corners; ++j)
    for (std::uint32_t i = 0; i < corners; ++i) {
      Result<RayTree> tree = read_tree(stand, x + i, y + j);
      if (!tree) return tl::make_unexpected(tree.error());
      explanation.trees.push_back(std::move(*tree));
    }
  explanation.color = explanation.trees[0].rays[0].color;
  if (corners > 1)
    for (std::size_t c = 0; c < 3; ++c) {
      const auto corner = [&](std::size_t i) { return explanation.trees[i].rays[0].color[c]; };
      explanation.color[c] = mean_of_corners(corner(0), corner(1), corner(2), corner(3));
    }
  if (!stand.variation.rules.key.empty()) explanation.varied = stand.variation.rules;
  if (stand.variation.vary_image) {
    Image pixel(1, 1);
    std::copy(explanation.color.begin(), explanation.color.end(), pixel.pixels.begin());
    stand.variation.vary_image(pixel);
    std::copy_n(pixel.pixels.begin(), 3, explanation.color.begin());
  }
  return explanation;
}

Stand stand_for(const Scene& scene, RenderOptions options, Isa isa, const Variation& variation) {
  if (variation.vary_options) variation.vary_options(options);
  Scene varied;
  if (variation.vary_scene) variation.vary_scene(varied = scene);
  PreparedScene<float> prepared = variation.vary_scene
                                      ? prepare<float>(std::move(varied), options.profile)
                                      : prepare<float>(scene, options.profile);
  const TraceSettings settings = settings_of(options, prepared.frame, variation.number);
  return {scene,
          options,
          settings,
          std::move(prepared),
          variation.kernel == nullptr ? &kernel_of(isa) : variation.kernel,
          variation};
}

}  // namespace

struct Explainer::Impl {
  Stand stand;
};

Explainer::Explainer(std::unique_ptr<Impl> impl) : impl_(std::move(impl)) {}
Explainer::Explainer(Explainer&&) noexcept = default;
Explainer& Explainer::operator=(Explainer&&) noexcept = default;
Explainer::~Explainer() = default;

Result<Explainer> Explainer::create(const Scene& scene, const RenderOptions& options) {
  return varied_explainer(scene, options, {});
}

Result<Explainer> varied_explainer(const Scene& scene, const RenderOptions& options,
                                   const Variation& variation) {
  const Result<Isa> isa = isa_to_listen_to(scene, options);
  if (!isa) return tl::make_unexpected(isa.error());
  try {
    return Explainer(std::unique_ptr<Explainer::Impl>(
        new Explainer::Impl{stand_for(scene, options, *isa, variation)}));
  } catch (const std::bad_alloc&) {
    return failure("", fmt::format("not enough memory for {} shapes", scene.shape_count()));
  }
}

Result<Explanation> Explainer::pixel(std::uint32_t x, std::uint32_t y) {
  const Resolution size = impl_->stand.scene.resolution;
  if (x >= size.width || y >= size.height)
    return failure("",
                   fmt::format("pixel ({}, {}) is outside of the picture of {}×{} pixels", x, y,
                               size.width, size.height),
                   fmt::format("columns go from 0 to {} from the left, rows from 0 to {} from the "
                               "top",
                               size.width - 1, size.height - 1));
  try {
    return read_pixel(impl_->stand, x, y);
  } catch (const std::bad_alloc&) {
    return failure("", fmt::format("not enough memory for the ray tree of pixel ({}, {})", x, y),
                   "ask for fewer levels with a smaller depth");
  }
}

Neighbourhood Explainer::around(std::uint32_t x, std::uint32_t y, std::uint32_t side) {
  const Stand& stand = impl_->stand;
  const Resolution size = stand.scene.resolution;
  const auto start = [&](std::uint32_t at, std::uint32_t all) {
    const std::uint32_t room = std::min(side, all);
    return std::min(at > room / 2 ? at - room / 2 : 0, all - room);
  };
  const std::uint32_t corner = stand.options.profile.average_corners ? 1 : 0;
  Neighbourhood found{start(x, size.width), start(y, size.height), {}};
  Image rays(std::min(side, size.width) + corner, std::min(side, size.height) + corner);
  const TileRect tile{static_cast<std::int32_t>(found.left), static_cast<std::int32_t>(found.top),
                      static_cast<std::int32_t>(rays.width),
                      static_cast<std::int32_t>(rays.height)};
  WorkspaceMemory<float> workspace(tile.width * tile.height, stand.settings.max_depth);
  RayCounts counts;
  stand.kernel->trace_tile(stand.frozen(), stand.settings, tile, workspace.workspace(), counts,
                           rays.pixels.data(), rays.width);
  found.image = corner == 0 ? std::move(rays) : means_of_corners(std::move(rays));
  return found;
}

Result<Explanation> explain(const Scene& scene, const RenderOptions& options, std::uint32_t x,
                            std::uint32_t y) {
  Result<Explainer> explainer = Explainer::create(scene, options);
  if (!explainer) return tl::make_unexpected(explainer.error());
  return explainer->pixel(x, y);
}

}  // namespace zraka
