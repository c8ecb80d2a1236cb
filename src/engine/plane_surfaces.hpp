// SPDX-License-Identifier: Apache-2.0
// Where rays hit a plane: the same steps as body_hit() in accel/body_surface.cpp, in lanes.
#pragma once

#include "accel/body_rays.hpp"
#include "engine/hit_path.hpp"

namespace zraka::ZRAKA_ISA {

/// Those of the lanes of a query that hit the plane; `out` takes each part of them, so many double
/// lanes from number c on: part(c, lanes, point, normal, size, inside), what BodyHit has of them.
template <class L, class Part>
void hits_of_plane(const FrozenShapes<typename L::Real, Body>& bodies, std::int32_t body,
                   std::uint32_t lanes, const BodyQuery<L>& query, const Part& part) {
  using D = DoublesOf<L>;
  using F = typename D::F;
  const double* const row = bodies.numbers + bodies.start[body];
  const double* const m = row + kBodyMatrix;
  const V3<double> x{m[0], m[1], m[2]}, y{m[3], m[4], m[5]}, z{m[6], m[7], m[8]};
  const V3<double> up = x * 0.0 + y * 1.0 + z * 0.0;  // the gradient, by the transposed matrix
  const V3<double> normal = up * (1 / __builtin_sqrt(dot(up, up)));
  each_part<L>(lanes, [&](std::size_t c, std::uint32_t asked) {
    const V3<F> origin = load_doubles<L>(query.origin, c);
    const V3<F> direction = load_doubles<L>(query.direction, c);
    const BodyView<F> view = view_of(SharedNumbers<D>{row}, origin, direction);
    F at[BodyLanes<Plane, D>::kMost];
    BodyLanes<Plane, D>::cross(0, view.ray, at);
    for (F& t : at) t = view.distance(t);
    const F t = first_in_front(at);
    const auto inside = but_not(at[1] == t, at[0] == t);
    part(c, asked, origin + direction * t, normal, view.unit, inside);
  });
}

}  // namespace zraka::ZRAKA_ISA
