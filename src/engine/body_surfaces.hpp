// SPDX-License-Identifier: Apache-2.0
// The surfaces of bodies where rays hit them, in lanes: the hit is found once more, in double, and
// its normal comes from the body's own formula.
#pragma once

#include "accel/body_surface.hpp"
#include "accel/csg_meet.hpp"
#include "accel/group_rays.hpp"
#include "engine/hit_path.hpp"
#include "engine/surfaces.hpp"

namespace zraka::ZRAKA_ISA {

/// Points are rounded once and normals nearly exact: as much as shapes in float take is plenty. In
/// double, what a body's own space loses counts besides.
template <class R>
constexpr double kBodyOffset = sizeof(R) == 4 ? 0x1p-20 : 0x1p-47;
template <class R>
constexpr double kOwnOffset = sizeof(R) == 4 ? 0x1p-30 : 0x1p-47;

/// Lanes of surfaces in memory, for who changes them one by one.
template <class L>
struct SurfaceMemory {
  using R = typename L::Real;
  alignas(64) R point[3][L::kWidth], normal[3][L::kWidth], offset[L::kWidth], inside[L::kWidth],
      behind[L::kWidth];
  alignas(64) std::int32_t material[L::kWidth];

  explicit SurfaceMemory(const Surfaces<L>& s) {
    using F = typename L::F;
    L::store(s.at.point.x, point[0]), L::store(s.at.point.y, point[1]);
    L::store(s.at.point.z, point[2]), L::store(s.at.normal.x, normal[0]);
    L::store(s.at.normal.y, normal[1]), L::store(s.at.normal.z, normal[2]);
    L::store(s.at.offset, offset);
    L::store(select(s.at.inside, F(R(1)), F(R(0))), inside);
    L::store(select(s.at.behind, F(R(1)), F(R(0))), behind);
    L::store(s.material, material);
  }
  Surfaces<L> back() const {
    return {{{L::load(point[0]), L::load(point[1]), L::load(point[2])},
             {L::load(normal[0]), L::load(normal[1]), L::load(normal[2])},
             L::load(offset),
             L::load(inside) > typename L::F(R(0)),
             L::load(behind) > typename L::F(R(0))},
            L::load(material)};
  }
  void set(std::size_t lane, const V3<double>& at, const V3<double>& way) {
    point[0][lane] = static_cast<R>(at.x), point[1][lane] = static_cast<R>(at.y);
    point[2][lane] = static_cast<R>(at.z), normal[0][lane] = static_cast<R>(way.x);
    normal[1][lane] = static_cast<R>(way.y), normal[2][lane] = static_cast<R>(way.z);
  }
  double largest(std::size_t lane) const {
    const auto size = [&](int k) { return __builtin_fabs(static_cast<double>(point[k][lane])); };
    return max(size(0), max(size(1), size(2)));
  }
  /// Sets those of the lanes [c, c + kWidth) of doubles that are asked for; `unit` is what the
  /// body's own unit is along the ray.
  void put(std::size_t c, std::uint32_t asked, const V3<typename DoublesOf<L>::F>& at,
           const V3<typename DoublesOf<L>::F>& way, typename DoublesOf<L>::F unit,
           typename DoublesOf<L>::M from_inside) {
    using D = DoublesOf<L>;
    using F = typename D::F;
    const auto mine = D::from_bits(asked);
    const auto set = [&](const F& value, R* to) {
      D::store_reals(select(mine, value, D::load_reals(to + c)), to + c);
    };
    set(at.x, point[0]), set(at.y, point[1]), set(at.z, point[2]);
    set(way.x, normal[0]), set(way.y, normal[1]), set(way.z, normal[2]);
    const auto length = [&](const R* x) { return abs(D::load_reals(x + c)); };
    const F most = max(length(point[0]), max(length(point[1]), length(point[2])));
    set(most * F(kBodyOffset<R>) + unit * F(kOwnOffset<R>), offset);
    set(select(from_inside, F(1.0), F(0.0)), inside);
  }
};

/// The normal of a body's own space at points of its surface, of any length.
template <class Shape, class D, class Numbers>
ZRAKA_INLINE V3<typename D::F> own_normal(const Numbers& numbers, const V3<typename D::F>& p) {
  if constexpr (requires { BodyLanes<Shape, D>::normal(numbers, p); }) {
    return BodyLanes<Shape, D>::normal(numbers, p);
  } else {
    double at[3][D::kWidth], found[3][D::kWidth];
    D::store(p.x, at[0]), D::store(p.y, at[1]), D::store(p.z, at[2]);
    for (std::size_t i = 0; i < D::kWidth; ++i) {
      const V3<double> n =
          isa_oracle::own_normal(kTypeOf<Shape>, numbers.of(i), {at[0][i], at[1][i], at[2][i]});
      found[0][i] = n.x, found[1][i] = n.y, found[2][i] = n.z;
    }
    return {D::load(found[0]), D::load(found[1]), D::load(found[2])};
  }
}

/// The unit normal, outwards, where rays hit the body of these numbers at t.
template <class Shape, class D, class Row>
ZRAKA_INLINE V3<typename D::F> normal_at(const Row& row, const BodyView<typename D::F>& view,
                                         typename D::F t) {
  using F = typename D::F;
  const V3<F> own = view.ray.origin + view.ray.direction * (t / view.unit - view.before);
  const V3<F> n = own_normal<Shape, D>(NumbersAfter<Row>{row}, own);
  const auto column = [&](int k) { return V3<F>{row(k), row(k + 1), row(k + 2)}; };
  // A gradient goes back by the transposed matrix.
  const V3<F> normal = column(kBodyMatrix) * n.x + column(kBodyMatrix + 3) * n.y +
                       column(kBodyMatrix + 6) * n.z;
  return normal * (F(1.0) / sqrt(dot(normal, normal)));
}

/// Which way a ray goes through is known where the body is closed, also where it only grazes. A
/// quadric may be cut off by its box: then a ray comes in where there is no surface.
template <class Shape, class D>
ZRAKA_INLINE typename D::M hits_from_inside(
    const typename D::F (&at)[BodyLanes<Shape, D>::kMost], typename D::F t,
    const V3<typename D::F>& normal, const V3<typename D::F>& direction) {
  using F = typename D::F;
  if constexpr (ShapeTraits<Shape>::kClosed && !std::is_same_v<Shape, Quadric>) {
    auto inside = but_not(at[1] == t, at[0] == t);
    for (int k = 3; k < BodyLanes<Shape, D>::kMost; k += 2)
      inside = either(inside, but_not(at[k] == t, at[k - 1] == t));
    return inside;
  } else {
    return dot(normal, direction) > F(0.0);
  }
}

/// What is found out about lanes that hit bodies.
template <class D>
struct SurfaceInLanes {
  typename D::F t, unit;
  V3<typename D::F> normal;
  typename D::M inside;
};
template <class Shape, class D, class Row>
ZRAKA_INLINE SurfaceInLanes<D> surface_in_lanes(const Row& row, const V3<typename D::F>& origin,
                                                const V3<typename D::F>& direction) {
  using F = typename D::F;
  if constexpr (std::is_same_v<Shape, Plane>) {
    const V3<F> way = into_body(row, direction);
    const V3<F> up{row(kBodyMatrix + 3), row(kBodyMatrix + 4), row(kBodyMatrix + 5)};
    return {distance_to_plane(row, origin, direction), F(1.0) / sqrt(dot(way, way)),
            up * (F(1.0) / sqrt(dot(up, up))), way.y > F(0.0)};
  } else {
    F at[BodyLanes<Shape, D>::kMost];
    crossings<Shape, D>(row, origin, direction, Wanted::first, F(kNever), at);
    const BodyView<F> view = view_of(row, origin, direction, true);
    const F t = first_in_front(at);
    const V3<F> normal = normal_at<Shape, D>(row, view, t);
    return {t, view.unit, normal, hits_from_inside<Shape, D>(at, t, normal, direction)};
  }
}

/// The same of those lanes that are asked for and that hit at `hit`, roughly.
template <class Shape, class D, class Row>
ZRAKA_INLINE SurfaceInLanes<D> surface_at_hit(const Row& row, const V3<typename D::F>& origin,
                                              const V3<typename D::F>& direction,
                                              typename D::F hit, std::uint32_t asked) {
  if constexpr (std::is_same_v<Shape, Torus>) {
    using F = typename D::F;
    const BodyView<F> view = view_of(row, origin, direction, true);
    F s = hit / view.unit - view.before;
    const TorusRay<F> torus(view.ray, row(kBodyNumbers));
    const Refined zeros = refine<D>(torus, asked, s);
    const F t = view.distance(s);
    const auto outwards = D::from_bits(asked & ~zeros.falls);
    if (zeros.found == asked) return {t, view.unit, normal_at<Shape, D>(row, view, t), outwards};
    const SurfaceInLanes<D> all = surface_in_lanes<Shape, D>(row, origin, direction);
    const V3<F> normal = normal_at<Shape, D>(row, view, t);
    const auto ours = D::from_bits(zeros.found);
    return {select(ours, t, all.t), view.unit,
            {select(ours, normal.x, all.normal.x), select(ours, normal.y, all.normal.y),
             select(ours, normal.z, all.normal.z)},
            either(both(ours, outwards), but_not(all.inside, ours))};
  } else {
    return surface_in_lanes<Shape, D>(row, origin, direction);
  }
}

/// Where all lanes hit one plane, as they mostly do on what scenes stand on: what surfaces_of()
/// finds, without memory in between.
template <class L>
ZRAKA_INLINE void surfaces_of_plane(const double* numbers, const V3<typename L::F>& origin,
                                    const V3<typename L::F>& direction, SurfacePoint<L>& out) {
  using D = DoublesOf<L>;
  using F = typename D::F;
  constexpr std::size_t kParts = kDoubleParts<L>;
  F o[3][kParts], d[3][kParts], point[3][kParts], normal[3][kParts], unit[kParts], inside[kParts];
  widen(origin.x, o[0]), widen(origin.y, o[1]), widen(origin.z, o[2]);
  widen(direction.x, d[0]), widen(direction.y, d[1]), widen(direction.z, d[2]);
  for (std::size_t i = 0; i < kParts; ++i) {
    const V3<F> from{o[0][i], o[1][i], o[2][i]}, way{d[0][i], d[1][i], d[2][i]};
    const auto found = surface_in_lanes<Plane, D>(SharedNumbers<D>{numbers}, from, way);
    const V3<F> at = from + way * found.t;
    point[0][i] = at.x, point[1][i] = at.y, point[2][i] = at.z;
    normal[0][i] = found.normal.x, normal[1][i] = found.normal.y, normal[2][i] = found.normal.z;
    unit[i] = found.unit;
    inside[i] = select(found.inside, F(1.0), F(0.0));
  }
  out.point = {narrow(point[0]), narrow(point[1]), narrow(point[2])};
  out.normal = {narrow(normal[0]), narrow(normal[1]), narrow(normal[2])};
  out.inside = narrow(inside) > typename L::F(typename L::Real(0));
  F most[kParts];
  widen(max(abs(out.point.x), max(abs(out.point.y), abs(out.point.z))), most);
  for (std::size_t i = 0; i < kParts; ++i)
    most[i] =
        most[i] * F(kBodyOffset<typename L::Real>) + unit[i] * F(kOwnOffset<typename L::Real>);
  out.offset = narrow(most);
}

/// Of lanes that hit bodies of this type.
template <class Shape, class L>
void surfaces_of(const FrozenShapes<typename L::Real, Body>& bodies, std::uint32_t lanes,
                 const BodyQuery<L>& query, SurfaceMemory<L>& out) {
  using D = DoublesOf<L>;
  using F = typename D::F;
  each_part<L>(lanes, [&](std::size_t c, std::uint32_t asked) {
    const V3<F> origin = load_doubles<L>(query.origin, c);
    const V3<F> direction = load_doubles<L>(query.direction, c);
    with_numbers<L>(bodies, query, c, asked, [&](const auto& row) {
      const SurfaceInLanes<D> found = surface_at_hit<Shape, D>(
          row, origin, direction, D::load_reals(query.t + c), asked);
      out.put(c, asked, origin + direction * found.t, found.normal, found.unit, found.inside);
    });
  });
}

template <class L>
using SurfaceFunction = void (*)(const FrozenShapes<typename L::Real, Body>&, std::uint32_t,
                                 const BodyQuery<L>&, SurfaceMemory<L>&);
template <class Shape, class L>
constexpr SurfaceFunction<L> surface_function() {
  if constexpr (ShapeTraits<Shape>::kComposed)
    return nullptr;
  else
    return surfaces_of<Shape, L>;
}
/// Nothing for bodies that are made of others.
template <class L>
inline constexpr SurfaceFunction<L> kSurfaceFunctions[kBodyTypes] = {
#define ZRAKA_FUNCTION(Type, plural) surface_function<Type, L>(),
    ZRAKA_BODIES(ZRAKA_FUNCTION)
#undef ZRAKA_FUNCTION
};

/// The unit normal of one member of CSG where rays cross it at t, and what its own unit is along
/// them.
template <class Shape, class D>
V3<typename D::F> member_normal(const double* numbers, const V3<typename D::F>& origin,
                                const V3<typename D::F>& direction, typename D::F t,
                                typename D::F& unit) {
  const SharedNumbers<D> row{numbers};
  const auto view = view_of(row, origin, direction, false);
  unit = view.unit;
  return normal_at<Shape, D>(row, view, t);
}
template <class D>
using MemberNormal = V3<typename D::F> (*)(const double*, const V3<typename D::F>&,
                                           const V3<typename D::F>&, typename D::F,
                                           typename D::F&);
template <class Shape, class D>
constexpr MemberNormal<D> member_normal_function() {
  if constexpr (ShapeTraits<Shape>::kClosed && !ShapeTraits<Shape>::kComposed)
    return member_normal<Shape, D>;
  else
    return nullptr;
}
template <class D>
inline constexpr MemberNormal<D> kMemberNormals[kBodyTypes] = {
#define ZRAKA_FUNCTION(Type, plural) member_normal_function<Type, D>(),
    ZRAKA_BODIES(ZRAKA_FUNCTION)
#undef ZRAKA_FUNCTION
};

/// Where lanes of rays hit a CSG body, by their way through it: the surface is that of the first
/// member that is crossed there. Sets `member` to it.
template <class L, class Way>
ZRAKA_INLINE void surface_of_way(const FrozenBodies& bodies, const Way& way, std::size_t c,
                                 std::uint32_t asked, const BodyQuery<L>& query,
                                 SurfaceMemory<L>& out, std::int32_t (&member)[L::kWidth]) {
  using D = DoublesOf<L>;
  using F = typename D::F;
  if (way.misses()) return;
  const V3<F> origin = load_doubles<L>(query.origin, c);
  const V3<F> direction = load_doubles<L>(query.direction, c);
  const F t = way.first_hit();
  V3<F> normal{F(0.0), F(1.0), F(0.0)};
  F unit(1.0);
  std::uint32_t left = asked;
  for (int i = 0; i < way.members() && left != 0; ++i) {
    const std::uint32_t crossed = left & bits_of_doubles(way.crosses(i, t));
    if (crossed == 0) continue;
    left &= ~crossed;
    const std::int32_t found = way.member(i);
    F its_unit;
    const V3<F> its = kMemberNormals<D>[bodies.type[found]](bodies.numbers + bodies.start[found],
                                                            origin, direction, t, its_unit);
    const auto mine = D::from_bits(crossed);
    normal = {select(mine, its.x, normal.x), select(mine, its.y, normal.y),
              select(mine, its.z, normal.z)};
    unit = select(mine, its_unit, unit);
    for (std::uint32_t lane = crossed; lane != 0; lane &= lane - 1)
      member[c + static_cast<std::size_t>(__builtin_ctz(lane))] = found;
  }
  // Outside is where the whole is not, whichever way the member's own surface looks.
  const auto enters = way.enters(t), leaves = but_not(t == t, enters);
  const auto away = dot(normal, direction) > F(0.0);
  const auto turned = either(both(enters, away), but_not(leaves, away));
  out.put(c, asked, origin + direction * t,
          {select(turned, -normal.x, normal.x), select(turned, -normal.y, normal.y),
           select(turned, -normal.z, normal.z)},
          unit, leaves);
}

/// Of lanes that hit one CSG body.
template <class L>
void surfaces_of_csg(const FrozenBodies& bodies, std::int32_t body, std::uint32_t lanes,
                     const BodyQuery<L>& query, SurfaceMemory<L>& out,
                     std::int32_t (&member)[L::kWidth]) {
  using D = DoublesOf<L>;
  using F = typename D::F;
  const Meet meet(bodies, body);
  each_part<L>(lanes, [&](std::size_t c, std::uint32_t asked) {
    const V3<F> origin = load_doubles<L>(query.origin, c);
    const V3<F> direction = load_doubles<L>(query.direction, c);
    const auto mine = D::from_bits(asked);
    if (meet.possible)
      surface_of_way<L>(bodies,
                        CsgMeet<D>(bodies, body, meet, origin, direction, mine, F(kNever)), c,
                        asked, query, out, member);
    else
      surface_of_way<L>(bodies,
                        CsgWay<D>(bodies, body, origin, direction, mine, F(kNever), true), c,
                        asked, query, out, member);
  });
}

/// Puts an instance in front of a path within its group, whose frame is reached by these columns
/// and this origin.
inline void add_instance(std::int32_t body, const void* group, const V3<double>& x, const V3<double>& y,
                  const V3<double>& z, const V3<double>& origin, const HitPath& inner,
                  HitPath& out) {
  out.group = inner.group != nullptr ? inner.group : group;
  out.slot = inner.slot;
  out.body = inner.body;
  out.depth = inner.depth + 1;
  out.instance[0] = body;
  for (int i = 0; i < inner.depth; ++i) out.instance[i + 1] = inner.instance[i];
  for (int k = 0; k < 12; k += 3) {
    const double* const v = inner.to_frame + k;
    const V3<double> moved = x * v[0] + y * v[1] + z * v[2] + (k == 9 ? origin : V3<double>{0, 0, 0});
    out.to_frame[k] = moved.x, out.to_frame[k + 1] = moved.y, out.to_frame[k + 2] = moved.z;
  }
}

/// Of the lanes that hit one instance: the group is traced once more, as it was for the hits, to
/// know what they have hit there.
template <class L>
void surfaces_of_instance(const FrozenShapes<typename L::Real, Body>& bodies, std::int32_t body,
                          std::uint32_t lanes, const BodyQuery<L>& query, SurfaceMemory<L>& out,
                          HitPath* paths) {
  using R = typename L::Real;
  const GroupRays<L> group_rays(bodies, body, query, lanes, false);
  RayGroup<L> rays = group_rays.rays();
  find_nearest_called<L>(group_rays.group(), rays);
  const RayLanes<L>& ray = rays.ray[0];
  HitPath inner[L::kWidth];
  const SurfaceMemory<L> found(surfaces_at<L>(group_rays.group(), ray.slot, ray.origin,
                                              ray.direction, ray.t,
                                              paths == nullptr ? nullptr : inner));
  const double* const row = bodies.numbers + bodies.start[body];
  const V3<double> center{row[0], row[1], row[2]}, x{row[3], row[4], row[5]},
      y{row[6], row[7], row[8]}, z{row[9], row[10], row[11]};
  const V3<double> yz = cross(y, z), zx = cross(z, x), xy = cross(x, y);
  const double determinant = 1 / dot(x, yz);
  for (; lanes != 0; lanes &= lanes - 1) {
    const auto lane = static_cast<std::size_t>(__builtin_ctz(lanes));
    const auto at = [&](int k) { return static_cast<double>(found.point[k][lane]); };
    const auto n = [&](int k) { return static_cast<double>(found.normal[k][lane]); };
    const V3<double> point = center + (yz * at(0) + zx * at(1) + xy * at(2)) * determinant;
    const V3<double> normal = x * n(0) + y * n(1) + z * n(2);
    const double stretch = sqrt(dot(normal, normal));
    out.set(lane, point, normal * (1 / stretch));
    out.offset[lane] = static_cast<R>(out.largest(lane) * kBodyOffset<R> +
                                      static_cast<double>(found.offset[lane]) / stretch);
    out.inside[lane] = found.inside[lane];
    out.behind[lane] = found.behind[lane];
    out.material[lane] =
        found.material[lane] >= 0 ? found.material[lane] : bodies.material[body];
    if (paths != nullptr)
      add_instance(body, &group_rays.group(), yz * determinant, zx * determinant,
                   xy * determinant, center, inner[lane], paths[lane]);
  }
}

}  // namespace zraka::ZRAKA_ISA
