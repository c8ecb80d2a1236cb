// SPDX-License-Identifier: Apache-2.0
// One ray through the hierarchy: against sixteen boxes and sixteen shapes at a time.
#pragma once

#include "accel/ray_lanes.hpp"
#include "scene/hierarchy.hpp"

namespace zraka::ZRAKA_ISA {

/// Parts of Node::leaf.
ZRAKA_INLINE std::int32_t leaf_count(std::int32_t leaf) {
  return leaf % (2 * kNodeWidth);
}
ZRAKA_INLINE std::int32_t leaf_kind(std::int32_t leaf) {
  return leaf / (2 * kNodeWidth);
}

/// Every node leaves at most fifteen children behind, and its last on top.
inline constexpr int kStackSize = kMaxNodeDepth * (kNodeWidth - 1) + kNodeWidth + 2;

/// A child that is still to be visited, and how near its box begins.
template <class R>
struct Entry {
  R t;
  std::int32_t child, leaf;
};

/// What is still to be visited, the next on top.
template <class E>
class Stack {
 public:
  ZRAKA_INLINE bool empty() const { return size_ == 0; }
  ZRAKA_INLINE int size() const { return size_; }
  ZRAKA_INLINE E pop() { return entries_[--size_]; }
  ZRAKA_INLINE void push(const E& entry) { entries_[size_++] = entry; }
  /// Without a branch, for what cannot be foreseen.
  ZRAKA_INLINE void push_if(bool wanted, const E& entry) {
    entries_[size_] = entry;
    size_ += wanted ? 1 : 0;
  }
  /// Puts what has been pushed since the stack had this size in order, the nearest on top.
  ZRAKA_INLINE void sort_from(int start) {
    for (int i = start + 1; i < size_; ++i) {
      const E entry = entries_[i];
      int at = i;
      for (; at > start && entries_[at - 1].t < entry.t; --at) entries_[at] = entries_[at - 1];
      entries_[at] = entry;
    }
  }

 private:
  int size_ = 0;
  E entries_[kStackSize];
};

/// 1/d with a large number for 1/0; boxes are larger than what that errs.
template <class F>
ZRAKA_INLINE F slab_inverse(F d) {
  const F tiny(0x1p-60f);
  return F(1) / select(abs(d) < tiny, select(d < F(0), -tiny, tiny), d);
}

/// One ray, the same in all lanes.
template <class L>
struct SingleRay {
  using R = typename L::Real;
  using F = typename L::F;
  V3<F> origin, direction, inverse, scaled;  ///< scaled: origin·inverse
  bool back_x, back_y, back_z;

  ZRAKA_INLINE SingleRay(const V3<R>& o, const V3<R>& d, const V3<R>& inv)
      : origin{F(o.x), F(o.y), F(o.z)},
        direction{F(d.x), F(d.y), F(d.z)},
        inverse{F(inv.x), F(inv.y), F(inv.z)},
        scaled(origin * inverse),
        back_x(inv.x < 0),
        back_y(inv.y < 0),
        back_z(inv.z < 0) {}

  /// Which of the boxes [k, k + kWidth) are met before `limit`, and where.
  ZRAKA_INLINE std::uint32_t meet(const Node& node, std::size_t k, F limit, F& t) const {
    const auto at = [&](const float* side, F i, F s) {
      return roughly_mul_sub(L::load_box(side + k), i, s);
    };
    const F x0 = at(back_x ? node.upper_x : node.lower_x, inverse.x, scaled.x);
    const F y0 = at(back_y ? node.upper_y : node.lower_y, inverse.y, scaled.y);
    const F z0 = at(back_z ? node.upper_z : node.lower_z, inverse.z, scaled.z);
    const F x1 = at(back_x ? node.lower_x : node.upper_x, inverse.x, scaled.x);
    const F y1 = at(back_y ? node.lower_y : node.upper_y, inverse.y, scaled.y);
    const F z1 = at(back_z ? node.lower_z : node.upper_z, inverse.z, scaled.z);
    t = max(max(x0, y0), max(z0, F(0)));
    return bits(t <= min(min(x1, y1), min(z1, limit)));
  }

