// SPDX-License-Identifier: Apache-2.0
// Bodies against rays, for one instruction set. CMake compiles this file once for each, like
// engine/kernel.cpp.
#include "accel/body_surface.hpp"
#include "accel/csg.hpp"
#include "accel/group_rays.hpp"
#include "engine/plane_surfaces.hpp"
#include "engine/surfaces.hpp"

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
      const std::int32_t body = query.body[c + static_cast<std::size_t>(__builtin_ctz(asked))];
      const std::uint32_t mine =
          lanes_with(asked, [&](std::size_t i) { return query.body[c + i] == body; });
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
  const bool one = all(in_lanes.which == typename L::I(query.body[0]));
  for (std::uint32_t left = bits(limit > typename L::F(R(0))); left != 0;) {
    const std::uint8_t type = bodies.type[query.body[__builtin_ctz(left)]];
    const std::uint32_t same =
        one ? left
            : lanes_with(left, [&](std::size_t i) { return bodies.type[query.body[i]] == type; });
    kFunctions[type](bodies, query, same, any);
    left &= ~same;
  }
  return L::load(query.t);
}

namespace {

/// Lanes of surfaces in memory, for who changes them one by one.
template <class L>
struct SurfaceMemory {
  using R = typename L::Real;
  alignas(64) R point[3][L::kWidth], normal[3][L::kWidth], offset[L::kWidth], inside[L::kWidth];
  alignas(64) std::int32_t material[L::kWidth];

