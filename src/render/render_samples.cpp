// SPDX-License-Identifier: Apache-2.0
#include "render/render_samples.hpp"

#include <algorithm>
#include <vector>

#include "core/threads.hpp"
#include "engine/tile_order.hpp"
#include "render/film.hpp"
#include "render/sample_tracer.hpp"
#include "render/tiles.hpp"
#include "scene/reals.hpp"

namespace zraka {
namespace {

template <class R>
class SampledPicture {
 public:
  SampledPicture(const PictureJob<R>& job, Rendering& rendering)
      : job_(job),
        rendering_(rendering),
        samples_(job.scene.camera, job.options.profile, job.options.sampling,
                 job.scene.textures != nullptr, job.scene.optics != nullptr),
        bounds_(job.bounds(samples_.filter().radius())),
        tracers_([this] { return SampleTracer<R>(job_, samples_); }),
        alpha_(job.options.transparent ? std::size_t{rendering.image.width} * rendering.image.height
                                       : 0) {}

  /// As many samples for each pixel: tile by tile, and a tile's film is all that there is at a
  /// time.
  bool render_evenly() {
    const std::uint64_t area = area_of(job_.part);
    WorkProgress progress(job_.options, area, area);
    PerThread<std::vector<FilmPixel>> films;
    const bool needs_film = samples_.count() > 1 || !alpha_.empty() ||
                            job_.options.sampling.filter == PixelFilter::mitchell;
    const bool complete = each_tile_of(job_.part, [&](const TileRect& tile) {
      std::uint64_t rays = 0;
      if (needs_film) {
        std::vector<FilmPixel>& film = films.local();
        film.assign(area_of(tile), FilmPixel());
        const Film in_tile{film.data(), tile};
        rays =
            trace(tile, in_tile, samples_.count(), [](std::int32_t, std::int32_t) { return true; });
        if (!cancelled()) develop(tile, in_tile);
      } else {
        rays = trace_only(tile);
      }
      if (cancelled()) return;
      if (job_.tile_done != nullptr && alpha_.empty())
        (*job_.tile_done)(rendering_.image,
                          {tile.x - job_.part.x, tile.y - job_.part.y, tile.width, tile.height});
      progress.add(area_of(tile), rays);
    });
    finish();
    rendering_.stats.samples_per_pixel = samples_.count();
    return complete;
  }

  /// More samples where they make a difference. All decisions of a pass are made before its first
  /// ray, from the pass before it, so that it does not matter which pixels share a tile.
  bool render_adaptively() {
    const auto most = static_cast<std::uint32_t>(job_.options.sampling.most);
    int passes = 1;
    for (std::uint32_t n = samples_.count(); n < most; n = std::min(2 * n, most)) ++passes;
    // A pass looks at neighbours, whose samples depend on theirs: a margin makes a crop the same.
    const TileRect region = with_margin(passes - 1);
    std::vector<FilmPixel> pixels(area_of(region));
    std::vector<float> means(3 * pixels.size());
    const Film film{pixels.data(), region};
    const ContrastTest test(pixels, means, region.width, region.height,
                            job_.options.sampling.contrast);
    WorkProgress progress(job_.options, area_of(job_.part),
                          static_cast<std::uint64_t>(passes) * area_of(region));
    std::uint32_t target = samples_.count();
    for (int pass = 0; pass < passes; ++pass, target = std::min(2 * target, most)) {
      if (pass > 0 && !each_tile_of(region, [&](const TileRect& tile) {
            each_pixel(tile, [&](std::int32_t x, std::int32_t y) {
              const FilmPixel& pixel = film.at(tile.x + x, tile.y + y);
              pixel.mean(samples_.filter(), means.data() + 3 * (&pixel - pixels.data()));
            });
          }))
        return false;
      const auto wants = [&](std::int32_t x, std::int32_t y) {
        return pass == 0 || test.wants_more(x - region.x, y - region.y);
      };
      if (!each_tile_of(region, [&](const TileRect& tile) {
            progress.add(area_of(tile), trace(tile, film, target, wants));
          }))
        return false;
    }
    develop(job_.part, film);
    finish();
    std::uint64_t all = 0;
    for (std::int32_t y = job_.part.y; y < job_.part.y + job_.part.height; ++y)
      for (std::int32_t x = job_.part.x; x < job_.part.x + job_.part.width; ++x) {
        rendering_.samples.push_back(film.at(x, y).count());
        all += rendering_.samples.back();
      }
    rendering_.stats.samples_per_pixel =
        static_cast<double>(all) / static_cast<double>(area_of(job_.part));
    return true;
  }

 private:
  /// The pixels of a rectangle of the picture.
  struct Film {
    FilmPixel* pixels;
    TileRect rect;
    FilmPixel& at(std::int32_t x, std::int32_t y) const {
      return pixels[std::ptrdiff_t{y - rect.y} * rect.width + (x - rect.x)];
    }
  };

  template <class Work>
  bool each_tile_of(const TileRect& rect, const Work& work) {
    return each_tile(static_cast<std::uint32_t>(rect.width),
                     static_cast<std::uint32_t>(rect.height), job_.tile, job_.threads,
                     job_.options.bind_threads, job_.options.cancel, [&](const TileRect& tile) {
                       work(TileRect{rect.x + tile.x, rect.y + tile.y, tile.width, tile.height});
                     });
  }

  /// A tile of many samples takes seconds: its pixels ask, too.
  bool cancelled() const {
    return job_.options.cancel != nullptr && job_.options.cancel->load(std::memory_order_relaxed);
  }

