// SPDX-License-Identifier: Apache-2.0
// Rays against one type of body: into its own space, its crossings, and back.
#pragma once

#include "accel/plane_rays.hpp"
#include "accel/ray_lanes.hpp"
#include "math/double_lanes.hpp"
#include "shapes/bodies.hpp"

namespace zraka::ZRAKA_ISA {

/// Rays and bodies of a register as they are asked for: in memory, for double lanes are fewer.
template <class L>
struct BodyQuery {
  using R = typename L::Real;
  static constexpr std::size_t kRoom = L::kWidth + 16;
  alignas(64) R origin[3][kRoom], direction[3][kRoom], limit[kRoom];
  alignas(64) std::int32_t body[kRoom];
  bool one_body = false;   ///< all lanes' are the same
  alignas(64) R t[kRoom];  ///< the answer: the nearest hit, not positive where there is none
};

template <class L>
ZRAKA_INLINE V3<typename DoublesOf<L>::F> load_doubles(
    const typename L::Real (&from)[3][BodyQuery<L>::kRoom], std::size_t i) {
  using D = DoublesOf<L>;
  return {D::load_reals(from[0] + i), D::load_reals(from[1] + i), D::load_reals(from[2] + i)};
}

/// A body's numbers: the same in all lanes.
template <class D>
struct SharedNumbers {
  const double* row;
  ZRAKA_INLINE typename D::F operator()(int k) const { return typename D::F(row[k]); }
  const double* of(std::size_t /*lane*/) const { return row; }
};
/// Or each lane's.
template <class D>
struct OwnNumbers {
  const double* numbers;
  const std::int32_t* start;
  ZRAKA_INLINE typename D::F operator()(int k) const { return D::gather(numbers + k, start); }
  const double* of(std::size_t lane) const { return numbers + start[lane]; }
};

/// A ray in a body's own space, and the way back to its distances: t = (s + before)·unit.
template <class F>
struct BodyView {
  BodyRay<F> ray;
  F before, unit;
  ZRAKA_INLINE F distance(F s) const { return (s + before) * unit; }
};

/// A direction in the space of the body whose numbers are `row`.
template <class F, class Row>
ZRAKA_INLINE V3<F> into_body(const Row& row, const V3<F>& v) {
  const auto turn = [&](int k) {
    return row(kBodyMatrix + k) * v.x + row(kBodyMatrix + k + 1) * v.y +
           row(kBodyMatrix + k + 2) * v.z;
  };
  return {turn(0), turn(3), turn(6)};
}

/// A ray in the space of the body whose numbers are `row`; first_only as BodyRay has it.
template <class F, class Row>
ZRAKA_INLINE BodyView<F> view_of(const Row& row, const V3<F>& origin, const V3<F>& direction,
                                 bool first_only) {
  const V3<F> o{origin.x - row(kBodyCenter), origin.y - row(kBodyCenter + 1),
                origin.z - row(kBodyCenter + 2)};
  const V3<F> own = into_body(row, o), way = into_body(row, direction);
  const F unit = F(1.0) / sqrt(dot(way, way));
  const V3<F> d = way * unit;
  const F before = -dot(own, d);
  return {{own + d * before, d, -before, first_only}, before, unit};
}

/// The numbers after a body's first.
template <class Row>
struct NumbersAfter {
  const Row& row;
  ZRAKA_INLINE auto operator()(int k) const { return row(kBodyNumbers + k); }
  const double* of(std::size_t lane) const { return row.of(lane) + kBodyNumbers; }
};

/// Which crossings are asked for: all (of which those before `from` and beyond the limit may be
/// anywhere there), or the first in front of the origin, or any that is nearer than the limit, too.
enum class Wanted { all, first, any };

/// Crossings of sharp boxes. Between pairs of planes nothing is lost wherever a ray begins: so they
/// do without the place that is nearest the middle, and without roots.
template <class D, class Row>
ZRAKA_INLINE void cross_cube(const Row& row, const V3<typename D::F>& origin,
                             const V3<typename D::F>& direction, typename D::F* at) {
  using F = typename D::F;
  const V3<F> o{origin.x - row(kBodyCenter), origin.y - row(kBodyCenter + 1),
                origin.z - row(kBodyCenter + 2)};
  const V3<F> own = into_body(row, o), way = into_body(row, direction);
  Span<F> span;
  clip(span, own.x, way.x, F(1.0));
  clip(span, own.y, way.y, F(1.0));
  clip(span, own.z, way.z, F(1.0));
  const auto hit = span.in <= span.out;
  at[0] = select(hit, span.in, F(kNever));
  at[1] = select(hit, span.out, F(kNever));
}

/// Crossings of a body of this type, whose numbers are `row`, as distances along the rays; what is
/// not wanted may be missing, as BodyRay has it. A function of its own, for it is long: hits,
/// surfaces and CSG share it. It hands on no view of the rays: what is to be returned is kept in
/// memory all along.
template <class Shape, class D, class Row>
__attribute__((noinline)) void crossings(const Row& row, const V3<typename D::F>& origin,
                                         const V3<typename D::F>& direction, Wanted wanted,
                                         typename D::F limit, typename D::F* at,
                                         typename D::F from = typename D::F(-kNever)) {
  using F = typename D::F;
  constexpr int kMost = BodyLanes<Shape, D>::kMost;
  if constexpr (std::is_same_v<Shape, Box>) {
    const auto sharp = row(kBodyNumbers) == F(0.0);
    if (all(sharp)) return cross_cube<D>(row, origin, direction, at);
  }
  BodyView<F> view = view_of(row, origin, direction, wanted != Wanted::all);
  if constexpr (requires { BodyLanes<Shape, D>::kAsksForEnd; }) {
    const F length = limit / view.unit;
    view.ray.end = length - view.before;
    view.ray.about = length * F(0x1p-20);
    view.ray.any = wanted == Wanted::any;
    const F before = from / view.unit;
    view.ray.from = before - abs(before) * F(0x1p-20) - view.before;
  }
  F found[kMost];
  BodyLanes<Shape, D>::cross(NumbersAfter<Row>{row}, view.ray, found);
  for (int k = 0; k < kMost; ++k) at[k] = view.distance(found[k]);
  if constexpr (std::is_same_v<Shape, Box>) {
    const auto sharp = row(kBodyNumbers) == F(0.0);
    if (!any(sharp)) return;
    F of_cube[kMost];
    cross_cube<D>(row, origin, direction, of_cube);
    for (int k = 0; k < kMost; ++k) at[k] = select(sharp, of_cube[k], at[k]);
  }
}

/// The first of crossings that lies in front; kNever where none does.
template <class F, int kMost>
ZRAKA_INLINE F first_in_front(const F (&at)[kMost]) {
  F nearest(kNever);
  for (const F& t : at) nearest = select(t > F(0.0), min(t, nearest), nearest);
  return nearest;
}

/// Stores distances for those lanes [c, c + kWidth) of a query that are asked for.
template <class L>
ZRAKA_INLINE void answer(BodyQuery<L>& query, std::size_t c, std::uint32_t asked,
                         typename DoublesOf<L>::F nearest) {
  using D = DoublesOf<L>;
  using F = typename D::F;
  const F t = select(nearest < F(kFarAway<double>), nearest, F(-1.0));
  constexpr auto kAll = static_cast<std::uint32_t>((std::uint64_t{1} << D::kWidth) - 1);
  D::store_reals(
      asked == kAll ? t : select(D::from_bits(asked), t, D::load_reals(query.t + c)), query.t + c);
}

/// Calls function(c, asked) for each part of the query's lanes that double lanes hold.
template <class L, class Function>
ZRAKA_INLINE void each_part(std::uint32_t lanes, const Function& function) {
  constexpr std::size_t kWidth = DoublesOf<L>::kWidth;
  constexpr auto kAll = static_cast<std::uint32_t>((std::uint64_t{1} << kWidth) - 1);
  for (std::size_t c = 0; c < L::kWidth; c += kWidth)
    if (const std::uint32_t asked = lanes >> c & kAll; asked != 0) function(c, asked);
}

/// Calls function(row) with the numbers of the bodies that lanes [c, c + kWidth) of a query are
/// asked for: what is the same for all of them is not gathered.
template <class L, class Function>
ZRAKA_INLINE void with_numbers(const FrozenShapes<typename L::Real, Body>& bodies,
                               const BodyQuery<L>& query, std::size_t c, std::uint32_t asked,
                               const Function& function) {
  using D = DoublesOf<L>;
  const std::int32_t first = query.body[c + static_cast<std::size_t>(__builtin_ctz(asked))];
  if (query.one_body) return function(SharedNumbers<D>{bodies.numbers + bodies.start[first]});
  std::int32_t start[D::kWidth];
  bool shared = true;
  for (std::size_t lane = 0; lane < D::kWidth; ++lane) {
    const std::int32_t body = (asked >> lane & 1) != 0 ? query.body[c + lane] : first;
    shared = shared && body == first;
    start[lane] = bodies.start[body];
  }
  if (shared)
    function(SharedNumbers<D>{bodies.numbers + start[0]});
  else
    function(OwnNumbers<D>{bodies.numbers, start});
}

/// The nearest hits of those lanes of a query, all of bodies of this type.
template <class Shape, class L>
void hit_bodies(const FrozenShapes<typename L::Real, Body>& bodies, BodyQuery<L>& query,
                std::uint32_t lanes, bool any) {
  using D = DoublesOf<L>;
  using F = typename D::F;
  const Wanted wanted = any ? Wanted::any : Wanted::first;
  each_part<L>(lanes, [&](std::size_t c, std::uint32_t asked) {
    const V3<F> origin = load_doubles<L>(query.origin, c);
    const V3<F> direction = load_doubles<L>(query.direction, c);
    with_numbers<L>(bodies, query, c, asked, [&](const auto& row) {
      if constexpr (std::is_same_v<Shape, Plane>) {
        answer<L>(query, c, asked, distance_to_plane(row, origin, direction));
      } else {
        F at[BodyLanes<Shape, D>::kMost];
        crossings<Shape, D>(row, origin, direction, wanted, D::load_reals(query.limit + c), at);
        answer<L>(query, c, asked, first_in_front(at));
      }
    });
  });
}

}  // namespace zraka::ZRAKA_ISA
