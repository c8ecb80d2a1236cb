// SPDX-License-Identifier: Apache-2.0
// Constructive solid geometry as it is frozen: an expression over members (accel/csg.hpp has the
// rays).
#pragma once

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

template <>
struct ShapeTraits<Csg> {
  static constexpr const char* kName = "csg";
  static constexpr const char* kNouns[2][4] = {
      {"compound solid", "compound solid", "compound solid", "compound solid"},
      {"složeno tijelo", "složeno tijelo", "složenog tijela", "složenom tijelu"}};
  static constexpr bool kClosed = true, kComposed = true;
};

}  // namespace zraka
