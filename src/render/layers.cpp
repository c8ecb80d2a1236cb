// SPDX-License-Identifier: Apache-2.0
#include "render/layers.hpp"

#include <algorithm>
#include <limits>
#include <optional>

#include "core/threads.hpp"
#include "render/crypto.hpp"
#include "engine/general/cuts.hpp"
#include "engine/tile_order.hpp"
#include "render/sample_rays.hpp"
#include "render/screen_bounds.hpp"
#include "render/tiles.hpp"
#include "render/tracer.hpp"
#include "render/uv_finder.hpp"
#include "render/workspace.hpp"
#include "scene/reals.hpp"

namespace zraka {
namespace {

using Floats = std::vector<float>;
using Ids = std::vector<std::uint32_t>;

/// The index of what a slot holds, counted over all kinds.
template <class R>
std::uint32_t id_in_slot(const FrozenScene<R>& scene, std::int32_t slot) {
#define ZRAKA_IF(Type, plural)                                                                    \
  if (const std::int32_t at = slot - scene.plural.first_slot; at >= 0 && at < scene.plural.count) \
    return static_cast<std::uint32_t>(scene.plural.id[at]);
  ZRAKA_KINDS(ZRAKA_IF)
#undef ZRAKA_IF
  return 0;
}

/// The values of the layers while they are found; empty ones are not wanted.
struct Values {
  std::uint32_t width;
  Floats depth, position[3], normal[3], uv[2];
  Ids object, material, rays, tree_depth;

  Values(const LayerSet& layers, const Resolution& size) : width(size.width) {
    const std::size_t count = std::size_t{size.width} * size.height;
    const auto start = [&](Layer layer, auto& values, auto nothing) {
      if (layers.has(layer)) values.assign(count, nothing);
    };
    start(Layer::depth, depth, kNoDepth);
    for (Floats& values : position) start(Layer::position, values, 0.0f);
    for (Floats& values : normal) start(Layer::normal, values, 0.0f);
    for (Floats& values : uv) start(Layer::uv, values, 0.0f);
    start(Layer::object_id, object, 0u);
    start(Layer::cryptomatte, object, 0u);
    start(Layer::material_id, material, 0u);
    start(Layer::rays, rays, 1u);  // the one that hits nothing
    start(Layer::tree_depth, tree_depth, 0u);
  }
  std::size_t index(std::int32_t x, std::int32_t y) const {
    return std::size_t{width} * static_cast<std::size_t>(y) + static_cast<std::size_t>(x);
  }
};

template <class R>
class LayerMaker {
 public:
  explicit LayerMaker(const LayerPass<R>& pass, const Resolution& size)
      : pass_(pass),
        job_(pass.job),
        scene_(pass.job.scene),
        size_(size),
        values_(pass.job.options.layers, size),
        counts_rays_(pass.job.options.layers.has(Layer::rays) ||
                     pass.job.options.layers.has(Layer::tree_depth)),
        has_cuts_(scene_.optics != nullptr && scene_.optics->cut_count > 0),
        samples_(scene_.camera, job_.options.profile, kOne, scene_.textures != nullptr),
        bounds_(job_.bounds()) {
    if (pass.job.options.layers.has(Layer::uv)) uv_.emplace(*pass.scene, *pass.prepared.store);
  }

  bool make() {
    return each_tile(size_.width, size_.height, job_.tile, job_.threads, job_.options.bind_threads,
                     job_.options.cancel, [this](const TileRect& tile) { make_tile(tile); });
  }
  void put(Layers& layers);

 private:
  static constexpr Sampling kOne{};

  /// A thread's memory. Its first hits have paths as in textured scenes; its trees are of one
  /// pixel.
  struct Worker {
    std::optional<WorkspaceMemory<R>> hits;
    std::optional<GeneralMemory<R>> beyond_cuts;  ///< of rays that go on, where there are cuts
    std::optional<TracerMemory<R>> tree;
  };

