// SPDX-License-Identifier: Apache-2.0
// From samples to the colours of pixels, by way of the engine.
#pragma once

#include <algorithm>
#include <atomic>
#include <type_traits>
#include <vector>

#include "engine/tile_order.hpp"
#include "render/film.hpp"
#include "render/picture_job.hpp"
#include "render/sample_rays.hpp"
#include "render/tracer.hpp"

namespace zraka {

/// A tile may be of one pixel, but rays want company.
inline constexpr std::int32_t kLeastBatch = 1024;

/// Samples on their way through the engine, a batch at a time, and back to their pixels in the
/// order that they came in.
template <class R>
class SampleTracer {
 public:
  SampleTracer(const PictureJob<R>& job, const SampleRays<R>& samples)
      : job_(job),
        samples_(samples),
        memory_(batch_of(job), job.scene, job.settings),
        batch_(static_cast<std::size_t>(memory_.workspace().batch)),
        only_(batch_.number.size()),
        hits_(batch_.number.size()) {}

  /// The samples [first, last) of a pixel.
  void add(std::int32_t x, std::int32_t y, std::uint32_t first, std::uint32_t last,
           FilmPixel& pixel) {
    Workspace<R>& workspace = memory_.workspace();
    if (!samples_.in_batches()) return add_one_by_one(x, y, first, last, pixel);
    while (first < last) {
      const std::uint32_t n =
          std::min(last - first, static_cast<std::uint32_t>(workspace.batch - count_));
      samples_.add(x, y, first, n, workspace, batch_, count_);
      count_ += static_cast<std::int32_t>(n);
      runs_.push_back({&pixel, count_});
      first += n;
      if (count_ == workspace.batch) flush();
    }
  }

  /// The only samples of all pixels of a rectangle: their colours are the pixels'. color_at(x, y) is
  /// where one goes to.
  template <class ColorAt>
  void add_only(const TileRect& rect, const ColorAt& color_at, const std::atomic<bool>* cancel) {
    const auto cancelled = [&] {
      return cancel != nullptr && cancel->load(std::memory_order_relaxed);
    };
    if (!samples_.places_are_fixed()) {
      each_pixel(rect, [&](std::int32_t x, std::int32_t y) {
        if (!cancelled()) add_only(rect.x + x, rect.y + y, color_at(rect.x + x, rect.y + y));
      });
      return;
    }
    const typename SampleRays<R>::FixedPlaces places(samples_, memory_.workspace(), batch_);
    const std::int32_t batch = memory_.workspace().batch;
    std::int32_t count = count_;
    float** const colors = only_.data();
    each_pixel(rect, [&](std::int32_t x, std::int32_t y) {
      places.put(rect.x + x, rect.y + y, count);
      colors[count] = color_at(rect.x + x, rect.y + y);
      if (++count < batch) return;
      flush_only(cancelled() ? 0 : count);
      count = 0;
    });
    count_ = count;
    has_only_ = true;
  }
  /// The only sample of a pixel: its colour is the pixel's.
  void add_only(std::int32_t x, std::int32_t y, float* color) {
    Workspace<R>& workspace = memory_.workspace();
    if (samples_.in_batches()) {
      samples_.add(x, y, 0, 1, workspace, batch_, count_);
    } else if (samples_.make(x, y, 0, workspace, count_) == SampleRays<R>::Made::nothing) {
      std::fill_n(color, 3, 0.0f);
      return;
    }
    only_[static_cast<std::size_t>(count_)] = color;
    has_only_ = true;
    if (++count_ == workspace.batch) flush();
  }

  void flush_only(std::int32_t count) {
    count_ = count;
    has_only_ = true;
    flush();
  }

  /// Traces what has been added.
  void flush() {
    if (count_ == 0) return;
    Workspace<R>& workspace = memory_.workspace();
    Level<R>& level = workspace.levels[0];
    level.ray_count = count_;
    if (samples_.in_batches())
      samples_.make_all(*job_.kernel.services, count_, workspace, batch_);
    trace_rays(job_.kernel, job_.scene, job_.settings, memory_, counts);
    if (memory_.general && job_.settings.min_contribution > 0)
      for (std::size_t i = 0; i < static_cast<std::size_t>(count_); ++i)
        note_cut(static_cast<double>(memory_.general->workspace().rays[0][i].cut));
    if (has_only_)
      give_only(level);
    else
      give_all(level);
    count_ = 0;
  }

