// SPDX-License-Identifier: Apache-2.0
// Rays through bodies of smooth triangles, whose normals at an outline look past the viewer.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "picture_of.hpp"
#include "scenes.hpp"

namespace zraka {
namespace {

/// The octahedron |x| + |y| + |z| <= 1 with the normals of a ball; its corners run outward, or
/// inward where `turned`.
Group octahedron(bool turned) {
  Group group;
  for (const double x : {-1.0, 1.0})
    for (const double y : {-1.0, 1.0})
      for (const double z : {-1.0, 1.0}) {
        const Vec3 a{x, 0, 0}, b{0, y, 0}, c{0, 0, z};
        const bool outward = (x * y * z > 0) != turned;
        const Vec3 &second = outward ? b : c, &third = outward ? c : b;
        group.smooth_triangles.push_back({{a, second, third, a, second, third}, 0});
      }
  return group;
}

/// How much of a ray lies within the octahedron.
double length_within(const Vec3& from, const Vec3& way) {
  double in = 0, out = std::numeric_limits<double>::infinity();
  for (int face = 0; face < 8; ++face) {
    const double x = face & 1 ? 1 : -1, y = face & 2 ? 1 : -1, z = face & 4 ? 1 : -1;
    const double above = x * from.x + y * from.y + z * from.z - 1;
    const double along = x * way.x + y * way.y + z * way.z;
    if (along < 0) in = std::max(in, -above / along);
    if (along > 0) out = std::min(out, -above / along);
  }
  return std::max(out - in, 0.0);
}

constexpr int kSide = 64;

Scene clear_octahedron(bool turned) {
  Scene scene;
  scene.resolution = {kSide, kSide};
  scene.camera = {{0.4, 0.9, 5}, {0, 0, 0}, {2.4, 0, 0}, {0, 2.4, 0}};
  scene.background = {1, 1, 1};
  scene.materials = {{.ambient = {}, .diffuse = {}, .refraction = 1}};
  scene.groups = {octahedron(turned)};
  scene.transforms = {Transform{}};
  scene.instances = {{{0}, 0, 0}};
  return scene;
}

/// The largest difference from what a function of the length within the octahedron says.
template <class Expected>
double most_off(const Scene& scene, Isa isa, Expected expected) {
  const Image image = picture_of(scene, {.max_depth = 9, .isa = isa});
  const Vec3 eye = scene.camera.eye;
  double most = 0;
  for (int y = 0; y < kSide; ++y)
    for (int x = 0; x < kSide; ++x) {
      const Vec3 to{2.4 * (x + 0.5) / kSide - 1.2, 1.2 - 2.4 * (y + 0.5) / kSide, 0};
      const Vec3 way{to.x - eye.x, to.y - eye.y, to.z - eye.z};
      const double size = std::sqrt(way.x * way.x + way.y * way.y + way.z * way.z);
      const double length = length_within(eye, {way.x / size, way.y / size, way.z / size});
      if (length > 0 && length < 1e-3) continue;
      const float* pixel = image.row(static_cast<std::uint32_t>(y)) + 3 * x;
      most = std::max(most, std::fabs(static_cast<double>(pixel[0]) - expected(length)));
    }
  return most;
}

TEST(SmoothMesh, IsPassedOnceThroughEachFace) {
  for (const bool turned : {false, true}) {
    Scene scene = clear_octahedron(turned);
    scene.materials[0].refraction = 0.5;
    for (const Isa isa : available_isas())
      EXPECT_LT(most_off(scene, isa, [](double length) { return length > 0 ? 0.25 : 1; }), 1e-5)
          << name_of(isa);
  }
}

TEST(SmoothMesh, TakesLightForTheWayInside) {
  for (const bool turned : {false, true}) {
    Scene scene = clear_octahedron(turned);
    scene.materials[0].absorption = {1, 1, 1};
    for (const Isa isa : available_isas())
      EXPECT_LT(most_off(scene, isa, [](double length) { return std::exp(-length); }), 1e-4)
          << name_of(isa);
  }
}

/// A face whose blended normals lean so far from it that mirrored rays go on behind it: to what is
/// there, and not to the face once more.
TEST(SmoothMesh, MirrorsGoOnBehindFacesWhereTheirNormalsSendThem) {
  Scene scene;
  scene.resolution = {5, 5};
  scene.camera = {{0, 0, 10}, {0, 0, 0}, {0.001, 0, 0}, {0, 0.001, 0}};
  scene.ambient_light = {1, 1, 1};
  scene.materials = {{.ambient = {0, 0.25, 0}, .diffuse = {}, .reflection = 0.5},
                     {.ambient = {0.5, 0, 0}, .diffuse = {}}};
  const Vec3 leaning{std::sqrt(0.75), 0, 0.5};  // by 60°: what comes straight goes on at 30° behind
  scene.smooth_triangles.push_back(
      {SmoothTriangle{{-1, -1, 0}, {1, -1, 0}, {0, 1, 0}, leaning, leaning, leaning}, 0});
  scene.parallelograms.push_back({Parallelogram{{-9, -9, -1}, {18, 0, 0}, {0, 18, 0}}, 1});
  for (const double scale : {1e-4, 1.0, 1e4}) {
    Scene other = scene;
    SmoothTriangle& t = other.smooth_triangles[0].shape;
    for (Vec3* corner : {&t.a, &t.b, &t.c})
      *corner = {corner->x * scale, corner->y * scale, corner->z * scale};
    for (RenderOptions options : {RenderOptions{}, RenderOptions{.min_contribution = 1e-9}})
      for (const Isa isa : {available_isas().front(), Isa::portable, Isa::oracle}) {
        options.isa = isa;
        const Image picture = picture_of(other, options);
        const float* const pixel = picture.row(2) + 3 * 2;
        EXPECT_NEAR(pixel[0], 0.25, 1e-6) << name_of(isa) << scale;
        EXPECT_NEAR(pixel[1], 0.25, 1e-6) << name_of(isa) << scale;
      }
  }
}

}  // namespace
}  // namespace zraka
