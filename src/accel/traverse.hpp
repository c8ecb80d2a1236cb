// SPDX-License-Identifier: Apache-2.0
// Through the hierarchy: one ray against sixteen boxes and sixteen shapes at a time, or a packet of
// rays that go the same way against boxes as one bundle, and against shapes ray by ray in lanes.
#pragma once

#include "accel/flat_list.hpp"
#include "scene/hierarchy.hpp"

namespace zraka::ZRAKA_ISA {

/// A child that is still to be visited, and how near its box begins.
template <class R>
struct Entry {
  R t;
  std::int32_t child, leaf;
};

/// Every node leaves at most fifteen children behind, and its last on top.
inline constexpr int kStackSize = kMaxNodeDepth * (kNodeWidth - 1) + kNodeWidth + 1;

/// The children of a node that a ray or a bundle may meet: nearest last, so that it is taken first.
template <class L>
class Stack {
 public:
  using R = typename L::Real;
  ZRAKA_INLINE bool empty() const { return size_ == 0; }
  ZRAKA_INLINE Entry<R> pop() { return entries_[--size_]; }
  ZRAKA_INLINE void push(R t, std::int32_t child, std::int32_t leaf) {
    entries_[size_++] = {t, child, leaf};
  }

  /// Pushes children [k, k + kWidth) of the node for which `met` is true.
  ZRAKA_INLINE void push_met(const Node& node, std::size_t k, std::uint32_t met, typename L::F t) {
    alignas(64) R near[L::kWidth];
    L::store(t, near);
    for (; met != 0; met &= met - 1) {
      const auto i = static_cast<std::size_t>(__builtin_ctz(met));
      push(near[i], node.child[k + i], node.leaf[k + i]);
    }
  }
  /// Sorts what has been pushed since the stack had this size.
  ZRAKA_INLINE void sort_from(int start) {
    for (int i = start + 1; i < size_; ++i) {
      const Entry<R> entry = entries_[i];
      int at = i;
      for (; at > start && entries_[at - 1].t < entry.t; --at) entries_[at] = entries_[at - 1];
      entries_[at] = entry;
    }
  }
  ZRAKA_INLINE int size() const { return size_; }

 private:
  int size_ = 0;
  Entry<R> entries_[kStackSize];
};

/// 1/d with a large number for 1/0; boxes are large enough for what it errs.
template <class F>
ZRAKA_INLINE F slab_inverse(F d) {
  const F tiny(0x1p-80f);
  const F safe = select(abs(d) < tiny, select(d < F(0), -tiny, tiny), d);
  return F(1) / safe;
}

/// One ray for all lanes.
template <class L>
struct SingleRay {
  using R = typename L::Real;
  using F = typename L::F;
  V3<F> origin, direction, inverse;
  bool back_x, back_y, back_z;

  ZRAKA_INLINE SingleRay(const V3<R>& o, const V3<R>& d)
      : origin{F(o.x), F(o.y), F(o.z)},
        direction{F(d.x), F(d.y), F(d.z)},
        inverse{slab_inverse(direction.x), slab_inverse(direction.y), slab_inverse(direction.z)},
        back_x(d.x < 0),
        back_y(d.y < 0),
        back_z(d.z < 0) {}

