// SPDX-License-Identifier: Apache-2.0
// The general engine's steps at hits in lanes, to the bits that they have hit by hit: geometry in
// doubles, colours in the engine's numbers. CMake compiles this file once for each instruction set,
// like engine/kernel.cpp.
#include "engine/fresnel.hpp"
#include "engine/highlight.hpp"
#include "engine/hit_services.hpp"
#include "engine/indices.hpp"
#include "engine/light.hpp"

namespace zraka::ZRAKA_ISA {
namespace {

template <class L>
using Doubles = typename DoublesOf<L>::F[kDoubleParts<L>];

template <class D, class R>
ZRAKA_INLINE V3<typename D::F> three_at(const R* x, const R* y, const R* z, std::size_t i) {
  return {D::load_reals(x + i), D::load_reals(y + i), D::load_reals(z + i)};
}
template <class F>
ZRAKA_INLINE auto is_dark(const V3<F>& v) {
  return both(v.x == F(0), both(v.y == F(0), v.z == F(0)));
}

template <class L>
void start_shadow_rays(std::size_t n, Scratch<typename L::Real>& scratch) {
  using D = DoublesOf<L>;
  for (std::size_t h = 0; h < n; h += D::kWidth) {
    const auto offset = D::load_reals(scratch.offset + h);
    const auto from = three_at<D>(scratch.px, scratch.py, scratch.pz, h) +
                      three_at<D>(scratch.nx, scratch.ny, scratch.nz, h) * offset;
    D::store_reals(from.x, scratch.sox + h);
    D::store_reals(from.y, scratch.soy + h);
    D::store_reals(from.z, scratch.soz + h);
  }
}

template <class L>
void start_light(const FrozenScene<typename L::Real>& scene, const Terms& terms,
                 Level<typename L::Real>& level, const Scratch<typename L::Real>& scratch) {
  start_local<L>(scene, terms, level, scratch);
}

/// Which hits shine at all, of those that face the light.
template <class L>
struct MayShine {
  MaterialLanes<L> material;
  typename L::M lanes;

