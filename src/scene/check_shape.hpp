// SPDX-License-Identifier: Apache-2.0
// What is wrong with a shape.
#pragma once

#include <fmt/format.h>

#include <cmath>
#include <string>

#include "scene/bounds_of.hpp"
#include "shapes/bodies.hpp"
#include "shapes/shapes.hpp"

namespace zraka {

/// Squares and products of what is this far stay finite.
inline constexpr double kFarthest = 1e100;

inline bool within_reach(const Bounds& box) {
  for (const double side :
       {box.lower.x, box.lower.y, box.lower.z, box.upper.x, box.upper.y, box.upper.z})
    if (!(std::fabs(side) <= kFarthest)) return false;
  return true;
}

inline std::string too_far() {
  return fmt::format("it reaches farther than {} from the origin", kFarthest);
}

/// What is wrong with a primitive; "" where all is well.
template <class Shape>
std::string problem_of(const Shape& shape) {
  if (const char* const problem = ShapeTraits<Shape>::check(shape)) return problem;
  return within_reach(ShapeTraits<Shape>::bounds(shape)) ? "" : too_far();
}

/// What is wrong with a body that a transform moves; "" where all is well, or where it is made of
/// others.
template <class Body>
std::string problem_of(const Body& body, const Transform& transform) {
  if constexpr (ShapeTraits<Body>::kComposed) {
    return "";
  } else {
    if (const char* const problem = ShapeTraits<Body>::check(body)) return problem;
    Bounds box = ShapeTraits<Body>::bounds(body);
    if constexpr (std::is_same_v<Body, Plane>) box = {body.point, body.point};
    return within_reach(box) && within_reach(moved(box, transform)) ? "" : too_far();
  }
}

/// What besides is wrong with a body as a member of CSG.
template <class Body>
std::string problem_of_member(const Body& body) {
  if constexpr (requires { ShapeTraits<Body>::check_member(body); })
    if (const char* const problem = ShapeTraits<Body>::check_member(body)) return problem;
  return "";
}

}  // namespace zraka
