// SPDX-License-Identifier: Apache-2.0
// The open cone, frustum and cylinder.
#pragma once

#include <algorithm>

#include "shapes/triangle.hpp"

namespace zraka {

/// A cone of one radius among others like it: without what changes along the axis.
struct Cylinder : Cone {};

template <>
struct ShapeTraits<Cone> {
  static constexpr const char* kName = "cone";
  static constexpr const char* kNouns[2][4] = {{"cone", "cone", "cone", "cone"},
                                            {"stožac", "stožac", "stošca", "stošcu"}};
  /// Middle of the axis; unit axis; radius at the middle and its growth along the axis; half the
  /// axis' length.
  static constexpr int kReals = 9, kHitReals = 9;

  /// Around both end discs; a disc of radius r and unit normal n reaches r·√(1 - n²) along each
  /// axis.
  static Bounds bounds(const Cone& s) {
    const Vec3 axis{s.apex.x - s.base.x, s.apex.y - s.base.y, s.apex.z - s.base.z};
    const double length2 = axis.x * axis.x + axis.y * axis.y + axis.z * axis.z;
    const auto reach = [&](double n) {
      return length2 > 0 ? std::sqrt(std::fmax(0.0, 1 - n * n / length2)) : 1.0;
    };
    const Vec3 r{reach(axis.x), reach(axis.y), reach(axis.z)};
    Bounds box;
    const auto include = [&](const Vec3& c, double radius) {
      box.include({{c.x - radius * r.x, c.y - radius * r.y, c.z - radius * r.z},
                   {c.x + radius * r.x, c.y + radius * r.y, c.z + radius * r.z}});
    };
    include(s.base, s.base_radius);
    include(s.apex, s.apex_radius);
    return box;
  }

  /// From its box, or from the line that turns round the axis to make its side, whichever is
  /// farther.
  static double distance_to(const Cone& s, const Vec3& p) {
    const V3<double> axis{s.apex.x - s.base.x, s.apex.y - s.base.y, s.apex.z - s.base.z};
    const V3<double> from_base{p.x - s.base.x, p.y - s.base.y, p.z - s.base.z};
    const double length2 = dot(axis, axis), along = dot(from_base, axis) / length2;
    const V3<double> across = from_base - axis * along;
    const double growth = s.apex_radius - s.base_radius;
    const double outside = std::sqrt(dot(across, across)) - (s.base_radius + growth * along);
    const double away = std::fabs(outside) / std::sqrt(1 + growth * growth / length2);
    return std::fmax(bounds(s).distance_to(p), away);
  }

  static Bounds frozen_bounds(const double* s) {
    const auto along = [&](double y) {
      return Vec3{s[0] + s[3] * y, s[1] + s[4] * y, s[2] + s[5] * y};
    };
    const auto radius = [&](double y) { return std::fmax(0.0, s[6] + s[7] * y); };
    return bounds({along(-s[8]), radius(-s[8]), along(s[8]), radius(s[8])});
  }

  static const char* check(const Cone& s) {
    if (!finite(s.base) || !finite(s.apex)) return "an end is not finite";
    if (!finite(s.base_radius) || !finite(s.apex_radius) || s.base_radius < 0 ||
        s.apex_radius < 0 || !(s.base_radius + s.apex_radius > 0))
      return "its radii are not finite numbers of 0 or more, one of them more";
    if (s.base == s.apex) return "its ends are one point";
    return nullptr;
  }

  static void freeze(const Cone& s, const Frame& frame, double* out) {
    const Vec3 axis{s.apex.x - s.base.x, s.apex.y - s.base.y, s.apex.z - s.base.z};
    const double length = std::sqrt(axis.x * axis.x + axis.y * axis.y + axis.z * axis.z);
    put(frame.point({s.base.x / 2 + s.apex.x / 2, s.base.y / 2 + s.apex.y / 2,
                     s.base.z / 2 + s.apex.z / 2}),
        out);
    put({axis.x / length, axis.y / length, axis.z / length}, out + 3);
    out[6] = frame.length((s.base_radius + s.apex_radius) / 2);
    out[7] = (s.apex_radius - s.base_radius) / length;
    out[8] = frame.length(length / 2);
  }
};

template <>
struct ShapeTraits<Cylinder> : ShapeTraits<Cone> {
  static constexpr const char* kName = "cylinder";
  /// Middle of the axis; unit axis; radius; half the axis' length.
  static constexpr int kReals = 8, kHitReals = 8;

  static Bounds frozen_bounds(const double* s) {
    const double cone[] = {s[0], s[1], s[2], s[3], s[4], s[5], s[6], 0, s[7]};
    return ShapeTraits<Cone>::frozen_bounds(cone);
  }