  RayCounts counts;
  double most_cut = 0, all_cut = 0;

 private:
  void give_all(const Level<R>& level) {
    if (!adds_plainly_) {
      std::fill_n(hits_.begin(), count_, std::uint8_t{0});
      for (std::int32_t h = 0; h < level.hit_count; ++h)
        hits_[static_cast<std::size_t>(level.hits.ray[h])] = 1;
    }
    std::int32_t first = 0;
    for (const Run& run : runs_) {
      give(level, static_cast<std::size_t>(first), static_cast<std::size_t>(run.end), *run.pixel);
      first = run.end;
    }
    runs_.clear();
  }
  /// As FilmPixel::mean() has it, there is no zero below 0.
  void give_only(const Level<R>& level) {
    for (std::size_t i = 0; i < static_cast<std::size_t>(count_); ++i) {
      only_[i][0] = static_cast<float>(level.rays.r[i]) + 0.0f;
      only_[i][1] = static_cast<float>(level.rays.g[i]) + 0.0f;
      only_[i][2] = static_cast<float>(level.rays.b[i]) + 0.0f;
    }
    has_only_ = false;
  }

  /// The more children hits have, the fewer hits: their rays have to stay near.
  static std::int32_t batch_of(const PictureJob<R>& job) {
    if (job.scene.optics == nullptr) return std::max(job.tile * job.tile, kLeastBatch);
    return std::max(2 * kLeastBatch * 2 / general::most_children(job.settings), 64);
  }
  void note_cut(double cut) {
    most_cut = std::max(most_cut, cut);
    all_cut += cut;
  }

  void add_one_by_one(std::int32_t x, std::int32_t y, std::uint32_t first, std::uint32_t last,
                      FilmPixel& pixel) {
    Workspace<R>& workspace = memory_.workspace();
    for (std::uint32_t number = first; number < last; ++number) {
      const auto made = samples_.make(x, y, number, workspace, count_);
      if (made == SampleRays<R>::Made::nothing) {
        pixel.add(FilmSample{});
        continue;
      }
      batch_.negative[static_cast<std::size_t>(count_)] = made == SampleRays<R>::Made::negative_ray;
      if (runs_.empty() || runs_.back().pixel != &pixel) runs_.push_back({&pixel, 0});
      runs_.back().end = ++count_;
      if (count_ == workspace.batch) flush();
    }
  }

  /// Gives samples [first, end) to their pixel.
  void give(const Level<R>& level, std::size_t first, std::size_t end, FilmPixel& pixel) const {
    if constexpr (std::is_same_v<R, float>)
      if (adds_plainly_)
        return pixel.add(FilmRun{level.rays.r + first, level.rays.g + first, level.rays.b + first,
                                 end - first});
    for (std::size_t i = first; i < end; ++i) {
      FilmSample sample{{static_cast<float>(level.rays.r[i]), static_cast<float>(level.rays.g[i]),
                         static_cast<float>(level.rays.b[i])},
                        batch_.negative[i] != 0,
                        hits_[i] != 0};
      // Behind what is transparent is nothing.
      if (job_.options.transparent && !sample.hits) std::fill_n(sample.color, 3, 0.0f);
      pixel.add(sample);
    }
  }

  struct Run {
    FilmPixel* pixel;
    std::int32_t end;
  };
  const PictureJob<R>& job_;
  const SampleRays<R>& samples_;
  TracerMemory<R> memory_;
  SampleBatch batch_;
  std::vector<Run> runs_;  ///< of samples of one pixel each
  std::vector<float*> only_;  ///< or, of samples that are their pixels' only ones, these
  bool has_only_ = false;
  std::vector<std::uint8_t> hits_;
  std::int32_t count_ = 0;
  const bool adds_plainly_ = std::is_same_v<R, float> &&
                             job_.options.sampling.kind != Sampling::Kind::adaptive &&
                             job_.options.sampling.filter != PixelFilter::mitchell &&
                             !job_.options.transparent;
};

}  // namespace zraka
