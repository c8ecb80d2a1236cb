// SPDX-License-Identifier: Apache-2.0
// From the engine's arrays to a RayTree.
#pragma once

#include <cmath>
#include <limits>
#include <zraka/explain.hpp>

#include "explain/recording.hpp"
#include "explain/roundest.hpp"
#include "explain/shape_lookup.hpp"
#include "render/isa.hpp"
#include "render/prepare.hpp"
#include "render/variation.hpp"

namespace zraka {

/// What all pixels of a scene share.
struct Stand {
  const Scene& scene;
  RenderOptions options;
  TraceSettings settings;
  PreparedScene<float> prepared;
  const Kernel<float>* kernel;
  Variation variation;

  const FrozenScene<float>& frozen() const { return prepared.store->scene; }
  NamedShape named(std::int32_t slot) const {
    return zraka::named(scene, shape_in_slot(scene, frozen(), slot));
  }
  /// A point in the world. Of all that the engine's floats may stand for, the roundest numbers:
  /// an eye at 0 is printed as 0.
  Vec3 world_point(float x, float y, float z) const {
    const Vec3 world = prepared.frame.world_point(
        {static_cast<double>(x), static_cast<double>(y), static_cast<double>(z)});
    const auto half_step = [&](float v) {
      const float magnitude = std::fabs(v);
      return length(std::nextafter(magnitude, std::numeric_limits<float>::infinity()) - magnitude) /
             2;
    };
    return {roundest_within(world.x, half_step(x)), roundest_within(world.y, half_step(y)),
            roundest_within(world.z, half_step(z))};
  }
  double length(float framed) const {
    return prepared.frame.world_length(static_cast<double>(framed));
  }
};

/// Where a tree stopped because it does not fit.
struct TooLarge {
  std::size_t levels = 0, rays = 0, more = 0;  ///< whole levels, their rays, the next level's
  std::uint64_t terms = 0;                     ///< of light, if they are what is too much
};

/// The tree of the ray through a corner or the centre of a pixel, or of one of its samples, to the
/// depth of the settings. Fails where it is too large.
Result<RayTree> read_tree(const Stand& stand, const TraceSettings& settings, std::uint32_t x,
                          std::uint32_t y, std::uint32_t sample = 0);

}  // namespace zraka
