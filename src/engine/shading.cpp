// SPDX-License-Identifier: Apache-2.0
// Light that arrives at many hits, and highlights there: general/lights.cpp in lanes of doubles, to
// the same bits. CMake compiles this file once for each instruction set, like engine/kernel.cpp.
#include "engine/shading.hpp"

#include <limits>

#include "engine/highlight.hpp"
#include "engine/indices.hpp"
#include "math/vec.hpp"

namespace zraka::ZRAKA_ISA {
namespace {

template <class F>
ZRAKA_INLINE V3<F> all_of(const V3<double>& v) {
  return {F(v.x), F(v.y), F(v.z)};
}
template <class D, class R>
ZRAKA_INLINE V3<typename D::F> load_three(const R* x, const R* y, const R* z, std::size_t i) {
  return {D::load_reals(x + i), D::load_reals(y + i), D::load_reals(z + i)};
}

/// x²(3 - 2x) between 0 and 1.
template <class F>
ZRAKA_INLINE F smooth(F x) {
  const F t = min(max(x, F(0)), F(1));
  return t * t * (F(3) - F(2) * t);
}

/// Numbers of the hits of kWidth shadow rays.
template <class L>
struct ForRays {
  using R = typename L::Real;
  alignas(64) R of[L::kWidth];
  ZRAKA_INLINE ForRays(const Indices<L>& hit, const R* array) { L::store(hit.load(array), of); }
};

}  // namespace

template <class L>
void find_arriving(const OpticalLight& light, std::size_t n, Scratch<typename L::Real>& scratch,
                   const ArrivingLight& arriving) {
  using D = DoublesOf<L>;
  using F = typename D::F;
  const bool is_far = light.kind == LightKind::directional;
  const bool has_cone = light.kind == LightKind::spot;
  const double span = light.cos_inner - light.cos_outer;
  const V3<F> from = all_of<F>(light.position), along = all_of<F>(light.direction);
  for (std::size_t h = 0; h < n; h += D::kWidth) {
    V3<F> to = -along;
    F distance(std::numeric_limits<double>::infinity()), strength(1), cosine(1);
    if (!is_far) {
      const V3<F> way = from - load_three<D>(scratch.px, scratch.py, scratch.pz, h);
      distance = sqrt(dot(way, way));
      const auto apart = distance > F(0);
      const F scale = F(1) / distance;
      to = {select(apart, way.x * scale, F(0)), select(apart, way.y * scale, F(0)),
            select(apart, way.z * scale, F(0))};
      distance = select(apart, distance, F(0));
      strength = F(1) / (F(light.constant) + F(light.linear) * distance +
                         F(light.quadratic) * distance * distance);
      if (has_cone) {
        cosine = -dot(to, along);
        if (!light.linear_edge_counts())
          strength = strength * (span > 0 ? smooth((cosine - F(light.cos_outer)) / F(span))
                                          : select(cosine >= F(light.cos_outer), F(1), F(0)));
      }
      strength = select(apart, strength, F(0));
    }
    D::store_reals(to.x, scratch.lx + h);
    D::store_reals(to.y, scratch.ly + h);
    D::store_reals(to.z, scratch.lz + h);
    D::store(distance, arriving.distance + h);
    D::store(strength, arriving.strength + h);
    D::store(cosine, arriving.cosine + h);
    D::store(dot(to, load_three<D>(scratch.nx, scratch.ny, scratch.nz, h)), arriving.l_n + h);
  }
}

template <class L>
void find_highlights(std::size_t n, const Scratch<typename L::Real>& scratch, double* highlights) {
  using R = typename L::Real;
  using I = typename L::I;
  using D = DoublesOf<L>;
  for (std::size_t first = 0; first < n; first += L::kWidth) {
    const Indices<L> hit(select(L::first(n - first), L::load(scratch.shadow_ray_hit + first),
                                I(scratch.shadow_ray_hit[first])));
    const ForRays<L> nx(hit, scratch.nx), ny(hit, scratch.ny), nz(hit, scratch.nz);
    const ForRays<L> vx(hit, scratch.vx), vy(hit, scratch.vy), vz(hit, scratch.vz);
    const I row = hit.load(scratch.row);
    static_assert(kMaterialReals == 16);
    const I two = row + row, four = two + two, eight = four + four, at = eight + eight;
    alignas(64) R shininess[L::kWidth], blinn[L::kWidth];
    L::store(L::gather(scratch.coefficients + kShininess, at), shininess);
    L::store(L::gather(scratch.coefficients + kBlinn, at), blinn);
    for (std::size_t i = 0; i < L::kWidth; i += D::kWidth) {
      const auto normal = load_three<D>(nx.of, ny.of, nz.of, i);
      const auto view = load_three<D>(vx.of, vy.of, vz.of, i);
      const auto light = load_three<D>(scratch.sdx + first, scratch.sdy + first,
                                        scratch.sdz + first, i);
      D::store(highlight_at<D>(normal, view, light, D::load_reals(shininess + i),
                               D::load_reals(blinn + i)),
               highlights + first + i);
    }
  }
}

#ifdef ZRAKA_WIDE
using Lanes = WideLanes;
#else
using Lanes = ScalarLanes<double>;
#endif
template void find_arriving<Lanes>(const OpticalLight&, std::size_t, Scratch<Lanes::Real>&,
                                   const ArrivingLight&);
template void find_highlights<Lanes>(std::size_t, const Scratch<Lanes::Real>&, double*);

}  // namespace zraka::ZRAKA_ISA
