// SPDX-License-Identifier: Apache-2.0
// Pairs of a ray and a shape that have still to hit: where few rays of a bundle come to a leaf of
// few shapes, neither fill a register, but pairs from several leaves do.
#pragma once

#include <algorithm>

#include "accel/ray_lanes.hpp"

namespace zraka::ZRAKA_ISA {

/// What few rays of a bundle have hit of a node's children.
template <class L>
struct FewRays {
  /// For so few rays what all have in common costs as much as each ray's own test.
  static constexpr std::size_t kMost = 6;
  std::int32_t ray[kMost];   ///< its number in the bundle
  std::uint32_t hit[kMost];  ///< a bit for each lane's child
  std::size_t count = 0;
};

/// The pairs with shapes of one kind, first in, first out.
template <class L>
class PairQueue {
 public:
  /// What may be added before any are taken: the pairs of one node's leaves, or of one leaf.
  static constexpr std::size_t kMostAtOnce = kMostInSmallLeaf * kNodeWidth * FewRays<L>::kMost;

  /// Whether there are enough for a register; or any at all, if all are to be taken.
  ZRAKA_INLINE bool ready(bool all) const { return end_ - begin_ >= (all ? 1 : L::kWidth); }

  /// Adds each of the rays, a bit each, with `count` shapes from the first on: kMostAtOnce pairs at
  /// most. There must be less than a register of others.
  ZRAKA_INLINE void add(std::uint32_t rays, std::int32_t first, std::int32_t count) {
    make_room();
    typename L::I numbers[kRegisters<L>];
    std::size_t n[kRegisters<L>];
    for (std::size_t r = 0; r < kRegisters<L>; ++r) {
      n[r] = static_cast<std::size_t>(__builtin_popcount(in_register<L>(rays, r)));
      numbers[r] =
          L::compress(L::iota(static_cast<std::int32_t>(r * L::kWidth)), lanes_of<L>(rays, r));
    }
    std::size_t end = end_;
    for (std::int32_t shape = first; shape < first + count; ++shape) {
      const std::size_t start = end;
      for (std::size_t r = 0; r < kRegisters<L>; end += n[r++]) L::store(numbers[r], ray_ + end);
      for (std::size_t at = start; at < end; at += L::kWidth)
        L::store(typename L::I(shape), shape_ + at);
    }
    end_ = end;
  }

  /// Adds each of the rays with those shapes in lanes that are among `wanted` and that it has hit:
  /// those of one node, before which there must be less than a register of others.
  ZRAKA_INLINE void add(const FewRays<L>& rays, std::uint32_t wanted, typename L::I shapes) {
    make_room();
    std::size_t end = end_;
    for (std::size_t r = 0; r < rays.count; ++r) {
      const std::uint32_t lanes = rays.hit[r] & wanted;
      L::store(typename L::I(rays.ray[r]), ray_ + end);
      L::compress_store(shapes, L::from_bits(lanes), shape_ + end);
      end += static_cast<std::size_t>(__builtin_popcount(lanes));
    }
    end_ = end;
  }

  /// The first pairs, up to a register of them; they stay where they are until more are added.
  struct Taken {
    std::size_t count;
    const std::int32_t *ray, *shape;
  };
  ZRAKA_INLINE Taken take() {
    const std::size_t at = begin_, n = std::min(end_ - begin_, L::kWidth);
    begin_ += n;
    return {n, ray_ + at, shape_ + at};
  }

  /// Whether all that was written so far lies in the queue; it does, but a test has to see it.
  bool fits() const { return end_ + L::kWidth <= kRoom; }

 private:
  /// What may be there: less than a register, what is added at once, and what is written beyond.
  static constexpr std::size_t kLongest = 2 * L::kWidth + kMostAtOnce;
  static constexpr std::size_t kRoom = 2 * kLongest;

  /// Moves what is there, less than a register, to the front where room ends. (Between the shapes
  /// of one node nothing is taken, so it is done before the first of them, if at all.)
  ZRAKA_INLINE void make_room() {
    if (begin_ + kLongest <= kRoom) return;
    L::store(L::load(ray_ + begin_), ray_);
    L::store(L::load(shape_ + begin_), shape_);
    end_ -= begin_;
    begin_ = 0;
  }

  std::size_t begin_ = 0, end_ = 0;
  alignas(64) std::int32_t ray_[kRoom];
  alignas(64) std::int32_t shape_[kRoom];
};

/// A queue for each kind of shape.
template <class L>
struct Pairs {
  static constexpr std::uint32_t kAllKinds = (1u << kKinds) - 1;
  PairQueue<L> of_kind[kKinds];

  /// Adds each of the rays with each shape of a leaf. Returns the kind's bit if there are then
  /// enough of its pairs for a register.
  ZRAKA_INLINE std::uint32_t add_leaf(std::uint32_t rays, std::int32_t first, std::int32_t leaf) {
    PairQueue<L>& queue = of_kind[leaf_kind(leaf)];
    queue.add(rays, first, leaf_count(leaf));
    return queue.ready(false) ? 1u << leaf_kind(leaf) : 0;
  }
};

}  // namespace zraka::ZRAKA_ISA
