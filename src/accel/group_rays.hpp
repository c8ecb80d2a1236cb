// SPDX-License-Identifier: Apache-2.0
// Rays through an instance: into the frame of its group, through the group's own hierarchy, and
// back.
#pragma once

#include "accel/body_rays.hpp"
#include "accel/called.hpp"

namespace zraka::ZRAKA_ISA {

/// Those lanes of a query that look at one instance, in its group's frame. A ray starts there a
/// little before it comes near the group, so that floats are spent on the group and not on the way
/// to it.
template <class L>
class GroupRays {
 public:
  using R = typename L::Real;

  GroupRays(const FrozenShapes<R, Body>& bodies, std::int32_t body, const BodyQuery<L>& query,
            std::uint32_t lanes, bool any) {
    // Distances are compared as they are in the end; until then ends are only roughly known: the
    // slack is for the whole distance, which was rounded, and not for what is left of it here.
    const double slack = any ? 1 : 1 + 0x1p-20;
    using F = typename D::F;
    const double* const row = bodies.numbers + bodies.start[body];
    const SharedNumbers<D> numbers{row};
    group_ = bodies.groups + static_cast<std::ptrdiff_t>(row[kBodyNumbers]);
    const F reach(row[kBodyNumbers + 1]);
    alignas(64) R o[3][BodyQuery<L>::kRoom], d[3][BodyQuery<L>::kRoom], t[BodyQuery<L>::kRoom];
    for (std::size_t c = 0; c < L::kWidth; c += D::kWidth) {
      const BodyView<F> view = view_of(numbers, load_doubles<L>(query.origin, c),
                                       load_doubles<L>(query.direction, c), false);
      // From the point nearest to the middle back to where the ray began, or to where it comes
      // near: before + start is how far that is from the ray's origin.
      const F start = max(-view.before, -reach);
      const V3<F> from = view.ray.origin + view.ray.direction * start;
      const F limit =
          D::load_reals(query.limit + c) * F(slack) / view.unit - (view.before + start);
      store(from.x, o[0] + c), store(from.y, o[1] + c), store(from.z, o[2] + c);
      store(view.ray.direction.x, d[0] + c), store(view.ray.direction.y, d[1] + c);
      store(view.ray.direction.z, d[2] + c);
      store(limit, t + c);
      D::store(view.before + start, start_ + c);
      D::store(view.unit, unit_ + c);
    }
    rays_.ray[0] = {{L::load(o[0]), L::load(o[1]), L::load(o[2])},
                    {L::load(d[0]), L::load(d[1]), L::load(d[2])},
                    min(L::load(t), typename L::F(kFarAway<R>)),
                    typename L::I(-1)};
    rays_.active[0] = L::from_bits(lanes);
    for (std::size_t r = 1; r < kRegisters<L>; ++r) {
      rays_.ray[r] = rays_.ray[0];
      rays_.active[r] = L::first(0);
    }
  }

  const FrozenScene<R>& group() const { return *group_; }
  const RayGroup<L>& rays() const { return rays_; }

  void answer_nearest(BodyQuery<L>& query, std::uint32_t lanes) const {
    RayGroup<L> rays = rays_;
    find_nearest_called<L>(*group_, rays);
    alignas(64) R t[L::kWidth];
    alignas(64) std::int32_t slot[L::kWidth];
    L::store(rays.ray[0].t, t);
    L::store(rays.ray[0].slot, slot);
    for (; lanes != 0; lanes &= lanes - 1) {
      const auto lane = static_cast<std::size_t>(__builtin_ctz(lanes));
      query.t[lane] = slot[lane] >= 0 ? back(lane, t[lane]) : R(-1);
    }
  }

  /// Half the limit is as good as any distance.
  void answer_any(BodyQuery<L>& query, std::uint32_t lanes) const {
    RayGroup<L> rays = rays_;
    LastBlocker last;
    const std::uint32_t blocked = find_blocked_called<L>(*group_, last, rays);
    for (; lanes != 0; lanes &= lanes - 1) {
      const auto lane = static_cast<std::size_t>(__builtin_ctz(lanes));
      query.t[lane] = (blocked >> lane & 1) != 0 ? query.limit[lane] * R(0.5f) : R(-1);
    }
  }

  /// A distance in the group's frame as one along the ray that came.
  R back(std::size_t lane, R t) const {
    return static_cast<R>((start_[lane] + static_cast<double>(t)) * unit_[lane]);
  }

 private:
  using D = DoublesOf<L>;
  static ZRAKA_INLINE void store(typename D::F v, R* to) {
    alignas(64) double values[D::kWidth];
    D::store(v, values);
    for (std::size_t i = 0; i < D::kWidth; ++i) to[i] = static_cast<R>(values[i]);
  }

  const FrozenScene<R>* group_;
  RayGroup<L> rays_;
  alignas(64) double start_[BodyQuery<L>::kRoom], unit_[BodyQuery<L>::kRoom];
};

}  // namespace zraka::ZRAKA_ISA
