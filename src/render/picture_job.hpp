// SPDX-License-Identifier: Apache-2.0
// What the ways to render a picture share: what is to be done, and how far it is.
#pragma once

#include <atomic>
#include <cstdint>
#include <functional>
#include <optional>
#include <type_traits>
#include <zraka/render.hpp>

#include "engine/engine.hpp"
#include "render/screen_bounds.hpp"

namespace zraka {

inline std::uint64_t area_of(const TileRect& rect) {
  return static_cast<std::uint64_t>(rect.width) * static_cast<std::uint64_t>(rect.height);
}

inline void add(RayCounts& sum, const RayCounts& more) {
  sum.camera += more.camera;
  sum.shadow += more.shadow;
  sum.reflected += more.reflected;
  sum.refracted += more.refracted;
  sum.hits += more.hits;
  sum.cut += more.cut;
}

/// Told of parts of an image that are done, from worker threads.
using TileOfImage = std::function<void(const Image&, const TileRect&)>;

/// A picture, or the part of it that is asked for, of a frozen scene.
template <class R>
struct PictureJob {
  const FrozenScene<R>& scene;
  const Kernel<R>& kernel;
  const TraceSettings& settings;
  const RenderOptions& options;
  Resolution resolution;  ///< of the whole picture
  TileRect part;          ///< of it
  int tile, threads;
  const TileOfImage* tile_done = nullptr;  ///< none: nobody wants to know

  /// Whether all rays that hit nothing bring the same colour.
  bool sky_is_flat() const {
    return scene.optics == nullptr || scene.optics->sky.kind == Sky::Kind::flat;
  }

  /// Where shapes can be seen; none where every ray has to ask: the oracle's do, and those of
  /// varied rules, which may be about what rays hit. Samples are up to `reach` pixels from a
  /// pixel's place.
  std::optional<ScreenBounds> bounds(double reach = 0) const {
    if constexpr (std::is_same_v<R, float>)
      if (settings.variation == 0 && sky_is_flat() && scene.camera.kind != CameraKind::fisheye)
        return ScreenBounds(scene, resolution.width, resolution.height, reach);
    return std::nullopt;
  }
};

/// Tells options.progress of work that comes in several passes over more pixels than the picture
/// has, as if each of the picture's were done once.
class WorkProgress {
 public:
  WorkProgress(const RenderOptions& options, std::uint64_t pixels, std::uint64_t work)
      : options_(options), pixels_(pixels), work_(work) {}

  void add(std::uint64_t done, std::uint64_t rays) {
    if (!options_.progress) return;
    const std::uint64_t all = done_.fetch_add(done) + done;
    const std::uint64_t all_rays = rays_.fetch_add(rays) + rays;
    options_.progress(work_ == pixels_ ? all
                                       : static_cast<std::uint64_t>(static_cast<double>(all) /
                                                                    static_cast<double>(work_) *
                                                                    static_cast<double>(pixels_)),
                      pixels_, all_rays);
  }

 private:
  const RenderOptions& options_;
  const std::uint64_t pixels_, work_;
  std::atomic<std::uint64_t> done_{0}, rays_{0};
};

}  // namespace zraka
