// SPDX-License-Identifier: Apache-2.0
// Influence: listens to the renderer's steps on every tile, and notes which rays hit one shape.
#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <new>
#include <tuple>
#include <zraka/influence.hpp>

#include "engine/tile_order.hpp"
#include "explain/general_recording.hpp"
#include "explain/shape_lookup.hpp"
#include "explain/tile_listeners.hpp"
#include "render/variation.hpp"

namespace zraka {
namespace {

/// Ways of rays as a tree of their own, so that a ray needs one number for its way.
class Ways {
 public:
  static constexpr std::uint32_t kRoot = 0;

  /// The way of a reflected or refracted ray.
  std::uint32_t next(std::uint32_t way, RayKind kind) {
    if (nodes_[way].longer) return way;
    const bool full = nodes_[way].path.size() == kInfluencePath;
    const std::size_t branch = full ? 2 : kind == RayKind::reflected ? 0 : 1;
    if (nodes_[way].next[branch] == 0) {
      nodes_[way].next[branch] = static_cast<std::uint32_t>(nodes_.size());
      Node node{nodes_[way].path, full};
      if (!full) node.path.push_back(kind);
      nodes_.push_back(std::move(node));
    }
    return nodes_[way].next[branch];
  }
  const std::vector<RayKind>& path(std::uint32_t way) const { return nodes_[way].path; }
  bool longer(std::uint32_t way) const { return nodes_[way].longer; }

 private:
  struct Node {
    std::vector<RayKind> path;
    bool longer = false;
    std::uint32_t next[3] = {};  ///< reflected, refracted, longer; 0: not there yet
  };
  std::vector<Node> nodes_{Node{}};
};

std::uint8_t bit_of(const std::vector<RayKind>& path, bool shadow) {
  if (shadow) return kShadow;
  const bool reflected = std::find(path.begin(), path.end(), RayKind::reflected) != path.end();
  const bool refracted = std::find(path.begin(), path.end(), RayKind::refracted) != path.end();
  return reflected && refracted ? kBothWays
         : reflected            ? kMirrored
         : refracted            ? kThroughGlass
                                : kSeen;
}

/// The slots of a shape of a frozen scene, or of a group: one, or more if it is in pieces.
std::vector<std::int32_t> slots_of(const ShapeLists& shapes, const FrozenScene<float>& frozen,
                                   const ShapeId& shape) {
  std::int32_t slots = 0;
#define ZRAKA_COUNT(Type, plural) slots += frozen.plural.count;
  ZRAKA_KINDS(ZRAKA_COUNT)
#undef ZRAKA_COUNT
  std::vector<std::int32_t> its;
  for (std::int32_t slot = 0; slot < slots; ++slot)
    if (shape_in_slot(shapes, frozen, slot) == shape) its.push_back(slot);
  return its;
}

/// The shape that is looked for, as its slots where it stands.
class Wanted {
 public:
  Wanted(const Scene& scene, const FrozenStore<float>& store, const ShapeInScene& shape)
      : scene_(store.scene) {
    if (shape.group < 0) {
      slots_ = slots_of(scene, store.scene, shape.id);
    } else if (const auto group = static_cast<std::size_t>(shape.group);
               group < scene.groups.size()) {
      group_ = &store.groups[group];
      slots_ = slots_of(scene.groups[group], *group_, shape.id);
    }
  }

  bool exists() const { return !slots_.empty(); }
  bool in_group() const { return group_ != nullptr; }

  /// Whether the way to a hit of this slot of the scene goes through it.
  bool is_on_way(std::int32_t slot, const HitPath* path) const {
    if (slot < 0) return false;
    if (group_ == nullptr) return holds(slot);
    if (path == nullptr) return false;
    const FrozenScene<float>* at = &scene_;
    for (int i = 0; i < path->depth; ++i) {
      const FrozenShapes<float, Body>& bodies = at->bodies;
      if (at == group_ && holds(bodies.first_slot + path->instance[i])) return true;
      const double* const row = bodies.numbers + bodies.start[path->instance[i]];
      at = bodies.groups + static_cast<std::ptrdiff_t>(row[kBodyNumbers]);
    }
    return at == group_ && holds(path->slot);
  }

 private:
  bool holds(std::int32_t slot) const {
    return std::find(slots_.begin(), slots_.end(), slot) != slots_.end();
  }

