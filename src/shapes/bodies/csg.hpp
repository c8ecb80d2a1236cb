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

/// The value of an expression of so many steps: step(i) is one, in_member(i) the value of a member,
/// and put_together(operation, a, b) that of an operation.
template <class Step, class InMember, class Together>
auto csg_value(int length, const Step& step, const InMember& in_member,
               const Together& put_together) {
  decltype(in_member(0)) waiting[kMostCsgWaiting];
  int count = 0;
  for (int i = 0; i < length; ++i) {
    const int of = step(i);
    if (of >= 0) {
      waiting[count++] = in_member(of);
      continue;
    }
    const int operands = csg_operands(of);
    count -= operands;
    auto all = waiting[count];
    for (int k = 1; k < operands; ++k)
      all = put_together(csg_operation_of(of), all, waiting[count + k]);
    waiting[count++] = all;
  }
  return waiting[0];
}

/// All that the expression of so few members may say fits the bits of one number: bit s is what it
/// says of a place in the members that are s' bits.
inline constexpr int kMostCsgTableMembers = 6;
inline std::uint64_t csg_table(const double* steps, int length, int members) {
  std::uint64_t table = 0;
  for (std::uint64_t s = 0; s < std::uint64_t{1} << members; ++s) {
    const bool inside = csg_value(
        length, [&](int i) { return static_cast<int>(steps[i]); },
        [&](int member) { return (s >> member & 1) != 0; },
        [](CsgOperation operation, bool a, bool b) {
          return operation == CsgOperation::unite       ? a || b
                 : operation == CsgOperation::intersect ? a && b
                                                        : a && !b;
        });
    if (inside) table |= std::uint64_t{1} << s;
  }
  return table;
}

/// A CSG body's numbers: how many members it has that are no CSG themselves, how long its
/// expression is, and the bits of csg_table() where there are few; then the members, as bodies;
/// then the expression, operands before operations (an index of a member, or csg_step()); then two
/// numbers of each member that say how much its own space loses to rounding.
struct CsgNumbers {
  const double* row;
  int members() const { return static_cast<int>(row[0]); }
  int length() const { return static_cast<int>(row[1]); }
  bool has_table() const { return members() <= kMostCsgTableMembers; }
  std::uint64_t table() const { return __builtin_bit_cast(std::uint64_t, row[2]); }
  std::int32_t member(int i) const { return static_cast<std::int32_t>(row[3 + i]); }
  int step(int i) const { return static_cast<int>(row[3 + members() + i]); }
  /// How much longer a vector may be in a member's own space, by their largest coordinates.
  double stretch(int i) const { return row[3 + members() + length() + 2 * i]; }
  /// The largest coordinate of a member's middle, times that.
  double shift(int i) const { return row[3 + members() + length() + 2 * i + 1]; }
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
