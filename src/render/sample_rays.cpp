// SPDX-License-Identifier: Apache-2.0
#include "render/sample_rays.hpp"

#include <cmath>

#include "cameras/cameras.hpp"
#include "sampling/dimensions.hpp"

namespace zraka {

template <class R>
SampleRays<R>::SampleRays(const FrozenCamera<R>& camera, const Profile& profile,
                          const Sampling& sampling, bool textured)
    : camera_(camera),
      sampling_(sampling),
      filter_(PixelFilterShape::of(sampling.filter)),
      textured_(textured),
      in_pixel_(profile.average_corners ? 0.5 : 0) {
  const auto count = static_cast<std::uint32_t>(sampling.count);
  count_ = sampling.kind == Sampling::Kind::grid ? count * count : count;
  // Together the samples' cones are as wide as the pixel's.
  cone_scale_ = 1 / std::sqrt(static_cast<double>(count_));
}

template <class R>
FilterOffset SampleRays<R>::offset(std::int32_t x, std::int32_t y, std::uint32_t number) const {
  if (sampling_.is_single()) return {0, 0, false};
  if (sampling_.kind == Sampling::Kind::grid) {
    const auto side = static_cast<std::uint32_t>(sampling_.count);
    return filter_.offset({(number % side + 0.5) / side, (number / side + 0.5) / side});
  }
  return filter_.offset(sample_point(sampling_.seed, x, y, number, kPixelPair));
}

/// To the bit as make_camera_rays() of the engine has it.
template <class R>
V3<double> SampleRays<R>::plain_direction(std::int32_t x, std::int32_t y) const {
  const V3<R> through = (camera_.first + camera_.down * static_cast<R>(y)) +
                        camera_.right * static_cast<R>(x);
  const V3<R> unit = through * (R(1) / std::sqrt(dot(through, through)));
  return {static_cast<double>(unit.x), static_cast<double>(unit.y), static_cast<double>(unit.z)};
}

template <class R>
typename SampleRays<R>::Made SampleRays<R>::make(std::int32_t x, std::int32_t y,
                                                 std::uint32_t number, Workspace<R>& workspace,
                                                 std::int32_t index) const {
  const FilterOffset at = offset(x, y, number);
  PicturePoint point{x + in_pixel_ + at.x, y + in_pixel_ + at.y, {}};
  if (camera_.has_lens()) point.lens = sample_point(sampling_.seed, x, y, number, kLensPair);
  CameraRay ray;
  if (!camera_ray(camera_, point, ray)) return Made::nothing;
  if (camera_.is_plain() && sampling_.is_single()) ray.direction = plain_direction(x, y);

  const RayArrays<R>& rays = workspace.levels[0].rays;
  rays.ox[index] = static_cast<R>(ray.origin.x);
  rays.oy[index] = static_cast<R>(ray.origin.y);
  rays.oz[index] = static_cast<R>(ray.origin.z);
  rays.dx[index] = static_cast<R>(ray.direction.x);
  rays.dy[index] = static_cast<R>(ray.direction.y);
  rays.dz[index] = static_cast<R>(ray.direction.z);
  if (textured_) {
    const CameraCone cone = camera_cone(camera_, point, ray);
    rays.width[index] = static_cast<R>(cone.width * cone_scale_);
    rays.spread[index] = static_cast<R>(cone.spread * cone_scale_);
  }
  workspace.samples[index] = {x, y, number};
  return at.negative ? Made::negative_ray : Made::ray;
}

template class SampleRays<float>;
template class SampleRays<double>;

}  // namespace zraka
