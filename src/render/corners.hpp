// SPDX-License-Identifier: Apache-2.0
// Pixels of the spd profile: the databases trace rays through the corners of pixels.
#pragma once

#include <cstddef>
#include <functional>
#include <zraka/image.hpp>

namespace zraka {

/// A pixel from its four corners.
inline float mean_of_corners(float upper_left, float upper_right, float lower_left,
                             float lower_right) {
  return ((upper_left + upper_right) + (lower_left + lower_right)) * 0.25f;
}

/// Calls work(index) for all indices below `count`, in any order, in any threads.
using DoAll =
    std::function<void(std::size_t count, const std::function<void(std::size_t index)>& work)>;

/// Pixels of one column and one row less, each the mean of the four around it; in the same memory.
Image means_of_corners(Image corners, const DoAll& do_all);

/// The same, by all threads.
Image means_of_corners(Image corners);

}  // namespace zraka
