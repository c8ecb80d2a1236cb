// SPDX-License-Identifier: Apache-2.0
// Pairs of a ray and a shape as they hit, a lane each.
#pragma once

#include "accel/bundle.hpp"
#include "accel/pair_queue.hpp"

namespace zraka::ZRAKA_ISA {

/// The numbers of the shapes that lanes name.
template <class L, class Shape>
ZRAKA_INLINE void gather_shapes(const FrozenShapes<typename L::Real, Shape>& shapes,
                                typename L::I which,
                                NumbersOf<Shape, L>& out) {
  if constexpr (std::is_same_v<Shape, Body>) {
    out = {&shapes, which};
  } else {
    constexpr int kHitReals = ShapeTraits<Shape>::kHitReals;
    if (shapes.rows == nullptr) {
      for (int k = 0; k < kHitReals; ++k) out[k] = L::gather(shapes.column[k], which);
      return;
    }
    const typename L::I row = which * typename L::I(shapes.kRowReals);
    for (int k = 0; k < kHitReals; k += 4) {
      typename L::F four[4];
      L::gather_four(shapes.rows + k, row, four);
      for (int i = 0; i < 4 && k + i < kHitReals; ++i) out[k + i] = four[i];
    }
  }
}

/// Up to a register of pairs.
template <class L>
struct MetPairs {
  typename L::F distance;  ///< not positive, or NaN, where they do not hit
  typename L::I ray;
  typename L::M active;       ///< the lanes that hold a pair
  const std::int32_t* shape;  ///< of each lane; until the next pairs are added
};

/// Takes the first pairs of a queue. Rays look no farther than their t; for any hit with kAny.
template <bool kAny, class L, class Shape>
ZRAKA_INLINE MetPairs<L> intersect_pairs(const FrozenShapes<typename L::Real, Shape>& shapes,
                                         const Bundle<L>& bundle, PairQueue<L>& queue,
                                         const typename L::Real* t) {
  using I = typename L::I;
  const auto taken = queue.take();
  const typename L::M active = L::first(taken.count);
  const I ray = select(active, L::load(taken.ray), I(0));
  NumbersOf<Shape, L> shape;
  gather_shapes<L>(shapes, select(active, L::load(taken.shape), I(0)), shape);
  using F = typename L::F;
  F limit(0);
  if constexpr (std::is_same_v<Shape, Body>) limit = select(active, L::look_up(t, ray), F(-1));
  return {intersect_shape<kAny, Shape, L>(shape, bundle.origins(ray), bundle.directions(ray),
                                          limit),
          ray, active, taken.shape};
}

/// Whether they take less time than either rays in lanes, so many in so many registers, or shapes:
/// a register of pairs costs about 8/3 tests.
template <class L>
ZRAKA_INLINE constexpr bool pairs_take_less(int rays, int registers, int shapes) {
  constexpr int kWidth = static_cast<int>(L::kWidth);
  return 8 * rays < 3 * kWidth * registers &&
         8 * shapes < 3 * kWidth * ((shapes + kWidth - 1) / kWidth);
}

/// The most pairs of a leaf for which they take less.
template <class L>
constexpr std::size_t most_pairs_of_a_leaf() {
  int most = 0;
  for (int rays = 1; rays <= static_cast<int>(RayGroup<L>::kRays); ++rays)
    for (int shapes = 1; shapes <= kNodeWidth; ++shapes)
      if (pairs_take_less<L>(rays, kRegisters<L>, shapes)) most = std::max(most, rays * shapes);
  return static_cast<std::size_t>(most);
}

/// Whether a leaf's rays and shapes are to wait as pairs.
template <class L>
ZRAKA_INLINE bool better_as_pairs(std::uint32_t rays, std::int32_t shapes) {
  static_assert(most_pairs_of_a_leaf<L>() <= PairQueue<L>::kMostAtOnce);
  if (L::kWidth == 1) return false;
  int registers = 0;
  for (std::size_t r = 0; r < kRegisters<L>; ++r) registers += in_register<L>(rays, r) != 0 ? 1 : 0;
  return pairs_take_less<L>(__builtin_popcount(rays), registers, shapes);
}

}  // namespace zraka::ZRAKA_ISA
