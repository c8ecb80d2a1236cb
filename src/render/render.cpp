// SPDX-License-Identifier: Apache-2.0
// Tiles over threads: oneTBB hands out tiles, each thread has its own memory for the engine.
#include <fmt/format.h>
#include <tbb/enumerable_thread_specific.h>
#include <tbb/global_control.h>
#include <tbb/info.h>

#include <algorithm>
#include <cmath>
#include <chrono>
#include <optional>
#include <type_traits>
#include <vector>
#include <zraka/render.hpp>

#include "core/phrase.hpp"
#include "core/spread.hpp"
#include "render/corners.hpp"
#include "render/isa.hpp"
#include "render/prepare.hpp"
#include "render/screen_bounds.hpp"
#include "render/tiles.hpp"
#include "render/variation.hpp"
#include "engine/coefficients.hpp"
#include "engine/tile_order.hpp"
#include "render/tracer.hpp"
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
  sum.cut += more.cut;
}

template <class R>
struct Worker {
  TracerMemory<R> memory;
  RayCounts counts;
  double most_cut = 0, all_cut = 0;
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

template <class R>
void trace_tile_generally(const Kernel<R>& kernel, const FrozenScene<R>& scene,
                          const TraceSettings& settings, const TileRect& tile,
                          Worker<R>& worker, RayCounts& counts, Image& image) {
  TracerMemory<R>& memory = worker.memory;
  Workspace<R>& workspace = memory.workspace();
  RayArrays<R>& rays = workspace.levels[0].rays;
  std::size_t i = 0;
  const FrozenCamera<R>& c = scene.camera;
  each_pixel(tile, [&](std::int32_t x, std::int32_t y) {
    workspace.samples[i] = {tile.x + x, tile.y + y, 0};
    V3<R> d = (c.first + c.down * static_cast<R>(tile.y + y)) + c.right * static_cast<R>(tile.x + x);
    d = d * (R(1) / std::sqrt(dot(d, d)));
    rays.ox[i] = c.eye.x, rays.oy[i] = c.eye.y, rays.oz[i] = c.eye.z;
    rays.dx[i] = d.x, rays.dy[i] = d.y, rays.dz[i] = d.z;
    ++i;
  });
  workspace.levels[0].ray_count = static_cast<std::int32_t>(i);
  if (scene.textures != nullptr) start_cones(scene.camera, workspace.levels[0]);
  trace_rays(kernel, scene, settings, memory, counts);
  i = 0;
  each_pixel(tile, [&](std::int32_t x, std::int32_t y) {
    float* const out = pixel_of(image, tile.x + x, tile.y + y);
    out[0] = static_cast<float>(rays.r[i]), out[1] = static_cast<float>(rays.g[i]);
    out[2] = static_cast<float>(rays.b[i]);
    const auto cut = static_cast<double>(memory.general->workspace().rays[0][i].cut);
    worker.most_cut = std::max(worker.most_cut, cut);
    worker.all_cut += cut;
    ++i;
  });
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
    if (settings.variation == 0 && scene.optics == nullptr) {
      bounds.emplace(scene, image.width, image.height);
      const V3<float>& color = scene.background;
      for (int i = 0; i < tile; ++i)
        background.insert(background.end(), {color.x, color.y, color.z});
    }
  tbb::enumerable_thread_specific<Worker<R>> workers([&] {
    return Worker<R>{TracerMemory<R>(tile * tile, scene, settings), {}};
  });
  std::atomic<std::uint64_t> pixels_done{0}, rays_done{0};
  const auto render_tile = [&](const TileRect& rect) {
    Worker<R>& worker = workers.local();
    RayCounts counts;
    const TileRect part = bounds ? bounds->part_of(rect) : rect;
    if (scene.optics != nullptr)
      trace_tile_generally(kernel, scene, settings, part, worker, counts, image);
    else if (area_of(part) != 0)
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
  double all_cut = 0;
  for (const Worker<R>& worker : workers) {
    add(rendering.stats.rays, worker.counts);
    rendering.stats.most_cut = std::max(rendering.stats.most_cut, worker.most_cut);
    all_cut += worker.all_cut;
  }
  rendering.stats.mean_cut = all_cut / static_cast<double>(std::uint64_t{image.width} * image.height);
  return complete;
}

template <class R, class SceneRef>
bool freeze_and_render(SceneRef&& scene, const Kernel<R>& kernel, const RenderOptions& options,
                       int tile, int threads, int variation, Rendering& rendering) {
  const auto start = std::chrono::steady_clock::now();
  const Resolution resolution = scene.resolution;
  if (options.bind_threads && scene.shape_count() >= kManyShapes) spread_workers(threads);
  const PreparedScene<R> prepared = prepare<R>(std::forward<SceneRef>(scene), options);
  rendering.stats.build_seconds = seconds_since(start);
  rendering.stats.scene_bytes = prepared.store->bytes();
  rendering.stats.accel_bytes = prepared.hierarchy.nodes.size() * sizeof(Node) +
                                prepared.hierarchy.rank.size() * sizeof(std::int32_t);

  // Not before: while a scene is frozen, memory is fullest.
  const std::uint32_t more = options.profile.average_corners ? 1 : 0;
  rendering.image = Image(resolution.width + more, resolution.height + more);
  const auto traced = std::chrono::steady_clock::now();
  const bool complete =
      render_tiles(prepared.store->scene, kernel, settings_of(options, prepared, variation),
                   options, tile, threads, rendering);
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
  if (variation.kernel != nullptr && needs_general_engine(scene, options)) return beyond_the_lab();
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
            ? freeze_and_render<double>(std::forward<SceneRef>(scene), isa_oracle::kKernel, options,
                                        tile, threads, 0, rendering)
            : freeze_and_render<float>(
                  std::forward<SceneRef>(scene),
                  variation.kernel == nullptr ? kernel_of(*isa) : *variation.kernel, options, tile,
                  threads, variation.number, rendering);
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

tl::unexpected<Diagnostics> beyond_the_lab() {
  return failure("", phrase(Word::mistake_beyond), phrase(Word::mistake_rules));
}

Result<Rendering> render_varied(const Scene& scene, const RenderOptions& options,
                                const Variation& variation) {
  Scene varied = scene;
  if (variation.vary_scene) variation.vary_scene(varied);
  RenderOptions other = options;
  if (variation.vary_options) variation.vary_options(other);
  Result<Rendering> rendering = render_any(std::move(varied), other, variation);
  if (rendering && variation.vary_image) variation.vary_image(rendering->image);
  return rendering;
}

}  // namespace zraka
