// SPDX-License-Identifier: Apache-2.0
// What the engine's arrays say of a hit besides light: the way through instances, CSG, the shape's
// own space, textures.
#pragma once

#include <zraka/explain.hpp>

#include "engine/engine.hpp"
#include "math/frame.hpp"
#include "scene/freeze.hpp"

namespace zraka {

inline Float3 float3(const V3<float>& v) {
  return {v.x, v.y, v.z};
}

class HitReader {
 public:
  HitReader(const Scene& scene, const FrozenStore<float>& store, const Frame& frame)
      : scene_(scene), store_(store), frame_(frame) {}

  /// What lies behind the scene's own shape; `path` is nullptr where nothing can.
  ExplainedPath path(const HitPath* path) const;

  /// Adds all that is known of hit h, which is that of this ray of the level, to what is known of
  /// its distance, point and normal.
  void read(const Level<float>& level, const Scratch<float>& scratch, std::size_t h,
            std::size_t ray, ExplainedHit& hit) const;

 private:
  /// The scene, or a group.
  struct Home {
    const ShapeLists* shapes;
    const FrozenScene<float>* frozen;
  };
  Home group(std::uint32_t index) const { return {&scene_.groups[index], &store_.groups[index]}; }
  Home home(const ExplainedPath& path) const;
  ExplainedTexture texture(std::uint32_t index) const;
  std::optional<ExplainedCrossings> crossings(const ShapeId& shape, const ExplainedPath& path,
                                              const HitPath& from, const Level<float>& level,
                                              const Scratch<float>& scratch, std::size_t h,
                                              std::size_t ray) const;
  void read_textures(const Scratch<float>& scratch, std::size_t h, ExplainedHit& hit) const;

  const Scene& scene_;
  const FrozenStore<float>& store_;
  const Frame& frame_;
};

}  // namespace zraka
