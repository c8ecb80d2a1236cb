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

/// A CSG body's numbers: how many members it has that are no CSG themselves, how long its
/// expression is, and the bits of csg_table() where there are few; then the members, as bodies;
/// then the expression, operands before operations (an index of a member, or csg_step()).
struct CsgNumbers {
  const double* row;
  int members() const { return static_cast<int>(row[0]); }
  int length() const { return static_cast<int>(row[1]); }
  bool has_table() const { return members() <= kMostCsgTableMembers; }
  std::uint64_t table() const { return __builtin_bit_cast(std::uint64_t, row[2]); }
  std::int32_t member(int i) const { return static_cast<std::int32_t>(row[3 + i]); }
  int step(int i) const { return static_cast<int>(row[3 + members() + i]); }
};

/// Whether what a table says is nothing outside of a member.
inline bool csg_needs(std::uint64_t table, int member) {
  constexpr std::uint64_t kWithout[kMostCsgTableMembers] = {
      0x5555555555555555, 0x3333333333333333, 0x0F0F0F0F0F0F0F0F,
      0x00FF00FF00FF00FF, 0x0000FFFF0000FFFF, 0x00000000FFFFFFFF};
  return (table & kWithout[member]) == 0;
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
