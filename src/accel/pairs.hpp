// SPDX-License-Identifier: Apache-2.0
// Pairs of a ray and a shape that have still to meet: where few rays of a bundle come to a leaf of
// few shapes, neither fill a register, but pairs from several leaves do.
#pragma once

#include <algorithm>

#include "accel/bundle.hpp"

namespace zraka::ZRAKA_ISA {

/// The most numbers that an intersection needs, of all kinds of shapes.
#define ZRAKA_HIT_REALS(Type, plural) ShapeTraits<Type>::kHitReals,
inline constexpr int kMostHitReals = std::max({ZRAKA_KINDS(ZRAKA_HIT_REALS) 0});
#undef ZRAKA_HIT_REALS

/// The pairs with shapes of one kind, first in, first out.
template <class L>
class PairQueue {
 public:
  using R = typename L::Real;
  using F = typename L::F;

  ZRAKA_INLINE bool empty() const { return end_ == begin_; }
  /// Enough for a register.
  ZRAKA_INLINE bool full() const { return end_ - begin_ >= L::kWidth; }

  /// Adds a shape's pairs with each of the rays; the queue must not be full. The shape's numbers
  /// are written for each of them now, which takes less time than to gather them lane by lane
  /// later.
  template <class Shape>
  ZRAKA_INLINE void add(const FrozenShapes<R, Shape>& shapes, std::int32_t shape,
                        std::uint32_t rays) {
    if (begin_ + kLongest > kRoom) move_to_front<Shape>();
    std::size_t end = end_;
    for (std::size_t r = 0; r < kRegisters<L>; ++r) {
      const typename L::M mine = lanes_of<L>(rays, r);
      L::compress_store(L::iota(static_cast<std::int32_t>(r * L::kWidth)), mine, ray_ + end);
      end += count(mine);
    }
    for (std::size_t at = end_; at < end; at += L::kWidth) {
      L::store(typename L::I(shape), shape_ + at);
      for (int k = 0; k < ShapeTraits<Shape>::kHitReals; ++k)
        L::store(F(shapes.column[k][shape]), numbers_[k] + at);
    }
    end_ = end;
  }

  /// The first pairs, up to a register of them, as they meet.
  struct Met {
    F distance;  ///< not positive, or NaN, where they do not
    typename L::I ray;
    typename L::M active;       ///< the lanes that hold a pair
    const std::int32_t* shape;  ///< of each lane; until the next pairs are added
  };
  template <class Shape>
  ZRAKA_INLINE Met take(const Bundle<L>& bundle) {
    const std::size_t at = begin_, n = end_ - begin_;
    begin_ += std::min(n, L::kWidth);
    const typename L::M active = L::first(n);
    const typename L::I ray = select(active, L::load(ray_ + at), typename L::I(0));
    F shape[ShapeTraits<Shape>::kHitReals];
    for (int k = 0; k < ShapeTraits<Shape>::kHitReals; ++k) shape[k] = L::load(numbers_[k] + at);
    const F distance =
        ShapeLanes<Shape, L>::intersect(shape, bundle.origins(ray), bundle.directions(ray));
    return {distance, ray, active, shape_ + at};
  }

 private:
  /// What may be written from begin_ on: a register but one, all rays, and what is written beyond.
  static constexpr std::size_t kLongest = 2 * L::kWidth + RayGroup<L>::kRays;
  static constexpr std::size_t kRoom = kLongest + 6 * L::kWidth;

  template <class Shape>
  ZRAKA_INLINE void move_to_front() {
    L::store(L::load(ray_ + begin_), ray_);
    L::store(L::load(shape_ + begin_), shape_);
    for (int k = 0; k < ShapeTraits<Shape>::kHitReals; ++k)
      L::store(L::load(numbers_[k] + begin_), numbers_[k]);
    end_ -= begin_;
    begin_ = 0;
  }

  std::size_t begin_ = 0, end_ = 0;
  alignas(64) std::int32_t ray_[kRoom];
  alignas(64) std::int32_t shape_[kRoom];
  alignas(64) R numbers_[kMostHitReals][kRoom];
};

/// A queue for each kind of shape.
template <class L>
struct Pairs {
  PairQueue<L> of_kind[kKinds];
};

/// Whether that takes less time than either the rays in lanes or the shapes: a register of pairs
/// costs about 8/3 tests.
template <class L>
ZRAKA_INLINE bool better_as_pairs(std::uint32_t rays, std::int32_t shapes) {
  if (L::kWidth == 1) return false;
  constexpr int kWidth = static_cast<int>(L::kWidth);
  const int count = __builtin_popcount(rays);
  int with_rays_in_lanes = 0;
  for (std::size_t r = 0; r < kRegisters<L>; ++r)
    with_rays_in_lanes += in_register<L>(rays, r) != 0 ? shapes : 0;
  const int with_shapes_in_lanes = count * ((shapes + kWidth - 1) / kWidth);
  return 8 * count * shapes < 3 * kWidth * std::min(with_rays_in_lanes, with_shapes_in_lanes);
}

}  // namespace zraka::ZRAKA_ISA
