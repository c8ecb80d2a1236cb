// SPDX-License-Identifier: Apache-2.0
// From the scene as read to the scene as traced.
#pragma once

#include <memory>
#include <zraka/render.hpp>
#include <zraka/scene.hpp>

#include "core/unset_vector.hpp"
#include "math/frame.hpp"
#include "scene/frozen.hpp"

namespace zraka {

/// The memory behind a FrozenScene.
template <class R>
struct FrozenStore {
  FrozenScene<R> scene{};
  UnsetVector<R> reals, rows;
  UnsetVector<std::int32_t> materials, ids;
  std::vector<FrozenLight<R>> lights;
  std::uint64_t bytes() const;
};

/// The engine's frame for a scene: centred on the median of its shapes, where most of the detail
/// is. A middle of the bounds would let one huge sphere, a ground, take the other shapes' digits.
Frame frame_of(const Scene& scene);

/// Freezes a scene that check() finds nothing wrong with, its shapes in the order that they were
/// read; the scene is not needed any more then. R is float, or double for the oracle.
template <class R>
std::unique_ptr<FrozenStore<R>> freeze(const Scene& scene, const Profile& profile,
                                       const Frame& frame);

/// Where the slots of each kind of shape begin, and where the last one's end.
template <class R>
std::vector<std::int32_t> kind_starts_of(const FrozenScene<R>& scene);

/// The boxes of all slots for the hierarchy's builder, enlarged by what intersections can err.
template <class R>
void refer_to(const FrozenScene<R>& scene, BuildRef* refs);

/// Puts the shapes into the order of the hierarchy, if there is one, and points the scene to its
/// nodes: the scene is then ready.
template <class R>
void reorder_by_leaf(FrozenStore<R>& store, const BuiltHierarchy& hierarchy);

}  // namespace zraka
