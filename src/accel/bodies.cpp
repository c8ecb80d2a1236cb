// SPDX-License-Identifier: Apache-2.0
// Bodies against rays, for one instruction set. CMake compiles this file once for each, like
// engine/kernel.cpp.
#include "accel/csg.hpp"
#include "accel/group_rays.hpp"

namespace zraka::ZRAKA_ISA {

#ifdef ZRAKA_WIDE
using Lanes = WideLanes;
#else
using Lanes = ScalarLanes<double>;
#endif

/// CSG bodies one after the other: rays are in lanes.
template <class L>
void hit_csgs(const FrozenShapes<typename L::Real, Body>& bodies, BodyQuery<L>& query,
              std::uint32_t lanes, bool /*any*/) {
  using D = DoublesOf<L>;
  using F = typename D::F;
  each_part<L>(lanes, [&](std::size_t c, std::uint32_t asked) {
    const V3<F> origin = load_doubles<L>(query.origin, c);
    const V3<F> direction = load_doubles<L>(query.direction, c);
    while (asked != 0) {
      const auto lane = static_cast<std::size_t>(__builtin_ctz(asked));
      const std::int32_t body = query.body[c + lane];
      std::uint32_t mine = 0;
      for (std::uint32_t left = asked; left != 0; left &= left - 1) {
        const int i = __builtin_ctz(left);
        if (query.body[c + static_cast<std::size_t>(i)] == body) mine |= 1u << i;
      }
      // What is found in float is compared with the limit later: here it is only roughly known.
      const F limit = D::load_reals(query.limit + c) * F(1.0 + 0x1p-20);
      const CsgWay<D> way(bodies, body, origin, direction);
      answer<L>(query, c, mine, way.first_hit(limit));
      asked &= ~mine;
    }
  });
}

/// Groups one after the other: rays are in lanes, in the group's own frame.
template <class L>
void hit_instances(const FrozenShapes<typename L::Real, Body>& bodies, BodyQuery<L>& query,
                   std::uint32_t lanes, bool any) {
  while (lanes != 0) {
    const std::int32_t body = query.body[__builtin_ctz(lanes)];
    std::uint32_t mine = 0;
    for (std::uint32_t left = lanes; left != 0; left &= left - 1) {
      const int i = __builtin_ctz(left);
      if (query.body[i] == body) mine |= 1u << i;
    }
    const GroupRays<L> rays(bodies, body, query, mine);
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
  else
    return hit_bodies<Shape, L>;
}

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
  L::store(origin.x, query.origin[0]);
  L::store(origin.y, query.origin[1]);
  L::store(origin.z, query.origin[2]);
  L::store(direction.x, query.direction[0]);
  L::store(direction.y, query.direction[1]);
  L::store(direction.z, query.direction[2]);
  L::store(limit, query.limit);
  L::store(typename L::F(R(-1)), query.t);
  for (std::uint32_t left = bits(limit > typename L::F(R(0))); left != 0;) {
    const std::uint8_t type = bodies.type[query.body[__builtin_ctz(left)]];
    std::uint32_t same = 0;
    for (std::uint32_t rest = left; rest != 0; rest &= rest - 1) {
      const int lane = __builtin_ctz(rest);
      if (bodies.type[query.body[lane]] == type) same |= 1u << lane;
    }
    kFunctions[type](bodies, query, same, any);
    left &= ~same;
  }
  return L::load(query.t);
}

template Lanes::F intersect_bodies<Lanes>(const BodiesInLanes<Lanes>&, const V3<Lanes::F>&,
                                          const V3<Lanes::F>&, Lanes::F, bool);

}  // namespace zraka::ZRAKA_ISA
