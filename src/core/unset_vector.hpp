// SPDX-License-Identifier: Apache-2.0
// Large arrays that their writers touch first.
#pragma once

#include <memory>
#include <utility>
#include <vector>

namespace zraka {

/// Leaves new elements of plain types unset.
template <class T>
struct UnsetAllocator : std::allocator<T> {
  template <class U>
  struct rebind {
    using other = UnsetAllocator<U>;
  };
  using std::allocator<T>::allocator;
  template <class U>
  void construct(U* at) {
    ::new (static_cast<void*>(at)) U;
  }
  template <class U, class... Values>
  void construct(U* at, Values&&... values) {
    ::new (static_cast<void*>(at)) U(std::forward<Values>(values)...);
  }
};

/// A vector whose resize() takes memory and does not touch it: many threads that fill it then share
/// what the system takes for new memory, which is more than filling it.
template <class T>
using UnsetVector = std::vector<T, UnsetAllocator<T>>;

}  // namespace zraka
