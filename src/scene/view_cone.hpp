// SPDX-License-Identifier: Apache-2.0
// A cone around all rays of a picture, from which follows what deserves floats' precision.
#pragma once

#include <zraka/scene.hpp>

#include "math/bounds.hpp"
#include "math/vec.hpp"

namespace zraka {

double length_of(const V3<double>& v);

/// Its tip is the eye, or, of an orthographic camera, it is a cylinder around the view; a panorama
/// and a fisheye of half a turn and more see everything.
class ViewCone {
 public:
  ViewCone(const Camera& camera, const Resolution& resolution);

  /// False only if no ray meets the box.
  bool may_see(const Bounds& box) const;
  /// On the view.
  Vec3 point_at(double distance) const;
  /// How wide the picture is at a distance.
  double width_at(double distance) const;

  const Vec3 eye;

 private:
  V3<double> axis_{};
  double cosine_ = 1, sine_ = 0;
  double radius_ = 0;  ///< at the eye
  bool parallel_ = false;
  bool known_ = false;
};

}  // namespace zraka
