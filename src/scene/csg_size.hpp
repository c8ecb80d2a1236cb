// SPDX-License-Identifier: Apache-2.0
// How much room a ray's way through a CSG body takes (accel/csg.hpp), to be asked before.
#pragma once

#include <string>
#include <zraka/bodies.hpp>

namespace zraka {

/// CSG shapes may be members of each other up to this depth.
inline constexpr int kMostCsgDepth = 64;

struct CsgSize {
  int crossings = 0;  ///< of all members
  int waiting = 0;    ///< operands, while the expression is worked out
  int depth = 1;      ///< of CSG in CSG
};
CsgSize size_of(const Csg& csg);

/// What is too much of it, "" where all fits.
std::string problem_of_size(const CsgSize& size);

/// What to do about it.
inline constexpr const char* kHintAtSize =
    "members that lie side by side can be CSG shapes of their own";

}  // namespace zraka