  static void freeze(const Cone& s, const Frame& frame, double* out) {
    double cone[ShapeTraits<Cone>::kReals];
    ShapeTraits<Cone>::freeze(s, frame, cone);
    std::copy_n(cone, 7, out);
    out[7] = cone[8];
  }
};

#ifdef ZRAKA_ISA
namespace ZRAKA_ISA {

/// A cone's radius along its axis, and half the axis' length.
template <class L>
struct SlopingSide {
  using F = typename L::F;
  static constexpr bool kSlopes = true;
  static ZRAKA_INLINE F radius(const F* s, const F& y) { return s[6] + s[7] * y; }
  static ZRAKA_INLINE F half_length(const F* s) { return s[8]; }
};

/// A cylinder's: what a cone computes with a slope of 0, bit by bit.
template <class L>
struct StraightSide {
  using F = typename L::F;
  static constexpr bool kSlopes = false;
  static ZRAKA_INLINE F radius(const F* s, const F&) { return s[6]; }
  static ZRAKA_INLINE F half_length(const F* s) { return s[7]; }
};

/// What cones and cylinders share.
template <class L, class Side>
struct ConeLanes {
  using F = typename L::F;

  /// With y along the axis from its middle and p across, |p|² = (r + k·y)²; a quadratic in the
  /// distance from the ray's point nearest to the middle, so that its numbers are of the cone's
  /// size, not of the origin's distance.
  static ZRAKA_INLINE F intersect(const F* s, const V3<F>& origin, const V3<F>& direction) {
    const V3<F> axis{s[3], s[4], s[5]};
    const V3<F> from_middle{origin.x - s[0], origin.y - s[1], origin.z - s[2]};
    const F shift = -dot(from_middle, direction);
    const V3<F> at = from_middle + direction * shift;
    const F y = dot(at, axis), dy = dot(direction, axis);
    const V3<F> p = at - axis * y, dp = direction - axis * dy;
    const F radius = Side::radius(s, y);
    F a = dot(dp, dp), b = dot(p, dp);
    if constexpr (Side::kSlopes) {
      const F dr = s[7] * dy;
      a = a - dr * dr;
      b = b - radius * dr;
    }
    const F c = dot(p, p) - radius * radius;
    const F discriminant = b * b - a * c;
    if (!any(discriminant >= F(0.0f))) return F(-1.0f);
    const F root = sqrt(max(discriminant, F(0.0f)));
    const F q = -(b + select(b >= F(0.0f), root, -root));
    // The roots are q/a and c/q; the sides' ends and the mirror cone beyond the tip are cut off.
    const F far(0x1p+60f);
    const F margin = hit_margin<L>(origin);
    const auto valid = [&](const F& x) {
      const F height = y + x * dy;
      const F at_height = Side::radius(s, height);
      // For flat cones and along the side the roots are noise; a hit must lie within the solid
      // cone.
      const V3<F> across = p + dp * x;
      const F reach = at_height + margin;
      auto on_side =
          both(abs(height) <= Side::half_length(s), dot(across, across) <= reach * reach);
      if constexpr (Side::kSlopes) on_side = both(on_side, at_height >= F(0.0f));
      const auto ahead = x + shift > F(0.0f);
      return select(both(both(on_side, ahead), discriminant >= F(0.0f)), x + shift, far);
    };
    const F nearest = min(valid(q / a), valid(c / q));
    return select(nearest < far, nearest, F(-1.0f));
  }

  static ZRAKA_INLINE SurfacePoint<L> surface(const F* s, const V3<F>&, const V3<F>& direction,
                                              const V3<F>& point) {
    const V3<F> axis{s[3], s[4], s[5]};
    const V3<F> from_middle{point.x - s[0], point.y - s[1], point.z - s[2]};
    const F y = dot(from_middle, axis);
    const V3<F> across = from_middle - axis * y;
    const F away = sqrt(dot(across, across));
    V3<F> normal = across * (F(1.0f) / away);
    F above = away - Side::radius(s, y);
    if constexpr (Side::kSlopes) {
      const F slope = F(1.0f) / sqrt(F(1.0f) + s[7] * s[7]);
      normal = (normal - axis * s[7]) * slope;
      above = above * slope;
    }
    const V3<F> on_surface = point - normal * above;
    const auto largest = [](const V3<F>& v) { return max(abs(v.x), max(abs(v.y), abs(v.z))); };
    const F magnitude = largest(on_surface) + (largest(from_middle) + s[6]);
    return {on_surface, normal, magnitude * F(sizeof(typename L::Real) == 4 ? 0x1p-20f : 0x1p-49f),
            dot(normal, direction) > F(0.0f)};
  }
};

template <class L>
struct ShapeLanes<Cone, L> : ConeLanes<L, SlopingSide<L>> {};
template <class L>
struct ShapeLanes<Cylinder, L> : ConeLanes<L, StraightSide<L>> {};

}  // namespace ZRAKA_ISA
#endif

}  // namespace zraka
