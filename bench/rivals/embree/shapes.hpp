// SPDX-License-Identifier: Apache-2.0
// Shapes that Embree asks us about, for one ray or a packet: F is float or a vector of them.
#pragma once

#include <cmath>
#include <limits>

#include "version.hpp"
#include "wide.hpp"

namespace zraka::embree {

inline constexpr float kNever = std::numeric_limits<float>::infinity();

template <class Mask, class F>
inline F choose(Mask condition, F a, F b) {
  return condition ? a : b;
}
template <class F>
inline Three<F> spread(Vec v) {
  return {F{} + v.x, F{} + v.y, F{} + v.z};
}

struct Sphere4 {
  Vec center;
  float radius;

  RTCBounds bounds() const {
    const Vec low = center - Vec{radius, radius, radius},
              high = center + Vec{radius, radius, radius};
    return {low.x, low.y, low.z, 0, high.x, high.y, high.z, 0};
  }

  /// Where unit directions hit it between `near` and `far`; kNever if nowhere.
  template <class F>
  F meet(Three<F> origin, Three<F> direction, F near, F far) const {
    const Three<F> from_center = origin - spread<F>(center);
    const F middle = -dot(from_center, direction);
    const Three<F> nearest = from_center + direction * middle;
    const F square = radius * radius - dot(nearest, nearest);
    const F half = sqrt(choose(square > 0.0f, square, F{}));
    const F one = middle - half, other = middle + half;
    const auto valid = [&](F t) { return (square >= 0.0f) & (t > near) & (t < far); };
    return choose(valid(one), one, choose(valid(other), other, F{} + kNever));
  }

  Vec normal_at(Vec point) const { return point - center; }
};

/// The side of a cone or cylinder.
struct OpenCone {
  Vec base, axis;  ///< the axis has unit length
  float radius, growth, length;

  RTCBounds bounds() const {
    const Vec apex = base + axis * length;
    const float top = radius + growth * length;
    // A disc of radius r and unit normal n reaches r·√(1 - n²) along each axis.
    const auto low = [&](float b, float a, float n) {
      const float reach = std::sqrt(std::fmax(0.0f, 1 - n * n));
      return std::fmin(b - reach * radius, a - reach * top);
    };
    const auto high = [&](float b, float a, float n) { return -low(-b, -a, n); };
    return {low(base.x, apex.x, axis.x),  low(base.y, apex.y, axis.y),
            low(base.z, apex.z, axis.z),  0,
            high(base.x, apex.x, axis.x), high(base.y, apex.y, axis.y),
            high(base.z, apex.z, axis.z), 0};
  }

  /// As above. Counted from the point of the ray that is nearest to the base, so that far eyes cost
  /// no digits.
  template <class F>
  F meet(Three<F> origin, Three<F> direction, F near, F far) const {
    const Three<F> along = spread<F>(axis), from_base = origin - spread<F>(base);
    const F shift = -dot(from_base, direction);
    const Three<F> at = from_base + direction * shift;
    const F height = dot(at, along), climb = dot(direction, along);
    const Three<F> across = at - along * height, sideways = direction - along * climb;
    const F r = radius + growth * height, dr = growth * climb;
    const F a = dot(sideways, sideways) - dr * dr;
    const F b = dot(across, sideways) - r * dr;
    const F c = dot(across, across) - r * r;
    const F square = b * b - a * c;
    const F root = sqrt(choose(square > 0.0f, square, F{}));
    const F q = -(b + choose(b >= 0.0f, root, -root));
    const auto valid = [&](F x) {
      const F y = height + x * climb, t = x + shift;
      const auto good = (square >= 0.0f) & (y >= 0.0f) & (y <= length) &
                        (radius + growth * y >= 0.0f) & (t > near) & (t < far);
      return choose(good, t, F{} + kNever);
    };
    const F one = valid(q / a), other = valid(c / q);
    return choose(one < other, one, other);
  }

  Vec normal_at(Vec point) const {
    const Vec from_base = point - base;
    const Vec across = from_base - axis * dot(from_base, axis);
    return across * (1 / std::sqrt(dot(across, across))) - axis * growth;
  }
};

}  // namespace zraka::embree
