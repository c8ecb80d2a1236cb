// SPDX-License-Identifier: Apache-2.0
// Builds the hierarchy.
#pragma once

#include <vector>

#include "scene/hierarchy.hpp"

namespace zraka {

/// A hierarchy over all references, which come back in another order; `kinds` is one more than the
/// greatest kind. The result does not depend on the number of threads. Splits by the surface area
/// heuristic over bins (Wald, "On fast construction of SAH-based bounding volume hierarchies",
/// 2007), straight into nodes of sixteen. Boxes must be finite.
BuiltHierarchy build_hierarchy(std::vector<BuildRef>& refs, int kinds);

}  // namespace zraka
