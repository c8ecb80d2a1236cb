// SPDX-License-Identifier: Apache-2.0
// Numbers of an array at the indices that lanes name: one load or store where the indices follow
// one another, as they mostly do.
#pragma once

#include "math/lanes.hpp"

namespace zraka::ZRAKA_ISA {

template <class L>
struct Indices {
  using R = typename L::Real;
  using F = typename L::F;
  using I = typename L::I;
  using M = typename L::M;
  I index;
  std::int32_t first;
  bool run;  ///< lane i's index is first + i

  ZRAKA_INLINE explicit Indices(I lanes)
      : index(lanes), first(first_lane(lanes)), run(all(lanes == L::iota(first))) {}

  template <class T>
  ZRAKA_INLINE auto load(const T* array) const {
    return run ? L::load(array + first) : L::gather(array, index);
  }
  /// The wanted lanes; all lanes' indices must exist.
  ZRAKA_INLINE void store(F v, M wanted, R* array) const {
    if (run && all(wanted))
      L::store(v, array + first);
    else
      L::scatter(v, wanted, array, index);
  }
};

}  // namespace zraka::ZRAKA_ISA
