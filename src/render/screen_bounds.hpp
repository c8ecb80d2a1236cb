// SPDX-License-Identifier: Apache-2.0
// Where in the picture shapes can be seen, so that no ray need ask where none can.
#pragma once

#include <cstdint>
#include <vector>

#include "engine/engine.hpp"
#include "scene/frozen.hpp"

namespace zraka {

/// The pixels that some boxes around all shapes cover, as a rectangle for each.
class ScreenBounds {
 public:
  /// Of a scene that is ready, in a picture of so many pixels: of the boxes two levels down in the
  /// hierarchy, or of each shape where there is none. `reach`: how far from a pixel's place its
  /// rays may go through the picture, in pixels. Everywhere for cameras that make no straight lines
  /// of straight lines, and those with a lens.
  template <class R>
  ScreenBounds(const FrozenScene<R>& scene, std::uint32_t width, std::uint32_t height,
               double reach = 0);

  /// The part of a tile that they cover: no ray through a pixel outside of it hits a shape. Of no
  /// size where they cover none.
  TileRect part_of(const TileRect& tile) const;

 private:
  struct Projection;
  void add(const Projection& camera, const float* lower, const float* upper);

  /// By box: columns [left, right), rows [top, bottom).
  std::vector<std::int32_t> left_, top_, right_, bottom_;
};

}  // namespace zraka
