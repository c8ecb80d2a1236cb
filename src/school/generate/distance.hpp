// SPDX-License-Identifier: Apache-2.0
// Distances inside a drawn shape.
#pragma once

#include <vector>

#include "school/glyphs/font.hpp"

namespace zraka {

/// For each pixel with at least half coverage the distance, in pixels, from its centre to the
/// centre of the nearest pixel outside; 0 outside. What lies beyond the picture's edge counts as
/// outside. The exact Euclidean transform of Felzenszwalb and Huttenlocher, "Distance Transforms of
/// Sampled Functions" (2012).
std::vector<float> distance_inside(const Coverage& shape);

}  // namespace zraka