  void make_tile(const TileRect& tile);
  void put_hit(Workspace<R>& workspace, std::size_t h);
  void count_rays(std::int32_t x, std::int32_t y, TracerMemory<R>& memory);
  /// Where a pixel of the whole picture has its values.
  std::size_t index(std::int32_t x, std::int32_t y) const {
    return values_.index(x - job_.part.x, y - job_.part.y);
  }

  const LayerPass<R>& pass_;
  const PictureJob<R>& job_;
  const FrozenScene<R>& scene_;
  Resolution size_;
  Values values_;
  bool counts_rays_, has_cuts_;
  const SampleRays<R> samples_;
  std::optional<UvFinder<R>> uv_;
  std::optional<ScreenBounds> bounds_;
  PerThread<Worker> workers_;
};

template <class R>
void LayerMaker<R>::make_tile(const TileRect& tile) {
  const TileRect whole{tile.x + job_.part.x, tile.y + job_.part.y, tile.width, tile.height};
  const TileRect part = bounds_ ? bounds_->part_of(whole) : whole;
  if (part.width <= 0 || part.height <= 0) return;
  Worker& worker = workers_.local();
  if (!worker.hits)
    worker.hits.emplace(WorkspaceNeeds{.batch = job_.tile * job_.tile,
                                       .textured = scene_.textures != nullptr,
                                       .general = true});
  Workspace<R>& workspace = worker.hits->workspace();
  Level<R>& level = workspace.levels[0];
  std::int32_t count = 0;
  each_pixel(part, [&](std::int32_t x, std::int32_t y) {
    if (samples_.make(part.x + x, part.y + y, 0, workspace, count) != SampleRays<R>::Made::nothing)
      ++count;
  });
  if (count == 0) return;
  level.ray_count = level.in_batch = count;
  level.done = 0;
  if (!has_cuts_) {
    job_.kernel.services->find_hits(scene_, level, workspace.scratch);
  } else {
    if (!worker.beyond_cuts)
      worker.beyond_cuts.emplace(job_.tile * job_.tile, 0, scene_, job_.settings);
    general::find_uncut_hits(scene_, *job_.kernel.services, level, workspace.scratch,
                             worker.beyond_cuts->workspace());
  }
  const auto hits = static_cast<std::size_t>(level.hit_count);
  for (std::size_t h = 0; h < hits; ++h) put_hit(workspace, h);
}

template <class R>
void LayerMaker<R>::put_hit(Workspace<R>& workspace, std::size_t h) {
  const Scratch<R>& scratch = workspace.scratch;
  const std::int32_t ray = workspace.levels[0].hits.ray[h];
  const auto [x, y, number] = workspace.samples[ray];
  const std::size_t at = index(x, y);
  const Frame& frame = pass_.prepared.frame;
  const V3<double> point{static_cast<double>(scratch.px[h]), static_cast<double>(scratch.py[h]),
                         static_cast<double>(scratch.pz[h])};
  if (!values_.depth.empty())
    values_.depth[at] = static_cast<float>(frame.world_length(static_cast<double>(scratch.t[ray])));
  if (!values_.position[0].empty()) {
    const Vec3 in_world = frame.world_point({point.x, point.y, point.z});
    values_.position[0][at] = static_cast<float>(in_world.x);
    values_.position[1][at] = static_cast<float>(in_world.y);
    values_.position[2][at] = static_cast<float>(in_world.z);
  }
  if (!values_.normal[0].empty()) {
    values_.normal[0][at] = static_cast<float>(scratch.nx[h]);
    values_.normal[1][at] = static_cast<float>(scratch.ny[h]);
    values_.normal[2][at] = static_cast<float>(scratch.nz[h]);
  }
  if (uv_) {
    const auto [u, v] = uv_->at(scratch.paths[h], point);
    values_.uv[0][at] = static_cast<float>(u);
    values_.uv[1][at] = static_cast<float>(v);
  }
  if (!values_.object.empty()) values_.object[at] = 1 + id_in_slot(scene_, scratch.slot[ray]);
  if (!values_.material.empty())
    values_.material[at] = 1 + static_cast<std::uint32_t>(scratch.material[h]);
  if (counts_rays_) {
    Worker& worker = workers_.local();
    constexpr std::int32_t kBatch = 64;
    if (!worker.tree) worker.tree.emplace(kBatch, scene_, job_.settings);
    count_rays(x, y, *worker.tree);
  }
}

/// One pixel's ray tells how many rays it has. Its tree is as deep as the depth has to be for all
/// children to be there.
template <class R>
void LayerMaker<R>::count_rays(std::int32_t x, std::int32_t y, TracerMemory<R>& memory) {
  const auto count_to = [&](int depth) {
    TraceSettings settings = job_.settings;
    settings.max_depth = depth;
    RayCounts counts;
    samples_.make(x, y, 0, memory.workspace(), 0);
    memory.workspace().levels[0].ray_count = 1;
    trace_rays(job_.kernel, scene_, settings, memory, counts);
    return counts;
  };
  const auto children = [](const RayCounts& counts) { return counts.reflected + counts.refracted; };
  const RayCounts all = count_to(job_.settings.max_depth);
  const std::size_t at = index(x, y);
  if (!values_.rays.empty())
    values_.rays[at] = static_cast<std::uint32_t>(
        std::min<std::uint64_t>(all.total(), std::numeric_limits<std::uint32_t>::max()));
  if (values_.tree_depth.empty() || children(all) == 0) return;
  int depth = 1;
  while (depth < job_.settings.max_depth && children(count_to(depth)) < children(all)) ++depth;
  values_.tree_depth[at] = static_cast<std::uint32_t>(depth);
}

template <class R>
void LayerMaker<R>::put(Layers& layers) {
  layers.width = size_.width;
  layers.height = size_.height;
  const auto add = [&](const char* name, auto& values, bool half = false) {
    if (!values.empty()) layers.channels.push_back({name, std::move(values), half});
  };
  add("Z", values_.depth);
  add("position.X", values_.position[0]);
  add("position.Y", values_.position[1]);
  add("position.Z", values_.position[2]);
  add("normal.X", values_.normal[0], true);
  add("normal.Y", values_.normal[1], true);
  add("normal.Z", values_.normal[2], true);
  add("uv.U", values_.uv[0]);
  add("uv.V", values_.uv[1]);
  add("materialId.X", values_.material);
  add("rays.X", values_.rays);
  add("treeDepth.X", values_.tree_depth);
  if (job_.options.layers.has(Layer::cryptomatte))
    add_cryptomatte(*pass_.scene, values_.object, layers);
  if (job_.options.layers.has(Layer::object_id)) add("objectId.X", values_.object);
}

}  // namespace

template <class R>
bool make_layers(const LayerPass<R>& pass, Rendering& rendering) {
  if (pass.job.options.layers.empty()) return true;
  LayerMaker<R> maker(pass, {rendering.image.width, rendering.image.height});
  if (!maker.make()) return false;
  maker.put(rendering.layers);
  return true;
}

template <class R>
bool make_layers(const LayerPass<R>& pass, Layers& layers) {
  const TileRect& part = pass.job.part;
  LayerMaker<R> maker(pass, {static_cast<std::uint32_t>(part.width),
                             static_cast<std::uint32_t>(part.height)});
  if (!maker.make()) return false;
  maker.put(layers);
  return true;
}

#define ZRAKA_FOR(R)                                             \
  template bool make_layers(const LayerPass<R>&, Rendering&);    \
  template bool make_layers(const LayerPass<R>&, Layers&);
ZRAKA_FOR_REALS(ZRAKA_FOR)
#undef ZRAKA_FOR

}  // namespace zraka