  const FrozenScene<float>& scene_;
  const FrozenScene<float>* group_ = nullptr;  ///< nullptr: it stands in the scene itself
  std::vector<std::int32_t> slots_;
};

/// One thread's listener and what it has noted.
class WayReader {
 public:
  WayReader(const FrozenScene<float>& scene, const TraceSettings& settings, const Wanted& wanted,
            bool corners, std::int32_t batch)
      : scene_(scene),
        wanted_(wanted),
        corners_(corners),
        recorder_(scene, settings, batch, *this, wanted.in_group()),
        pixels_(static_cast<std::size_t>(settings.max_depth) + 1),
        ways_of_rays_(pixels_.size()) {}
  WayReader(const WayReader&) = delete;
  WayReader& operator=(const WayReader&) = delete;

  /// Traces a tile of pixels and sets their bits.
  void read(const TileRect& tile, Influence& influence);

  /// Pixels that are reached by each way, by its path and whether it is a shadow's.
  using Key = std::tuple<std::vector<RayKind>, bool, bool>;
  void add_counts_to(std::map<Key, std::uint64_t>& counts) const {
    for (const auto& [way, count] : counts_)
      counts[{ways_.path(way / 2), ways_.longer(way / 2), way % 2 == 1}] += count;
  }

  void at_hits(const Level<float>& level, const Scratch<float>& s);
  void at_light(std::int32_t light, std::size_t shadow_rays, const Level<float>& level,
                const Scratch<float>& s);
  void at_children(const Level<float>& level, const Level<float>& next);
  void at_fold(const Level<float>&) {}

 private:
  std::size_t depth_of(const Level<float>& level) {
    return static_cast<std::size_t>(&level - recorder_.workspace().levels);
  }
  void note(std::size_t depth, std::size_t ray, bool shadow);
  void leave_each_once() {
    std::sort(notes_.begin(), notes_.end());
    notes_.erase(std::unique(notes_.begin(), notes_.end()), notes_.end());
  }

