// SPDX-License-Identifier: Apache-2.0
// From the general engine's arrays to a RayTree.
#pragma once

#include <optional>

#include "explain/tree_reader.hpp"

namespace zraka {

/// The tree of one sample, each of its levels in one batch of this size; none where it is too large,
/// one without rays where the camera sees nothing.
std::optional<RayTree> read_general_tree(const Stand& stand, const TraceSettings& settings,
                                         const CameraSample& sample, std::int32_t batch,
                                         TooLarge& too_large);

}  // namespace zraka
