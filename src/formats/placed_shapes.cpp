// SPDX-License-Identifier: Apache-2.0
#include "formats/placed_shapes.hpp"

#include "language/bake.hpp"
#include "scene/bounds_of.hpp"

namespace zraka {

std::uint32_t PlacedShapes::index_of(const Transform& t) {
  if (t == Transform{}) return 0;
  // Neighbours often share one.
  if (scene_.transforms.empty() || scene_.transforms.back() != t) scene_.transforms.push_back(t);
  return static_cast<std::uint32_t>(scene_.transforms.size());
}

void PlacedShapes::add_sphere(const Vec3& center, double radius, std::uint32_t material,
                              const Transform& t) {
  if (keeps_balls(t))
    scene_.spheres.push_back(
        {t == Transform{} ? Sphere{center, radius} : language::baked(Sphere{center, radius}, t),
         material, index_of(t)});
  else
    add_body(scene_.ellipsoids, Ellipsoid{center, {radius, radius, radius}}, material, t);
}

void PlacedShapes::add_triangle(const Triangle& triangle, std::uint32_t material,
                                const Transform& t) {
  scene_.triangles.push_back(
      {t == Transform{} ? triangle : language::baked(triangle, t), material, index_of(t)});
}

void PlacedShapes::add_triangle(const SmoothTriangle& triangle, std::uint32_t material,
                                const Transform& t) {
  scene_.smooth_triangles.push_back(
      {t == Transform{} ? triangle : language::baked(triangle, t), material, index_of(t)});
}

}  // namespace zraka
