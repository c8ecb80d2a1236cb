// SPDX-License-Identifier: Apache-2.0
// From the scene as read to the scene as traced.
#pragma once

#include <memory>
#include <zraka/render.hpp>
#include <zraka/scene.hpp>

#include "math/frame.hpp"
#include "scene/frozen.hpp"

namespace zraka {

/// The memory behind a FrozenScene.
template <class R>
struct FrozenStore {
  FrozenScene<R> scene{};
  std::uint64_t bytes = 0;
  std::vector<R> reals;
  std::vector<std::int32_t> indices;
  std::vector<FrozenLight<R>> lights;
};

/// The engine's frame for a scene: centred on the median of its shapes, where most of the detail
/// is. A middle of the bounds would let one huge sphere, a ground, take the other shapes' digits.
Frame frame_of(const Scene& scene);

/// References to all shapes for the hierarchy's builder, their boxes enlarged by what intersections
/// can err.
std::vector<BuildRef> references_to(const Scene& scene, const Frame& frame);

/// Freezes a scene that check() finds nothing wrong with, its shapes in the order of the hierarchy,
/// if there is one; the store then points to its nodes. R is float, or double for the oracle.
template <class R>
std::unique_ptr<FrozenStore<R>> freeze(const Scene& scene, const Profile& profile,
                                       const Frame& frame, const BuiltHierarchy& hierarchy);

}  // namespace zraka
