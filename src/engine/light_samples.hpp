// SPDX-License-Identifier: Apache-2.0
// Samples of lights that are surfaces, as points see them: general/lights.cpp's arriving() in lanes of
// doubles, to the same bits.
#pragma once

#include <cmath>
#include <cstddef>
#include <cstdint>

#include "engine/engine.hpp"
#include "engine/sobol_lanes.hpp"
#include "math/double_lanes.hpp"

namespace zraka::ZRAKA_ISA {

inline constexpr std::size_t kSampleChunk = kArrayPadding;

/// Places in the unit square.
struct SquarePoints {
  alignas(64) double u[kSampleChunk], v[kSampleChunk];

  ZRAKA_INLINE SquarePoints(const SampleKeys& keys, std::size_t first) {
    alignas(64) std::uint32_t a[kSampleChunk], b[kSampleChunk];
    find_bits(PointsOfEach(keys, first), kSampleChunk, a, b);
    for (std::size_t i = 0; i < kSampleChunk; ++i) u[i] = unit(a[i]), v[i] = unit(b[i]);
  }

 private:
  /// unit_of(), by a number with a sign, which all processors know how to turn into a double.
  static ZRAKA_INLINE double unit(std::uint32_t bits) {
    const auto moved = static_cast<std::int32_t>(bits ^ 0x80000000u);
    return (static_cast<double>(moved) + (0x1p31 + 0.5)) * 0x1p-32;
  }
};

/// To the disc of radius 1, where quick_concentric_disc() puts them.
ZRAKA_INLINE void move_to_disc(SquarePoints& at) {
  constexpr double kQuarter = 0.78539816339744830962;  // π/4
  for (std::size_t i = 0; i < kSampleChunk; ++i) {
    const double a = 2 * at.u[i] - 1, b = 2 * at.v[i] - 1;  // never 0
    const bool wide = std::fabs(a) > std::fabs(b);
    const double r = wide ? a : b, t = kQuarter * ((wide ? b : a) / r), z = t * t;
    const double sine =
        t * (1 + z * (-1.0 / 6 + z * (1.0 / 120 + z * (-1.0 / 5040 + z * (1.0 / 362880)))));
    const double cosine =
        1 + z * (-1.0 / 2 + z * (1.0 / 24 + z * (-1.0 / 720 + z * (1.0 / 40320))));
    const double along = r * cosine, across = r * sine;
    at.u[i] = wide ? along : across, at.v[i] = wide ? across : along;
  }
}

/// Hits' points or normals, for a sample each.
template <class R>
struct HitVectors {
  alignas(64) R x[kSampleChunk], y[kSampleChunk], z[kSampleChunk];

  ZRAKA_INLINE HitVectors(const R* from_x, const R* from_y, const R* from_z,
                          const std::int32_t* hit, std::size_t count) {
    for (std::size_t i = 0; i < kSampleChunk; ++i) {
      const std::int32_t h = hit[i < count ? i : 0];
      x[i] = from_x[h], y[i] = from_y[h], z[i] = from_z[h];
    }
  }
  template <class D>
  ZRAKA_INLINE V3<typename D::F> load(std::size_t i) const {
    return {D::load_reals(x + i), D::load_reals(y + i), D::load_reals(z + i)};
  }
};

template <class F>
ZRAKA_INLINE V3<F> in_all(const V3<double>& v) {
  return {F(v.x), F(v.y), F(v.z)};
}
template <class F, class M>
ZRAKA_INLINE V3<F> select3(const M& first, const V3<F>& a, const V3<F>& b) {
  return {select(first, a.x, b.x), select(first, a.y, b.y), select(first, a.z, b.z)};
}

/// As basis_of().
template <class F>
ZRAKA_INLINE void basis_in_lanes(const V3<F>& n, V3<F>& a, V3<F>& b) {
  const F sign = select(n.z < F(0), F(-1), F(1));
  const F p = F(-1) / (sign + n.z), q = n.x * n.y * p;
  a = {F(1) + sign * n.x * n.x * p, sign * q, -sign * n.x};
  b = {q, sign + n.y * n.y * p, -n.y};
}

/// Of a sphere, a point on the disc that it looks like, where the cone around it touches it; from
/// inside its middle.
template <class F>
ZRAKA_INLINE V3<F> point_on_sphere(const OpticalLight& light, const V3<F>& seen_from, F on_x,
                                   F on_y) {
  const F radius(light.radius);
  const V3<F> middle = in_all<F>(light.position), way = middle - seen_from;
  const F away = sqrt(dot(way, way));
  const V3<F> axis = way * (F(1) / away);
  V3<F> a, b;
  basis_in_lanes(axis, a, b);
  const F sine = radius / away, cosine = sqrt(F(1) - sine * sine);
  return select3(away > radius,
                 middle - axis * (radius * sine) + (a * on_x + b * on_y) * (radius * cosine),
                 middle);
}

/// As Services::sample_light().
template <class L, class R = typename L::Real>
void sample_light(const OpticalLight& light, const SampleKeys& keys, const std::int32_t* hit,
                  std::size_t count, const Scratch<R>& scratch, const ArrivingSamples<R>& to) {
  using D = DoublesOf<L>;
  using F = typename D::F;
  const V3<F> position = in_all<F>(light.position);
  const V3<F> edge_u = in_all<F>(light.edge_u), edge_v = in_all<F>(light.edge_v);
  const bool fades = light.constant != 1 || light.linear != 0 || light.quadratic != 0;
  for (std::size_t done = 0; done < count; done += kSampleChunk) {
    const HitVectors<R> points(scratch.px, scratch.py, scratch.pz, hit + done, count - done);
    const HitVectors<R> normals(scratch.nx, scratch.ny, scratch.nz, hit + done, count - done);
    SquarePoints at(keys, done);
    if (light.kind != LightKind::rectangle) move_to_disc(at);
    for (std::size_t i = 0; i < kSampleChunk; i += D::kWidth) {
      const V3<F> point = points.template load<D>(i);
      const F u = D::load(at.u + i), v = D::load(at.v + i);
      const V3<F> from = light.kind == LightKind::sphere ? point_on_sphere(light, point, u, v)
                                                         : position + edge_u * u + edge_v * v;
      const V3<F> way = from - point;
      const F distance = sqrt(dot(way, way)), scale = F(1) / distance;
      const auto apart = distance > F(0);
      const V3<F> l = select3(apart, way * scale, in_all<F>({0, 0, 0}));
      F strength = select(apart, F(1), F(0));
      if (fades)
        strength = select(apart, F(1) / (F(light.constant) + F(light.linear) * distance +
                                         F(light.quadratic) * distance * distance), F(0));
      D::store_reals(l.x, to.dx + done + i);
      D::store_reals(l.y, to.dy + done + i);
      D::store_reals(l.z, to.dz + done + i);
      D::store_reals(min(distance, F(kFarthest)), to.distance + done + i);
      D::store_reals(strength, to.strength + done + i);
      D::store(dot(l, normals.template load<D>(i)), to.l_n + done + i);
    }
  }
}

}  // namespace zraka::ZRAKA_ISA
