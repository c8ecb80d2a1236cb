// SPDX-License-Identifier: Apache-2.0
// Pairs of a ray and a shape as they meet, a lane each.
#pragma once

#include "accel/bundle.hpp"
#include "accel/pair_queue.hpp"

namespace zraka::ZRAKA_ISA {

/// The numbers of the shapes that lanes name.
template <class L, class Shape>
ZRAKA_INLINE void gather_shapes(const FrozenShapes<typename L::Real, Shape>& shapes,
                                typename L::I which,
                                typename L::F (&out)[ShapeTraits<Shape>::kHitReals]) {
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

/// Up to a register of pairs.
template <class L>
struct MetPairs {
  typename L::F distance;  ///< not positive, or NaN, where they do not meet
  typename L::I ray;
  typename L::M active;       ///< the lanes that hold a pair
  const std::int32_t* shape;  ///< of each lane; until the next pairs are added
};

/// Takes the first pairs of a queue.
template <class L, class Shape>
ZRAKA_INLINE MetPairs<L> meet_pairs(const FrozenShapes<typename L::Real, Shape>& shapes,
                                    const Bundle<L>& bundle, PairQueue<L>& queue) {
  using I = typename L::I;
  const auto taken = queue.take();
  const typename L::M active = L::first(taken.count);
  const I ray = select(active, L::load(taken.ray), I(0));
  typename L::F shape[ShapeTraits<Shape>::kHitReals];
  gather_shapes<L>(shapes, select(active, L::load(taken.shape), I(0)), shape);
  return {ShapeLanes<Shape, L>::intersect(shape, bundle.origins(ray), bundle.directions(ray)), ray,
          active, taken.shape};
}

/// Whether that takes less time than either the rays in lanes or the shapes: a register of pairs
/// costs about 8/3 tests.
template <class L>
ZRAKA_INLINE bool better_as_pairs(std::uint32_t rays, std::int32_t shapes) {
  if (L::kWidth == 1) return false;
  constexpr int kWidth = static_cast<int>(L::kWidth);
  const int count = __builtin_popcount(rays);
  int registers = 0;
  for (std::size_t r = 0; r < kRegisters<L>; ++r) registers += in_register<L>(rays, r) != 0 ? 1 : 0;
  return 8 * count < 3 * kWidth * registers &&
         8 * shapes < 3 * kWidth * ((shapes + kWidth - 1) / kWidth);
}

}  // namespace zraka::ZRAKA_ISA
