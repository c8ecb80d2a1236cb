// SPDX-License-Identifier: Apache-2.0
// From a sample of a pixel to its ray in the engine's arrays.
#pragma once

#include <cstdint>
#include <zraka/render.hpp>

#include "engine/engine.hpp"
#include "sampling/pixel_filter.hpp"
#include "scene/frozen.hpp"

namespace zraka {

/// Makes the rays of a picture's samples. What it makes depends on pixel and number alone.
template <class R>
class SampleRays {
 public:
  /// `textured`: rays have cones.
  SampleRays(const FrozenCamera<R>& camera, const Profile& profile, const Sampling& sampling,
             bool textured);

  enum class Made { ray, negative_ray, nothing };
  /// Puts a sample's ray to place `index` of level 0, and its name into the workspace; a negative
  /// one counts where the filter is below 0. Nothing where the camera does not see anything.
  Made make(std::int32_t x, std::int32_t y, std::uint32_t number, Workspace<R>& workspace,
            std::int32_t index) const;

  /// Samples that every pixel has; adaptive ones are the least.
  std::uint32_t count() const { return count_; }
  const PixelFilterShape& filter() const { return filter_; }

 private:
  V3<double> plain_direction(std::int32_t x, std::int32_t y) const;
  FilterOffset offset(std::int32_t x, std::int32_t y, std::uint32_t number) const;

  const FrozenCamera<R>& camera_;
  const Sampling sampling_;
  const PixelFilterShape& filter_;
  const bool textured_;
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
