// SPDX-License-Identifier: Apache-2.0
// Tiles over threads: oneTBB hands out tiles, each thread has its own memory for the engine.
#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <optional>
#include <utility>
#include <vector>
#include <zraka/render.hpp>

#include "core/large_pages.hpp"
#include "core/phrase.hpp"
#include "core/spread.hpp"
#include "core/threads.hpp"
#include "render/corners.hpp"
#include "render/isa.hpp"
#include "render/layers.hpp"
#include "render/outlines.hpp"
#include "render/picture_job.hpp"
#include "render/prepare.hpp"
#include "render/render_prepared.hpp"
#include "render/render_samples.hpp"
#include "render/sample_rays.hpp"
#include "render/tiles.hpp"
#include "render/variation.hpp"
#include "render/workspace.hpp"
#include "scene/reals.hpp"

namespace zraka {
namespace {

/// So many shapes are worth waiting for all threads before a hierarchy is built of them.
constexpr std::uint64_t kManyShapes = 4096;

double seconds_since(std::chrono::steady_clock::time_point start) {
  return std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
}

template <class R>
struct Worker {
  WorkspaceMemory<R> memory;
  RayCounts counts;
};

float* pixel_of(Image& image, std::int32_t x, std::int32_t y) {
  return image.row(static_cast<std::uint32_t>(y)) + 3 * x;
}

/// Gives the pixels of a tile the background's colour, but for a part of it; `background` is a row
/// of pixels of that colour, as long as a tile's.
void fill_around(const TileRect& part, const TileRect& tile, const std::vector<float>& background,
                 Image& image) {
  const auto fill = [&](std::int32_t x, std::int32_t y, std::int32_t width) {
    std::copy_n(background.data(), 3 * width, pixel_of(image, x, y));
  };
  const std::int32_t right = part.x + part.width, end = tile.x + tile.width;
  for (std::int32_t y = tile.y; y < tile.y + tile.height; ++y) {
    const bool beside = y >= part.y && y < part.y + part.height;
    fill(tile.x, y, beside ? part.x - tile.x : tile.width);
    if (beside) fill(right, y, end - right);
  }
}

/// Renders a picture with one ray a pixel, from the eye. False if it was cancelled.
template <class R>
bool render_tiles(const PictureJob<R>& job, Rendering& rendering) {
  const FrozenScene<R>& scene = job.scene;
  Image& image = rendering.image;
  const std::optional<ScreenBounds> bounds = job.bounds();
  std::vector<float> background;
  for (int i = 0; i < job.tile; ++i)
    background.insert(background.end(), {static_cast<float>(scene.background.x),
                                         static_cast<float>(scene.background.y),
                                         static_cast<float>(scene.background.z)});
  PerThread<Worker<R>> workers([&] {
    return Worker<R>{
        WorkspaceMemory<R>(job.tile * job.tile, job.settings.max_depth, scene.textures != nullptr),
        {}};
  });
  const std::uint64_t pixels = std::uint64_t{image.width} * image.height;
  WorkProgress progress(job.options, pixels, pixels);
  const auto in_image = [&](TileRect rect) {
    return TileRect{rect.x - job.part.x, rect.y - job.part.y, rect.width, rect.height};
  };
  const auto render_tile = [&](const TileRect& tile) {
    const TileRect rect{tile.x + job.part.x, tile.y + job.part.y, tile.width, tile.height};
    Worker<R>& worker = workers.local();
    RayCounts counts;
    const TileRect part = bounds ? bounds->part_of(rect) : rect;
    if (area_of(part) != 0)
      job.kernel.trace_tile(scene, job.settings, part, worker.memory.workspace(), counts,
                            pixel_of(image, in_image(part).x, in_image(part).y), image.width);
    if (area_of(part) != area_of(rect)) {
      fill_around(in_image(part), tile, background, image);
      counts.camera += area_of(rect) - area_of(part);  // they have been answered, too
    }
    add(worker.counts, counts);
    if (job.tile_done != nullptr) (*job.tile_done)(image, tile);
    progress.add(area_of(rect), counts.total());
  };
  const bool complete = each_tile(image.width, image.height, job.tile, job.threads,
                                  job.options.bind_threads, job.options.cancel, render_tile);
  workers.each([&](const Worker<R>& worker) { add(rendering.stats.rays, worker.counts); });
  return complete;
}

/// The same of the alpha that a transparent picture has.
void average_corners(Layers& layers) {
  for (Channel& channel : layers.channels) {
    auto* const corners = std::get_if<std::vector<float>>(&channel.values);
    if (corners == nullptr) continue;
    std::vector<float> means;
    for (std::size_t y = 0; y + 1 < layers.height; ++y)
      for (std::size_t x = 0; x + 1 < layers.width; ++x) {
        const float* const at = corners->data() + layers.width * y + x;
        means.push_back(mean_of_corners(at[0], at[1], at[layers.width], at[layers.width + 1]));
      }
    *corners = std::move(means);
  }
  if (!layers.channels.empty()) --layers.width, --layers.height;
}

/// The part of the picture that is asked for.
TileRect part_of(const RenderOptions& options, const Resolution& resolution) {
  const PixelRect all{0, 0, resolution.width, resolution.height};
  const PixelRect part = options.crop.value_or(all);
  return {static_cast<std::int32_t>(part.x), static_cast<std::int32_t>(part.y),
          static_cast<std::int32_t>(part.width), static_cast<std::int32_t>(part.height)};
}

Image black_image(std::uint32_t width, std::uint32_t height) {
  Image image;
  image.width = width, image.height = height;
  const std::size_t values = std::size_t{3} * width * height;
  reserve_large_pages(image.pixels, values);
  image.pixels.resize(values, 0.0f);
  return image;
}

/// Black, also where alpha says that nothing is.
void draw_lines(const std::vector<bool>& lines, Rendering& rendering) {
  std::vector<float>* alpha = nullptr;
  for (Channel& channel : rendering.layers.channels)
    if (channel.name == "A") alpha = std::get_if<std::vector<float>>(&channel.values);
  for (std::size_t i = 0; i < lines.size(); ++i) {
    if (!lines[i]) continue;
    std::fill_n(rendering.image.pixels.data() + 3 * i, 3, 0.0f);
    if (alpha != nullptr) (*alpha)[i] = 1;
  }
}

}  // namespace

template <class R>
bool render_prepared(const Scene* scene, const PreparedScene<R>& prepared,
                     const FrozenScene<R>& frozen, const Kernel<R>& kernel,
                     const RenderOptions& options, const Resolution& resolution, int threads,
                     const Variation& variation, const TileOfImage& tile_done,
                     Rendering& rendering) {
  const TraceSettings settings = settings_of(options, prepared, variation);
  const bool plain = is_plain(frozen, options.sampling) && !options.transparent;
  const bool corners = has_corners(frozen, options);
  const TileRect part = part_of(options, resolution);
  const int tile = options.tile == 0 ? chosen_tile(static_cast<std::uint32_t>(part.width),
                                                   static_cast<std::uint32_t>(part.height), threads)
                                     : options.tile;
  PictureJob<R> job{frozen, kernel, settings, options, resolution, part, tile, threads};
  const bool all_at_once = corners || options.transparent || options.outlines > 0 ||
                           (!plain && options.sampling.kind == Sampling::Kind::adaptive);
  if (tile_done && !all_at_once) job.tile_done = &tile_done;
  if (corners) ++job.part.width, ++job.part.height;
  // Not before: while a scene is frozen, memory is fullest.
  rendering.image = black_image(static_cast<std::uint32_t>(job.part.width),
                                static_cast<std::uint32_t>(job.part.height));
  const auto traced = std::chrono::steady_clock::now();
  bool complete = plain ? render_tiles(job, rendering) : render_samples(job, rendering);
  if (complete && corners) {
    rendering.image = means_of_corners(std::move(rendering.image));
    average_corners(rendering.layers);
  }
  if (complete && options.outlines > 0) {
    std::vector<bool> lines;
    complete = find_outlines<R>({scene, prepared, job}, part, lines);
    if (complete) draw_lines(lines, rendering);
  }
  complete = complete && make_layers<R>({scene, prepared, job}, rendering);
  if (complete && tile_done && all_at_once)
    tile_done(rendering.image, {0, 0, static_cast<std::int32_t>(rendering.image.width),
                                static_cast<std::int32_t>(rendering.image.height)});
  rendering.stats.render_seconds = seconds_since(traced);
  return complete;
}

#define ZRAKA_FOR(R)                                                                            \
  template bool render_prepared(const Scene*, const PreparedScene<R>&, const FrozenScene<R>&,   \
                                const Kernel<R>&, const RenderOptions&, const Resolution&, int, \
                                const Variation&, const TileOfImage&, Rendering&);
ZRAKA_FOR_REALS(ZRAKA_FOR)
#undef ZRAKA_FOR

namespace {

template <class R, class SceneRef>
bool freeze_and_render(SceneRef&& scene, const Kernel<R>& kernel, const RenderOptions& options,
                       int threads, const Variation& variation, const TileOfImage& tile_done,
                       Rendering& rendering) {
  const auto start = std::chrono::steady_clock::now();
  const Resolution resolution = scene.resolution;
  if (options.bind_threads && scene.shape_count() >= kManyShapes) spread_workers(threads);
  const PreparedScene<R> prepared = need_scene(options.layers)
                                        ? prepare<R>(std::as_const(scene), options)
                                        : prepare<R>(std::forward<SceneRef>(scene), options);
  if (is_cancelled(options)) return false;
  rendering.stats.build_seconds = seconds_since(start);
  rendering.stats.scene_bytes = prepared.store->bytes();
  rendering.stats.accel_bytes = prepared.hierarchy.nodes.size() * sizeof(Node) +
                                prepared.hierarchy.rank.size() * sizeof(std::int32_t);

  return render_prepared(&scene, prepared, prepared.store->scene, kernel, options, resolution,
                         threads, variation, tile_done, rendering);
}

template <class SceneRef>
Result<Rendering> render_any(SceneRef&& scene, const RenderOptions& options,
                             const Variation& variation = {}, const TileOfImage& tile_done = {}) {
  const int threads = threads_for(options.threads);
  Diagnostics problems;
  with_threads(options.threads, [&] { problems = check_request(scene, options); });
  if (!problems.empty()) return tl::make_unexpected(std::move(problems));
  if (is_cancelled(options)) return failure("", "the render was cancelled");
  const Result<Isa> isa = choose_isa(options.isa);
  if (!isa) return tl::make_unexpected(isa.error());
  if (variation.kernel != nullptr && is_beyond_the_lab(scene, options)) return beyond_the_lab();
  if (*isa == Isa::oracle && variation.kernel != nullptr)
    return failure("", "the oracle keeps to the rules", "ask for avx512, avx2 or portable");

  const Resolution resolution = scene.resolution;
  const std::uint64_t shapes = scene.shape_count();
  Rendering rendering;
  try {
    rendering.stats.isa = *isa;
    rendering.stats.threads = threads;
    bool complete = false;
    with_threads(options.threads, [&] {
      const auto with = [&](const auto& kernel) {
        complete = freeze_and_render(std::forward<SceneRef>(scene), kernel, options, threads,
                                     variation, tile_done, rendering);
      };
#if ZRAKA_ORACLE
      if (*isa == Isa::oracle) return with(isa_oracle::kKernel);
#endif
      with(variation.kernel == nullptr ? kernel_of(*isa) : variation.kernel(*isa));
    });
    if (!complete) return failure("", "the render was cancelled");
  } catch (const std::bad_alloc&) {
    return failure("", fmt::format("not enough memory for a picture of {}×{} pixels and {} shapes",
                                   resolution.width, resolution.height, shapes));
  }
  return rendering;
}

}  // namespace

Result<Rendering> render(const Scene& scene, const RenderOptions& options) {
  return render_any(scene, options);
}

Result<Rendering> render(Scene&& scene, const RenderOptions& options) {
  return render_any(std::move(scene), options);
}

Result<Rendering> render_with_tiles(const Scene& scene, const RenderOptions& options,
                                    const TileOfImage& tile_done) {
  return render_any(scene, options, {}, tile_done);
}

Result<Rendering> render_with_tiles(Scene&& scene, const RenderOptions& options,
                                    const TileOfImage& tile_done) {
  return render_any(std::move(scene), options, {}, tile_done);
}

Result<void> check_lesson(const Scene& scene) {
  if (scene.camera.kind == CameraKind::pinhole && !(scene.camera.aperture > 0)) return {};
  return failure("", "this is known for a pinhole camera without a lens only",
                 "use another camera: perspective or window");
}

tl::unexpected<Diagnostics> beyond_the_lab() {
  return failure("", phrase(Word::mistake_beyond), phrase(Word::mistake_rules));
}

Result<Rendering> render_varied(const Scene& scene, const RenderOptions& options,
                                const Variation& variation) {
  if (options.transparent || !options.layers.empty() || options.outlines > 0)
    return failure("", "layers, outlines and transparent pictures are those of the right rules");
  Scene varied = scene;
  if (variation.vary_scene) variation.vary_scene(varied);
  RenderOptions other = options;
  if (variation.vary_options) variation.vary_options(other);
  if (variation.kernel != nullptr) {
    other.sampling = {};
    if (const Result<void> good = check_lesson(varied); !good)
      return tl::make_unexpected(good.error());
  }
  Result<Rendering> rendering = render_any(std::move(varied), other, variation);
  if (rendering && variation.vary_image) variation.vary_image(rendering->image);
  return rendering;
}

}  // namespace zraka