  const FrozenScene<float>& scene_;
  const Wanted& wanted_;
  bool corners_;
  TileRecorder recorder_;
  Ways ways_;
  /// By level and ray: which ray of the tile it comes from, and by which way.
  std::vector<std::vector<std::uint32_t>> pixels_, ways_of_rays_;
  TileRect tile_{};                   ///< of pixels
  std::vector<TileRect> ray_places_;  ///< the pixels, in the tile, that a ray of level 0 belongs to
  std::vector<std::pair<std::uint32_t, std::uint32_t>> notes_;  ///< (2·way + shadow, pixel in tile)
  std::map<std::uint32_t, std::uint64_t> counts_;               ///< pixels by 2·way + shadow
};

void WayReader::note(std::size_t depth, std::size_t ray, bool shadow) {
  constexpr std::size_t kMany = std::size_t{1} << 20;
  const TileRect& of = ray_places_[pixels_[depth][ray]];
  const std::uint32_t way = 2 * ways_of_rays_[depth][ray] + (shadow ? 1 : 0);
  for (std::int32_t y = of.y; y < of.y + of.height; ++y)
    for (std::int32_t x = of.x; x < of.x + of.width; ++x)
      notes_.push_back({way, static_cast<std::uint32_t>(y * tile_.width + x)});
  if (notes_.size() > kMany) leave_each_once();
}

void WayReader::at_hits(const Level<float>& level, const Scratch<float>& s) {
  const auto begin = static_cast<std::size_t>(level.done);
  for (std::size_t h = 0; h < static_cast<std::size_t>(level.hit_count); ++h) {
    const auto ray = static_cast<std::size_t>(level.hits.ray[h]);
    if (wanted_.is_on_way(s.slot[ray], &s.paths[h])) note(depth_of(level), begin + ray, false);
  }
}

void WayReader::at_light(std::int32_t, std::size_t shadow_rays, const Level<float>& level,
                         const Scratch<float>& s) {
  const auto begin = static_cast<std::size_t>(level.done);
  const RecordedTerms& terms = recorder_.terms();
  const GeneralRecorder* const general = recorder_.general();
  for (std::size_t i = 0; i < shadow_rays; ++i) {
    const auto h = static_cast<std::size_t>(s.shadow_ray_hit[i]);
    bool shades = s.lit[h] <= 0 &&
                  wanted_.is_on_way(terms.blocker(i, s), terms.blocker_path(i, scene_));
    // What takes a part of the light has a part in the shadow, too.
    if (general != nullptr)
      for (const GeneralRecorder::Body& body : general->passed(h))
        shades = shades || wanted_.is_on_way(body.slot, &body.path);
    if (shades) note(depth_of(level), begin + static_cast<std::size_t>(level.hits.ray[h]), true);
  }
}

void WayReader::at_children(const Level<float>& level, const Level<float>& next) {
  const std::size_t depth = depth_of(level);
  const auto begin = static_cast<std::size_t>(level.done);
  pixels_[depth + 1].resize(static_cast<std::size_t>(next.ray_count));
  ways_of_rays_[depth + 1].resize(static_cast<std::size_t>(next.ray_count));
  for (std::size_t h = 0; h < static_cast<std::size_t>(level.hit_count); ++h) {
    const std::size_t parent = begin + static_cast<std::size_t>(level.hits.ray[h]);
    recorder_.each_child(level, h, [&](std::int32_t index, bool refracted) {
      const auto child = static_cast<std::size_t>(index);
      pixels_[depth + 1][child] = pixels_[depth][parent];
      ways_of_rays_[depth + 1][child] =
          ways_.next(ways_of_rays_[depth][parent],
                     refracted ? RayKind::refracted : RayKind::reflected);
    });
  }
}

void WayReader::read(const TileRect& tile, Influence& influence) {
  tile_ = tile;
  const std::int32_t more = corners_ ? 1 : 0;
  const TileRect rays{tile.x, tile.y, tile.width + more, tile.height + more};
  ray_places_.clear();
  each_pixel(rays, [&](std::int32_t x, std::int32_t y) {
    // A corner belongs to the pixels right and below, left and above of it.
    const std::int32_t left = std::max(0, x - more), top = std::max(0, y - more);
    ray_places_.push_back({left, top, std::min(x, tile.width - 1) - left + 1,
                           std::min(y, tile.height - 1) - top + 1});
  });
  pixels_[0].resize(ray_places_.size());
  for (std::size_t i = 0; i < pixels_[0].size(); ++i) pixels_[0][i] = static_cast<std::uint32_t>(i);
  ways_of_rays_[0].assign(ray_places_.size(), Ways::kRoot);

  recorder_.trace(rays);
  leave_each_once();
  for (const auto& [way, pixel] : notes_) {
    ++counts_[way];
    const auto width = static_cast<std::uint32_t>(tile.width);
    const std::size_t x = static_cast<std::size_t>(tile.x) + pixel % width;
    const std::size_t y = static_cast<std::size_t>(tile.y) + pixel / width;
    influence.pixels[y * influence.width + x] |= bit_of(ways_.path(way / 2), way % 2 == 1);
  }
  notes_.clear();
}

}  // namespace

std::uint64_t Influence::count(unsigned bits) const {
  return static_cast<std::uint64_t>(std::count_if(
      pixels.begin(), pixels.end(), [&](std::uint8_t pixel) { return (pixel & bits) != 0; }));
}

Result<Influence> influence(const Scene& scene, const RenderOptions& options,
                            const ShapeInScene& shape) {
  if (const Result<Isa> isa = isa_to_listen_to(scene, options); !isa)
    return tl::make_unexpected(isa.error());
  if (const Result<void> good = check_lesson(scene); !good)
    return tl::make_unexpected(good.error());
  try {
    const PreparedScene<float> prepared = prepare<float>(scene, options);
    if (is_cancelled(options)) return failure("", "the search was cancelled");
    const FrozenScene<float>& frozen = prepared.store->scene;
    const Wanted wanted(scene, *prepared.store, shape);
    if (!wanted.exists()) return failure("", "the scene does not have this shape");

    Influence found;
    found.width = scene.resolution.width;
    found.height = scene.resolution.height;
    found.pixels.resize(std::size_t{found.width} * found.height);
    const bool corners = options.profile.average_corners;
    const TraceSettings settings = settings_of(options, prepared);
    const auto readers = listen_to_tiles<WayReader>(
        scene.resolution, options,
        [&](std::int32_t batch) {
          return std::make_unique<WayReader>(frozen, settings, wanted, corners, batch);
        },
        [&](WayReader& reader, const TileRect& rect) { reader.read(rect, found); });
    if (!readers) return failure("", "the search was cancelled");

    std::map<WayReader::Key, std::uint64_t> counts;
    for (const std::unique_ptr<WayReader>& reader : *readers) reader->add_counts_to(counts);
    for (const auto& [key, pixels] : counts)
      found.ways.push_back({std::get<0>(key), std::get<1>(key), std::get<2>(key), pixels});
    std::sort(found.ways.begin(), found.ways.end(),
              [](const InfluenceWay& a, const InfluenceWay& b) {
                return std::tie(b.pixels, a.path, a.longer, a.shadow) <
                       std::tie(a.pixels, b.path, b.longer, b.shadow);
              });
    return found;
  } catch (const std::bad_alloc&) {
    return failure(
        "", fmt::format("not enough memory for a picture of {}×{} pixels and {} shapes",
                        scene.resolution.width, scene.resolution.height, scene.shape_count()));
  }
}

}  // namespace zraka
