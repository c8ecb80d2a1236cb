// SPDX-License-Identifier: Apache-2.0
// Constructive solid geometry as it is frozen: an expression over members (accel/csg.hpp has the
// rays).
#pragma once

#include <cstdint>

#include "shapes/bodies/body.hpp"

namespace zraka {

/// Crossings that all members of a CSG body may have together.
inline constexpr int kMostCsgCrossings = 512;
/// Operands that its expression may wait with.
inline constexpr int kMostCsgWaiting = 64;

/// A step of an expression that puts the last operands together; steps from 0 on are members.
inline int csg_step(CsgOperation operation, int operands) {
  return -1 - (static_cast<int>(operation) + 3 * operands);
}
inline CsgOperation csg_operation_of(int step) {
  return static_cast<CsgOperation>((-1 - step) % 3);
}
inline int csg_operands(int step) {
  return (-1 - step) / 3;
}

/// What an expression says of a place that is in those members whose bits are set, of 64 at most.
inline bool csg_says(const double* steps, int length, std::uint64_t in_members) {
  bool waiting[kMostCsgWaiting];
  int count = 0;
  for (int i = 0; i < length; ++i) {
    const int step = static_cast<int>(steps[i]);
    if (step >= 0) {
      waiting[count++] = (in_members >> step & 1) != 0;
      continue;
    }
    count -= csg_operands(step);
    bool all = waiting[count];
    for (int k = 1; k < csg_operands(step); ++k) {
      const bool next = waiting[count + k];
      const CsgOperation operation = csg_operation_of(step);
      all = operation == CsgOperation::unite       ? all || next
            : operation == CsgOperation::intersect ? all && next
                                                   : all && !next;
    }
    waiting[count++] = all;
  }
  return waiting[0];
}

/// All that the expression of so few members may say fits the bits of one number: bit s is what it
/// says of a place in the members that are s' bits.
inline constexpr int kMostCsgTableMembers = 6;
inline std::uint64_t csg_table(const double* steps, int length, int members) {
  std::uint64_t table = 0;
  for (std::uint64_t s = 0; s < std::uint64_t{1} << members; ++s)
    if (csg_says(steps, length, s)) table |= std::uint64_t{1} << s;
  return table;
}

template <>
struct ShapeTraits<Csg> {
  static constexpr const char* kName = "csg";
  static constexpr const char* kNouns[2][4] = {
      {"compound solid", "compound solid", "compound solid", "compound solid"},
      {"složeno tijelo", "složeno tijelo", "složenog tijela", "složenom tijelu"}};
  static constexpr bool kClosed = true, kComposed = true;
};

}  // namespace zraka
