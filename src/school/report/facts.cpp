// SPDX-License-Identifier: Apache-2.0
// Renders the stages, listens to them, and sorts out what was counted.
#include "school/report/facts.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <new>
#include <set>

#include "core/phrase.hpp"
#include "explain/shape_lookup.hpp"
#include "explain/tile_listeners.hpp"
#include "image/alter.hpp"
#include "school/report/listener.hpp"

namespace zraka {
namespace {

const Material& material_of(const Scene& scene, const ShapeId& id) {
  std::int32_t kind = 0;
#define ZRAKA_IF(Type, plural) \
  if (id.kind == kind++) return scene.materials[scene.plural[id.index].material];
  ZRAKA_SHAPES(ZRAKA_IF)
#undef ZRAKA_IF
  return scene.materials.front();
}

/// A picture's stages on the way to their facts.
class Measurement {
 public:
  Measurement(const Scene& scene, const RenderOptions& options)
      : scene_(scene),
        options_(options),
        prepared_(prepare<float>(scene, options)),
        seen_(std::size_t{scene.resolution.width} * scene.resolution.height) {}

  Result<void> stage(Stage stage,
                     const std::function<Result<void>(Stage, const StagePictures&)>& take);
  SceneFacts facts;

 private:
  const FrozenScene<float>& frozen() const { return prepared_.store->scene; }
  Result<RayTally> listen();
  StagePictures change(Stage stage, const Image& image, Change& change);
  void sort_out(const RayTally& tally, StageFacts& stage) const;
  void note_seen(const RayTally& tally);

  ShapePixels shape_pixels(std::int32_t slot, std::uint64_t pixels) const {
    const ShapeId id = shape_in_slot(scene_, frozen(), slot);
    return {named(scene_, id), material_of(scene_, id), pixels};
  }
  static void most_first(std::vector<ShapePixels>& shapes) {
    std::sort(shapes.begin(), shapes.end(), [](const ShapePixels& a, const ShapePixels& b) {
      return a.pixels != b.pixels ? a.pixels > b.pixels : a.shape.id < b.shape.id;
    });
  }
  /// Shapes by the pixels where they alone are seen, of those that `wanted` asks for.
  template <class Wanted>
  std::vector<ShapePixels> by_shape(const Wanted& wanted) const {
    std::map<std::int32_t, std::uint64_t> counts;
    for (std::size_t i = 0; i < seen_.size(); ++i)
      if (seen_[i] >= 0 && wanted(i)) ++counts[seen_[i]];
    std::vector<ShapePixels> shapes;
    for (const auto& [slot, count] : counts) shapes.push_back(shape_pixels(slot, count));
    most_first(shapes);
    return shapes;
  }

