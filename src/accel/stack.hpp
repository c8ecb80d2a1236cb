// SPDX-License-Identifier: Apache-2.0
// What rays of a bundle have still to visit on their way through the hierarchy.
#pragma once

#include <utility>

#include "accel/ray_lanes.hpp"

namespace zraka::ZRAKA_ISA {

/// Every node leaves at most fifteen children behind, and its last on top.
inline constexpr std::size_t kStackSize = kMaxNodeDepth * (kNodeWidth - 1) + kNodeWidth + 2;

/// A child that some rays of a bundle, a bit each, have still to visit.
template <class R>
struct BundleEntry {
  R t;  ///< how near the box begins for the first of them, where order counts
  std::int32_t child, leaf;
  std::uint32_t rays;
};

/// For rays that look for their nearest hit: of a node's children the nearest comes first.
template <class L>
class OrderedStack {
 public:
  static constexpr bool kOrdered = true;
  using R = typename L::Real;
  using F = typename L::F;
  using Entry = BundleEntry<R>;

  ZRAKA_INLINE bool empty() const { return size_ == 0; }
  ZRAKA_INLINE std::size_t size() const { return size_; }
  ZRAKA_INLINE Entry pop() { return entries_[--size_]; }
  ZRAKA_INLINE void push(const Entry& entry) { entries_[size_++] = entry; }
  /// Without a branch, for what cannot be foreseen; in no order.
  ZRAKA_INLINE void push_if(bool wanted, const Entry& entry) {
    entries_[size_] = entry;
    size_ += wanted ? 1 : 0;
  }
  /// The wanted ones of a node's children [k, k + kWidth), which begin at `nearest`, in order.
  ZRAKA_INLINE void push_children(const Node& node, std::size_t k, std::uint32_t wanted, F nearest,
                                  typename L::I rays) {
    alignas(64) std::int32_t rays_of[L::kWidth];
    alignas(64) R near[L::kWidth];
    L::store(rays, rays_of);
    L::store(nearest, near);
    Entry* const entries =
        entries_ +
        std::exchange(size_, size_ + static_cast<std::size_t>(__builtin_popcount(wanted)));
    for (std::uint32_t left = wanted; left != 0; left &= left - 1) {
      const auto lane = static_cast<std::size_t>(__builtin_ctz(left));
      // Above all that are farther, without a branch.
      const F mine(near[lane]);
      const std::uint32_t equal = bits(nearest == mine) & ~(left ^ (left - 1));
      entries[__builtin_popcount(wanted & (bits(nearest > mine) | equal))] = {
          near[lane], node.child[k + lane], node.leaf[k + lane],
          static_cast<std::uint32_t>(rays_of[lane])};
    }
  }
  /// Puts what has been pushed since the stack had this size in order, the nearest on top.
  ZRAKA_INLINE void sort_from(std::size_t start) {
    for (std::size_t i = start + 1; i < size_; ++i) {
      const Entry entry = entries_[i];
      std::size_t at = i;
      for (; at > start && entries_[at - 1].t < entry.t; --at) entries_[at] = entries_[at - 1];
      entries_[at] = entry;
    }
  }

 private:
  std::size_t size_ = 0;
  Entry entries_[kStackSize];
};

/// For rays that any hit will do for: column by column, so that a node's children are pushed at
/// once.
template <class L>
class UnorderedStack {
 public:
  static constexpr bool kOrdered = false;
  using Entry = BundleEntry<typename L::Real>;

  ZRAKA_INLINE bool empty() const { return size_ == 0; }
  ZRAKA_INLINE std::size_t size() const { return size_; }
  ZRAKA_INLINE Entry pop() {
    --size_;
    return {0, child_[size_], leaf_[size_], static_cast<std::uint32_t>(rays_[size_])};
  }
  /// An entry for no rays, if there is none.
  ZRAKA_INLINE Entry pop_if_any() { return empty() ? Entry{0, 0, 0, 0} : pop(); }
  ZRAKA_INLINE void push(const Entry& entry) { push_if(true, entry); }
  ZRAKA_INLINE void push_if(bool wanted, const Entry& entry) {
    child_[size_] = entry.child;
    leaf_[size_] = entry.leaf;
    rays_[size_] = static_cast<std::int32_t>(entry.rays);
    size_ += wanted ? 1 : 0;
  }
  ZRAKA_INLINE void push_children(const Node& node, std::size_t k, std::uint32_t wanted,
                                  typename L::F, typename L::I rays) {
    const typename L::M lanes = L::from_bits(wanted);
    L::compress_store(L::load(node.child + k), lanes, child_ + size_);
    L::compress_store(L::load(node.leaf + k), lanes, leaf_ + size_);
    L::compress_store(rays, lanes, rays_ + size_);
    size_ += static_cast<std::size_t>(__builtin_popcount(wanted));
  }
  ZRAKA_INLINE void sort_from(std::size_t) {}

  /// Whether what is pushed next lies on the stack; it does, but a test has to
  /// see it.
  bool fits() const { return size_ + L::kWidth <= kRoom; }

 private:
  // Who takes an entry ahead of its turn goes down in two places at once, and leaves as much behind
  // in each; besides, what is written beyond.
  static constexpr std::size_t kRoom = 2 * kStackSize + L::kWidth;
  std::size_t size_ = 0;
  std::int32_t child_[kRoom], leaf_[kRoom], rays_[kRoom];
};

}  // namespace zraka::ZRAKA_ISA