  /// Pushes the children that are met before `limit`.
  template <class S>
  ZRAKA_INLINE void push_children(const Node& node, R limit, S& stack) const {
    for (std::size_t k = 0; k < kNodeWidth; k += L::kWidth) {
      F t;
      std::uint32_t met = meet(node, k, F(limit), t);
      if (met == 0) continue;
      alignas(64) R near[L::kWidth];
      L::store(t, near);
      for (; met != 0; met &= met - 1) {
        const auto i = static_cast<std::size_t>(__builtin_ctz(met));
        stack.push({near[i], node.child[k + i], node.leaf[k + i]});
      }
    }
  }
};

/// Distances to the shapes of a leaf, kWidth at a time: function(first, distances, which of them
/// count).
template <class L, class R, class Function>
ZRAKA_INLINE void distances_in_leaf(const FrozenScene<R>& scene, const SingleRay<L>& ray,
                                    std::int32_t child, std::int32_t leaf,
                                    const Function& function) {
  const auto count = static_cast<std::size_t>(leaf_count(leaf));
  with_kind(scene, leaf_kind(leaf), [&]<class Shape>(const FrozenShapes<R, Shape>& shapes) {
    for (std::size_t k = 0; k < count; k += L::kWidth) {
      const std::int32_t first = child + static_cast<std::int32_t>(k);
      typename L::F shape[ShapeTraits<Shape>::kHitReals];
      load_shapes<L>(shapes, first, shape);
      function(shapes.first_slot + first,
               ShapeLanes<Shape, L>::intersect(shape, ray.origin, ray.direction),
               L::first(count - k));
    }
  });
}

/// The nearest hit in a leaf, if it is nearer than t.
template <class L, class R = typename L::Real>
ZRAKA_INLINE void nearest_in_leaf(const FrozenScene<R>& scene, const SingleRay<L>& ray,
                                  std::int32_t child, std::int32_t leaf, R& t, std::int32_t& slot) {
  using F = typename L::F;
  distances_in_leaf<L>(scene, ray, child, leaf,
                       [&](std::int32_t first, F distance, typename L::M exists) {
                         const auto nearer = both(both(distance > F(0), distance <= F(t)), exists);
                         if (!any(nearer)) return;
                         const R least = min_of(select(nearer, distance, F(kFarAway<R>)));
                         for (std::uint32_t equal = bits(both(nearer, distance <= F(least)));
                              equal != 0; equal &= equal - 1) {
                           // Of equal hits the shape that was read first counts, in whatever order
                           // they are found.
                           const std::int32_t found = first + __builtin_ctz(equal);
                           if (least < t || slot < 0 || id_of(scene, found) < id_of(scene, slot))
                             slot = found;
                           t = least;
                         }
                       });
}

template <class L, class R = typename L::Real>
ZRAKA_INLINE bool blocked_in_leaf(const FrozenScene<R>& scene, const SingleRay<L>& ray,
                                  std::int32_t child, std::int32_t leaf, R t) {
  using F = typename L::F;
  bool blocked = false;
  distances_in_leaf<L>(
      scene, ray, child, leaf, [&](std::int32_t, F distance, typename L::M exists) {
        blocked = blocked || any(both(both(distance > F(0), distance < F(t)), exists));
      });
  return blocked;
}

/// The nearest hit of one ray below a node, if it is nearer than t.
template <class L, class R = typename L::Real>
void nearest_of_one(const FrozenScene<R>& scene, const SingleRay<L>& ray, std::int32_t node, R& t,
                    std::int32_t& slot) {
  Stack<Entry<R>> stack;
  stack.push({0, node, 0});
  while (!stack.empty()) {
    const Entry<R> entry = stack.pop();
    if (entry.t > t) continue;
    if (entry.leaf != 0) {
      nearest_in_leaf<L>(scene, ray, entry.child, entry.leaf, t, slot);
      continue;
    }
    const int before = stack.size();
    ray.push_children(scene.hierarchy.nodes[entry.child], t, stack);
    stack.sort_from(before);
  }
}

/// Does one ray meet anything below a node, nearer than t?
template <class L, class R = typename L::Real>
bool one_is_blocked(const FrozenScene<R>& scene, const SingleRay<L>& ray, std::int32_t node, R t) {
  Stack<Entry<R>> stack;
  stack.push({0, node, 0});
  while (!stack.empty()) {
    const Entry<R> entry = stack.pop();
    if (entry.leaf == 0)
      ray.push_children(scene.hierarchy.nodes[entry.child], t, stack);
    else if (blocked_in_leaf<L>(scene, ray, entry.child, entry.leaf, t))
      return true;
  }
  return false;
}

}  // namespace zraka::ZRAKA_ISA
