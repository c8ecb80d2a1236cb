// SPDX-License-Identifier: Apache-2.0
// The sheet's rules where solutions of the lab go wrong, a function for each. The renderer's steps
// ask Rules, whose functions are a plain line each; mistaken_rules.hpp breaks one at a time, so
// that a picture with a mistake is traced by the very steps that trace the right one.
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
  /// The normal of R = -aN - bU, if that is another one.
  ZRAKA_INLINE bool turns_for_refraction() const { return false; }
  template <class F, class M>
  ZRAKA_INLINE V3<F> refraction_normal(const V3<F>& seen, M) const {
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
  /// What shadow rays leave behind besides their answer: nothing.
  template <class L, class R>
  ZRAKA_INLINE void after_shadow_rays(const FrozenScene<R>&, std::size_t, Scratch<R>&) const {}
  /// Hits that face the light and whose shadow ray is blocked: is there anything to do for them,
  /// what is left of the local light, and which hits get the specular term?
  ZRAKA_INLINE bool looks_into_shadows() const { return false; }
  template <class F, class M>
  ZRAKA_INLINE V3<F> local_in_shadow(const V3<F>& local, M /*blocked*/) const {
    return local;
  }
  template <class M>
  ZRAKA_INLINE M lit_for_specular(M lit, M /*blocked*/) const {
    return lit;
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
  /// What hits [h, h + kWidth) whose refracted ray cannot be get in its place: nothing.
  template <class L, class F, class M, class R>
  ZRAKA_INLINE void instead_of_refracted(const Level<R>&, std::size_t, M /*total*/,
                                         F /*refraction*/) const {}
  template <class F>
  ZRAKA_INLINE V3<F> reflected(const V3<F>& direction) const {
    return direction;
  }
};

}  // namespace zraka::ZRAKA_ISA
