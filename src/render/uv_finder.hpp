// SPDX-License-Identifier: Apache-2.0
// Where on its surface a hit is, whether or not the scene has textures.
#pragma once

#include <array>
#include <vector>
#include <zraka/scene.hpp>

#include "engine/hit_path.hpp"
#include "scene/freeze.hpp"

namespace zraka {

/// Finds u and v of hits by their paths, as textures find them (engine/coefficients.cpp): of what
/// textures need, a scene without any keeps nothing, so this asks the scene as it was read.
template <class R>
class UvFinder {
 public:
  /// Both have to live as long as this.
  UvFinder(const Scene& scene, const FrozenStore<R>& store);

  /// Of a point in the engine's frame.
  std::array<double, 2> at(const HitPath& path, const V3<double>& point) const;

 private:
  /// Where a path ends: the scene or a group, as read and as frozen.
  struct Home {
    const ShapeLists& shapes;
    const FrozenScene<R>& frozen;
  };
  template <class Shape>
  bool find(const Home& home, const FrozenShapes<R, Shape>& kind, std::int32_t slot,
            const V3<double>& point, std::array<double, 2>& uv) const;

  const Scene& scene_;
  const FrozenStore<R>& store_;
  std::vector<Transform> to_shape_;  ///< of Scene::transforms
};

}  // namespace zraka
