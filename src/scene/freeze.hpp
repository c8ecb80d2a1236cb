// SPDX-License-Identifier: Apache-2.0
// From the scene as read to the scene as traced.
#pragma once

#include <memory>
#include <zraka/render.hpp>
#include <zraka/scene.hpp>

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

/// Freezes a scene that check() finds nothing wrong with. R is float, or double for the oracle.
template <class R>
std::unique_ptr<FrozenStore<R>> freeze(const Scene& scene, const Profile& profile);

}  // namespace zraka
