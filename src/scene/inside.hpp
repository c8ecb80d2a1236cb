// SPDX-License-Identifier: Apache-2.0
// Which closed bodies a point is inside of.
#pragma once

#include <zraka/scene.hpp>

#include "scene/bounds_of.hpp"

namespace zraka {

/// Asks shapes of a scene whose indices exist (check()). Planes have an inside in CSG alone.
class Insides {
 public:
  explicit Insides(const Scene& scene) : scene_(scene), where_(scene) {}

  template <class Shape>
  bool has(const Object<Shape>& object, const Vec3& point) const {
    if (where_.bounds(object).distance_to(point) > 0) return false;
    if constexpr (is_body<Shape>)
      return has(object.shape, object.transform, point);
    else
      return has(object.shape, point);
  }

 private:
  template <class Body>
  bool has(const Body& body, std::uint32_t transform, const Vec3& point) const {
    const std::optional<Transform> to_own = inverse(where_.transform(transform));
    return to_own && has(body, moved(point, *to_own));
  }
#define ZRAKA_DECLARE(Type, plural) bool has(const Type& shape, const Vec3& point) const;
  ZRAKA_SHAPES(ZRAKA_DECLARE)
#undef ZRAKA_DECLARE
  bool has(const CsgMember& member, const Vec3& point) const;

  const Scene& scene_;
  Whereabouts where_;
};

}  // namespace zraka
