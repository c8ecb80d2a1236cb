// SPDX-License-Identifier: Apache-2.0
// A pixel's rays as lines in the world, to be drawn.
#pragma once

#include <array>
#include <string_view>
#include <vector>
#include <zraka/explain.hpp>

namespace zraka {

enum class SegmentKind {
  camera,
  reflected,
  refracted,
  shadow_ray_lit,
  shadow_ray_blocked,
  shadow_ray_dimmed  ///< one that reaches the light, behind a transparent body
};
inline constexpr std::array<std::string_view, 6> kSegmentNames = {
    "camera",         "reflected",          "refracted",
    "shadow-ray-lit", "shadow-ray-blocked", "shadow-ray-dimmed"};

struct Segment {
  SegmentKind kind = SegmentKind::camera;
  Vec3 from, to;
  bool endless = false;  ///< it goes on beyond `to`
  std::size_t tree = 0, ray = 0;
  std::size_t light = 0;  ///< of a shadow ray
};

/// Rays up to what they hit; shadow rays up to their light or to what blocks them, in parts where
/// they pass transparent bodies. What hits
/// nothing is as long as half of what the tree spans, and shadow rays to lights from far away end
/// after eight times that span.
std::vector<Segment> segments_of(const Scene& scene, const Explanation& explanation);

}  // namespace zraka
