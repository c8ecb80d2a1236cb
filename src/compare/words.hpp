// SPDX-License-Identifier: Apache-2.0
// A comparison in words, the same on the terminal and in the page.
#pragma once

#include <string>
#include <utility>
#include <vector>
#include <zraka/compare.hpp>

namespace zraka {

/// A difference of values of 0…1 in steps of 1/255; where it is a whole number but for the rounding
/// of floats, it is given as one.
double steps_of(double difference);

/// A pixel's values: of 255 or 65535 for integers, as they are for floats.
std::string values_of(const std::array<float, 3>& pixel, int bits, bool floats);

/// "400 × 400 pixels, PNG with 8 bits"
std::string describe(const ReadImage& picture);

/// One sentence: equal, within the tolerance, or by how much not.
std::string verdict_on(const Comparison& comparison);

/// Labels and values, in the order to show them: the pictures and the measures, and then the
/// pixels.
using Lines = std::vector<std::pair<std::string, std::string>>;
Lines measure_lines(const Comparison& comparison, const std::string& a_name,
                    const std::string& b_name);
Lines pixel_lines(const Comparison& comparison);

}  // namespace zraka
