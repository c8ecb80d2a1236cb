// SPDX-License-Identifier: Apache-2.0
#include "explain/rays_file.hpp"

#include <gtest/gtest.h>

#include <bit>
#include <cmath>
#include <nlohmann/json.hpp>
#include <sstream>

#include "scenes.hpp"

namespace zraka {
namespace {

std::string bytes_of(const std::string& text) {
  constexpr std::string_view kDigits =
      "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
  std::string bytes;
  unsigned bits = 0, count = 0;
  for (const char c : text) {
    if (c == '=') break;
    bits = bits << 6 | static_cast<unsigned>(kDigits.find(c));
    if ((count += 6) >= 8) bytes += static_cast<char>(bits >> (count -= 8) & 0xFF);
  }
  return bytes;
}

RenderOptions lab() {
  return {.profile = profile_of(ProfileName::lab)};
}

/// A mirror that sees nothing, lit by one light and shadowed from another.
Scene small_scene() {
  Scene scene = lab_scene();
  scene.lights = {{{0, 2, 2}, {1, 1, 1}}, {{0, 0, 8}, {1, 1, 1}}, {{0, 0, -9}, {1, 1, 1}}};
  add_sphere(scene, {0, 0, -1}, 1, {.reflection = 0.5});
  add_sphere(scene, {0, 1, 1}, 0.1, {});
  return scene;
}

TEST(Segments, GoToWhatTheyMeet) {
  const Scene scene = small_scene();
  const std::vector<Segment> segments = segments_of(scene, explain(scene, lab(), 50, 50).value());
  ASSERT_EQ(segments.size(), 4u)
      << "a ray, two shadow rays to lights before the surface, its mirror";
  const auto expect = [&](std::size_t i, SegmentKind kind, Vec3 from, Vec3 to, bool endless) {
    EXPECT_EQ(segments[i].kind, kind) << i;
    EXPECT_NEAR(std::hypot(segments[i].from.x - from.x, segments[i].from.y - from.y,
                           segments[i].from.z - from.z),
                0, 1e-5)
        << i;
    EXPECT_NEAR(
        std::hypot(segments[i].to.x - to.x, segments[i].to.y - to.y, segments[i].to.z - to.z), 0,
        1e-5)
        << i;
    EXPECT_EQ(segments[i].endless, endless) << i;
  };
  expect(0, SegmentKind::camera, {0, 0, 2}, {0, 0, 0}, false);
  const double edge = 1 - 0.1 * std::sqrt(0.5);
  expect(1, SegmentKind::shadow_ray_blocked, {0, 0, 0}, {0, edge, edge}, false);
  expect(2, SegmentKind::shadow_ray_lit, {0, 0, 0}, {0, 0, 8}, false);
  expect(3, SegmentKind::reflected, {0, 0, 0}, {0, 0, 1}, true);
}

TEST(Segments, AreAsLongAsCanBeSeen) {
  Scene scene = small_scene();
  scene.lights = {{{0, 0, 1e30}, {1, 1, 1}}};
  for (const Segment& s : segments_of(scene, explain(scene, lab(), 50, 50).value()))
    EXPECT_LE(std::hypot(s.to.x - s.from.x, s.to.y - s.from.y, s.to.z - s.from.z), 16.001);
  // A ray that hits nothing goes as far as the window, and as much again.
  const std::vector<Segment> one = segments_of(scene, explain(scene, lab(), 0, 0).value());
  ASSERT_EQ(one.size(), 1u);
  EXPECT_NEAR(std::hypot(one[0].to.x, one[0].to.y, one[0].to.z - 2), 2, 1e-5);
  EXPECT_TRUE(one[0].endless);
}

TEST(RaysFile, IsAnObj) {
  const Scene scene = small_scene();
  const std::vector<Segment> segments = segments_of(scene, explain(scene, lab(), 50, 50).value());
  std::istringstream lines(rays_as_obj(segments, "rays"));
  std::string line;
  std::size_t vertices = 0, elements = 0, objects = 0;
  std::getline(lines, line);
  EXPECT_EQ(line, "# rays");
  while (std::getline(lines, line)) {
    std::istringstream words(line);
    std::string word;
    words >> word;
    if (word == "v") {
      double x, y, z;
      EXPECT_TRUE(words >> x >> y >> z);
      ++vertices;
    } else if (word == "l") {
      std::size_t a, b;
      EXPECT_TRUE(words >> a >> b);
      EXPECT_EQ(a, 2 * elements + 1);
      EXPECT_EQ(b, vertices);
      ++elements;
    } else {
      EXPECT_EQ(word, "o") << line;
      ++objects;
    }
  }
  EXPECT_EQ(elements, segments.size());
  EXPECT_EQ(objects, 4u) << "camera, reflected, lit, blocked";
}

TEST(RaysFile, IsAGltf) {
  // Far from the origin, floats must not lose the rays.
  Scene scene = small_scene();
  const double far = 1e6;
  scene.camera.eye.x += far, scene.camera.window_center.x += far;
  for (Light& light : scene.lights) light.position.x += far;
  for (auto& sphere : scene.spheres) sphere.shape.center.x += far;
  const std::vector<Segment> segments = segments_of(scene, explain(scene, lab(), 50, 50).value());
  const auto gltf = nlohmann::json::parse(rays_as_gltf(segments));
  EXPECT_EQ(gltf["asset"]["version"], "2.0");
  const std::string uri = gltf["buffers"][0]["uri"];
  const std::string start = "data:application/octet-stream;base64,";
  ASSERT_TRUE(uri.starts_with(start));
  const std::string bytes = bytes_of(uri.substr(start.size()));
  EXPECT_EQ(bytes.size(), gltf["buffers"][0]["byteLength"].get<std::size_t>());
  std::size_t seen = 0;
  for (const std::size_t node : gltf["scenes"][0]["nodes"]) {
    const auto& mesh = gltf["meshes"][gltf["nodes"][node]["mesh"].get<std::size_t>()];
    const auto& primitive = mesh["primitives"][0];
    EXPECT_EQ(primitive["mode"], 1) << "lines";
    const auto& accessor =
        gltf["accessors"][primitive["attributes"]["POSITION"].get<std::size_t>()];
    const auto& view = gltf["bufferViews"][accessor["bufferView"].get<std::size_t>()];
    std::size_t at = view["byteOffset"];
    EXPECT_EQ(view["byteLength"].get<std::size_t>(), 12 * accessor["count"].get<std::size_t>());
    const auto next = [&](std::size_t axis) {
      std::uint32_t bits = 0;
      for (unsigned i = 0; i < 4; ++i)
        bits |= std::uint32_t{static_cast<unsigned char>(bytes[at++])} << 8 * i;
      const auto value = std::bit_cast<float>(bits);
      EXPECT_GE(value, accessor["min"][axis].get<float>());
      EXPECT_LE(value, accessor["max"][axis].get<float>());
      return static_cast<double>(value) + gltf["nodes"][node]["translation"][axis].get<double>();
    };
    for (const Segment& s : segments) {
      if (mesh["name"] != kSegmentNames[static_cast<std::size_t>(s.kind)]) continue;
      for (const Vec3& p : {s.from, s.to}) {
        EXPECT_NEAR(next(0), p.x, 1e-5);
        EXPECT_NEAR(next(1), p.y, 1e-5);
        EXPECT_NEAR(next(2), p.z, 1e-5);
      }
      ++seen;
    }
  }
  EXPECT_EQ(seen, segments.size());
}

}  // namespace
}  // namespace zraka
