// SPDX-License-Identifier: Apache-2.0
#include "render/layers.hpp"

#include <tbb/enumerable_thread_specific.h>

#include <algorithm>
#include <limits>
#include <optional>
#include <type_traits>

#include "render/corners.hpp"
#include "render/crypto.hpp"
#include "render/screen_bounds.hpp"
#include "render/tiles.hpp"
#include "render/uv_finder.hpp"
#include "render/workspace.hpp"

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
  LayerMaker(const LayerPass<R>& pass, Image& image, const Resolution& size)
      : pass_(pass),
        scene_(pass.prepared.store->scene),
        image_(image),
        size_(size),
        values_(pass.options.layers, size),
        counts_rays_(pass.options.layers.has(Layer::rays) ||
                     pass.options.layers.has(Layer::tree_depth)) {
    if (pass.options.layers.has(Layer::uv)) uv_.emplace(*pass.scene, *pass.prepared.store);
    if (pass.options.transparent) alpha_.assign(std::size_t{image.width} * image.height, 0.0f);
    if constexpr (std::is_same_v<R, float>) bounds_.emplace(scene_, image.width, image.height);
  }

  bool make() {
    return each_tile(image_.width, image_.height, pass_.tile, pass_.threads,
                     pass_.options.bind_threads, pass_.options.cancel,
                     [this](const TileRect& tile) { make_tile(tile); });
  }
  void put(Layers& layers);

 private:
  /// A thread's memory. Its first hits have paths as in textured scenes; its trees are of one
  /// pixel.
  struct Worker {
    std::optional<WorkspaceMemory<R>> hits, tree;
  };

  void make_tile(const TileRect& tile);
  void put_hit(Workspace<R>& workspace, std::size_t h);
  void count_rays(std::int32_t x, std::int32_t y, Workspace<R>& workspace);
  Floats alpha_of_pixels() const;
  bool is_pixel(std::int32_t x, std::int32_t y) const {
    return static_cast<std::uint32_t>(x) < size_.width &&
           static_cast<std::uint32_t>(y) < size_.height;
  }

  const LayerPass<R>& pass_;
  const FrozenScene<R>& scene_;
  Image& image_;
  Resolution size_;  ///< the picture's, without corners
  Values values_;
  bool counts_rays_;
  Floats alpha_;  ///< of the image's rays, corners and all
  std::optional<UvFinder<R>> uv_;
  std::optional<ScreenBounds> bounds_;
  tbb::enumerable_thread_specific<Worker> workers_;
};

template <class R>
void LayerMaker<R>::make_tile(const TileRect& tile) {
  const TileRect part = bounds_ ? bounds_->part_of(tile) : tile;
  if (part.width > 0 && part.height > 0) {
    Worker& worker = workers_.local();
    if (!worker.hits) worker.hits.emplace(pass_.tile * pass_.tile, 0, uv_.has_value());
    Workspace<R>& workspace = worker.hits->workspace();
    pass_.first_hits(scene_, part, workspace);
    const auto hits = static_cast<std::size_t>(workspace.levels[0].hit_count);
    for (std::size_t h = 0; h < hits; ++h) put_hit(workspace, h);
  }
  for (std::int32_t y = tile.y; pass_.options.transparent && y < tile.y + tile.height; ++y)
    for (std::int32_t x = tile.x; x < tile.x + tile.width; ++x) {
      const std::size_t at =
          std::size_t{image_.width} * static_cast<std::size_t>(y) + static_cast<std::size_t>(x);
      if (alpha_[at] == 0) std::fill_n(image_.pixels.data() + 3 * at, 3, 0.0f);
    }
}

template <class R>
void LayerMaker<R>::put_hit(Workspace<R>& workspace, std::size_t h) {
  const Scratch<R>& scratch = workspace.scratch;
  const std::int32_t ray = workspace.levels[0].hits.ray[h];
  const auto [x, y, number] = workspace.samples[ray];
  if (pass_.options.transparent)
    alpha_[std::size_t{image_.width} * static_cast<std::size_t>(y) + static_cast<std::size_t>(x)] =
        1;
  if (!is_pixel(x, y)) return;
  const std::size_t at = values_.index(x, y);
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
    if (!worker.tree)
      worker.tree.emplace(kBatch, pass_.settings.max_depth, scene_.textures != nullptr);
    count_rays(x, y, worker.tree->workspace());
  }
}

/// A tile of one pixel tells how many rays that has. Its tree is as deep as the depth has to be for
/// all children to be there.
template <class R>
void LayerMaker<R>::count_rays(std::int32_t x, std::int32_t y, Workspace<R>& workspace) {
  const auto count_to = [&](int depth) {
    TraceSettings settings = pass_.settings;
    settings.max_depth = depth;
    RayCounts counts;
    float color[3];
    pass_.kernel.trace_tile(scene_, settings, {x, y, 1, 1}, workspace, counts, color, 1);
    return counts;
  };
  const auto children = [](const RayCounts& counts) { return counts.reflected + counts.refracted; };
  const RayCounts all = count_to(pass_.settings.max_depth);
  const std::size_t at = values_.index(x, y);
  if (!values_.rays.empty())
    values_.rays[at] = static_cast<std::uint32_t>(
        std::min<std::uint64_t>(all.total(), std::numeric_limits<std::uint32_t>::max()));
  if (values_.tree_depth.empty() || children(all) == 0) return;
  int depth = 1;
  while (depth < pass_.settings.max_depth && children(count_to(depth)) < children(all)) ++depth;
  values_.tree_depth[at] = static_cast<std::uint32_t>(depth);
}

/// As the picture's pixels come about.
template <class R>
Floats LayerMaker<R>::alpha_of_pixels() const {
  if (image_.width == size_.width) return alpha_;
  Floats means;
  for (std::size_t y = 0; y < size_.height; ++y)
    for (std::size_t x = 0; x < size_.width; ++x) {
      const float* const at = alpha_.data() + image_.width * y + x;
      means.push_back(
          mean_of_corners(at[0], at[1], at[image_.width], at[std::size_t{image_.width} + 1]));
    }
  return means;
}

template <class R>
void LayerMaker<R>::put(Layers& layers) {
  layers.width = size_.width;
  layers.height = size_.height;
  const auto add = [&](const char* name, auto& values, bool half = false) {
    if (!values.empty()) layers.channels.push_back({name, std::move(values), half});
  };
  if (pass_.options.transparent) {
    Floats alpha = alpha_of_pixels();
    add("A", alpha, true);
  }
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
  if (pass_.options.layers.has(Layer::cryptomatte))
    add_cryptomatte(*pass_.scene, values_.object, layers);
  if (pass_.options.layers.has(Layer::object_id)) add("objectId.X", values_.object);
}

}  // namespace

template <class R>
bool make_layers(const LayerPass<R>& pass, Rendering& rendering) {
  if (pass.options.layers.empty() && !pass.options.transparent) return true;
  const std::uint32_t more = pass.options.profile.average_corners ? 1 : 0;
  LayerMaker<R> maker(pass, rendering.image,
                      {rendering.image.width - more, rendering.image.height - more});
  if (!maker.make()) return false;
  maker.put(rendering.layers);
  return true;
}

template bool make_layers<float>(const LayerPass<float>&, Rendering&);
template bool make_layers<double>(const LayerPass<double>&, Rendering&);

}  // namespace zraka
