// SPDX-License-Identifier: Apache-2.0
// What the colours of particles mean, beside their picture.
#pragma once

#include <string>
#include <vector>
#include <zraka/formats.hpp>
#include <zraka/image.hpp>
#include <zraka/render.hpp>

namespace zraka::app {

/// The numbers that a legend names: round ones, some four to eight, from low to high.
std::vector<double> legend_ticks(double low, double high);

/// A picture with a strip to its right, of the background's colour, that has a bar of colours with
/// numbers for each legend; the picture's own pixels stay where they are. Fails where there is no
/// font.
Result<Image> with_legends(const Image& picture, const std::vector<ColorLegend>& legends,
                           const Color& background, Transfer transfer);

}  // namespace zraka::app
