// SPDX-License-Identifier: Apache-2.0
// The triangle with a normal at each corner.
#pragma once

#include "shapes/triangle.hpp"

namespace zraka {

template <>
struct ShapeTraits<SmoothTriangle> {
  static constexpr const char* kName = "smooth triangle";
  static constexpr const char* kNouns[2][4] = {{"smooth triangle", "smooth triangle", "smooth triangle", "smooth triangle"},
                                            {"glatki trokut", "glatki trokut", "glatkog trokuta", "glatkom trokutu"}};
  static constexpr int kReals = 18, kHitReals = 9;  // corners, then their normals

  static Triangle flat(const SmoothTriangle& s) { return {s.a, s.b, s.c}; }
  static Bounds bounds(const SmoothTriangle& s) { return ShapeTraits<Triangle>::bounds(flat(s)); }

  static double distance_to(const SmoothTriangle& s, const Vec3& p) {
    return ShapeTraits<Triangle>::distance_to(flat(s), p);
  }

  static Bounds frozen_bounds(const double* s) { return ShapeTraits<Triangle>::frozen_bounds(s); }

  static const char* check(const SmoothTriangle& s) {
    if (!finite(s.normal_a) || !finite(s.normal_b) || !finite(s.normal_c))
      return "a normal is not finite";
    return ShapeTraits<Triangle>::check(flat(s));
  }

  static void freeze(const SmoothTriangle& s, const Frame& frame, double* out) {
    put(frame.point(s.a), out);
    put(frame.point(s.b), out + 3);
    put(frame.point(s.c), out + 6);
    put(unit(s.normal_a), out + 9);
    put(unit(s.normal_b), out + 12);
    put(unit(s.normal_c), out + 15);
  }

 private:
  static Vec3 unit(const Vec3& v) {
    const double length = std::sqrt(v.x * v.x + v.y * v.y + v.z * v.z);
    return length > 0 ? Vec3{v.x / length, v.y / length, v.z / length} : Vec3{};
  }
};

#ifdef ZRAKA_ISA
namespace ZRAKA_ISA {

template <class L>
struct ShapeLanes<SmoothTriangle, L> {
  using F = typename L::F;

  static ZRAKA_INLINE F intersect(const F (&s)[9], const V3<F>& origin, const V3<F>& direction) {
    return TriangleLanes<L>::intersect(s, origin, direction);
  }

  static ZRAKA_INLINE SurfacePoint<L> surface(const F (&s)[18], const V3<F>&,
                                              const V3<F>& direction, const V3<F>& point) {
    const typename TriangleLanes<L>::Seen seen(s, point);
    const V3<F> on_surface = TriangleLanes<L>::on_plane(seen, direction, point);
    // Barycentric weights: the areas opposite the corners, seen along the flat normal.
    const F wa = dot(seen.normal, cross(seen.b, seen.c)),
            wb = dot(seen.normal, cross(seen.c, seen.a)),
            wc = dot(seen.normal, cross(seen.a, seen.b));
    const V3<F> blended = V3<F>{s[9], s[10], s[11]} * wa + V3<F>{s[12], s[13], s[14]} * wb +
                          V3<F>{s[15], s[16], s[17]} * wc;
    const F length = sqrt(dot(blended, blended));
    const auto good = length > F(0.0f);
    const F flat_scale = F(1.0f) / sqrt(dot(seen.normal, seen.normal));
    const F scale = F(1.0f) / select(good, length, F(1.0f));
    const V3<F> normal{select(good, blended.x * scale, seen.normal.x * flat_scale),
                       select(good, blended.y * scale, seen.normal.y * flat_scale),
                       select(good, blended.z * scale, seen.normal.z * flat_scale)};
    // At an outline the blended normal may look past the viewer, who sees the face's outer side all
    // the same. Which side that is, the face says, so that light goes on evenly up to the outline.
    const F outward = dot(normal, seen.normal);  // negative: the corners run the other way round
    const F along = dot(seen.normal, direction);
    const F mirrored = along - (dot(normal, direction) + dot(normal, direction)) * outward;
    const auto behind = either(both(along > F(0.0f), mirrored > F(0.0f)),
                               both(along < F(0.0f), mirrored < F(0.0f)));
    return {on_surface, normal, TriangleLanes<L>::offset_at(seen, on_surface),
            select(outward < F(0.0f), -along, along) > F(0.0f), behind};
  }
};

}  // namespace ZRAKA_ISA
#endif

}  // namespace zraka
