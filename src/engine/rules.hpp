// SPDX-License-Identifier: Apache-2.0
// The optics of a hit, a function for each quantity, so that the renderer's steps can be compiled
// with another one in its place: lessons of the school show what each of them is for.
#pragma once

#include "accel/traverse.hpp"
#include "engine/engine.hpp"
#include "math/power.hpp"

namespace zraka::ZRAKA_ISA {

struct Rules {
  /// Sheet 3.3: the nearest hit of each active ray.
  template <class L, class Scene>
  ZRAKA_INLINE void find_nearest(const Scene& scene, RayGroup<L>& rays) const {
    ZRAKA_ISA::find_nearest<L>(scene, rays);
  }
  /// Sheet 3.7: the normal on the side that the ray comes from.
  template <class F, class M>
  ZRAKA_INLINE V3<F> seen_normal(const V3<F>& outward, M inside) const {
    return {select(inside, -outward.x, outward.x), select(inside, -outward.y, outward.y),
            select(inside, -outward.z, outward.z)};
  }
  /// Whether N of R = -aN - bU looks to the viewer wherever N elsewhere does not.
  static constexpr bool kTurnsToViewer = true;
  /// The normal of R = -aN - bU.
  template <class F, class M>
  ZRAKA_INLINE V3<F> refraction_normal(const V3<F>& seen, M /*inside*/) const {
    return seen;
  }
  /// How far from the surface the next rays begin (the sheet's Epsilon).
  template <class F>
  ZRAKA_INLINE F offset(F enough) const {
    return enough;
  }
  /// From hit to light.
  template <class F>
  ZRAKA_INLINE V3<F> light_direction(const V3<F>& unit, F /*distance*/) const {
    return unit;
  }
  template <class F>
  ZRAKA_INLINE auto faces(F l_n) const {
    return l_n >= F(0);
  }
  /// How far a shadow ray goes.
  template <class F>
  ZRAKA_INLINE F shadow_ray_length(F light_distance) const {
    return light_distance;
  }
  template <class F>
  ZRAKA_INLINE F diffuse_factor(F l_n) const {
    return l_n;
  }
  /// R, the mirror of L about N, and R·V.
  template <class F>
  ZRAKA_INLINE V3<F> mirrored(const V3<F>& l, const V3<F>& normal, F l_n) const {
    return normal * (l_n + l_n) - l;
  }
  template <class F, class Distance>
  ZRAKA_INLINE F r_v(const V3<F>& r, const V3<F>& v, const V3<F>& /*l*/, const V3<F>& /*normal*/,
                     const Distance& /*to_viewer*/) const {
    return dot(r, v);
  }
  template <class F>
  ZRAKA_INLINE auto shines(F r_v) const {
    return r_v >= F(0);
  }
  template <class F>
  ZRAKA_INLINE F highlight(F r_v, F shininess) const {
    return power(min(max(r_v, F(0)), F(1)), shininess);
  }
  /// The column of n1/n2 where a ray leaves the body.
  ZRAKA_INLINE int ratio_on_exit() const { return kRatioOut; }
  /// U·N, as Snell's law has it.
  template <class F>
  ZRAKA_INLINE F refraction_cosine(F cosine) const {
    return cosine;
  }
  /// D as it is taken for granted: negative is total internal reflection.
  template <class F>
  ZRAKA_INLINE F discriminant(F d) const {
    return d;
  }
  template <class F>
  ZRAKA_INLINE V3<F> reflected(const V3<F>& direction) const {
    return direction;
  }
};

}  // namespace zraka::ZRAKA_ISA
