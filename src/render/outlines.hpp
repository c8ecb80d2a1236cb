// SPDX-License-Identifier: Apache-2.0
// Which pixels an outline goes over: from the first hits of rays through pixels side by side.
#pragma once

#include <vector>

#include "render/layers.hpp"

namespace zraka {

/// Marks those of `part` of the whole picture, row by row, that lines go over which are as wide as
/// the options say. A line is where two pixels side by side see different objects (triangles are
/// all one), or where the same has an edge or a gap between them. What is beyond the picture's
/// border is not asked, so that a crop has the lines of the whole. False if it was cancelled.
template <class R>
bool find_outlines(const LayerPass<R>& pass, const TileRect& part, std::vector<bool>& lines);

}  // namespace zraka
