// SPDX-License-Identifier: Apache-2.0
// Children of hits: reflected and refracted rays (sheet 3.4 and 3.5).
#pragma once

#include "engine/engine.hpp"
#include "engine/light.hpp"

namespace zraka::ZRAKA_ISA {

/// Appends the wanted lanes to the level as rays, and returns each lane's index there, -1 where
/// none. Directions come in with a length within a few roundings of 1 and leave nearer to it (one
/// Newton step).
template <class L, class R = typename L::Real>
ZRAKA_INLINE void append_rays(Level<R>& level, const V3<typename L::F>& origin,
                              const V3<typename L::F>& direction, typename L::M wanted,
                              std::int32_t* indices) {
  using F = typename L::F;
  if (!any(wanted)) {
    L::store(typename L::I(-1), indices);
    return;
  }
  const auto at = static_cast<std::size_t>(level.ray_count);
  const V3<F> unit = direction * (F(1.5f) - F(0.5f) * dot(direction, direction));
  L::compress_store(origin.x, wanted, level.rays.ox + at);
  L::compress_store(origin.y, wanted, level.rays.oy + at);
  L::compress_store(origin.z, wanted, level.rays.oz + at);
  L::compress_store(unit.x, wanted, level.rays.dx + at);
  L::compress_store(unit.y, wanted, level.rays.dy + at);
  L::compress_store(unit.z, wanted, level.rays.dz + at);
  // The k-th wanted lane gets index at + k.
  if (all(wanted)) {
    L::store(L::iota(level.ray_count), indices);
  } else {
    const std::uint32_t lanes = bits(wanted);
    for (std::size_t i = 0; i < L::kWidth; ++i)
      indices[i] = (lanes >> i & 1) == 0
                       ? -1
                       : level.ray_count + __builtin_popcount(lanes & ((1u << i) - 1));
  }
  level.ray_count += static_cast<std::int32_t>(count(wanted));
}

/// U·N and the frame of a hit that its children start from.
template <class L, class R = typename L::Real>
struct HitLanes {
  using F = typename L::F;
  V3<F> point, normal, view;
  F offset, cosine;

  ZRAKA_INLINE HitLanes(const Scratch<R>& scratch, std::size_t h)
      : point{L::load(scratch.px + h), L::load(scratch.py + h), L::load(scratch.pz + h)},
        normal(load_normal<L>(scratch, h)),
        view{L::load(scratch.vx + h), L::load(scratch.vy + h), L::load(scratch.vz + h)},
        offset(L::load(scratch.offset + h)),
        cosine(dot(view, normal)) {}

