// SPDX-License-Identifier: Apache-2.0
// The rules with one mistake in them (zraka/school/mistakes.def). Mistakes of numbers that the
// engine only reads - shares, ratios, the camera, depth - are made before (mistakes.cpp).
#pragma once

#include <zraka/school/mistakes.hpp>

#include "accel/flat_list.hpp"
#include "engine/rules.hpp"

namespace zraka::ZRAKA_ISA {

struct MistakenRules : Rules {
  Mistake made = Mistake::none, also = Mistake::none;
  float unit = 1;  ///< length of the engine's unit in the scene's
  ZRAKA_INLINE bool is(Mistake mistake) const { return mistake == made || mistake == also; }

  template <class L, class Scene>
  void find_nearest(const Scene& scene, RayGroup<L>& rays) const {
    if (!is(Mistake::first_hit)) return Rules::find_nearest<L>(scene, rays);
    // The first in the order of the file.
    for (RayLanes<L>& ray : rays.ray) {
      alignas(64) std::int32_t first[L::kWidth];
      for (std::size_t i = 0; i < L::kWidth; ++i) first[i] = -1;
      RayLanes<L> hit_ray = ray;
#define ZRAKA_FIRST(Type, plural) first_of<L>(scene, scene.plural, ray, hit_ray, first);
      ZRAKA_KINDS(ZRAKA_FIRST)
#undef ZRAKA_FIRST
      ray = hit_ray;
    }
  }

  template <class F, class M>
  ZRAKA_INLINE V3<F> seen_normal(const V3<F>& outward, M inside) const {
    if (is(Mistake::normal_outward) || is(Mistake::normal_for_refraction)) return outward;
    if (is(Mistake::view_reversed)) {
      const V3<F> seen = Rules::seen_normal(outward, inside);
      return {-seen.x, -seen.y, -seen.z};
    }
    return Rules::seen_normal(outward, inside);
  }
  ZRAKA_INLINE bool turns_for_refraction() const {
    return is(Mistake::normal_for_refraction);
  }
  static constexpr bool kTurnsToViewer = false;  // some mistakes are that it does not
  template <class F, class M>
  ZRAKA_INLINE V3<F> refraction_normal(const V3<F>& seen, M inside) const {
    return is(Mistake::normal_for_refraction) ? Rules::seen_normal(seen, inside) : seen;
  }
  template <class F>
  ZRAKA_INLINE F offset(F enough) const {
    if (is(Mistake::offset_zero)) return F(0);
    return is(Mistake::offset_large) ? F(0.02f / unit) : enough;
  }
  template <class F>
  ZRAKA_INLINE V3<F> light_direction(const V3<F>& l, F distance) const {
    if (is(Mistake::light_reversed)) return -l;
    return is(Mistake::light_not_unit) ? l * (distance * F(unit)) : l;
  }
  template <class F>
  ZRAKA_INLINE auto faces(F l_n) const {
    const bool always = is(Mistake::facing_unchecked) || is(Mistake::facing_magnitude);
    return always ? l_n == l_n : Rules::faces(l_n);
  }
  template <class F>
  ZRAKA_INLINE F shadow_ray_length(F light_distance) const {
    return is(Mistake::feeler_unbounded) ? F(0x1p+60f) : light_distance;
  }
  template <class F>
  ZRAKA_INLINE F diffuse_factor(F l_n) const {
    if (is(Mistake::facing_magnitude)) return abs(l_n);
    return is(Mistake::diffuse_sine) ? sqrt(max(F(1) - l_n * l_n, F(0))) : l_n;
  }
  template <class F>
  ZRAKA_INLINE V3<F> mirrored(const V3<F>& l, const V3<F>& normal, F l_n) const {
    const V3<F> r = Rules::mirrored(l, normal, l_n);
    if (is(Mistake::mirror_sum)) return normal * (l_n + l_n) + l;
    return is(Mistake::mirror_reversed) ? -r : r;
  }
  template <class F, class Distance>
  ZRAKA_INLINE F r_v(const V3<F>& r, const V3<F>& v, const V3<F>& l, const V3<F>& normal,
                     const Distance& to_viewer) const {
    if (is(Mistake::view_reversed)) return -dot(r, v);
    if (is(Mistake::view_not_unit)) return dot(r, v) * (to_viewer() * F(unit));
    if (!is(Mistake::half_vector)) return dot(r, v);
    const V3<F> between = l + v;
    return dot(between, normal) * (F(1) / sqrt(max(dot(between, between), F(0x1p-60f))));
  }
  template <class F>
  ZRAKA_INLINE auto shines(F r_v) const {
    return is(Mistake::highlight_unchecked) ? r_v == r_v : Rules::shines(r_v);
  }
  template <class F>
  ZRAKA_INLINE F highlight(F r_v, F shininess) const {
    if (is(Mistake::no_power)) return r_v;
    if (is(Mistake::highlight_unchecked)) {
      // What pow(R·V, n) gives: no number where n is not whole, which no colour shows.
      const F size = power(min(abs(r_v), F(1)), shininess);
      const F half = shininess * F(0.5f);
      const auto even = round_to_integer(half) == half;
      const auto whole = round_to_integer(shininess) == shininess;
      const F sign = select(r_v < F(0), select(even, F(1), select(whole, F(-1), F(0))), F(1));
      return size * sign;
    }
    if (is(Mistake::light_not_unit) || is(Mistake::view_not_unit) || is(Mistake::mirror_sum)) {
      // A base above 1 grows with its power: no more than what any clamp makes white.
      const F base = max(r_v, F(0));
      const F inverse = power(min(F(1) / max(base, F(1)), F(1)), shininess);
      return select(base > F(1), F(1) / max(inverse, F(0x1p-10f)),
                    power(min(base, F(1)), shininess));
    }
    return Rules::highlight(r_v, shininess);
  }
  ZRAKA_INLINE int ratio_on_exit() const {
    return is(Mistake::ratio_on_exit) ? kRatioIn : kRatioOut;
  }
  template <class F>
  ZRAKA_INLINE F refraction_cosine(F cosine) const {
    return is(Mistake::refraction_sine) ? sqrt(max(F(1) - cosine * cosine, F(0))) : cosine;
  }
  template <class F>
  ZRAKA_INLINE F discriminant(F d) const {
    return is(Mistake::total_clamped) ? max(d, F(0)) : d;
  }
  template <class F>
  ZRAKA_INLINE V3<F> reflected(const V3<F>& direction) const {
    return is(Mistake::reflected_reversed) ? -direction : direction;
  }

 private:
  template <class L, class Scene, class Shapes>
  static void first_of(const Scene& scene, const Shapes& shapes, const RayLanes<L>& ray,
                       RayLanes<L>& hit_ray, std::int32_t* first) {
    using F = typename L::F;
    for (std::int32_t i = 0; i < shapes.count; ++i) {
      RayLanes<L> one = ray;
      intersect_one<L>(scene, shapes, i, one);
      const std::int32_t id = shapes.id[i];
      alignas(64) typename L::Real wins[L::kWidth];
      alignas(64) std::int32_t slot[L::kWidth];
      L::store(one.slot, slot);
      for (std::size_t lane = 0; lane < L::kWidth; ++lane) {
        const bool win = slot[lane] >= 0 && (first[lane] < 0 || id < first[lane]);
        if (win) first[lane] = id;
        wins[lane] = win ? 1 : 0;
      }
      const auto won = L::load(wins) > F(0);
      hit_ray.t = select(won, one.t, hit_ray.t);
      hit_ray.slot = select(won, one.slot, hit_ray.slot);
    }
  }
};

}  // namespace zraka::ZRAKA_ISA
