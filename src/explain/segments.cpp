// SPDX-License-Identifier: Apache-2.0
#include "explain/segments.hpp"

#include <cmath>

#include "math/bounds.hpp"

namespace zraka {
namespace {

double distance(const Vec3& a, const Vec3& b) {
  return std::hypot(a.x - b.x, a.y - b.y, a.z - b.z);
}

Vec3 along(const Vec3& from, const Float3& direction, double t) {
  return {from.x + t * static_cast<double>(direction[0]),
          from.y + t * static_cast<double>(direction[1]),
          from.z + t * static_cast<double>(direction[2])};
}

/// Diagonal of the box around all origins and hits; of a tree of one ray, twice the way to the
/// window.
double span_of(const Scene& scene, const Explanation& explanation) {
  Bounds box;
  for (const RayTree& tree : explanation.trees)
    for (const ExplainedRay& ray : tree.rays) {
      box.include({ray.origin, ray.origin});
      if (ray.hit) box.include({ray.hit->point, ray.hit->point});
    }
  const double span = box.empty() ? 0 : distance(box.lower, box.upper);
  if (span > 0) return span;
  const double to_window = distance(scene.camera.window_center, scene.camera.eye);
  return to_window > 0 ? 2 * to_window : 1;
}

}  // namespace

std::vector<Segment> segments_of(const Scene& scene, const Explanation& explanation) {
  constexpr SegmentKind kKindsOfRays[] = {SegmentKind::camera, SegmentKind::reflected,
                                          SegmentKind::refracted};
  const double span = span_of(scene, explanation);
  std::vector<Segment> segments;
  for (std::size_t t = 0; t < explanation.trees.size(); ++t)
    for (std::size_t r = 0; r < explanation.trees[t].rays.size(); ++r) {
      const ExplainedRay& ray = explanation.trees[t].rays[r];
      const Vec3 end = ray.hit ? ray.hit->point : along(ray.origin, ray.direction, span / 2);
      segments.push_back({kKindsOfRays[static_cast<int>(ray.kind)], ray.origin, end,
                          !ray.hit.has_value(), t, r, 0});
      if (!ray.hit) continue;
      for (std::size_t l = 0; l < ray.hit->lights.size(); ++l) {
        const LightTerms& at = ray.hit->lights[l];
        if (at.reach != Reach::lit && at.reach != Reach::blocked) continue;
        const bool blocked = at.reach == Reach::blocked;
        const double whole = at.blocker ? at.blocker->distance : at.distance;
        const double length = std::min(whole, 8 * span);
        SegmentKind kind =
            blocked ? SegmentKind::shadow_ray_blocked : SegmentKind::shadow_ray_lit;
        Vec3 from = end;
        for (const PassedBody& body : at.passed) {
          if (blocked || !at.filter || body.distance >= length) break;
          const Vec3 there = along(end, at.to_light, body.distance);
          segments.push_back({kind, from, there, false, t, r, l});
          from = there;
          kind = SegmentKind::shadow_ray_dimmed;
        }
        segments.push_back(
            {kind, from, along(end, at.to_light, length), length < whole, t, r, l});
      }
    }
  return segments;
}

}  // namespace zraka
