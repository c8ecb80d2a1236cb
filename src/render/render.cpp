// SPDX-License-Identifier: Apache-2.0
// Tiles over threads: oneTBB hands out tiles, each thread has its own memory for the engine.
#include <fmt/format.h>
#include <tbb/enumerable_thread_specific.h>
#include <tbb/global_control.h>
#include <tbb/info.h>

#include <algorithm>
#include <chrono>
#include <optional>
#include <type_traits>
#include <utility>
#include <vector>
#include <zraka/render.hpp>

#include "core/spread.hpp"
#include "render/corners.hpp"
#include "render/isa.hpp"
#include "render/layers.hpp"
#include "render/prepare.hpp"
#include "render/screen_bounds.hpp"
#include "render/tiles.hpp"
#include "render/variation.hpp"
#include "render/workspace.hpp"

namespace zraka {
namespace {

/// So many shapes are worth waiting for all threads before a hierarchy is built of them.
constexpr std::uint64_t kManyShapes = 4096;

double seconds_since(std::chrono::steady_clock::time_point start) {
  return std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
}

void add(RayCounts& sum, const RayCounts& more) {
  sum.camera += more.camera;
  sum.shadow += more.shadow;
  sum.reflected += more.reflected;
  sum.refracted += more.refracted;
  sum.hits += more.hits;
}

template <class R>
struct Worker {
  WorkspaceMemory<R> memory;
  RayCounts counts;
};

std::uint64_t area_of(const TileRect& rect) {
  return static_cast<std::uint64_t>(rect.width) * static_cast<std::uint64_t>(rect.height);
}

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

/// Renders all tiles of a frozen scene. False if it was cancelled.
template <class R>
bool render_tiles(const FrozenScene<R>& scene, const Kernel<R>& kernel,
                  const TraceSettings& settings, const RenderOptions& options, int tile,
                  int threads, Rendering& rendering) {
  Image& image = rendering.image;
  // The oracle asks with every ray, and so do varied rules, which may be about what rays hit.
  std::optional<ScreenBounds> bounds;
  std::vector<float> background;
  if constexpr (std::is_same_v<R, float>)
    if (settings.variation == 0) {
      bounds.emplace(scene, image.width, image.height);
      const V3<float>& color = scene.background;
      for (int i = 0; i < tile; ++i)
        background.insert(background.end(), {color.x, color.y, color.z});
    }
  tbb::enumerable_thread_specific<Worker<R>> workers([&] {
    return Worker<R>{WorkspaceMemory<R>(tile * tile, settings.max_depth, scene.textures != nullptr), {}};
  });
  std::atomic<std::uint64_t> pixels_done{0}, rays_done{0};
  const auto render_tile = [&](const TileRect& rect) {
    Worker<R>& worker = workers.local();
    RayCounts counts;
    const TileRect part = bounds ? bounds->part_of(rect) : rect;
    if (area_of(part) != 0)
      kernel.trace_tile(scene, settings, part, worker.memory.workspace(), counts,
                        pixel_of(image, part.x, part.y), image.width);
    if (area_of(part) != area_of(rect)) {
      fill_around(part, rect, background, image);
      counts.camera += area_of(rect) - area_of(part);  // they have been answered, too
    }
    add(worker.counts, counts);
    if (options.progress) {
      const std::uint64_t area = area_of(rect);
      const std::uint64_t pixels = pixels_done.fetch_add(area) + area;
      const std::uint64_t rays = rays_done.fetch_add(counts.total()) + counts.total();
      options.progress(pixels, std::uint64_t{image.width} * image.height, rays);
    }
  };
  const bool complete = each_tile(image.width, image.height, tile, threads, options.bind_threads,
                                  options.cancel, render_tile);
  for (const Worker<R>& worker : workers) add(rendering.stats.rays, worker.counts);
  return complete;
}

template <class R, class SceneRef>
bool freeze_and_render(SceneRef&& scene, const Kernel<R>& kernel,
                       TraceFirstHitsOfTile<R>& first_hits, const RenderOptions& options, int tile,
                       int threads, int variation, Rendering& rendering) {
  const auto start = std::chrono::steady_clock::now();
  const Resolution resolution = scene.resolution;
  if (options.bind_threads && scene.shape_count() >= kManyShapes) spread_workers(threads);
  const PreparedScene<R> prepared =
      need_scene(options.layers) ? prepare<R>(std::as_const(scene), options.profile)
                                 : prepare<R>(std::forward<SceneRef>(scene), options.profile);
  rendering.stats.build_seconds = seconds_since(start);
  rendering.stats.scene_bytes = prepared.store->bytes();
  rendering.stats.accel_bytes = prepared.hierarchy.nodes.size() * sizeof(Node) +
                                prepared.hierarchy.rank.size() * sizeof(std::int32_t);

  // Not before: while a scene is frozen, memory is fullest.
  const std::uint32_t more = options.profile.average_corners ? 1 : 0;
  rendering.image = Image(resolution.width + more, resolution.height + more);
  const auto traced = std::chrono::steady_clock::now();
  const TraceSettings settings = settings_of(options, prepared.frame, variation);
  const bool complete =
      render_tiles(prepared.store->scene, kernel, settings, options, tile, threads, rendering) &&
      make_layers<R>({&scene, prepared, kernel, first_hits, settings, options, tile, threads},
                     rendering);
  if (complete && options.profile.average_corners)
    rendering.image = means_of_corners(std::move(rendering.image));
  rendering.stats.render_seconds = seconds_since(traced);
  return complete;
}

template <class SceneRef>
Result<Rendering> render_any(SceneRef&& scene, const RenderOptions& options,
                             const Variation& variation = {}) {
  const int threads = options.threads == 0 ? tbb::info::default_concurrency()
                                           : std::clamp(options.threads, 1, kMaxThreads);
  tbb::global_control limit(tbb::global_control::max_allowed_parallelism,
                            static_cast<std::size_t>(threads));
  Diagnostics problems = check_request(scene, options);
  if (!problems.empty()) return tl::make_unexpected(std::move(problems));
  const Result<Isa> isa = choose_isa(options.isa);
  if (!isa) return tl::make_unexpected(isa.error());
  if (*isa == Isa::oracle && variation.kernel != nullptr)
    return failure("", "the oracle keeps to the rules", "ask for avx512, avx2 or portable");

  const Resolution resolution = scene.resolution;
  const int tile =
      options.tile == 0 ? chosen_tile(resolution.width, resolution.height, threads) : options.tile;
  const std::uint64_t shapes = scene.shape_count();
  Rendering rendering;
  try {
    rendering.stats.isa = *isa;
    rendering.stats.threads = threads;
    const bool complete =
        *isa == Isa::oracle
            ? freeze_and_render<double>(std::forward<SceneRef>(scene), isa_oracle::kKernel,
                                        isa_oracle::trace_first_hits_of_tile, options, tile,
                                        threads, 0, rendering)
            : freeze_and_render<float>(
                  std::forward<SceneRef>(scene),
                  variation.kernel == nullptr ? kernel_of(*isa) : *variation.kernel,
                  first_hits_of(*isa), options, tile, threads, variation.number, rendering);
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

Result<Rendering> render_varied(const Scene& scene, const RenderOptions& options,
                                const Variation& variation) {
  if (options.transparent || !options.layers.empty())
    return failure("", "layers and transparent pictures are those of the right rules");
  Scene varied = scene;
  if (variation.vary_scene) variation.vary_scene(varied);
  RenderOptions other = options;
  if (variation.vary_options) variation.vary_options(other);
  Result<Rendering> rendering = render_any(std::move(varied), other, variation);
  if (rendering && variation.vary_image) variation.vary_image(rendering->image);
  return rendering;
}

}  // namespace zraka
