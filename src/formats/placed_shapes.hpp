// SPDX-License-Identifier: Apache-2.0
// Shapes that a format puts somewhere by a transform: primitives where they stay such, else bodies.
#pragma once

#include <zraka/scene.hpp>

namespace zraka {

class PlacedShapes {
 public:
  explicit PlacedShapes(Scene& scene) : scene_(scene) {}

  void add_sphere(const Vec3& center, double radius, std::uint32_t material, const Transform& t);
  void add_triangle(const Triangle& triangle, std::uint32_t material, const Transform& t);
  /// The transform must have an inverse.
  void add_triangle(const SmoothTriangle& triangle, std::uint32_t material, const Transform& t);
  template <class Body>
  void add_body(std::vector<Object<Body>>& list, const Body& body, std::uint32_t material,
                const Transform& t) {
    list.push_back({body, material, index_of(t)});
  }
  /// For Object::transform and CsgMember::transform.
  std::uint32_t index_of(const Transform& t);

 private:
  Scene& scene_;
};

}  // namespace zraka