  /// Brings those pixels of a tile that want it to `target` samples. Returns the number of rays.
  template <class Wants>
  std::uint64_t trace(const TileRect& tile, const Film& film, std::uint32_t target,
                      const Wants& wants) {
    SampleTracer<R>& tracer = tracers_.local();
    const std::uint64_t before = tracer.counts.total();
    const TileRect seen = bounds_ ? bounds_->part_of(tile) : tile;
    const FilmSample empty = empty_sample();
    each_pixel(tile, [&](std::int32_t column, std::int32_t row) {
      const std::int32_t x = tile.x + column, y = tile.y + row;
      if (!wants(x, y) || cancelled()) return;
      FilmPixel& pixel = film.at(x, y);
      if (contains(seen, x, y)) {
        tracer.add(x, y, pixel.count(), target, pixel);
        return;
      }
      const std::uint32_t more = target - std::min(pixel.count(), target);
      if (more > 0) pixel.add(empty, more);
      tracer.counts.camera += more;
    });
    tracer.flush();
    return tracer.counts.total() - before;
  }

  /// Brings a tile's pixels their only samples.
  std::uint64_t trace_only(const TileRect& tile) {
    SampleTracer<R>& tracer = tracers_.local();
    const std::uint64_t before = tracer.counts.total();
    const TileRect seen = bounds_ ? bounds_->part_of(tile) : tile;
    if (cancelled()) return 0;
    if (area_of(seen) < area_of(tile)) fill_beside(tile, seen, tracer.counts);
    float* const corner = color_at(job_.part.x, job_.part.y);
    const std::ptrdiff_t stride = color_at(job_.part.x, job_.part.y + 1) - corner;
    tracer.add_only(
        seen,
        [corner, stride, left = job_.part.x, top = job_.part.y](std::int32_t x, std::int32_t y) {
          return corner + (y - top) * stride + 3 * (x - left);
        },
        job_.options.cancel);
    tracer.flush();
    return tracer.counts.total() - before;
  }

  /// Of a tile, the pixels that surely see nothing.
  void fill_beside(const TileRect& tile, const TileRect& seen, RayCounts& counts) {
    const FilmSample empty = empty_sample();
    for (std::int32_t y = tile.y; y < tile.y + tile.height; ++y)
      for (std::int32_t x = tile.x; x < tile.x + tile.width; ++x) {
        if (contains(seen, x, y)) continue;
        for (int c = 0; c < 3; ++c) color_at(x, y)[c] = empty.color[c] + 0.0f;
        ++counts.camera;
      }
  }

  static bool contains(const TileRect& rect, std::int32_t x, std::int32_t y) {
    return x >= rect.x && y >= rect.y && x < rect.x + rect.width && y < rect.y + rect.height;
  }

  /// Of what surely hits nothing.
  FilmSample empty_sample() const {
    if (job_.options.transparent) return {};
    const V3<R>& sky = job_.scene.background;
    return {{static_cast<float>(sky.x), static_cast<float>(sky.y), static_cast<float>(sky.z)}};
  }

  float* color_at(std::int32_t x, std::int32_t y) const {
    return rendering_.image.row(static_cast<std::uint32_t>(y - job_.part.y)) +
           3 * (x - job_.part.x);
  }

  /// Makes pixels of the image of a film's.
  void develop(const TileRect& rect, const Film& film) {
    for (std::int32_t y = rect.y; y < rect.y + rect.height; ++y) {
      float* color = color_at(rect.x, y);
      for (std::int32_t x = rect.x; x < rect.x + rect.width; ++x, color += 3) {
        film.at(x, y).mean(samples_.filter(), color);
        if (!alpha_.empty())
          alpha_[static_cast<std::size_t>(color - rendering_.image.pixels.data()) / 3] =
              film.at(x, y).coverage(samples_.filter());
      }
    }
  }

  TileRect with_margin(std::int32_t margin) const {
    const TileRect& part = job_.part;
    const std::int32_t left = std::max(part.x - margin, 0), top = std::max(part.y - margin, 0);
    const std::int32_t right =
        std::min(part.x + part.width + margin, static_cast<std::int32_t>(job_.resolution.width));
    const std::int32_t bottom =
        std::min(part.y + part.height + margin, static_cast<std::int32_t>(job_.resolution.height));
    return {left, top, right - left, bottom - top};
  }

  void finish() {
    if (!alpha_.empty()) {
      rendering_.layers.width = rendering_.image.width;
      rendering_.layers.height = rendering_.image.height;
      rendering_.layers.channels.push_back({"A", std::move(alpha_), true});
    }
    double all_cut = 0;
    tracers_.each([&](const SampleTracer<R>& tracer) {
      add(rendering_.stats.rays, tracer.counts);
      rendering_.stats.most_cut = std::max(rendering_.stats.most_cut, tracer.most_cut);
      all_cut += tracer.all_cut;
    });
    const auto cameras = static_cast<double>(rendering_.stats.rays.camera);
    if (cameras > 0) rendering_.stats.mean_cut = all_cut / cameras;
  }

  const PictureJob<R>& job_;
  Rendering& rendering_;
  const SampleRays<R> samples_;
  const std::optional<ScreenBounds> bounds_;
  PerThread<SampleTracer<R>> tracers_;
  std::vector<float> alpha_;  ///< of a transparent picture
};

}  // namespace

template <class R>
bool render_samples(const PictureJob<R>& job, Rendering& rendering) {
  SampledPicture<R> picture(job, rendering);
  return job.options.sampling.kind == Sampling::Kind::adaptive ? picture.render_adaptively()
                                                               : picture.render_evenly();
}

#define ZRAKA_FOR(R) template bool render_samples(const PictureJob<R>&, Rendering&);
ZRAKA_FOR_REALS(ZRAKA_FOR)
#undef ZRAKA_FOR

}  // namespace zraka
