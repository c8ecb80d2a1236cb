// SPDX-License-Identifier: Apache-2.0
// From a sample of a pixel to its ray in the engine's arrays.
#pragma once

#include <cstdint>
#include <vector>
#include <zraka/render.hpp>

#include "cameras/camera_ray.hpp"
#include "engine/engine.hpp"
#include "sampling/pixel_filter.hpp"
#include "scene/frozen.hpp"

namespace zraka {

/// What the samples of a batch are drawn from, and which of them count below 0.
struct SampleBatch {
  std::vector<std::uint32_t> shuffle, u, v, number;
  std::vector<std::uint8_t> negative;
  explicit SampleBatch(std::size_t size)
      : shuffle(size + kArrayPadding),
        u(size + kArrayPadding),
        v(size + kArrayPadding),
        number(size + kArrayPadding),
        negative(size) {}
};

/// Makes the rays of a picture's samples. What it makes depends on pixel and number alone.
template <class R>
class SampleRays {
 public:
  /// `textured`: rays have cones. `names_samples`: the engine asks which samples add()'s are.
  SampleRays(const FrozenCamera<R>& camera, const Profile& profile, const Sampling& sampling,
             bool textured, bool names_samples = true);

  enum class Made { ray, negative_ray, nothing };
  /// Puts a sample's ray to place `index` of level 0, and its name into the workspace; a negative
  /// one counts where the filter is below 0. Nothing where the camera does not see anything.
  Made make(std::int32_t x, std::int32_t y, std::uint32_t number, Workspace<R>& workspace,
            std::int32_t index) const;

  /// Whether the following two make them, many at a time.
  bool in_batches() const { return in_batches_; }
  /// Samples [first, first + count) of a pixel, to places from `index` on.
  void add(std::int32_t x, std::int32_t y, std::uint32_t first, std::uint32_t count,
           Workspace<R>& workspace, SampleBatch& batch, std::int32_t index) const;
  /// A pixel's only sample, likewise.
  void add_only(std::int32_t x, std::int32_t y, Workspace<R>& workspace, SampleBatch& batch,
                std::int32_t index) const {
    if (is_drawn_) return add(x, y, 0, 1, workspace, batch, index);
    const RayArrays<R>& rays = workspace.levels[0].rays;
    rays.dx[index] = static_cast<R>(x + in_pixel_) + static_cast<R>(only_.x);
    rays.dy[index] = static_cast<R>(y + in_pixel_) + static_cast<R>(only_.y);
    batch.negative[static_cast<std::size_t>(index)] = only_.negative;
    if (names_samples_) workspace.samples[index] = {x, y, 0};
  }
  /// The rays of the first n.
  void make_all(const Services<R>& services, std::int32_t n, Workspace<R>& workspace,
                SampleBatch& batch) const;

  /// Samples that every pixel has; adaptive ones are the least.
  std::uint32_t count() const { return count_; }
  const PixelFilterShape& filter() const { return filter_; }

 private:
  void put_cone(const PicturePoint& point, const CameraRay& ray, const RayArrays<R>& rays,
                std::int32_t index) const;
  FilterOffset fixed_offset(std::uint32_t number) const;
  FilterOffset offset(std::int32_t x, std::int32_t y, std::uint32_t number) const;

  const FrozenCamera<R>& camera_;
  const Sampling sampling_;
  const PixelFilterShape& filter_;
  const InverseFilter inverse_;
  const bool textured_, in_batches_;
  const bool is_drawn_;  ///< places come of Sobol's sequence, and are not the same in all pixels
  const bool names_samples_;
  const double in_pixel_;  ///< corners that are averaged are around the pixel, not its place
  std::uint32_t count_;
  FilterOffset only_{};  ///< of samples that are their pixels' only ones
  double cone_scale_;
};

/// Whether trace_tile() knows all rays of the picture and what becomes of them.
template <class R>
bool is_plain(const FrozenScene<R>& scene, const Sampling& sampling) {
  return scene.camera.is_plain() && scene.optics == nullptr && sampling.is_single();
}

/// Whether each pixel is the mean of the rays through its corners.
template <class R>
bool has_corners(const FrozenScene<R>& scene, const RenderOptions& options) {
  return options.profile.average_corners && scene.camera.is_plain() &&
         options.sampling.is_single();
}

}  // namespace zraka
