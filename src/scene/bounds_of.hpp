// SPDX-License-Identifier: Apache-2.0
// Where the shapes of a scene are in the world: their own bounds, moved by their transforms; those
// of what is made of other shapes.
#pragma once

#include <optional>
#include <vector>
#include <zraka/scene.hpp>

#include "shapes/bodies.hpp"
#include "shapes/shapes.hpp"

namespace zraka {

inline Vec3 turned(const Vec3& v, const Transform& t) {
  const Vec3 &x = t.along_x, &y = t.along_y, &z = t.along_z;
  return {x.x * v.x + y.x * v.y + z.x * v.z, x.y * v.x + y.y * v.y + z.y * v.z,
          x.z * v.x + y.z * v.y + z.z * v.z};
}
inline Vec3 moved(const Vec3& point, const Transform& t) {
  const Vec3 v = turned(point, t);
  return {v.x + t.origin.x, v.y + t.origin.y, v.z + t.origin.z};
}
/// first, then second.
inline Transform then(const Transform& first, const Transform& second) {
  return {turned(first.along_x, second), turned(first.along_y, second),
          turned(first.along_z, second), moved(first.origin, second)};
}
/// None where it makes something flat of what is not.
std::optional<Transform> inverse(const Transform& transform);
/// Around the image of a box, or of the ellipsoid of these axes.
Bounds moved(const Bounds& box, const Transform& transform);
/// The least that a map changes a length by, from its inverse: 1 over what that may stretch, which
/// is at most the root of the sum of its squares.
double least_stretch(const Transform& inverse);
/// Whether it maps balls to balls.
bool keeps_balls(const Transform& transform);

/// Whether bounds of a shape of this kind are; those of primitives always are.
template <class Shape>
bool has_bounds(const Bounds& box) {
  if constexpr (is_body<Shape>) return box.bounded();
  return true;
}

/// Bounds and distances of shapes in the world, or in the space of the group that they are in.
class Whereabouts {
 public:
  /// Looks at all groups. The scene must be one whose indices exist (check()), its groups without
  /// cycles.
  explicit Whereabouts(const Scene& scene);

  template <class Shape>
  Bounds bounds(const Object<Shape>& object) const {
    if constexpr (is_body<Shape>)
      return bounds(object.shape, transform(object.transform));
    else
      return ShapeTraits<Shape>::bounds(object.shape);
  }
  /// Of a whole group, in its own space.
  const Bounds& group(std::uint32_t index) const { return groups_[index]; }

  /// From a shape's surface to a point, or less.
  template <class Shape>
  double distance(const Object<Shape>& object, const Vec3& point) const {
    if constexpr (is_body<Shape>)
      return distance(object.shape, transform(object.transform), point);
    else
      return ShapeTraits<Shape>::distance_to(object.shape, point);
  }

  Transform transform(std::uint32_t index) const {
    return index == 0 ? Transform() : scene_.transforms[index - 1];
  }
  Bounds bounds_of_all(const ShapeLists& shapes) const;

 private:
  template <class Shape>
  Bounds bounds(const Shape& shape, const Transform& transform) const {
    if constexpr (requires { ShapeTraits<Shape>::bounds_under(shape, transform); })
      return ShapeTraits<Shape>::bounds_under(shape, transform);
    else
      return moved(ShapeTraits<Shape>::bounds(shape), transform);
  }
  Bounds bounds(const Csg& csg, const Transform& transform) const;
  Bounds bounds(const Instance& instance, const Transform& transform) const;
  template <class Shape>
  double distance(const Shape& shape, const Transform& transform, const Vec3& point) const {
    const std::optional<Transform> to_own = inverse(transform);
    if (!to_own) return 0;
    return ShapeTraits<Shape>::distance_to(shape, moved(point, *to_own)) * least_stretch(*to_own);
  }
  double distance(const Csg& csg, const Transform& transform, const Vec3& point) const;
  double distance(const Instance& instance, const Transform& transform, const Vec3& point) const;

  const Scene& scene_;
  std::vector<Bounds> groups_;
  std::vector<bool> known_;
  void look_at(std::uint32_t group);
};

}  // namespace zraka