  /// The same with the normal that the refracted ray is computed from: on the viewer's side, also
  /// where a blended or bent one looks past the viewer.
  template <class Ruling>
  ZRAKA_INLINE HitLanes for_refraction(const Scratch<R>& scratch, std::size_t h,
                                       const Ruling& rules) const {
    HitLanes hit = *this;
    hit.normal = rules.refraction_normal(normal, L::load(scratch.inside + h) > F(0));
    hit.cosine = dot(view, hit.normal);
    if constexpr (Ruling::kTurnsToViewer) {
      const auto past = hit.cosine < F(0);
      hit.normal = {select(past, -hit.normal.x, hit.normal.x),
                    select(past, -hit.normal.y, hit.normal.y),
                    select(past, -hit.normal.z, hit.normal.z)};
      hit.offset = select(past, -hit.offset, hit.offset);  // along what it was
      hit.cosine = abs(hit.cosine);
    }
    return hit;
  }
};

/// Ratio n1/n2 for a ray that comes from the hit's viewer, and D/4 of sheet 3.5.
template <class L, class R = typename L::Real>
struct Snell {
  using F = typename L::F;
  F b, d;
  template <class Ruling>
  ZRAKA_INLINE Snell(const MaterialLanes<L>& material, const Scratch<R>& scratch, std::size_t h,
                     F cosine, const Ruling& rules)
      : b(select(L::load(scratch.inside + h) > F(0), material[rules.ratio_on_exit()],
                 material[kRatioIn])),
        d(rules.discriminant(b * b * cosine * cosine - b * b + F(1))) {}
};

/// R = 2(U·N)N - U, and the shares of both children. With mirror_when_total the share of a
/// refracted ray that cannot be goes to the reflected one.
template <class L, class R = typename L::Real, class Recorder = NoRecord, class Ruling = Rules>
void spawn_reflected(const TraceSettings& settings, Level<R>& level,
                     const Scratch<R>& scratch, Level<R>& next, RayCounts& counts,
                     const Recorder& record = {}, const Ruling& rules = {}) {
  using F = typename L::F;
  const auto n = static_cast<std::size_t>(level.hit_count);
  const std::int32_t before = next.ray_count;
  for (std::size_t h = 0; h < n; h += L::kWidth) {
    const auto material = load_materials<L>(scratch, h, n);
    F reflection = settings.terms.reflection ? material[kReflection] : F(0);
    F refraction = settings.terms.refraction ? material[kRefraction] : F(0);
    const HitLanes<L> hit(scratch, h);
    record.keep(Quantity::cosine, h, hit.cosine);
    if (settings.terms.refraction && any(but_not(L::first(n - h), refraction == F(0)))) {
      const HitLanes<L> turned = hit.for_refraction(scratch, h, rules);
      const Snell<L> snell(material, scratch, h, rules.refraction_cosine(turned.cosine), rules);
      const auto passes = snell.d >= F(0);
      record.keep(Quantity::ratio, h, snell.b);
      record.keep(Quantity::quarter_d, h, snell.d);
      if (settings.mirror_when_total)
        reflection = select(passes, reflection, reflection + refraction);
      refraction = select(passes, refraction, F(0));
    }
    L::store(reflection, level.hits.reflection + h);
    L::store(refraction, level.hits.refraction + h);
    const F offset = hit.offset * L::load(scratch.mirror_side + h);
    append_rays<L>(next, hit.point + hit.normal * offset,
                   rules.reflected(hit.normal * (hit.cosine + hit.cosine) - hit.view),
                   but_not(L::first(n - h), reflection == F(0)), level.hits.reflected + h);
  }
  counts.reflected += static_cast<std::uint64_t>(next.ray_count - before);
}

/// The shares of children that are too deep to be traced.
template <class L, class R = typename L::Real>
void find_shares(const TraceSettings& settings, Level<R>& level, const Scratch<R>& scratch) {
  using F = typename L::F;
  const auto n = static_cast<std::size_t>(level.hit_count);
  for (std::size_t h = 0; h < n; h += L::kWidth) {
    const auto material = load_materials<L>(scratch, h, n);
    L::store(settings.terms.reflection ? material[kReflection] : F(0), level.hits.reflection + h);
    L::store(settings.terms.refraction ? material[kRefraction] : F(0), level.hits.refraction + h);
  }
}

/// R = -aN - bU with a = -b·cos α + √(D/4), where D is not negative.
template <class L, class R = typename L::Real, class Recorder = NoRecord, class Ruling = Rules>
void spawn_refracted(Level<R>& level, const Scratch<R>& scratch,
                     Level<R>& next, RayCounts& counts, const Recorder& record = {},
                     const Ruling& rules = {}) {
  using F = typename L::F;
  const auto n = static_cast<std::size_t>(level.hit_count);
  const std::int32_t before = next.ray_count;
  for (std::size_t h = 0; h < n; h += L::kWidth) {
    const F refraction = L::load(level.hits.refraction + h);
    const auto wanted = but_not(L::first(n - h), refraction == F(0));
    if (!any(wanted)) {
      L::store(typename L::I(-1), level.hits.refracted + h);
      continue;
    }
    const auto material = load_materials<L>(scratch, h, n);
    const HitLanes<L> hit = HitLanes<L>(scratch, h).for_refraction(scratch, h, rules);
    const F cosine = rules.refraction_cosine(hit.cosine);
    const Snell<L> snell(material, scratch, h, cosine, rules);
    const F a = sqrt(max(snell.d, F(0))) - snell.b * cosine;
    record.keep(Quantity::along_normal, h, a);
    append_rays<L>(next, hit.point - hit.normal * hit.offset,
                   -(hit.normal * a) - hit.view * snell.b, wanted, level.hits.refracted + h);
  }
  counts.refracted += static_cast<std::uint64_t>(next.ray_count - before);
}

}  // namespace zraka::ZRAKA_ISA