  explicit SurfaceMemory(const Surfaces<L>& s) {
    using F = typename L::F;
    L::store(s.at.point.x, point[0]), L::store(s.at.point.y, point[1]);
    L::store(s.at.point.z, point[2]), L::store(s.at.normal.x, normal[0]);
    L::store(s.at.normal.y, normal[1]), L::store(s.at.normal.z, normal[2]);
    L::store(s.at.offset, offset);
    L::store(select(s.at.inside, F(R(1)), F(R(0))), inside);
    L::store(s.material, material);
  }
  Surfaces<L> back() const {
    return {{{L::load(point[0]), L::load(point[1]), L::load(point[2])},
             {L::load(normal[0]), L::load(normal[1]), L::load(normal[2])},
             L::load(offset),
             L::load(inside) > typename L::F(R(0))},
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
};

/// Points are rounded once and normals nearly exact: as much as shapes in float take is plenty. In
/// double, what a body's own space loses counts besides.
template <class R>
constexpr double kBodyOffset = sizeof(R) == 4 ? 0x1p-20 : 0x1p-47;
template <class R>
constexpr double kOwnOffset = sizeof(R) == 4 ? 0x1p-30 : 0x1p-47;

template <class L>
V3<double> one_of(const typename L::Real (&v)[3][BodyQuery<L>::kRoom], std::size_t lane) {
  return {static_cast<double>(v[0][lane]), static_cast<double>(v[1][lane]),
          static_cast<double>(v[2][lane])};
}

template <class L>
void surface_of_body(const FrozenShapes<typename L::Real, Body>& bodies, std::int32_t body,
                     std::size_t lane, const BodyQuery<L>& query, SurfaceMemory<L>& out,
                     HitPath* paths) {
  using R = typename L::Real;
  const BodyHit hit = isa_oracle::body_hit(bodies, body, one_of<L>(query.origin, lane),
                                           one_of<L>(query.direction, lane));
  out.set(lane, hit.point, hit.normal);
  out.offset[lane] =
      static_cast<R>(out.largest(lane) * kBodyOffset<R> + hit.size * kOwnOffset<R>);
  out.inside[lane] = hit.inside ? R(1) : R(0);
  const std::int32_t own = bodies.material[hit.body];
  out.material[lane] = own >= 0 ? own : bodies.material[body];
  if (paths != nullptr) paths[lane].body = hit.body;
}

/// Of the lanes that hit one plane: as surface_of_body(), in lanes.
template <class L>
void surfaces_of_plane(const FrozenShapes<typename L::Real, Body>& bodies, std::int32_t body,
                       std::uint32_t lanes, const BodyQuery<L>& query, SurfaceMemory<L>& out,
                       HitPath* paths) {
  using R = typename L::Real;
  using D = DoublesOf<L>;
  using F = typename D::F;
  hits_of_plane<L>(bodies, body, lanes, query,
                   [&](std::size_t c, std::uint32_t asked, const V3<F>& point,
                       const V3<double>& normal, const F& size, typename D::M inside) {
    const auto mine = D::from_bits(asked);
    const auto put = [&](const F& value, R* to) {
      D::store_reals(select(mine, value, D::load_reals(to + c)), to + c);
    };
    put(point.x, out.point[0]), put(point.y, out.point[1]), put(point.z, out.point[2]);
    put(F(normal.x), out.normal[0]), put(F(normal.y), out.normal[1]);
    put(F(normal.z), out.normal[2]);
    const auto length = [&](const R* at) { return abs(D::load_reals(at + c)); };
    const F largest =
        max(length(out.point[0]), max(length(out.point[1]), length(out.point[2])));
    put(largest * F(kBodyOffset<R>) + size * F(kOwnOffset<R>), out.offset);
    put(select(inside, F(1.0), F(0.0)), out.inside);
  });
  for (; lanes != 0; lanes &= lanes - 1) {
    const auto lane = static_cast<std::size_t>(__builtin_ctz(lanes));
    out.material[lane] = bodies.material[body];
    if (paths != nullptr) paths[lane].body = body;
  }
}

/// Puts an instance in front of a path within its group, whose frame is reached by these columns
/// and this origin.
void add_instance(std::int32_t body, const void* group, const V3<double>& x, const V3<double>& y,
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
  nearest_in_group<L>(group_rays.group(), rays);
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
    out.material[lane] =
        found.material[lane] >= 0 ? found.material[lane] : bodies.material[body];
    if (paths != nullptr)
      add_instance(body, &group_rays.group(), yz * determinant, zx * determinant,
                   xy * determinant, center, inner[lane], paths[lane]);
  }
}

}  // namespace

template <class L>
void surfaces_of_bodies(const FrozenShapes<typename L::Real, Body>& bodies, typename L::I slot,
                        const V3<typename L::F>& origin, const V3<typename L::F>& direction,
                        typename L::F t, Surfaces<L>& surfaces, HitPath* paths) {
  using I = typename L::I;
  std::uint32_t left = bits(but_not(slot >= I(bodies.first_slot),
                                    slot >= I(bodies.first_slot + bodies.count)));
  if (left == 0) return;
  BodyQuery<L> query;
  store_rays<L>(origin, direction, query);
  L::store(slot + I(-bodies.first_slot), query.body);
  L::store(t * typename L::F(typename L::Real(1.0f + 0x1p-18f)), query.limit);
  SurfaceMemory<L> memory(surfaces);
  while (left != 0) {
    const auto lane = static_cast<std::size_t>(__builtin_ctz(left));
    const std::int32_t body = query.body[lane];
    const bool is_plane = bodies.type[body] == kTypePlane;
    if (!is_plane && bodies.type[body] != kTypeInstance) {
      surface_of_body<L>(bodies, body, lane, query, memory, paths);
      left &= left - 1;
      continue;
    }
    const std::uint32_t mine = lanes_with(left, [&](std::size_t i) { return query.body[i] == body; });
    if (is_plane)
      surfaces_of_plane<L>(bodies, body, mine, query, memory, paths);
    else
      surfaces_of_instance<L>(bodies, body, mine, query, memory, paths);
    left &= ~mine;
  }
  surfaces = memory.back();
}

template Lanes::F intersect_bodies<Lanes>(const BodiesInLanes<Lanes>&, const V3<Lanes::F>&,
                                          const V3<Lanes::F>&, Lanes::F, bool);
template void surfaces_of_bodies<Lanes>(const FrozenShapes<Lanes::Real, Body>&, Lanes::I,
                                        const V3<Lanes::F>&, const V3<Lanes::F>&, Lanes::F,
                                        Surfaces<Lanes>&, HitPath*);

}  // namespace zraka::ZRAKA_ISA
