// SPDX-License-Identifier: Apache-2.0
#include "render/sample_rays.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>

#include "cameras/cameras.hpp"
#include "engine/window_rays.hpp"
#include "sampling/dimensions.hpp"
#include "scene/reals.hpp"

namespace zraka {

template <class R>
SampleRays<R>::SampleRays(const FrozenCamera<R>& camera, const Profile& profile,
                          const Sampling& sampling, bool textured, bool names_samples)
    : camera_(camera),
      sampling_(sampling),
      filter_(PixelFilterShape::of(sampling.filter)),
      inverse_(filter_.inverse()),
      textured_(textured),
      in_batches_(camera.is_plain()),
      is_drawn_(!sampling.is_single() && sampling.kind != Sampling::Kind::grid),
      names_samples_(names_samples),
      in_pixel_(profile.average_corners && !(camera.is_plain() && sampling.is_single()) ? 0.5 : 0) {
  const auto count = static_cast<std::uint32_t>(sampling.count);
  count_ = sampling.kind == Sampling::Kind::grid ? count * count : count;
  // Together the samples' cones are as wide as the pixel's.
  cone_scale_ = 1 / std::sqrt(static_cast<double>(count_));
}

template <class R>
FilterOffset SampleRays<R>::fixed_offset(std::uint32_t number) const {
  if (sampling_.is_single()) return {0, 0, false};
  const auto side = static_cast<std::uint32_t>(sampling_.count);
  return filter_.offset({(number % side + 0.5) / side, (number / side + 0.5) / side});
}

/// Of one sample, as make_all() has those of many.
template <class R>
FilterOffset SampleRays<R>::offset(std::int32_t x, std::int32_t y, std::uint32_t number) const {
  if (!is_drawn_) return fixed_offset(number);
  std::uint32_t u = 0, v = 0;
  Sobol2(hash(sampling_.seed, x, y, kPixelPair)).find_bits(number, u, v);
  const auto place = [&](std::uint32_t bits) {
    return static_cast<double>(inverse_.places == nullptr
                                   ? inverse_.template place<true, R>(bits)
                                   : inverse_.template place<false, R>(bits));
  };
  return {place(u), place(v), inverse_.is_negative(u) != inverse_.is_negative(v)};
}

template <class R>
typename SampleRays<R>::Made SampleRays<R>::make(std::int32_t x, std::int32_t y,
                                                 std::uint32_t number, Workspace<R>& workspace,
                                                 std::int32_t index) const {
  const FilterOffset at = offset(x, y, number);
  PicturePoint point{x + in_pixel_ + at.x, y + in_pixel_ + at.y, {}};
  if (camera_.has_lens()) point.lens = sample_point(sampling_.seed, x, y, number, kLensPair);
  CameraRay ray;
  const RayArrays<R>& rays = workspace.levels[0].rays;
  if (in_batches_) {
    // To the bit as it is made among others.
    V3<R> way{static_cast<R>(x + in_pixel_) + static_cast<R>(at.x),
              static_cast<R>(y + in_pixel_) + static_cast<R>(at.y), R(0)};
    look_through_window(camera_, 1, &way.x, &way.y, &way.z);
    ray = {in_double(camera_.eye), in_double(way)};
  } else if (!camera_ray(camera_, point, ray)) {
    return Made::nothing;
  }
  rays.ox[index] = static_cast<R>(ray.origin.x);
  rays.oy[index] = static_cast<R>(ray.origin.y);
  rays.oz[index] = static_cast<R>(ray.origin.z);
  rays.dx[index] = static_cast<R>(ray.direction.x);
  rays.dy[index] = static_cast<R>(ray.direction.y);
  rays.dz[index] = static_cast<R>(ray.direction.z);
  if (textured_) put_cone(point, ray, rays, index);
  workspace.samples[index] = {x, y, number};
  return at.negative ? Made::negative_ray : Made::ray;
}

template <class R>
void SampleRays<R>::put_cone(const PicturePoint& point, const CameraRay& ray,
                             const RayArrays<R>& rays, std::int32_t index) const {
  const CameraCone cone = camera_cone(camera_, point, ray);
  rays.width[index] = static_cast<R>(cone.width * cone_scale_);
  rays.spread[index] = static_cast<R>(cone.spread * cone_scale_);
  rays.travelled[index] = R(0);
}

template <class R>
void SampleRays<R>::add(std::int32_t x, std::int32_t y, std::uint32_t first, std::uint32_t count,
                        Workspace<R>& workspace, SampleBatch& batch, std::int32_t index) const {
  const RayArrays<R>& rays = workspace.levels[0].rays;
  const auto i = static_cast<std::size_t>(index);
  if (names_samples_)
    for (std::uint32_t s = 0; s < count; ++s) workspace.samples[i + s] = {x, y, first + s};
  if (is_drawn_) {
    const Sobol2 points(hash(sampling_.seed, x, y, kPixelPair));
    batch.runs.push_back({x + in_pixel_, y + in_pixel_, points.shuffle, points.scramble_u,
                          points.scramble_v, first, count, static_cast<std::uint32_t>(index)});
    return;
  }
  for (std::uint32_t s = 0; s < count; ++s) {
    const FilterOffset at = fixed_offset(first + s);
    rays.dx[i + s] = static_cast<R>(x + in_pixel_) + static_cast<R>(at.x);
    rays.dy[i + s] = static_cast<R>(y + in_pixel_) + static_cast<R>(at.y);
    batch.negative[i + s] = at.negative;
  }
}

template <class R>
void SampleRays<R>::make_all(const Services<R>& services, std::int32_t n, Workspace<R>& workspace,
                             SampleBatch& batch) const {
  RayArrays<R>& rays = workspace.levels[0].rays;
  services.make_window_rays(camera_, is_drawn_ ? &inverse_ : nullptr,
                            {batch.runs.data(), batch.runs.size(), batch.shuffle.data(),
                             batch.u.data(), batch.v.data(), batch.number.data()},
                            static_cast<std::size_t>(n), rays, batch.negative.data());
  batch.runs.clear();
  if (!textured_) return;
  for (std::int32_t i = 0; i < n; ++i) {
    const auto d = [&](const R* of) { return static_cast<double>(of[i]); };
    put_cone({}, {{}, {d(rays.dx), d(rays.dy), d(rays.dz)}}, rays, i);
  }
}

#define ZRAKA_FOR(R) template class SampleRays<R>;
ZRAKA_FOR_REALS(ZRAKA_FOR)
#undef ZRAKA_FOR

}  // namespace zraka
