// SPDX-License-Identifier: Apache-2.0
// A camera and lights for what comes without: chosen so that one sees all of it.
#pragma once

#include <array>
#include <span>
#include <zraka/scene.hpp>

namespace zraka {

/// The size of pictures of what says nothing of it.
inline constexpr Resolution kFramedResolution = {1280, 720};

/// From where one looks, and what is up. Of unit length, not parallel.
struct ViewDirection {
  Vec3 to_eye, up;
};

/// The nearest place of an eye from which all balls are in the picture: each of the four planes of
/// the view touches one.
class Framing {
 public:
  Framing(const ViewDirection& direction, double aspect);

  /// How far balls lie out, for each plane.
  using Distances = std::array<double, 4>;
  Distances none() const;
  void include(const Vec3& center, double radius, Distances& most) const;
  Camera camera(const Distances& most) const;

 private:
  ViewDirection direction_;
  double aspect_;
  Vec3 along_, right_, up_;
  std::array<double, 4> angles_;
  std::array<Vec3, 4> normals_;  ///< of the planes, outwards
};

/// A camera that has all points in its picture.
Camera camera_around(std::span<const Vec3> points, const ViewDirection& direction, double aspect);

/// A key light from the upper left, and one that fills its shadows from the right; both far away
/// from something of that size.
void add_studio_lights(Scene& scene, const ViewDirection& direction, const Vec3& middle,
                       double size);

}  // namespace zraka