  /// Which of the boxes [k, k + kWidth) are met before `limit`, and where.
  ZRAKA_INLINE std::uint32_t meet(const Node& node, std::size_t k, F limit, F& t) const {
    const auto side = [&](bool back, const float* lower, const float* upper) {
      return (back ? upper : lower) + k;
    };
    const F x0 = (L::load_box(side(back_x, node.lower_x, node.upper_x)) - origin.x) * inverse.x;
    const F y0 = (L::load_box(side(back_y, node.lower_y, node.upper_y)) - origin.y) * inverse.y;
    const F z0 = (L::load_box(side(back_z, node.lower_z, node.upper_z)) - origin.z) * inverse.z;
    const F x1 = (L::load_box(side(!back_x, node.lower_x, node.upper_x)) - origin.x) * inverse.x;
    const F y1 = (L::load_box(side(!back_y, node.lower_y, node.upper_y)) - origin.y) * inverse.y;
    const F z1 = (L::load_box(side(!back_z, node.lower_z, node.upper_z)) - origin.z) * inverse.z;
    t = max(max(x0, y0), max(z0, F(0)));
    return bits(t <= min(min(x1, y1), min(z1, limit)));
  }
};

/// The nearest hit of one ray.
template <class L, class R = typename L::Real>
void nearest_of_one(const FrozenScene<R>& scene, const V3<R>& origin, const V3<R>& direction, R& t,
                    std::int32_t& slot) {
  using F = typename L::F;
  const SingleRay<L> ray(origin, direction);
  Stack<L> stack;
  stack.push(0, 0, 0);
  while (!stack.empty()) {
    const Entry<R> entry = stack.pop();
    if (entry.t > t) continue;
    if (entry.leaf == 0) {
      const Node& node = scene.hierarchy.nodes[entry.child];
      const int before = stack.size();
      for (std::size_t k = 0; k < kNodeWidth; k += L::kWidth) {
        F near;
        const std::uint32_t met = ray.meet(node, k, F(t), near);
        stack.push_met(node, k, met, near);
      }
      stack.sort_from(before);
      continue;
    }
    const auto count = static_cast<std::size_t>(entry.leaf % (2 * kNodeWidth));
    with_kind(
        scene, entry.leaf / (2 * kNodeWidth),
        [&]<class Shape>(const FrozenShapes<R, Shape>& shapes) {
          for (std::size_t k = 0; k < count; k += L::kWidth) {
            const std::int32_t first = entry.child + static_cast<std::int32_t>(k);
            F shape[ShapeTraits<Shape>::kReals];
            load_shapes<L>(shapes, first, shape);
            const F distance = ShapeLanes<Shape, L>::intersect(shape, ray.origin, ray.direction);
            const auto nearer = both(both(distance > F(0), distance <= F(t)), L::first(count - k));
            if (!any(nearer)) continue;
            const R least = min_of(select(nearer, distance, F(kFarAway<R>)));
            std::uint32_t equal = bits(both(nearer, distance <= F(least)));
            for (; equal != 0; equal &= equal - 1) {
              const std::int32_t found = shapes.first_slot + first + __builtin_ctz(equal);
              if (least < t || slot < 0 || id_of(scene, found) < id_of(scene, slot)) slot = found;
              t = least;
            }
          }
        });
  }
}

/// Does one ray meet anything nearer than t?
template <class L, class R = typename L::Real>
bool one_is_blocked(const FrozenScene<R>& scene, const V3<R>& origin, const V3<R>& direction, R t) {
  using F = typename L::F;
  const SingleRay<L> ray(origin, direction);
  Stack<L> stack;
  stack.push(0, 0, 0);
  bool blocked = false;
  while (!stack.empty()) {
    const Entry<R> entry = stack.pop();
    if (entry.leaf == 0) {
      const Node& node = scene.hierarchy.nodes[entry.child];
      for (std::size_t k = 0; k < kNodeWidth; k += L::kWidth) {
        F near;
        const std::uint32_t met = ray.meet(node, k, F(t), near);
        stack.push_met(node, k, met, near);
      }
      continue;
    }
    const auto count = static_cast<std::size_t>(entry.leaf % (2 * kNodeWidth));
    with_kind(scene, entry.leaf / (2 * kNodeWidth),
              [&]<class Shape>(const FrozenShapes<R, Shape>& shapes) {
                for (std::size_t k = 0; k < count; k += L::kWidth) {
                  F shape[ShapeTraits<Shape>::kReals];
                  load_shapes<L>(shapes, entry.child + static_cast<std::int32_t>(k), shape);
                  const F distance =
                      ShapeLanes<Shape, L>::intersect(shape, ray.origin, ray.direction);
                  blocked = blocked ||
                            any(both(both(distance > F(0), distance < F(t)), L::first(count - k)));
                }
              });
    if (blocked) return true;
  }
  return false;
}

/// Rays in lanes as one bundle: intervals of origins and of inverse directions.
template <class L>
struct Bundle {
  using R = typename L::Real;
  using F = typename L::F;
  struct Axis {
    F o_lower, o_upper;  // of origins
    F i_lower, i_upper;  // of the magnitudes of inverse directions
    bool back, same_side;

    ZRAKA_INLINE Axis(F origin, F direction, typename L::M active) {
      const F far(kFarAway<R>);
      const F inverse = slab_inverse(direction);
      const R lower = min_of(select(active, inverse, far)),
              upper = max_of(select(active, inverse, -far));
      same_side = lower > 0 || upper < 0;
      back = upper < 0;
      o_lower = F(min_of(select(active, origin, far)));
      o_upper = F(max_of(select(active, origin, -far)));
      i_lower = back ? F(-upper) : F(lower);
      i_upper = back ? F(-lower) : F(upper);
    }
  };
  Axis x, y, z;
  bool coherent;  ///< all go to the same side along each axis; else the bundle is of no use