  const Scene& scene_;
  RenderOptions options_;
  PreparedScene<float> prepared_;
  std::vector<std::int32_t> seen_;  ///< slot by pixel
  Image before_;                    ///< the stage before, as stored
};

Result<RayTally> Measurement::listen() {
  const Resolution& size = scene_.resolution;
  const bool corners = options_.profile.average_corners;
  const TraceSettings settings = settings_of(options_, prepared_);
  const auto listeners = listen_to_tiles<StageListener>(
      size, options_,
      [&](std::int32_t batch) {
        return std::make_unique<StageListener>(frozen(), settings, corners,
                                               static_cast<std::int32_t>(size.width),
                                               static_cast<std::int32_t>(size.height), batch);
      },
      [&](StageListener& listener, const TileRect& rect) { listener.read(rect, seen_); });
  if (!listeners) return failure("", "the report was cancelled");
  RayTally tally;
  for (const std::unique_ptr<StageListener>& listener : *listeners) tally.add(listener->tally());
  return tally;
}

void Measurement::note_seen(const RayTally& tally) {
  for (const auto& [what, pixels] : tally.pixels)
    if (std::get<0>(what) == Tie::seen)
      facts.seen.push_back(shape_pixels(std::get<1>(what), pixels));
  most_first(facts.seen);
  facts.covered = static_cast<std::uint64_t>(std::count_if(
      seen_.begin(), seen_.end(), [](std::int32_t slot) { return slot != kNothingSeen; }));
}

StagePictures Measurement::change(Stage stage, const Image& image, Change& change) {
  StagePictures pictures;
  pictures.picture = as_stored(image, options_.profile.transfer, 8);
  const std::vector<float>& now = pictures.picture.pixels;
  std::set<std::array<float, 3>> colors;
  std::array<float, 3> last{-1, -1, -1};
  for (std::size_t i = 0; i < now.size(); i += 3) {
    const std::array<float, 3> color{now[i], now[i + 1], now[i + 2]};
    if (stage == Stage::ambient && color != last) colors.insert(last = color);
    if (std::max({color[0], color[1], color[2]}) >= 1) ++change.full;
  }
  change.colors = colors.size();
  if (stage != Stage::silhouette) {
    const std::vector<float>& before = before_.pixels;
    const std::vector<float> map = difference_map(before_, pictures.picture);
    float largest = 0;
    for (std::size_t i = 0; i < map.size(); ++i) {
      if (map[i] == 0) continue;
      ++change.pixels;
      largest = std::max(largest, map[i]);
      const auto steps = [&](const std::vector<float>& values) {
        int sum = 0;
        for (std::size_t c = 3 * i; c < 3 * i + 3; ++c)
          sum += static_cast<int>(255 * values[c] + 0.5f);
        return sum;
      };
      const int more = steps(now) - steps(before);
      if (more > 0) ++change.brighter;
      if (more < 0) ++change.darker;
      if (seen_[i] == kNothingSeen) ++change.on_background;
    }
    change.largest = static_cast<int>(255 * largest + 0.5f);
    change.on = by_shape([&](std::size_t i) { return map[i] != 0; });
    pictures.brightest = brightest_difference(map);
    pictures.changes = heat_picture(map, image.width, image.height, pictures.brightest);
  }
  before_ = pictures.picture;
  return pictures;
}

void Measurement::sort_out(const RayTally& tally, StageFacts& stage) const {
  stage.points = tally.points;
  stage.later_points = tally.later_points;
  if (options_.terms.diffuse || options_.terms.specular) {
    for (const RayTally::Light& light : tally.lights)
      stage.lights.push_back({light.facing, light.away, light.blocked, light.dark, light.partly,
                              light.dimmed});
    stage.unlit = tally.lights.empty() ? tally.points : tally.unlit;
  }
  stage.entering = tally.entering;
  stage.leaving = tally.leaving;
  stage.ended_reflected = tally.ended_reflected;
  stage.ended_refracted = tally.ended_refracted;
  stage.deepest = static_cast<int>(tally.deepest);
  stage.absorbed = tally.absorbed;
  stage.fresnel = tally.fresnel;
  stage.split = tally.split;
  stage.total.entering = tally.total_entering;
  stage.total.leaving = tally.total_leaving;
  std::map<std::int32_t, ShapePixels> mostly_on;
  std::vector<ShapePixels> blockers;
  std::map<ShapeId, std::int32_t> slots;
  for (const auto& [what, pixels] : tally.pixels) {
    const auto& [tie, slot, on] = what;
    if (slot == kAnyShape) {
      (tie == Tie::total ? stage.total.pixels : stage.shadowed) = pixels;
      continue;
    }
    const ShapePixels shape = shape_pixels(slot, pixels);
    if (tie == Tie::mirrored) stage.mirrored.push_back(shape);
    if (tie == Tie::seen_through) stage.seen_through.push_back(shape);
    if (tie == Tie::total) stage.total.on.push_back(shape);
    if (tie == Tie::shadow_by) {
      blockers.push_back(shape);
      slots[shape.shape.id] = slot;
    }
    if (tie == Tie::shadow_on) {
      const ShapePixels receiver = shape_pixels(on, pixels);
      ShapePixels& most = mostly_on[slot];
      if (pixels > most.pixels || (pixels == most.pixels && receiver.shape.id < most.shape.id))
        most = receiver;
    }
  }
  for (std::vector<ShapePixels>* list : {&stage.mirrored, &stage.seen_through, &stage.total.on})
    most_first(*list);
  most_first(blockers);
  for (const ShapePixels& by : blockers)
    stage.shadows.push_back({by, mostly_on[slots[by.shape.id]]});
  if (stage.total.pixels > 0) {
    const auto at = [&](int i) { return static_cast<std::uint32_t>(tally.total_box[i]); };
    stage.total.box = {at(0), at(1), at(2), at(3)};
  }
}

Result<void> Measurement::stage(
    Stage stage, const std::function<Result<void>(Stage, const StagePictures&)>& take) {
  options_.terms = terms_of(stage);
  const Result<Rendering> rendering = render(scene_, options_);
  if (!rendering) return tl::make_unexpected(rendering.error());
  const Result<RayTally> tally = listen();
  if (!tally) return tl::make_unexpected(tally.error());
  if (stage == Stage::silhouette) note_seen(*tally);
  StageFacts& of_stage = facts.stages[static_cast<std::size_t>(stage) - 1];
  of_stage.rays = rendering->stats.rays;
  of_stage.build_seconds = rendering->stats.build_seconds;
  of_stage.render_seconds = rendering->stats.render_seconds;
  facts.threads = rendering->stats.threads;
  facts.isa = rendering->stats.isa;
  sort_out(*tally, of_stage);
  return take(stage, change(stage, rendering->image, of_stage.change));
}

}  // namespace

Result<SceneFacts> measure_stages(
    const Scene& scene, RenderOptions options,
    const std::function<Result<void>(Stage, const StagePictures&)>& take) {
  if (const Result<Isa> isa = isa_to_listen_to(scene, options); !isa)
    return tl::make_unexpected(isa.error());
  try {
    Measurement measurement(scene, options);
    if (is_cancelled(options)) return failure("", "the report was cancelled");
    measurement.facts.resolution = scene.resolution;
    measurement.facts.profile = options.profile;
    measurement.facts.max_depth = options.max_depth;
    measurement.facts.shapes = scene.shape_count();
    measurement.facts.lights = scene.lights.size();
    measurement.facts.dark = scene.ambient_light == Color{0, 0, 0};
    measurement.facts.general = needs_general_engine(scene, options);
    measurement.facts.min_contribution = options.min_contribution;
    measurement.facts.wavelengths = options.wavelengths;
    for (int i = 1; i <= 7; ++i) {
      const Result<void> done = measurement.stage(static_cast<Stage>(i), take);
      if (!done) return tl::make_unexpected(done.error());
    }
    return std::move(measurement.facts);
  } catch (const std::bad_alloc&) {
    return failure("",
                   phrase(Word::report_memory, scene.resolution.width, scene.resolution.height));
  }
}

}  // namespace zraka
