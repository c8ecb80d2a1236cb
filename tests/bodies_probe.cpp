// SPDX-License-Identifier: Apache-2.0
// Compiled once per instruction set, like lanes_probe.cpp.
#include "bodies_probe.hpp"

#include <algorithm>
#include <vector>

#include "engine/body_surfaces.hpp"
#include "math/double_power.hpp"

namespace zraka::ZRAKA_ISA {
namespace {

#ifdef ZRAKA_WIDE
using D = WideDoubles;
using L = WideLanes;
#else
using D = ScalarDoubles;
using L = ScalarLanes<double>;
#endif
using F = D::F;

/// As BodyCrossings has it, where it is 1.
template <class Shape, class Row>
F limits_kept(const Row& row, const V3<F>& origin, const V3<F>& direction) {
  const auto asked = [&](Wanted wanted, F limit) {
    F at[BodyLanes<Shape, D>::kMost];
    crossings<Shape, D>(row, origin, direction, wanted, limit, at);
    return first_in_front(at);
  };
  const F first = asked(Wanted::first, F(kNever));
  const auto there = first < F(kNever);
  const F more = select(there, first * F(1.001), F(0x1p20)), less = first * F(0.999);
  const F near = asked(Wanted::first, more), any = asked(Wanted::any, more);
  const auto found = both(both(near == first, any < more), there);
  const auto none = but_not(but_not(near >= more, any < more), there);
  const auto none_before =
      both(asked(Wanted::first, less) >= less, asked(Wanted::any, less) >= less);
  return select(both(either(found, none), none_before), F(1.0), F(0.0));
}

template <class Shape>
void cross_all(const double* numbers, const std::int32_t* start, const BodyProbeRay* rays,
               BodyCrossings* found, std::size_t count) {
  constexpr int kMost = BodyLanes<Shape, D>::kMost;
  static_assert(kMost <= kProbedCrossings);
  for (std::size_t first = 0; first < count; first += D::kWidth) {
    // The last ray once more where there are no more.
    const auto index = [&](std::size_t lane) { return std::min(first + lane, count - 1); };
    std::int32_t starts[D::kWidth];
    bool shared = true;
    for (std::size_t lane = 0; lane < D::kWidth; ++lane) {
      starts[lane] = start[index(lane)];
      shared = shared && starts[lane] == starts[0];
    }
    alignas(64) double lanes[D::kWidth];
    const auto load = [&](const double(BodyProbeRay::*part)[3], int axis) {
      for (std::size_t lane = 0; lane < D::kWidth; ++lane)
        lanes[lane] = (rays[index(lane)].*part)[axis];
      return D::load(lanes);
    };
    const auto vector = [&](const double(BodyProbeRay::*part)[3]) {
      const F x = load(part, 0), y = load(part, 1);
      return V3<F>{x, y, load(part, 2)};
    };
    const V3<F> origin = vector(&BodyProbeRay::origin),
                direction = vector(&BodyProbeRay::direction);
    F at[kMost];
    const auto surface = [&](const auto& row) {
      crossings<Shape, D>(row, origin, direction, Wanted::all, F(kNever), at);
      return surface_in_lanes<Shape, D>(row, origin, direction);
    };
    const auto hit = shared ? surface(SharedNumbers<D>{numbers + starts[0]})
                            : surface(OwnNumbers<D>{numbers, starts});
    const auto store = [&](const F& value, const auto& put) {
      D::store(value, lanes);
      for (std::size_t lane = 0; lane < D::kWidth; ++lane) put(found[index(lane)], lanes[lane]);
    };
    store(select(hit.t > F(0.0), hit.t, F(kNever)),
          [](BodyCrossings& c, double t) { c.first = t; });
    store(hit.normal.x, [](BodyCrossings& c, double n) { c.normal[0] = n; });
    store(hit.normal.y, [](BodyCrossings& c, double n) { c.normal[1] = n; });
    store(hit.normal.z, [](BodyCrossings& c, double n) { c.normal[2] = n; });
    store(shared ? limits_kept<Shape>(SharedNumbers<D>{numbers + starts[0]}, origin, direction)
                 : limits_kept<Shape>(OwnNumbers<D>{numbers, starts}, origin, direction),
          [](BodyCrossings& c, double kept) { c.keeps_limits = kept > 0; });
    store(select(hit.inside, F(1.0), F(0.0)),
          [](BodyCrossings& c, double inside) { c.inside = inside > 0; });
    for (int k = 0; k < kProbedCrossings; ++k) {
      D::store(k < kMost ? at[k] : F(kNever), lanes);
      for (std::size_t lane = 0; lane < D::kWidth; ++lane) found[index(lane)].at[k] = lanes[lane];
    }
  }
}

void cross(BodyType type, const double* numbers, const std::int32_t* start,
           const BodyProbeRay* rays, BodyCrossings* found, std::size_t count) {
#define ZRAKA_CROSS(Type, plural)              \
  if constexpr (!ShapeTraits<Type>::kComposed) \
    if (type == kType##Type) cross_all<Type>(numbers, start, rays, found, count);
  ZRAKA_BODIES(ZRAKA_CROSS)
#undef ZRAKA_CROSS
}

/// A register of hits: rays of the same numbers ask the same body.
void hit_register(const FrozenShapes<L::Real, Body>& bodies, const std::size_t (&index)[L::kWidth],
                  const BodyProbeRay* rays, const double* limit, BodyHit* found) {
  L::Real number[L::kWidth];
  std::int32_t which[L::kWidth];
  const auto load = [&](const auto& value) {
    for (std::size_t lane = 0; lane < L::kWidth; ++lane)
      number[lane] = static_cast<L::Real>(value(index[lane]));
    return L::load(number);
  };
  const auto vector = [&](const double(BodyProbeRay::*part)[3]) {
    V3<L::F> v;
    v.x = load([&](std::size_t i) { return (rays[i].*part)[0]; });
    v.y = load([&](std::size_t i) { return (rays[i].*part)[1]; });
    v.z = load([&](std::size_t i) { return (rays[i].*part)[2]; });
    return v;
  };
  for (std::size_t lane = 0; lane < L::kWidth; ++lane) {
    const bool shared = bodies.start[index[lane]] == bodies.start[index[0]];
    which[lane] = static_cast<std::int32_t>(shared ? index[0] : index[lane]);
  }
  const V3<L::F> origin = vector(&BodyProbeRay::origin),
                 direction = vector(&BodyProbeRay::direction);
  const L::F ends = load([&](std::size_t i) { return limit[i]; });
  const BodiesInLanes<L> in_lanes{&bodies, L::load(which)};
  const L::F t = intersect_bodies<L>(in_lanes, origin, direction, ends, false);
  const L::F any_t = intersect_bodies<L>(in_lanes, origin, direction, ends, true);
  const L::F zero(L::Real(0)), far(L::Real(-1));
  Surfaces<L> surfaces{{{zero, zero, zero}, {zero, zero, zero}, zero, t < far, t < far},
                       typename L::I(0)};
  surfaces_of_bodies<L>(bodies, select(t > zero, L::load(which), typename L::I(-1)), origin,
                        direction, t, surfaces, nullptr);
  const auto store = [&](const L::F& value, const auto& put) {
    L::store(value, number);
    for (std::size_t lane = 0; lane < L::kWidth; ++lane) put(found[index[lane]], number[lane]);
  };
  store(t, [](BodyHit& h, double v) { h.t = v; });
  store(any_t, [](BodyHit& h, double v) { h.any = v; });
  const V3<L::F>&p = surfaces.at.point, &n = surfaces.at.normal;
  store(p.x, [](BodyHit& h, double v) { h.point[0] = v; });
  store(p.y, [](BodyHit& h, double v) { h.point[1] = v; });
  store(p.z, [](BodyHit& h, double v) { h.point[2] = v; });
  store(n.x, [](BodyHit& h, double v) { h.normal[0] = v; });
  store(n.y, [](BodyHit& h, double v) { h.normal[1] = v; });
  store(n.z, [](BodyHit& h, double v) { h.normal[2] = v; });
  store(select(surfaces.at.inside, L::F(L::Real(1)), zero),
        [](BodyHit& h, double v) { h.inside = v > 0; });
}

void hit(BodyType type, const double* numbers, const std::int32_t* start, const BodyProbeRay* rays,
         const double* limit, BodyHit* found, std::size_t count) {
  const std::vector<std::uint8_t> types(count, type);
  const std::vector<std::int32_t> materials(count);
  FrozenShapes<L::Real, Body> bodies{};
  bodies.type = types.data();
  bodies.start = start;
  bodies.numbers = numbers;
  bodies.material = materials.data();
  bodies.count = bodies.bounded = static_cast<std::int32_t>(count);
  for (std::size_t first = 0; first < count; first += L::kWidth) {
    std::size_t index[L::kWidth];
    for (std::size_t lane = 0; lane < L::kWidth; ++lane)
      index[lane] = std::min(first + lane, count - 1);
    hit_register(bodies, index, rays, limit, found);
  }
}

template <class Function>
void each(const double* x, double* out, std::size_t count, const Function& function) {
  alignas(64) double lanes[D::kWidth];
  for (std::size_t first = 0; first < count; first += D::kWidth) {
    const std::size_t some = std::min(D::kWidth, count - first);
    std::fill_n(lanes, D::kWidth, 1.0);
    std::copy_n(x + first, some, lanes);
    D::store(function(D::load(lanes)), lanes);
    std::copy_n(lanes, some, out + first);
  }
}
void log2_of(const double* x, double* out, std::size_t count) {
  each(x, out, count, [](F v) { return double_log2(v); });
}
void exp2_of(const double* x, double* out, std::size_t count) {
  each(x, out, count, [](F v) { return double_exp2(v); });
}

}  // namespace

BodiesProbe bodies_probe();
BodiesProbe bodies_probe() {
  return {{}, cross, hit, log2_of, exp2_of};
}

}  // namespace zraka::ZRAKA_ISA
