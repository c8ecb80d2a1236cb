// SPDX-License-Identifier: Apache-2.0
// Bodies on their way into the engine: each a map into its own space and a few numbers.
#pragma once

#include <cstdint>
#include <vector>

#include "math/frame.hpp"
#include "scene/bounds_of.hpp"
#include "scene/frozen_bodies.hpp"

namespace zraka {

/// The memory behind FrozenBodies.
struct BodyStore {
  std::vector<std::uint8_t> type;
  std::vector<std::int32_t> start, material, transform, id;
  std::vector<double> numbers;
  /// In the engine's frame, of those in the hierarchy, until it is built.
  std::vector<Bounds> bounds;
  std::uint64_t bytes() const;
};

/// What instances need to know of a group.
struct GroupPlace {
  Frame frame;       ///< its own
  double reach = 0;  ///< how far it reaches from the middle of that, in it; infinite without bounds
};

/// Puts the bodies of a scene or of a group into the store, and points to them. Slots are not known
/// yet; ids count from `first_id` on. Members of CSG that have a transform get one more in
/// `transforms`, which begin as the scene's: their own and that of the whole.
void freeze_bodies(const ShapeLists& shapes, const Whereabouts& where, const Frame& frame,
                   const std::vector<GroupPlace>& groups, std::int32_t first_id,
                   std::vector<Transform>& transforms, BodyStore& store, FrozenBodies& out);

/// Puts the bodies of the hierarchy in its order.
void reorder_bodies(const std::int32_t* order, BodyStore& store, FrozenBodies& out);

}  // namespace zraka