  ZRAKA_INLINE MayShine(const Scratch<typename L::Real>& scratch, std::size_t h, std::size_t n)
      : material(load_materials<L>(scratch, h, n)),
        lanes(but_not(L::first(n - h), either(L::load(scratch.strength + h) == typename L::F(0),
                                              is_dark(material.color(kSpecular))))) {}
};

/// What is left of the light and how far it goes, in the engine's numbers; 0 where hits face away.
template <class L>
void narrow_arriving(std::size_t n, Scratch<typename L::Real>& scratch,
                     const ArrivingLight& arriving) {
  using D = DoublesOf<L>;
  using F = typename D::F;
  for (std::size_t h = 0; h < n; h += D::kWidth) {
    const auto faces = D::load(arriving.l_n + h) >= F(0);
    D::store_reals(select(faces, D::load(arriving.strength + h), F(0)), scratch.strength + h);
    D::store_reals(min(D::load(arriving.distance + h), F(kFarthest)), scratch.sdistance + h);
  }
}

template <class L>
bool find_shines(const Terms& terms, std::size_t n, Scratch<typename L::Real>& scratch,
                 const ArrivingLight& arriving) {
  using D = DoublesOf<L>;
  using F = typename D::F;
  narrow_arriving<L>(n, scratch, arriving);
  if (!terms.specular) return false;
  bool unknown = false;
  for (std::size_t h = 0; h < n; h += L::kWidth) {
    const MayShine<L> may(scratch, h, n);
    if (!any(may.lanes)) continue;
    Doubles<L> shininess, blinn;
    widen(may.material[kShininess], shininess);
    widen(may.material[kBlinn], blinn);
    for (std::size_t p = 0; p < kDoubleParts<L>; ++p) {
      const std::size_t i = h + p * D::kWidth;
      const F highlight = highlight_at<D>(three_at<D>(scratch.nx, scratch.ny, scratch.nz, i),
                                          three_at<D>(scratch.vx, scratch.vy, scratch.vz, i),
                                          three_at<D>(scratch.lx, scratch.ly, scratch.lz, i),
                                          shininess[p], blinn[p]);
      D::store(highlight, arriving.highlight + i);
      unknown = unknown || any(highlight == F(kUnknownHighlight));
    }
  }
  return unknown;
}

template <class L>
ZRAKA_INLINE typename L::F narrowed_from(const double* from) {
  using D = DoublesOf<L>;
  Doubles<L> parts;
  for (std::size_t p = 0; p < kDoubleParts<L>; ++p) parts[p] = D::load(from + p * D::kWidth);
  return narrow(parts);
}
/// 1 where a number is above 0, however little.
template <class L>
ZRAKA_INLINE typename L::F above_zero(const double* from) {
  using D = DoublesOf<L>;
  using F = typename D::F;
  Doubles<L> parts;
  for (std::size_t p = 0; p < kDoubleParts<L>; ++p)
    parts[p] = select(D::load(from + p * D::kWidth) > F(0), F(1), F(0));
  return narrow(parts);
}

template <class L>
std::size_t list_facing(const V3<typename L::Real>& color, const Terms& terms, std::size_t n,
                        Scratch<typename L::Real>& scratch, const ArrivingLight& arriving) {
  using F = typename L::F;
  const V3<F> sent = broadcast<L>(color);
  std::size_t listed = 0;
  for (std::size_t h = 0; h < n; h += L::kWidth) {
    const F strength = L::load(scratch.strength + h);
    const auto arrives = but_not(L::first(n - h), is_dark(sent * strength));
    auto counts = but_not(arrives, arrives);
    if (any(arrives)) {
      const auto material = load_materials<L>(scratch, h, n);
      if (terms.diffuse)
        counts = but_not(above_zero<L>(arriving.l_n + h) > F(0), is_dark(material.color(kDiffuse)));
      if (terms.specular)
        if (const auto dull = is_dark(material.color(kSpecular)); !all(dull))
          counts = either(counts, but_not(above_zero<L>(arriving.highlight + h) > F(0), dull));
      counts = both(counts, arrives);
    }
    L::store(select(counts, F(1), F(0)), scratch.lit + h);
    L::compress_store(L::iota(static_cast<std::int32_t>(h)), counts,
                      scratch.shadow_ray_hit + listed);
    listed += count(counts);
  }
  return listed;
}

template <class L>
void add_arriving(const V3<typename L::Real>& color, const Terms& terms,
                  Level<typename L::Real>& level, const Scratch<typename L::Real>& scratch,
                  const ArrivingLight& arriving) {
  using F = typename L::F;
  const auto n = static_cast<std::size_t>(level.hit_count);
  const HitArrays<typename L::Real>& hits = level.hits;
  const V3<F> sent = broadcast<L>(color), none{F(0), F(0), F(0)};
  for (std::size_t h = 0; h < n; h += L::kWidth) {
    const auto lit = both(L::load(scratch.lit + h) > F(0), L::first(n - h));
    V3<F> sum{L::load(hits.r + h), L::load(hits.g + h), L::load(hits.b + h)};
    const auto add = [&](const V3<F>& more, typename L::M lanes) {
      const V3<F> all = none + more;  // of the light's samples
      sum = sum + V3<F>{select(lanes, all.x, F(0)), select(lanes, all.y, F(0)),
                        select(lanes, all.z, F(0))};
    };
    if (any(lit)) {
      const auto material = load_materials<L>(scratch, h, n);
      const V3<F> radiance = sent * L::load(scratch.strength + h);
      if (terms.diffuse)
        add(radiance * material.color(kDiffuse) * narrowed_from<L>(arriving.l_n + h), lit);
      const V3<F> ks = material.color(kSpecular);
      if (const auto shiny = but_not(lit, is_dark(ks)); terms.specular && any(shiny)) {
        const F highlight = narrowed_from<L>(arriving.highlight + h);
        add(radiance * ks * highlight, but_not(shiny, highlight == F(kFacesAway)));
      }
    }
    L::store(sum.x, hits.r + h);
    L::store(sum.y, hits.g + h);
    L::store(sum.z, hits.b + h);
  }
}

template <class L>
bool find_exponentials(std::size_t n, const double* x, double* powers) {
  using D = DoublesOf<L>;
  using F = typename D::F;
  bool unknown = false;
  for (std::size_t i = 0; i < n; i += D::kWidth) {
    const F from = D::load(x + i);
    const auto usual = both(from >= F(-700), from <= F(0));
    const F power = pair_exp(PairLanes<F>{select(usual, from, F(0)), F(0)});
    D::store(select(usual, power, F(-1)), powers + i);
    unknown = unknown || !all(usual);
  }
  return unknown;
}

/// Numbers of hits that lanes name, in the parts of a register of the engine's.
template <class L>
struct NumbersAtHits {
  Indices<L> hit;
  ZRAKA_INLINE explicit NumbersAtHits(const std::int32_t* hits) : hit(L::load(hits)) {}
  ZRAKA_INLINE void load(const typename L::Real* array, Doubles<L>& parts) const {
    widen(hit.load(array), parts);
  }
};
template <class L>
struct VectorsAtHits {
  Doubles<L> x, y, z;
  ZRAKA_INLINE VectorsAtHits(const NumbersAtHits<L>& hits, const typename L::Real* of_x,
                             const typename L::Real* of_y, const typename L::Real* of_z) {
    hits.load(of_x, x), hits.load(of_y, y), hits.load(of_z, z);
  }
  ZRAKA_INLINE auto operator[](std::size_t part) const {
    return V3<typename DoublesOf<L>::F>{x[part], y[part], z[part]};
  }
};

template <class L>
void find_bends(std::size_t n, const Scratch<typename L::Real>& scratch, const Bends& bends) {
  using D = DoublesOf<L>;
  using F = typename D::F;
  for (std::size_t i = 0; i < n; i += L::kWidth) {
    const NumbersAtHits<L> hits(bends.hit + i);
    const VectorsAtHits<L> normal(hits, scratch.nx, scratch.ny, scratch.nz),
        view(hits, scratch.vx, scratch.vy, scratch.vz);
    for (std::size_t p = 0; p < kDoubleParts<L>; ++p) {
      const std::size_t at = i + p * D::kWidth;
      const F cosine = abs(dot(view[p], normal[p]));
      const F ratio = D::load(bends.n1 + at) / D::load(bends.n2 + at);
      D::store(ratio, bends.ratio + at);
      D::store(ratio * ratio * cosine * cosine - ratio * ratio + F(1), bends.quarter_d + at);
      D::store(reflected_share<D>(D::load(bends.by + at), cosine, ratio), bends.fresnel + at);
    }
  }
}

template <class L>
void aim_children(std::size_t n, const Scratch<typename L::Real>& scratch, const GoingOn& children,
                  std::size_t first, RayArrays<typename L::Real>& rays) {
  using D = DoublesOf<L>;
  using F = typename D::F;
  // Rays leave the surface along the normal that no texture has bent.
  const bool is_kept = scratch.smooth_x != nullptr;
  for (std::size_t i = 0; i < n; i += L::kWidth) {
    const NumbersAtHits<L> hits(children.hit + i);
    const VectorsAtHits<L> point(hits, scratch.px, scratch.py, scratch.pz),
        normal(hits, scratch.nx, scratch.ny, scratch.nz),
        view(hits, scratch.vx, scratch.vy, scratch.vz);
    Doubles<L> offset, mirror_side;
    hits.load(scratch.offset, offset), hits.load(scratch.mirror_side, mirror_side);
    VectorsAtHits<L> along = normal;
    if (is_kept) along = {hits, scratch.smooth_x, scratch.smooth_y, scratch.smooth_z};
    for (std::size_t p = 0; p < kDoubleParts<L>; ++p) {
      const std::size_t at = i + p * D::kWidth;
      const F ratio = D::load(children.ratio + at), quarter_d = D::load(children.quarter_d + at);
      const auto enters = quarter_d >= F(0);
      const V3<F> n_p = normal[p], v_p = view[p];
      // A blended or bent normal may look past the viewer; that of refraction does not.
      const F seen = dot(v_p, n_p);
      V3<F> way = n_p * (F(2) * seen) - v_p;
      if (any(enters)) {
        const auto behind = seen < F(0);
        const V3<F> turned{select(behind, -n_p.x, n_p.x), select(behind, -n_p.y, n_p.y),
                           select(behind, -n_p.z, n_p.z)};
        const V3<F> bent = -(turned * (sqrt(quarter_d) - ratio * abs(seen))) - v_p * ratio;
        way = {select(enters, bent.x, way.x), select(enters, bent.y, way.y),
               select(enters, bent.z, way.z)};
      }
      way = way * (F(1) / sqrt(dot(way, way)));
      const F side = select(enters, F(-1), mirror_side[p]);
      const V3<F> origin = point[p] + along[p] * (side * offset[p]);
      const std::size_t to = first + at;
      D::store_reals(origin.x, rays.ox + to), D::store_reals(origin.y, rays.oy + to);
      D::store_reals(origin.z, rays.oz + to), D::store_reals(way.x, rays.dx + to);
      D::store_reals(way.y, rays.dy + to), D::store_reals(way.z, rays.dz + to);
    }
  }
}

template <class L>
void bring_back(const BroughtBack<typename L::Real>& brings, bool clamps,
                Level<typename L::Real>& level) {
  using R = typename L::Real;
  using F = typename L::F;
  using I = typename L::I;
  const auto n = static_cast<std::size_t>(level.hit_count);
  for (std::size_t h = 0; h < n; h += L::kWidth) {
    V3<F> color{L::load(brings.r + h), L::load(brings.g + h), L::load(brings.b + h)};
    if (clamps) {
      const auto clamp = [](const F& c) { return min(max(c, F(0)), F(1)); };
      color = {clamp(color.x), clamp(color.y), clamp(color.z)};
    }
    if (const R* const* const t = brings.transmittance; t[0] != nullptr)
      color = color * V3<F>{L::load(t[0] + h), L::load(t[1] + h), L::load(t[2] + h)};
    if (brings.clear != nullptr) {
      const F clear = L::load(brings.clear + h);
      const V3<F> dim = color * clear + broadcast<L>(brings.fog) * (F(1) - clear);
      const auto none = clear == F(1);
      color = {select(none, color.x, dim.x), select(none, color.y, dim.y),
               select(none, color.z, dim.z)};
    }
    const auto exists = L::first(n - h);
    const Indices<L> ray(select(exists, L::load(level.hits.ray + h), I(level.hits.ray[h])) +
                         I(level.done));
    ray.store(color.x, exists, level.rays.r);
    ray.store(color.y, exists, level.rays.g);
    ray.store(color.z, exists, level.rays.b);
  }
}

#ifdef ZRAKA_WIDE
using Lanes = WideLanes;
#else
using Lanes = ScalarLanes<double>;
#endif

}  // namespace

extern const HitServices<Lanes::Real> kHitServices;
const HitServices<Lanes::Real> kHitServices = {
    start_shadow_rays<Lanes>, start_light<Lanes>,  find_shines<Lanes>,
    list_facing<Lanes>,       add_arriving<Lanes>, find_exponentials<Lanes>,
    find_bends<Lanes>,        aim_children<Lanes>, bring_back<Lanes>};

}  // namespace zraka::ZRAKA_ISA
