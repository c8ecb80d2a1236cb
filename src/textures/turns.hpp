// SPDX-License-Identifier: Apache-2.0
// Colours that take turns along a line, with sharp borders.
#pragma once

#include <vector>

#include "math/vec.hpp"

namespace zraka {

/// How much of what is filtered replaces what is sharp, where a footprint is so many cells wide:
/// nothing up to half a cell, all of it from a cell on.
double share_of_filtered(double width);

/// The colour at x, where each has one unit; or, where a footprint of this width sees more than
/// one, their mean over it. So much below a border counts as above.
V3<double> color_in_turn(const std::vector<V3<double>>& colors, double x, double width,
                         double tolerance);

/// Of two that are 1 and -1.
double sign_in_turn(double x, double width, double tolerance);

}  // namespace zraka
