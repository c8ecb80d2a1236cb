// SPDX-License-Identifier: Apache-2.0
// From the double that a scene is read in to the numbers that it is traced in.
#pragma once

#include <algorithm>
#include <limits>
#include <zraka/values.hpp>

#include "math/vec.hpp"

namespace zraka {

/// The nearest value of R, the largest one for what is out of its range.
template <class R>
R narrow(double v) {
  constexpr double kLargest = std::numeric_limits<R>::max();
  return static_cast<R>(std::clamp(v, -kLargest, kLargest));
}

template <class R>
V3<R> narrow(const Vec3& v) {
  return {narrow<R>(v.x), narrow<R>(v.y), narrow<R>(v.z)};
}

template <class R>
V3<R> narrow(const Color& c) {
  return {narrow<R>(c.r), narrow<R>(c.g), narrow<R>(c.b)};
}

}  // namespace zraka