  ZRAKA_INLINE Bundle(const RayLanes<L>& ray, typename L::M active)
      : x(ray.origin.x, ray.direction.x, active),
        y(ray.origin.y, ray.direction.y, active),
        z(ray.origin.z, ray.direction.z, active),
        coherent(x.same_side && y.same_side && z.same_side) {}

  /// Bounds of where the rays enter and leave slabs: no ray enters before `near` or leaves after
  /// `far`.
  static ZRAKA_INLINE void slab(const Axis& a, const float* lower, const float* upper, F& near,
                                F& far) {
    F in = L::load_box(lower), out = L::load_box(upper);
    if (a.back) {
      const F flipped = a.o_lower - out;
      out = a.o_upper - in;
      in = flipped;
    } else {
      in = in - a.o_upper;
      out = out - a.o_lower;
    }
    near = in * select(in > F(0), a.i_lower, a.i_upper);
    far = out * select(out > F(0), a.i_upper, a.i_lower);
  }

  ZRAKA_INLINE std::uint32_t meet(const Node& node, std::size_t k, F limit, F& t) const {
    F nx, ny, nz, fx, fy, fz;
    slab(x, node.lower_x + k, node.upper_x + k, nx, fx);
    slab(y, node.lower_y + k, node.upper_y + k, ny, fy);
    slab(z, node.lower_z + k, node.upper_z + k, nz, fz);
    t = max(max(nx, ny), max(nz, F(0)));
    return bits(t <= min(min(fx, fy), min(fz, limit)));
  }
};

/// The nearest hits of a bundle's rays; lanes that are not active have t below 0.
template <class L, class R = typename L::Real>
void nearest_of_bundle(const FrozenScene<R>& scene, const Bundle<L>& bundle, RayLanes<L>& ray) {
  using F = typename L::F;
  Stack<L> stack;
  stack.push(0, 0, 0);
  R farthest = max_of(ray.t);
  while (!stack.empty()) {
    const Entry<R> entry = stack.pop();
    if (entry.t > farthest) continue;
    if (entry.leaf == 0) {
      const Node& node = scene.hierarchy.nodes[entry.child];
      const int before = stack.size();
      for (std::size_t k = 0; k < kNodeWidth; k += L::kWidth) {
        F near;
        const std::uint32_t met = bundle.meet(node, k, F(farthest), near);
        stack.push_met(node, k, met, near);
      }
      stack.sort_from(before);
      continue;
    }
    const std::int32_t count = entry.leaf % (2 * kNodeWidth);
    with_kind(scene, entry.leaf / (2 * kNodeWidth),
              [&]<class Shape>(const FrozenShapes<R, Shape>& shapes) {
                for (std::int32_t i = 0; i < count; ++i)
                  meet<L>(scene, shapes, entry.child + i, ray);
              });
    farthest = max_of(ray.t);
  }
}

/// Which of a bundle's rays meet anything nearer than their t; lanes that are not wanted have t
/// below 0.
template <class L, class R = typename L::Real>
typename L::M bundle_is_blocked(const FrozenScene<R>& scene, const Bundle<L>& bundle,
                                RayLanes<L> ray) {
  using F = typename L::F;
  Stack<L> stack;
  stack.push(0, 0, 0);
  typename L::M blocked = L::first(0);
  R farthest = max_of(ray.t);
  while (!stack.empty()) {
    const Entry<R> entry = stack.pop();
    if (entry.t > farthest) continue;
    if (entry.leaf == 0) {
      const Node& node = scene.hierarchy.nodes[entry.child];
      for (std::size_t k = 0; k < kNodeWidth; k += L::kWidth) {
        F near;
        const std::uint32_t met = bundle.meet(node, k, F(farthest), near);
        stack.push_met(node, k, met, near);
      }
      continue;
    }
    const std::int32_t count = entry.leaf % (2 * kNodeWidth);
    const auto before = blocked;
    with_kind(scene, entry.leaf / (2 * kNodeWidth),
              [&]<class Shape>(const FrozenShapes<R, Shape>& shapes) {
                for (std::int32_t i = 0; i < count; ++i) {
                  F shape[ShapeTraits<Shape>::kReals];
                  broadcast_shape<L>(shapes, entry.child + i, shape);
                  const F t = ShapeLanes<Shape, L>::intersect(shape, ray.origin, ray.direction);
                  blocked = either(blocked, both(t > F(0), t < ray.t));
                }
              });
    if (any(but_not(blocked, before))) {
      // A ray that is blocked needs no more.
      ray.t = select(blocked, F(-1), ray.t);
      farthest = max_of(ray.t);
      if (farthest < 0) break;
    }
  }
  return blocked;
}

/// Ray by ray what a function does for one: function(lane, origin, direction).
template <class L, class Function>
ZRAKA_INLINE void each_ray(const RayLanes<L>& ray, typename L::M active, const Function& function) {
  using R = typename L::Real;
  alignas(64) R o[3][L::kWidth], d[3][L::kWidth];
  L::store(ray.origin.x, o[0]), L::store(ray.origin.y, o[1]), L::store(ray.origin.z, o[2]);
  L::store(ray.direction.x, d[0]), L::store(ray.direction.y, d[1]), L::store(ray.direction.z, d[2]);
  for (std::uint32_t left = bits(active); left != 0; left &= left - 1) {
    const auto i = static_cast<std::size_t>(__builtin_ctz(left));
    function(i, V3<R>{o[0][i], o[1][i], o[2][i]}, V3<R>{d[0][i], d[1][i], d[2][i]});
  }
}

/// How rays travel: by their place in the picture or towards one light, or anywhere.
enum class Travel { together, apart };

/// The nearest hit of each active ray nearer than its t.
template <class L>
void nearest_in_hierarchy(const FrozenScene<typename L::Real>& scene, Travel travel,
                          typename L::M active, RayLanes<L>& ray) {
  using R = typename L::Real;
  using F = typename L::F;
  if (travel == Travel::together && L::kWidth > 1) {
    const Bundle<L> bundle(ray, active);
    if (bundle.coherent) {
      ray.t = select(active, ray.t, F(-1));
      nearest_of_bundle<L>(scene, bundle, ray);
      return;
    }
  }
  alignas(64) R t[L::kWidth];
  alignas(64) std::int32_t slot[L::kWidth];
  L::store(ray.t, t);
  L::store(ray.slot, slot);
  each_ray<L>(ray, active, [&](std::size_t i, const V3<R>& origin, const V3<R>& direction) {
    nearest_of_one<L>(scene, origin, direction, t[i], slot[i]);
  });
  ray.t = L::load(t);
  ray.slot = L::load(slot);
}

/// Which of the wanted rays meet anything nearer than their t.
template <class L>
typename L::M blocked_in_hierarchy(const FrozenScene<typename L::Real>& scene, Travel travel,
                                   typename L::M wanted, const RayLanes<L>& ray) {
  using R = typename L::Real;
  using F = typename L::F;
  if (travel == Travel::together && L::kWidth > 1) {
    const Bundle<L> bundle(ray, wanted);
    if (bundle.coherent) {
      RayLanes<L> bounded = ray;
      bounded.t = select(wanted, ray.t, F(-1));
      return both(bundle_is_blocked<L>(scene, bundle, bounded), wanted);
    }
  }
  alignas(64) R t[L::kWidth], blocked[L::kWidth] = {};
  L::store(ray.t, t);
  each_ray<L>(ray, wanted, [&](std::size_t i, const V3<R>& origin, const V3<R>& direction) {
    blocked[i] = one_is_blocked<L>(scene, origin, direction, t[i]) ? R(1) : R(0);
  });
  return L::load(blocked) > F(0);
}

/// The nearest hit of each active ray nearer than its t, by whichever structure the scene has.
template <class L>
ZRAKA_INLINE void find_nearest(const FrozenScene<typename L::Real>& scene, Travel travel,
                               typename L::M active, RayLanes<L>& ray) {
  if (scene.hierarchy.nodes == nullptr)
    nearest_in_list<L>(scene, ray);
  else
    nearest_in_hierarchy<L>(scene, travel, active, ray);
}

/// Which of the wanted rays meet anything nearer than their t, by whichever structure the scene
/// has.
template <class L>
ZRAKA_INLINE typename L::M find_blocked(const FrozenScene<typename L::Real>& scene, Travel travel,
                                        typename L::M wanted, const RayLanes<L>& ray) {
  if (scene.hierarchy.nodes == nullptr) return blocked_in_list<L>(scene, ray, wanted);
  return blocked_in_hierarchy<L>(scene, travel, wanted, ray);
}

}  // namespace zraka::ZRAKA_ISA
