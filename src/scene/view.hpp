// SPDX-License-Identifier: Apache-2.0
// Cameras by what people say of them.
#pragma once

#include <optional>
#include <zraka/scene.hpp>

namespace zraka {

/// A pinhole at `eye` that sees `target` in the middle, `fov_deg` degrees over the height of a
/// picture that is `aspect` times as wide as tall. None where the eye is at the target, or `up`
/// along the view.
std::optional<Camera> look_at(const Vec3& eye, const Vec3& target, const Vec3& up, double fov_deg,
                              double aspect);

/// What sees `target` in the middle: parallel rays from a window of that height in scene units, and
/// of a picture's aspect; none as above.
std::optional<Camera> look_along(const Vec3& eye, const Vec3& target, const Vec3& up, double height,
                                 double aspect);

/// How far in front of the eye a point is, along the normal of the camera's window.
double depth_of(const Vec3& point, const Camera& camera);

/// Whether two directions are not parallel, and neither is 0.
bool spans_a_plane(const Vec3& a, const Vec3& b);

}  // namespace zraka
