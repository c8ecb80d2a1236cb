// SPDX-License-Identifier: Apache-2.0
// Half-spaces that are taken away: what is left of bodies, in closed form; their caps; who sees
// that, and who does not.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <limits>
#include <zraka/render.hpp>

namespace zraka {
namespace {

double dot(const Vec3& a, const Vec3& b) {
  return a.x * b.x + a.y * b.y + a.z * b.z;
}
Vec3 sum(const Vec3& a, const Vec3& b, double times = 1) {
  return {a.x + b.x * times, a.y + b.y * times, a.z + b.z * times};
}

Rendering rendered(const Scene& scene, RenderOptions options = {}) {
  Result<Rendering> rendering = render(scene, options);
  if (!rendering) ADD_FAILURE() << to_string(rendering.error().front());
  return rendering ? std::move(*rendering) : Rendering();
}
const std::vector<float>& floats(const Rendering& rendering, const char* name) {
  for (const Channel& channel : rendering.layers.channels)
    if (channel.name == name) return *channel.floats();
  static const std::vector<float> none;
  ADD_FAILURE() << name;
  return none;
}
const std::vector<std::uint32_t>& ids(const Rendering& rendering) {
  for (const Channel& channel : rendering.layers.channels)
    if (channel.ids() != nullptr) return *channel.ids();
  static const std::vector<std::uint32_t> none;
  ADD_FAILURE();
  return none;
}
RenderOptions with_layers(std::initializer_list<Layer> layers) {
  RenderOptions options;
  for (const Layer layer : layers) options.layers.add(layer);
  return options;
}

/// Parallel rays along -z from z = 10, over [x - half, x + half] × [-half, half].
Scene from_above(double half, std::uint32_t side, double x = 0) {
  Scene scene;
  scene.resolution = {side, side};
  scene.camera = {{x, 0, 10}, {x, 0, 0}, {2 * half, 0, 0}, {0, 2 * half, 0}};
  scene.camera.kind = CameraKind::orthographic;
  scene.materials = {{.ambient = {1, 1, 1}, .diffuse = {}}};
  scene.ambient_light = {1, 1, 1};
  return scene;
}
/// Where the ray through a pixel's middle is, across the view.
std::array<double, 2> place(const Scene& scene, std::size_t i) {
  const double side = scene.resolution.width, size = scene.camera.window_right.x;
  const auto column = static_cast<double>(i % scene.resolution.width),
             row = static_cast<double>(i / scene.resolution.width);
  return {scene.camera.eye.x + ((column + 0.5) / side - 0.5) * size,
          (0.5 - (row + 0.5) / side) * size};
}

TEST(Cuts, OpenASphereWithADiscInTheirPlane) {
  for (const bool caps : {true, false}) {
    Scene scene = from_above(1.5, 60);
    scene.spheres = {{Sphere{{0, 0, 0}, 1}, 0}};
    scene.cuts = {{.point = {0, 0, 0.5}, .normal = {0, 0, 3}, .caps = caps}};
    const Rendering picture =
        rendered(scene, with_layers({Layer::depth, Layer::normal, Layer::object_id}));
    const double disc = std::sqrt(1 - 0.25);
    for (std::size_t i = 0; i < 3600; ++i) {
      const auto [x, y] = place(scene, i);
      const double away = std::hypot(x, y);
      if (std::fabs(away - 1) < 1e-4 || std::fabs(away - disc) < 1e-4) continue;
      const bool seen = away < 1;
      EXPECT_EQ(ids(picture)[i], seen ? 1u : 0u);
      EXPECT_EQ(picture.image.pixels[3 * i], seen ? 1.0f : 0.0f);
      if (!seen) continue;
      const double ball = std::sqrt(1 - away * away);
      const bool in_disc = away < disc;
      EXPECT_NEAR(floats(picture, "Z")[i], in_disc ? caps ? 9.5 : 10 + ball : 10 - ball, 1e-5);
      if (in_disc && caps) {
        EXPECT_EQ(floats(picture, "normal.Z")[i], 1.0f);
      }
    }
  }
}

TEST(Cuts, LeaveAlphaWhereNothingIsLeft) {
  Scene scene = from_above(1.5, 30);
  scene.spheres = {{Sphere{{0, 0, 0}, 1}, 0}};
  scene.cuts = {{.point = {}, .normal = {1, 0, 0}}};
  const Rendering picture = rendered(scene, {.transparent = true});
  for (std::size_t i = 0; i < 900; ++i) {
    const auto [x, y] = place(scene, i);
    if (std::fabs(std::hypot(x, y) - 1) > 1e-4) {
      EXPECT_EQ(picture.layers.alpha()[i], x < 0 && std::hypot(x, y) < 1 ? 1.0f : 0.0f);
    }
  }
}

/// The share of pixels whose light differs from whether rays to the light, along (-1, 0, 1) from
/// the floor at z = -5, are free of a body.
double wrong_shadows(const Scene& scene, const std::function<bool(const Vec3&)>& is_in,
                     Shadows shadows = Shadows::opaque) {
  const Rendering picture = rendered(scene, {.shadows = shadows});
  std::size_t wrong = 0;
  const std::size_t count = std::size_t{scene.resolution.width} * scene.resolution.height;
  for (std::size_t i = 0; i < count; ++i) {
    const auto [x, y] = place(scene, i);
    bool blocked = false;
    for (double s = 0; s < 8 && !blocked; s += 0.004) blocked = is_in({x - s, y, s - 5});
    wrong += (picture.image.pixels[3 * i] == 0) != blocked;
  }
  return static_cast<double>(wrong) / static_cast<double>(count);
}
Scene floor_in_light() {
  Scene scene = from_above(1.5, 40, 5);
  scene.materials = {{.ambient = {}, .diffuse = {1, 1, 1}},
                     {.ambient = {}, .diffuse = {1, 1, 1}, .cut_group = 1}};
  scene.spheres = {{Sphere{{0, 0, 0}, 1}, 1}};
  scene.parallelograms = {{Parallelogram{{-50, -50, -5}, {100, 0, 0}, {0, 100, 0}}, 0}};
  scene.lights = {{.position = {}, .kind = LightKind::directional, .direction = {1, 0, -1}}};
  return scene;
}

TEST(Cuts, CastTheShadowOfWhatIsLeftUnlessForTheEyeOnly) {
  for (const bool eye_only : {false, true})
    for (const double way : {1.0, -1.0}) {
      Scene scene = floor_in_light();
      scene.cuts = {{.point = {0.2, 0, 0},
                     .normal = {way, 0, 0},
                     .eye_only = eye_only,
                     .group = way > 0 ? 1u : 0u}};  // where the floor lies, everything is left
      EXPECT_LT(wrong_shadows(scene,
                              [&](const Vec3& p) {
                                return dot(p, p) < 1 && (eye_only || way * (p.x - 0.2) <= 0);
                              }),
                0.01);
    }
}

TEST(Cuts, CastTheShadowOfASlabBetweenTwoCaps) {
  // Both of the sphere's surfaces on the light's way are taken away.
  Scene scene = floor_in_light();
  scene.cuts = {{.point = {0.1, 0, -0.1}, .normal = {1, 0, -1}, .group = 1},
                {.point = {-0.1, 0, 0.1}, .normal = {-1, 0, 1}, .group = 1}};
  const auto is_left = [](const Vec3& p) { return dot(p, p) < 1 && std::fabs(p.x - p.z) < 0.2; };
  EXPECT_LT(wrong_shadows(scene, is_left), 0.01);
  EXPECT_LT(wrong_shadows(scene, is_left, Shadows::transparent), 0.01);
}

TEST(Cuts, AreUnknownToMirrorsIfForTheEyeOnly) {
  for (const bool eye_only : {false, true}) {
    Scene scene = from_above(0.1, 5);
    scene.camera.eye.y = scene.camera.window_center.y = 0.5;
    scene.materials.push_back({.ambient = {}, .diffuse = {}, .reflection = 1});
    scene.background = {0.25, 0.25, 0.25};
    scene.spheres = {{Sphere{{0, 0, 0}, 1}, 0}};
    scene.materials[0].cut_group = 1;
    scene.parallelograms = {{Parallelogram{{-9, -9, -3}, {18, 0, 0}, {0, 18, 0}}, 1}};
    scene.cuts = {{.point = {}, .normal = {0, 1, 0}, .eye_only = eye_only, .group = 1}};
    EXPECT_EQ(rendered(scene).image.pixels[0], eye_only ? 1.0f : 0.25f);
  }
}

TEST(Cuts, AreForMaterialsOfTheirGroup) {
  Scene scene = from_above(2.5, 50);
  scene.materials.push_back(scene.materials[0]);
  scene.materials[1].cut_group = 7;
  scene.spheres = {{Sphere{{-1.2, 0, 0}, 1}, 0}, {Sphere{{1.2, 0, 0}, 1}, 1}};
  scene.cuts = {{.point = {0, 0, 0}, .normal = {0, 0, 1}, .group = 7}};
  const Rendering picture = rendered(scene, with_layers({Layer::depth, Layer::object_id}));
  for (std::size_t i = 0; i < 2500; ++i) {
    const auto [x, y] = place(scene, i);
    const double away = std::hypot(std::fabs(x) - 1.2, y);
    if (away > 0.999) continue;
    EXPECT_NEAR(floats(picture, "Z")[i], x > 0 ? 10 : 10 - std::sqrt(1 - away * away), 1e-5);
  }
}

TEST(Caps, AreOfThePriorityThenTheSmallestBody) {
  for (const bool first_is_large : {true, false})
    for (const int priority : {0, 1}) {
      Scene scene = from_above(1.2, 40);
      scene.materials.push_back(scene.materials[0]);
      scene.materials[0].priority = priority;
      scene.spheres = {{Sphere{{0, 0, 0}, 1}, 0}, {Sphere{{0.1, 0, 0}, 0.5}, 1}};
      if (!first_is_large) std::swap(scene.spheres[0], scene.spheres[1]);
      scene.cuts = {{.point = {}, .normal = {0, 0, 1}}};
      const Rendering picture = rendered(scene, with_layers({Layer::depth, Layer::material_id}));
      for (std::size_t i = 0; i < 1600; ++i) {
        const auto [x, y] = place(scene, i);
        const double in_small = std::hypot(x - 0.1, y) - 0.5;
        if (std::fabs(in_small) < 1e-4 || std::hypot(x, y) > 0.999) continue;
        EXPECT_EQ(ids(picture)[i], in_small < 0 && priority == 0 ? 2u : 1u);
        EXPECT_NEAR(floats(picture, "Z")[i], 10, 1e-5);
      }
    }
}

struct Found {
  double t = std::numeric_limits<double>::infinity();
  std::uint32_t id = 0;
};
/// What a ray sees of spheres that cuts have opened, by the definition alone.
Found by_definition(const Scene& scene, const Vec3& from, const Vec3& way) {
  double enter = -std::numeric_limits<double>::infinity(), leave = -enter;
  for (const Cut& cut : scene.cuts) {
    const double change = dot(cut.normal, way);
    const double at = dot(cut.normal, sum(cut.point, from, -1)) / change;
    (change < 0 ? enter : leave) = change < 0 ? std::max(enter, at) : std::min(leave, at);
  }
  Found found;
  double radius = 0;
  for (std::uint32_t i = 0; i < scene.spheres.size(); ++i) {
    const Sphere& s = scene.spheres[i].shape;
    const Vec3 to = sum(s.center, from, -1);
    const double along = dot(to, way), square = s.radius * s.radius - dot(to, to) + along * along;
    if (square < 0) continue;
    const double in = std::max(along - std::sqrt(square), enter),
                 out = std::min(along + std::sqrt(square), leave);
    if (in >= out || in <= 0) continue;
    if (in < found.t || (in == found.t && s.radius < radius)) {
      found = {in, i + 1};
      radius = s.radius;
    }
  }
  return found;
}

TEST(Caps, AreThereByTheDefinitionOfWhatIsLeft) {
  Scene scene;
  scene.resolution = {48, 48};
  scene.camera = {{1.5, 2, 4}, {0, 0, 0}, {4, 0, 0}, {0, 4, 0}};
  scene.materials = {{}};
  for (int i = 0; i < 30; ++i)
    scene.spheres.push_back(
        {Sphere{{std::sin(12.9 * i), std::sin(78.2 * i + 1), std::sin(37.7 * i + 2)},
                0.15 + 0.02 * i},
         0});
  for (const std::vector<Cut>& cuts :
       {std::vector<Cut>{{.point = {0, 0, 0.1}, .normal = {0.2, 0.3, 1}}},
        std::vector<Cut>{{.point = {0, 0, 0.3}, .normal = {0, 0, 1}},
                         {.point = {0, 0, -0.1}, .normal = {0, 0.1, -1}},
                         {.point = {0.2, 0, 0}, .normal = {1, 0, 0.5}}}}) {
    scene.cuts = cuts;
    const Rendering picture = rendered(scene, with_layers({Layer::depth, Layer::object_id}));
    std::size_t wrong = 0;
    for (std::size_t i = 0; i < 48 * 48; ++i) {
      const double x = (static_cast<double>(i % 48) + 0.5) / 48 - 0.5,
                   y = 0.5 - (static_cast<double>(i / 48) + 0.5) / 48;
      const Vec3 to = sum({4 * x, 4 * y, 0}, scene.camera.eye, -1);
      const Found found =
          by_definition(scene, scene.camera.eye, sum({}, to, 1 / std::sqrt(dot(to, to))));
      const double depth = static_cast<double>(floats(picture, "Z")[i]);
      wrong += ids(picture)[i] != found.id || (found.id != 0 && std::fabs(depth - found.t) > 1e-4);
    }
    EXPECT_LE(wrong, 2u);  // on edges
  }
}

TEST(Caps, CloseBodiesMeshesAndWhatStandsInGroups) {
  Scene scene = from_above(3, 60);
  scene.boxes = {{Box{{-2.5, -2, -1}, {-1.5, 2, 1}}, 0}};
  Group group;
  const Vec3 a{-0.5, -0.5, -0.8}, b{0.5, -0.5, -0.8}, c{0, 0.6, -0.8}, d{0, 0, 0.8};
  for (const auto& [p, q, r] :
       {std::array{a, c, b}, std::array{a, b, d}, std::array{b, c, d}, std::array{c, a, d}})
    group.triangles.push_back({Triangle{p, q, r}, 0});
  scene.groups.push_back(std::move(group));
  scene.instances = {{Instance{0}, 0}};
  scene.cones = {{Cone{{2, -1, 0}, 0.5, {2, 1, 0}, 0.5}, 0}};  // a pipe
  scene.cuts = {{.point = {}, .normal = {0, 0, 1}}};
  const Rendering picture = rendered(scene, with_layers({Layer::depth}));
  const auto depth_at = [&](double x, double y) {
    const auto column = static_cast<std::size_t>((x + 3) * 10),
               row = static_cast<std::size_t>((3 - y) * 10);
    return floats(picture, "Z")[row * 60 + column];
  };
  EXPECT_NEAR(depth_at(-2, 0.03), 10, 1e-5);
  EXPECT_NEAR(depth_at(0.02, 0.03), 10, 1e-5);
  EXPECT_NEAR(depth_at(2.03, 0.03), 10.5, 5e-3);
}

TEST(Caps, ForTheEyeOnlyLieInTheLightAndMirrorIt) {
  Scene scene = from_above(0.1, 5);
  scene.materials = {
      {.ambient = {0.125, 0.125, 0.125}, .diffuse = {0.5, 0.5, 0.5}, .reflection = 0.25}};
  scene.background = {1, 1, 1};
  scene.ambient_occlusion.samples = 16;
  scene.spheres = {{Sphere{{0, 0, 0}, 1}, 0}};
  scene.lights = {{.position = {}, .kind = LightKind::directional, .direction = {0, 0, -1}}};
  scene.cuts = {{.point = {}, .normal = {0, 0, 1}, .eye_only = true}};
  EXPECT_EQ(rendered(scene).image.pixels[36], 0.125f + 0.5f + 0.25f);
}

TEST(Caps, LetLightInAndOutOfGlass) {
  for (const double side : {1.0, -1.0}) {
    Scene scene = from_above(0.1, 5);
    scene.background = {1, 1, 1};
    scene.materials = {
        {.ambient = {}, .diffuse = {}, .refraction = 1, .ior = 1.5, .absorption = {0.5, 1, 2}}};
    scene.spheres = {{Sphere{{0, 0, 0}, 1}, 0}};
    scene.cuts = {{.point = {}, .normal = {0, 0, side}}};
    const Rendering picture = rendered(scene);
    for (std::size_t c = 0; c < 3; ++c)
      EXPECT_NEAR(picture.image.pixels[36 + c], std::exp(-std::array{0.5, 1.0, 2.0}[c]), 1e-4);
  }
}

TEST(Caps, OfGlassLetLightThroughByWhatIsLeft) {
  Scene scene = from_above(0.01, 5, 5);
  scene.materials = {
      {.ambient = {}, .diffuse = {1, 1, 1}},
      {.ambient = {}, .diffuse = {}, .refraction = 0.8, .absorption = {1, 1, 1}, .cut_group = 1}};
  scene.parallelograms = {{Parallelogram{{-50, -50, -5}, {100, 0, 0}, {0, 100, 0}}, 0}};
  scene.spheres = {{Sphere{{0, 0, 0}, 1}, 1}};
  scene.lights = {{.position = {}, .kind = LightKind::directional, .direction = {1, 0, -1}}};
  RenderOptions options;
  options.shadows = Shadows::transparent;
  const double facing = 1 / std::sqrt(2);
  for (const auto& [cuts, length] :
       {std::pair(std::vector<Cut>{}, 2.0),
        std::pair(std::vector<Cut>{{.point = {}, .normal = {1, 0, -1}, .group = 1}}, 1.0),
        std::pair(std::vector<Cut>{{.point = {}, .normal = {-1, 0, 1}, .group = 1}}, 1.0),
        std::pair(std::vector<Cut>{{.point = {0.1, 0, -0.1}, .normal = {1, 0, -1}, .group = 1},
                                   {.point = {-0.1, 0, 0.1}, .normal = {-1, 0, 1}, .group = 1}},
                  0.2 * std::sqrt(2))}) {
    scene.cuts = cuts;
    EXPECT_NEAR(rendered(scene, options).image.pixels[36], facing * 0.8 * std::exp(-length), 1e-4)
        << cuts.size();
  }
}

TEST(Cuts, HaveTheSameBitsHoweverTheyAreRendered) {
  Scene scene = floor_in_light();
  scene.resolution = {37, 29};
  scene.camera = {{3, 1, 6}, {0, 0, 0}, {3.7, 0, 0}, {0, 2.9, 0}};
  scene.ambient_occlusion.samples = 4;
  scene.materials[0].ambient = {0.3, 0.3, 0.3};
  scene.materials[0].reflection = 0.3;
  for (int i = 0; i < 40; ++i)
    scene.spheres.push_back(
        {Sphere{{std::sin(12.9 * i), std::sin(78.2 * i + 1), std::sin(37.7 * i + 2)}, 0.3}, 0});
  scene.cuts = {{.point = {0, 0, 0.2}, .normal = {0.1, 0, 1}, .eye_only = true},
                {.point = {0.4, 0, 0}, .normal = {1, 0, 0}}};
  RenderOptions options;
  options.isa = Isa::portable;
  options.threads = 1;
  const Rendering one = rendered(scene, options);
  options.threads = 3;
  options.tile = 7;
  options.isa.reset();
  EXPECT_EQ(rendered(scene, options).image.pixels, one.image.pixels);
  options.crop = {5, 6, 20, 10};
  const Rendering part = rendered(scene, options);
  for (std::uint32_t y = 0; y < 10; ++y)
    EXPECT_TRUE(std::equal(part.image.row(y), part.image.row(y) + 60, one.image.row(y + 6) + 15));
}

TEST(Cuts, NeedAPlane) {
  Scene scene = from_above(1, 4);
  scene.cuts = {{.point = {}, .normal = {0, 0, 1}}, {.point = {}, .normal = {0, 0, 0}}};
  const Result<Rendering> failed = render(scene);
  ASSERT_FALSE(failed);
  EXPECT_EQ(failed.error().front().message, "cut 2: its normal is 0, or it is not finite");
  scene.cuts.assign(1025, {});
  const Result<Rendering> many = render(scene);
  ASSERT_FALSE(many);
  EXPECT_EQ(many.error().front().message, "there are 1025 cuts: at most 1024 can be");
}

}  // namespace
}  // namespace zraka
