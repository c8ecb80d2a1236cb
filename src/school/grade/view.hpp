// SPDX-License-Identifier: Apache-2.0
// A picture of another view may have the right one in its middle, or be a part of it.
#pragma once

#include <array>
#include <vector>

#include "school/grade/align.hpp"

namespace zraka {

/// Leaves out where what was handed in goes on beyond the right picture as a scene does: whoever
/// cuts or frames a picture has nothing of the scene around it. Keeps the whole at least.
void leave_out_other_views(std::vector<Fitted>& fitted, const Image& silhouette,
                           const std::array<float, 3>& background);

}  // namespace zraka
