// SPDX-License-Identifier: Apache-2.0
// Bodies against rays, for one instruction set. CMake compiles this file once for each, like
// engine/kernel.cpp.
#include "accel/torus_rays.hpp"
#include "engine/body_surfaces.hpp"

namespace zraka::ZRAKA_ISA {

#ifdef ZRAKA_WIDE
using Lanes = WideLanes;
#else
using Lanes = ScalarLanes<double>;
#endif

namespace {

template <class L>
ZRAKA_INLINE void store_rays(const V3<typename L::F>& origin, const V3<typename L::F>& direction,
                             BodyQuery<L>& query) {
  L::store(origin.x, query.origin[0]);
  L::store(origin.y, query.origin[1]);
  L::store(origin.z, query.origin[2]);
  L::store(direction.x, query.direction[0]);
  L::store(direction.y, query.direction[1]);
  L::store(direction.z, query.direction[2]);
}

/// Those of the lanes for which this is true.
template <class Condition>
ZRAKA_INLINE std::uint32_t lanes_with(std::uint32_t lanes, const Condition& condition) {
  std::uint32_t with = 0;
  for (std::uint32_t left = lanes; left != 0; left &= left - 1) {
    const int lane = __builtin_ctz(left);
    if (condition(static_cast<std::size_t>(lane))) with |= 1u << lane;
  }
  return with;
}

/// The nearest hits of lanes of a query's part, all of one CSG body.
template <class L>
void hit_csg(const FrozenBodies& bodies, std::int32_t body, const Meet& meet, std::size_t c,
             std::uint32_t mine, BodyQuery<L>& query) {
  using D = DoublesOf<L>;
  using F = typename D::F;
  const V3<F> origin = load_doubles<L>(query.origin, c);
  const V3<F> direction = load_doubles<L>(query.direction, c);
  // What is found in float is compared with the limit later: here it is only roughly known.
  const F limit = D::load_reals(query.limit + c) * F(1.0 + 0x1p-20);
  const auto asked = D::from_bits(mine);
  const auto take = [&](const auto& way) {
    if (!way.misses()) answer<L>(query, c, mine, way.first_hit());
  };
  if (meet.possible)
    take(CsgMeet<D>(bodies, body, meet, origin, direction, asked, limit));
  else
    take(CsgWay<D>(bodies, body, origin, direction, asked, limit, true));
}

/// CSG bodies one after the other: rays are in lanes.
template <class L>
void hit_csgs(const FrozenShapes<typename L::Real, Body>& bodies, BodyQuery<L>& query,
              std::uint32_t lanes, bool /*any*/) {
  while (lanes != 0) {
    const std::int32_t body = query.body[__builtin_ctz(lanes)];
    const std::uint32_t mine =
        query.one_body ? lanes
                       : lanes_with(lanes, [&](std::size_t i) { return query.body[i] == body; });
    const Meet meet(bodies, body);
    each_part<L>(mine, [&](std::size_t c, std::uint32_t asked) {
      hit_csg<L>(bodies, body, meet, c, asked, query);
    });
    lanes &= ~mine;
  }
}

/// Groups one after the other: rays are in lanes, in the group's own frame.
template <class L>
void hit_instances(const FrozenShapes<typename L::Real, Body>& bodies, BodyQuery<L>& query,
                   std::uint32_t lanes, bool any) {
  while (lanes != 0) {
    const std::int32_t body = query.body[__builtin_ctz(lanes)];
    const std::uint32_t mine =
        lanes_with(lanes, [&](std::size_t i) { return query.body[i] == body; });
    const GroupRays<L> rays(bodies, body, query, mine, any);
    if (any)
      rays.answer_any(query, mine);
    else
      rays.answer_nearest(query, mine);
    lanes &= ~mine;
  }
}

template <class L>
using HitFunction = void (*)(const FrozenShapes<typename L::Real, Body>&, BodyQuery<L>&,
                             std::uint32_t, bool);
template <class Shape, class L>
constexpr HitFunction<L> hit_function() {
  if constexpr (std::is_same_v<Shape, Csg>)
    return hit_csgs<L>;
  else if constexpr (std::is_same_v<Shape, Instance>)
    return hit_instances<L>;
  else if constexpr (std::is_same_v<Shape, Torus>)
    return hit_tori<L>;
  else
    return hit_bodies<Shape, L>;
}

}  // namespace

template <class L>
typename L::F intersect_bodies(const BodiesInLanes<L>& in_lanes, const V3<typename L::F>& origin,
                               const V3<typename L::F>& direction, typename L::F limit, bool any) {
  static constexpr HitFunction<L> kFunctions[kBodyTypes] = {
#define ZRAKA_FUNCTION(Type, plural) hit_function<Type, L>(),
      ZRAKA_BODIES(ZRAKA_FUNCTION)
#undef ZRAKA_FUNCTION
  };
  using R = typename L::Real;
  const FrozenShapes<R, Body>& bodies = *in_lanes.bodies;
  BodyQuery<L> query;
  L::store(in_lanes.which, query.body);
  store_rays<L>(origin, direction, query);
  L::store(limit, query.limit);
  L::store(typename L::F(R(-1)), query.t);
  query.one_body = all(in_lanes.which == typename L::I(query.body[0]));
  for (std::uint32_t left = bits(limit > typename L::F(R(0))); left != 0;) {
    const std::uint8_t type = bodies.type[query.body[__builtin_ctz(left)]];
    const std::uint32_t same =
        query.one_body
            ? left
            : lanes_with(left, [&](std::size_t i) { return bodies.type[query.body[i]] == type; });
    kFunctions[type](bodies, query, same, any);
    left &= ~same;
  }
  return L::load(query.t);
}

template <class L>
void surfaces_of_bodies(const FrozenShapes<typename L::Real, Body>& bodies, typename L::I slot,
                        const V3<typename L::F>& origin, const V3<typename L::F>& direction,
                        typename L::F t, Surfaces<L>& surfaces, HitPath* paths) {
  using I = typename L::I;
  std::uint32_t left = bits(but_not(slot >= I(bodies.first_slot),
                                    slot >= I(bodies.first_slot + bodies.count)));
  if (left == 0) return;
  const std::int32_t first = first_lane(slot) - bodies.first_slot;
  if (all(slot == I(bodies.first_slot + first)) && bodies.type[first] == kTypePlane) {
    surfaces_of_plane<L>(bodies.numbers + bodies.start[first], origin, direction, surfaces.at);
    surfaces.material = I(bodies.material[first]);
    for (std::size_t i = 0; paths != nullptr && i < L::kWidth; ++i) paths[i].body = first;
    return;
  }
  BodyQuery<L> query;
  store_rays<L>(origin, direction, query);
  L::store(slot + I(-bodies.first_slot), query.body);
  L::store(t * typename L::F(typename L::Real(1.0f + 0x1p-18f)), query.limit);
  L::store(t, query.t);
  SurfaceMemory<L> memory(surfaces);
  while (left != 0) {
    const std::int32_t body = query.body[__builtin_ctz(left)];
    const std::uint8_t type = bodies.type[body];
    const SurfaceFunction<L> together = kSurfaceFunctions<L>[type];
    // Mostly all have hit the same body.
    std::uint32_t mine = left & bits(slot == I(bodies.first_slot + body));
    query.one_body = mine == left || together == nullptr;
    if (!query.one_body)
      mine = lanes_with(left, [&](std::size_t i) { return bodies.type[query.body[i]] == type; });
    left &= ~mine;
    if (type == kTypeInstance) {
      surfaces_of_instance<L>(bodies, body, mine, query, memory, paths);
      continue;
    }
    std::int32_t hit[L::kWidth];
    for (std::size_t i = 0; i < L::kWidth; ++i) hit[i] = query.body[i];
    if (together == nullptr)
      surfaces_of_csg<L>(bodies, body, mine, query, memory, hit);
    else
      together(bodies, mine, query, memory);
    for (std::uint32_t lanes = mine; lanes != 0; lanes &= lanes - 1) {
      const auto lane = static_cast<std::size_t>(__builtin_ctz(lanes));
      const std::int32_t own = bodies.material[hit[lane]];
      memory.material[lane] = own >= 0 ? own : bodies.material[query.body[lane]];
      if (paths != nullptr) paths[lane].body = hit[lane];
    }
  }
  surfaces = memory.back();
}

template Lanes::F intersect_bodies<Lanes>(const BodiesInLanes<Lanes>&, const V3<Lanes::F>&,
                                          const V3<Lanes::F>&, Lanes::F, bool);
template void surfaces_of_bodies<Lanes>(const FrozenShapes<Lanes::Real, Body>&, Lanes::I,
                                        const V3<Lanes::F>&, const V3<Lanes::F>&, Lanes::F,
                                        Surfaces<Lanes>&, HitPath*);

}  // namespace zraka::ZRAKA_ISA
