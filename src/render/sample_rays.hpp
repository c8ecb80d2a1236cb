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
  std::vector<SampleRun> runs;  ///< where the former are still to come from
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
  /// Whether add() puts each pixel's first sample to the same place in it: FixedPlaces does so, too.
  bool places_are_fixed() const { return in_batches_ && !is_drawn_; }
  class FixedPlaces {
   public:
    FixedPlaces(const SampleRays& samples, Workspace<R>& workspace, SampleBatch& batch)
        : dx_(workspace.levels[0].rays.dx),
          dy_(workspace.levels[0].rays.dy),
          samples_(workspace.samples),
          negative_(batch.negative.data()),
          in_pixel_(samples.in_pixel_),
          first_(samples.fixed_offset(0)) {}
    void put(std::int32_t x, std::int32_t y, std::int32_t index) const {
      dx_[index] = static_cast<R>(x + in_pixel_) + static_cast<R>(first_.x);
      dy_[index] = static_cast<R>(y + in_pixel_) + static_cast<R>(first_.y);
      negative_[index] = first_.negative;
      samples_[index] = {x, y, 0};
    }

   private:
    R *dx_, *dy_;
    CameraSample* samples_;
    std::uint8_t* negative_;
    const double in_pixel_;
    const FilterOffset first_;
  };
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
