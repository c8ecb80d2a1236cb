// SPDX-License-Identifier: Apache-2.0
// The spaces that shapes are described in, where textures lie.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstring>

#include "engine/hit_path.hpp"
#include "scene/bounds_of.hpp"
#include "scene/frozen.hpp"

namespace zraka {

/// The way from the engine's frame to the spaces of shapes, which is mostly that of the hit before.
template <class R>
class ShapeSpaces {
 public:
  explicit ShapeSpaces(const FrozenScene<R>& scene) : scene_(scene) { start(nullptr); }

  /// To the group that a hit's shape stands in.
  void follow(const HitPath& path) {
    if (path.group == group_ &&
        (group_ == nullptr || std::memcmp(path.to_frame, to_frame_, sizeof(to_frame_)) == 0))
      return;
    group_ = path.group;
    std::copy_n(path.to_frame, 12, to_frame_);
    start(static_cast<const FrozenScene<R>*>(path.group));
  }
  const FrozenScene<R>& home() const { return *home_; }
  const Transform& from_group() const { return from_group_; }
  const Transform& to_group() const { return to_group_; }
  /// Of its unit.
  double group_scale() const { return group_scale_; }
  /// By Object::transform, to the shape's space.
  const Transform& to_shape(std::int32_t transform) {
    if (transform == transform_) return to_shape_;
    transform_ = transform;
    const double scale = 1 / home_->frame_scale;
    const Transform to_space{{scale, 0, 0}, {0, scale, 0}, {0, 0, scale}, home_->frame_center};
    to_shape_ = then(to_group_, to_space);
    if (transform != 0) to_shape_ = then(to_shape_, scene_.textures->to_shape[transform - 1]);
    return to_shape_;
  }

 private:
  void start(const FrozenScene<R>* group) {
    const double(&m)[12] = to_frame_;
    home_ = group == nullptr ? &scene_ : group;
    from_group_ =
        group == nullptr
            ? Transform()
            : Transform{
                  {m[0], m[1], m[2]}, {m[3], m[4], m[5]}, {m[6], m[7], m[8]}, {m[9], m[10], m[11]}};
    to_group_ = group == nullptr ? Transform() : inverse(from_group_).value_or(Transform());
    const V3<double> unit = vector_of(turned({1, 0, 0}, to_group_));
    group_scale_ = std::sqrt(dot(unit, unit));
    transform_ = -1;
  }

  const FrozenScene<R>& scene_;
  const FrozenScene<R>* home_;
  const void* group_ = nullptr;
  double to_frame_[12]{};
  Transform from_group_, to_group_, to_shape_;
  double group_scale_;
  std::int32_t transform_;
};

}  // namespace zraka
