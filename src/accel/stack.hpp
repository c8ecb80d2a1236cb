// SPDX-License-Identifier: Apache-2.0
// What is still to be visited on the way through the hierarchy.
#pragma once

#include <utility>

#include "math/inline.hpp"
#include "scene/hierarchy.hpp"

namespace zraka::ZRAKA_ISA {

/// Every node leaves at most fifteen children behind, and its last on top.
inline constexpr int kStackSize = kMaxNodeDepth * (kNodeWidth - 1) + kNodeWidth + 2;

/// The next to be visited is on top. E has a member t, how near it begins.
template <class E>
class Stack {
 public:
  ZRAKA_INLINE bool empty() const { return size_ == 0; }
  ZRAKA_INLINE int size() const { return size_; }
  ZRAKA_INLINE E pop() { return entries_[--size_]; }
  ZRAKA_INLINE void push(const E& entry) { entries_[size_++] = entry; }
  /// Room for so many entries on top, which the caller fills.
  ZRAKA_INLINE E* extend(int entries) { return entries_ + std::exchange(size_, size_ + entries); }
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

}  // namespace zraka::ZRAKA_ISA
