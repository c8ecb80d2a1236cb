// SPDX-License-Identifier: Apache-2.0
// Scenes for Tachyon and POV-Ray: what comes back, what is written, what is said to be lost.
#include <gtest/gtest.h>

#include <cmath>
#include <zraka/formats.hpp>

#include "equal_scenes.hpp"
#include "formats/tessellate.hpp"
#include "scenes.hpp"
#include "shapes/bodies.hpp"

namespace zraka {
namespace {

Scene through(const Scene& scene, const char* format) {
  const Result<WrittenScene> written = write_scene(scene, format);
  if (!written) {
    ADD_FAILURE() << format << ": " << to_string(written.error().front());
    return {};
  }
  Result<ReadScene> read = parse_scene(written->text, format);
  if (!read) ADD_FAILURE() << to_string(read.error().front()) << written->text;
  return read ? std::move(read->scene) : Scene{};
}

std::string losses(const Scene& scene, const char* format) {
  const Result<WrittenScene> written = write_scene(scene, format);
  std::string all;
  for (const Diagnostic& d : written ? written->losses : written.error()) all += to_string(d);
  return all;
}

std::string text_of(const Scene& scene, const char* format) {
  return write_scene(scene, format).value().text;
}

void expect_has(const std::string& text, const std::string& part) {
  EXPECT_NE(text.find(part), std::string::npos) << "no " << part << " in\n" << text;
}

/// All that Tachyon can say, in numbers that its camera does not round.
Scene held_by_tachyon() {
  Scene scene;
  scene.resolution = {64, 64};
  scene.camera = {.eye = {1, 2, 4}, .window_center = {1, 2, 3}};
  scene.background = {0.1, 0.2, 0.3};
  scene.ambient_light = {1, 1, 1};
  scene.lights = {{.position = {1, 5, 4}, .color = {1, 0.5, 0.25}, .attenuation = {1, 0.5, 0.25}},
                  {.position = {}, .kind = LightKind::directional, .direction = {0, -1, 0}}};
  scene.defaults = {.profile = ProfileName::tachyon, .max_depth = 7};
  scene.defaults.sampling.count = 4;
  const auto material = [&](const Color& color, double shininess) {
    scene.materials.push_back({.ambient = {color.r / 4, color.g / 4, color.b / 4},
                               .diffuse = color,
                               .specular = {0.5, 0.5, 0.5},
                               .shininess = shininess,
                               .reflection = 0.25,
                               .highlight = Highlight::blinn});
    return static_cast<std::uint32_t>(scene.materials.size() - 1);
  };
  scene.spheres.push_back({{{1, 2, 0}, 0.7}, material({1, 0.5, 0.25}, 30)});
  scene.triangles.push_back({{{0, 0, 0}, {1, 0, 0.1}, {0, 1, 0}}, material({0, 1, 0.25}, 8)});
  scene.smooth_triangles.push_back(
      {{{0, 0, 1}, {1, 0, 1}, {0, 1, 1}, {0, 0, 1}, {0, 0.6, 0.8}, {1, 0, 0}}, 1});
  scene.cones.push_back({{{2, 0, 0}, 0.25, {2, 3, 0}, 0.25}, material({0.5, 0.5, 0.5}, 9)});
  scene.planes.push_back({{{0, -1, 0}, {0, 1, 0}}, 0});
  scene.boxes.push_back({{{-2, 0, 0}, {-1, 1, 1}}, 2});
  scene.discs.push_back({{{3, 3, 0}, {0, 0.6, 0.8}, 1, 0.25}, 1});
  return scene;
}

TEST(Writers, BringScenesBackFromTachyon) {
  const Scene scene = held_by_tachyon();
  EXPECT_EQ(losses(scene, "tachyon"),
            "warning: lost in Tachyon: lights: that highlights fade, too\n")
      << "as Tachyon itself draws it";
  expect_equal(scene, through(scene, "tachyon"));
  expect_equal(scene, through(through(through(scene, "toml"), "tachyon"), "toml"));
}

TEST(Writers, KeepCutsAsTachyonsClipGroups) {
  Scene scene = held_by_tachyon();
  scene.materials[1].cut_group = 1;
  scene.cuts = {{.point = {0, 2, 0}, .normal = {0, 2, 0}, .caps = false, .group = 1},
                {.point = {3, 0, 0}, .normal = {1, 0, 0}, .caps = false, .group = 1}};
  EXPECT_EQ(losses(scene, "tachyon"),
            "warning: lost in Tachyon: lights: that highlights fade, too\n");
  const Scene again = through(scene, "tachyon");
  ASSERT_EQ(again.cuts.size(), 2u) << "which several lists of shapes share";
  EXPECT_EQ(again.cuts[0], scene.cuts[0]);
  EXPECT_EQ(again.cuts[1], scene.cuts[1]);
  EXPECT_EQ(again.materials[again.spheres[0].material].cut_group, 0u);
  EXPECT_EQ(again.materials[again.triangles[0].material].cut_group, 1u);
  scene.cuts[0].caps = scene.cuts[0].eye_only = true;
  EXPECT_NE(losses(scene, "tachyon").find("cuts: the caps that close bodies\n"), std::string::npos);
  EXPECT_NE(losses(scene, "tachyon").find("cuts: that they are for the eye only\n"),
            std::string::npos);
  EXPECT_NE(losses(scene, "povray").find("cuts (2 times)\n"), std::string::npos)
      << losses(scene, "povray");
}

TEST(Writers, KeepTachyonsOwnFogSpotsAndLights) {
  Scene scene = held_by_tachyon();
  scene.fog = {Fog::Kind::exponential, 1, 9, 0.5, {0.5, 0.5, 0.5}, true};
  scene.lights.push_back({.position = {0, 3, 0},
                          .kind = LightKind::spot,
                          .direction = {0, -1, 0},
                          .inner_deg = 10,
                          .outer_deg = 20,
                          .linear_edge = true});
  // The light itself is seen.
  scene.materials.push_back({.ambient = {1, 1, 1},
                             .diffuse = {},
                             .shininess = 100,
                             .highlight = Highlight::blinn,
                             .casts_shadow = false});
  scene.spheres.insert(scene.spheres.begin(), {{{0, 3, 0}, 0.5}, 3});
  scene.lights[0].attenuation = Light{}.attenuation;
  EXPECT_EQ(losses(scene, "tachyon"), "");
  const Scene again = through(scene, "tachyon");
  EXPECT_EQ(again.fog, scene.fog);
  ASSERT_EQ(again.lights.size(), 3u);
  EXPECT_EQ(again.lights[2], scene.lights[2]);
  ASSERT_EQ(again.spheres.size(), 2u);
  EXPECT_EQ(again.spheres[0].shape.radius, 0.5);
  EXPECT_FALSE(again.materials[again.spheres[0].material].casts_shadow);
}

/// Ambient light and materials' shares of it as their product; the camera's window at distance 1.
Scene as_seen(Scene scene) {
  for (Material& m : scene.materials) {
    m.ambient = {m.ambient.r * scene.ambient_light.r, m.ambient.g * scene.ambient_light.g,
                 m.ambient.b * scene.ambient_light.b};
    m.highlight = Highlight::phong;
    m.shininess = 1;  // of no highlight
  }
  scene.ambient_light = {1, 1, 1};
  scene.defaults = {};
  scene.names.clear();
  const Vec3 eye = scene.camera.eye;
  Camera& c = scene.camera;
  const double away = std::fabs(c.window_center.z - eye.z);
  const auto near = [&](double v) { return std::round(v / away * 1e9) / 1e9; };
  c.window_center = {near(c.window_center.x - eye.x), near(c.window_center.y - eye.y),
                     near(c.window_center.z - eye.z)};
  for (Vec3* side : {&c.window_right, &c.window_up})
    *side = {near(side->x), near(side->y), near(side->z)};
  return scene;
}

TEST(Writers, GiveTheEqualSceneInFourFormats) {
  Scene scene;
  scene.resolution = {64, 64};
  scene.lights = {{.position = {2, 3, 4}}};
  for (int i = 0; i < 9; ++i) {
    const double x = i % 3 - 1, y = i / 3 - 1, red = (i + 1) / 16.0;
    add_sphere(scene, {0.6 * x, 0.6 * y, -1.3}, 0.25 + i / 100.0,
               {.ambient = {red, 0.5, 0.25}, .diffuse = {red, 0.5, 0.25}, .shininess = 1});
  }
  const Scene seen = as_seen(scene);
  for (const char* format : {"toml", "nff", "lab", "tachyon"}) {
    SCOPED_TRACE(format);
    expect_equal(seen, as_seen(through(scene, format)));
    expect_equal(seen, as_seen(through(through(scene, format), "toml")));
  }
}

Scene of_all_bodies() {
  Scene scene = lab_scene();
  scene.defaults = {};
  scene.materials = {{.specular = {0.5, 0.5, 0.5}}, {.refraction = 0.5, .ior = 1.5}};
  scene.transforms = {{{2, 0, 0}, {0, 1, 0}, {0, 0, 1}, {0, 3, 0}}};
  scene.tori = {{{}, 0}, {{}, 0, 1}, {{}, 1}};
  scene.ellipsoids = {{{{0, 0, 0}, {1, 2, 3}}, 0}};
  scene.quadrics = {{{}, 0}};
  scene.boxes = {{{{0, 0, 0}, {1, 1, 1}, 0.1}, 0}};
  scene.capsules = {{{}, 0}, {{}, 1}};
  scene.frustums = {{{{0, 0, 0}, 1, {0, 1, 0}, 1}, 0}, {{{0, 0, 0}, 1, {0, 1, 0}, 0}, 0}};
  scene.parallelograms = {{{}, 0}};
  return scene;
}

TEST(Writers, CountWhatTachyonHasTrianglesForAndLeavesOut) {
  EXPECT_EQ(
      losses(of_all_bodies(), "tachyon"),
      "warning: lost in Tachyon: materials: that what is transparent throws a full shadow\n"
      "warning: lost in Tachyon: materials: Phong's highlight, for which there is Blinn's of four "
      "times the exponent\n"
      "warning: lost in Tachyon: materials: that refracted rays are bent\n"
      "warning: lost in Tachyon: shapes: ellipsoid, for which there are triangles\n"
      "warning: lost in Tachyon: shapes: the round edges of boxes\n"
      "warning: lost in Tachyon: shapes: cones, for which there are triangles\n"
      "warning: lost in Tachyon: shapes: torus, for which there are triangles (3 times)\n"
      "warning: lost in Tachyon: shapes: capsules, for which there are triangles\n"
      "warning: lost in Tachyon: shapes: quadric\n"
      "warning: lost in Tachyon: the profile\n");
  const Scene again = through(of_all_bodies(), "tachyon");
  EXPECT_EQ(again.spheres.size(), 2u) << "a capsule's ends";
  EXPECT_EQ(again.cones.size(), 2u) << "its side, and a cylinder's";
  EXPECT_EQ(again.discs.size(), 2u) << "the cylinder's caps";
  EXPECT_EQ(again.boxes.size(), 1u);
  EXPECT_EQ(again.triangles.size(), 2u) << "the parallelogram";
}

TEST(Writers, CountWhatPovrayLoses) {
  Scene scene = of_all_bodies();
  EXPECT_EQ(losses(scene, "povray"),
            "warning: lost in POV-Ray: materials: that what is transparent throws a full shadow\n");
  scene.defaults.shadows = Shadows::transparent;
  EXPECT_EQ(losses(scene, "povray"), "");
  scene.lights[0].attenuation = {1, 1, 1};
  scene.fog.kind = Fog::Kind::linear;
  scene.ambient_occlusion.samples = 4;
  scene.defaults.profile = ProfileName::lab;
  EXPECT_EQ(losses(scene, "povray"),
            "warning: lost in POV-Ray: ambient occlusion\n"
            "warning: lost in POV-Ray: fog\n"
            "warning: lost in POV-Ray: lights: attenuation\n"
            "warning: lost in POV-Ray: the profile\n");
}

TEST(Writers, WritePovraysShapesAndMaterials) {
  Scene scene = of_all_bodies();
  scene.material_names[0] = "matt\n#include";
  const std::string text = text_of(scene, "povray");
  for (const char* part :
       {"#version 3.7;", "max_trace_level 5", "camera { perspective location <0,0,2>",
        "\n// matt↵#include\n#macro M0() ", "phong 0.5 phong_size 10", "interior { ior 1.5 }",
        "torus { 1, 0.25 sturm", "M0() matrix <2,0,0, 0,1,0, 0,0,1, 0,3,0> }",
        "sphere { 0, 1 scale <1,2,3> translate <0,0,0> M0() }",
        "cone { <0,0,0>, 1, <0,1,0>, 0  M0()"})
    expect_has(text, part);
}

TEST(Writers, PaintPovraysPigmentsAsItsPatternsAre) {
  const auto pigment = [](const Texture& texture) {
    Scene scene = of_all_bodies();
    scene.textures = {texture};
    scene.materials[0].textures = {{Coefficient::diffuse, 0}, {Coefficient::ambient, 0}};
    const std::string text = text_of(scene, "povray"), lost = losses(scene, "povray");
    const std::size_t begin = text.find("pigment { ") + 10, end = text.find(" } finish", begin);
    return text.substr(begin, end - begin) +
           (lost.find("the mean is kept") != std::string::npos            ? " (lost)"
            : lost.find("pictures in smaller sizes") != std::string::npos ? " (bilinear)"
                                                                          : "");
  };
  Texture t;
  t.colors = {{1, 0, 0}, {0, 1, 0}};
  t.size = 0.5;
  t.direction = {0, 0, 2};
  const std::string in_turn =
      "color_map { [0 rgbt <1,0,0,0>] [0.5 rgbt <1,0,0,0>] [0.5 rgbt <0,1,0,0>] [1 rgbt "
      "<0,1,0,0>] } scale 1";
  EXPECT_EQ(pigment(t), "checker rgbt <1,0,0,0>, rgbt <0,1,0,0> scale 0.5");
  t.kind = TextureKind::stripes;
  EXPECT_EQ(pigment(t), "gradient <0,0,1> " + in_turn);
  t.kind = TextureKind::gradient;
  EXPECT_EQ(pigment(t),
            "gradient <0,0,1> color_map { [0 rgbt <1,0,0,0>] [1 rgbt <0,1,0,0>] } scale 0.5");
  t.kind = TextureKind::rings;
  EXPECT_EQ(pigment(t), "wood ramp_wave " + in_turn + " matrix <1,0,0, 0,1,0, 0,0,1, 0,0,0>");
  t.transform.origin = {1, 2, 3};
  EXPECT_NE(pigment(t).find(" matrix <1,0,0, 0,1,0, 0,0,1, 1,2,3>"), std::string::npos);
  // What POV-Ray has otherwise, and what looks another way in the distance.
  t.turbulence = 1;
  EXPECT_NE(pigment(t).find("(lost)"), std::string::npos);
  t.kind = TextureKind::gradient, t.wrap = TextureWrap::clamp;
  EXPECT_NE(pigment(t).find("(lost)"), std::string::npos);
  t = {};
  t.kind = TextureKind::image;
  t.image = std::make_shared<Image>(1u, 1u);
  t.file = "a b.PNG";
  EXPECT_EQ(pigment(t),
            "image_map { png \"a b.PNG\" gamma srgb map_type 0 interpolate 2 } (bilinear)");
  t.filter = TextureFilter::nearest, t.transfer = Transfer::linear, t.file = "a.jpg";
  EXPECT_EQ(pigment(t), "image_map { jpeg \"a.jpg\" gamma 1.0 map_type 0 }");
  t.filter = TextureFilter::bilinear, t.file = "sky.hdr";
  EXPECT_EQ(pigment(t), "image_map { hdr \"sky.hdr\" map_type 0 interpolate 2 }");
  for (const char* file : {"", "a.webp", "a\".png", "png"}) {
    t.file = file;
    EXPECT_NE(pigment(t).find("(lost)"), std::string::npos) << file;
  }
  t.file = "a.png", t.mapping = TextureMapping::uv;
  EXPECT_NE(pigment(t).find("(lost)"), std::string::npos);
}

TEST(Writers, DispersePovraysGlassAsItsFormulaSays) {
  Scene scene = of_all_bodies();
  scene.defaults.wavelengths = 9;
  for (Material& m : scene.materials)
    if (m.refraction.most() > 0) m.dispersion = {Dispersion::Kind::cauchy, {1.5, 0.01, 0.0002}};
  const std::string text = text_of(scene, "povray");
  const auto number_behind = [&](const std::string& word) {
    const std::size_t found = text.find(word);
    EXPECT_NE(found, std::string::npos) << word << " in " << text;
    return found == std::string::npos ? 0 : std::stod(text.substr(found + word.size()));
  };
  const double ior = number_behind("interior { ior "), ratio = number_behind(" dispersion ");
  EXPECT_EQ(number_behind("dispersion_samples "), 9);
  // POV-Ray 3.7 spreads its bands evenly from 380 to 730 nm and takes ior·dispersion^((555 -
  // λ)/350).
  const auto theirs = [&](double nm) { return ior * std::pow(ratio, (555 - nm) / 350); };
  const auto cauchy = [](double nm) { return 1.5 + 1e4 / (nm * nm) + 2e8 / std::pow(nm, 4); };
  EXPECT_NEAR(theirs(587.5618), cauchy(587.5618), 1e-6);
  EXPECT_NEAR(theirs(486.1327) / theirs(656.2725), cauchy(486.1327) / cauchy(656.2725), 1e-6);
  scene.defaults.wavelengths = 1;  // which switches it off
  EXPECT_EQ(text_of(scene, "povray").find("dispersion"), std::string::npos);
}

TEST(Writers, FadePovraysLightsAsTheirsFade) {
  Scene scene = of_all_bodies();
  scene.lights = {{.position = {1, 2, 3}, .color = {2, 4, 8}, .attenuation = {2, 0, 0.5}},
                  {.position = {}, .color = {1, 1, 1}, .attenuation = {0, 0, 4}},
                  {.position = {}, .color = {1, 1, 1}, .attenuation = {0, 2, 0}},
                  {.position = {}, .color = {2, 1, 1}, .attenuation = {2, 0, 0}}};
  const std::string text = text_of(scene, "povray");
  std::size_t at = 0;
  for (const Light& light : scene.lights) {
    at = text.find("light_source", at) + 1;
    const std::string line = text.substr(at, text.find('\n', at) - at);
    const auto number_behind = [&](const std::string& word, double usual) {
      const std::size_t found = line.find(word);
      return found == std::string::npos ? usual : std::stod(line.substr(found + word.size()));
    };
    const double color = number_behind("rgb <", 0), power = number_behind("fade_power ", 0);
    const double away = number_behind("fade_distance ", 1);
    for (const double d : {1.0, 3.0}) {
      const Vec3& a = light.attenuation;
      const double strength = light.color.r / (a.x + a.y * d + a.z * d * d);
      // POV-Ray's formula.
      EXPECT_NEAR(power == 0 ? color : color * 2 / (1 + std::pow(d / away, power)), strength,
                  1e-3 * strength)
          << line;
    }
  }
}

TEST(Writers, KeepTrianglesOfGroupsTogetherForGlass) {
  Scene scene = lab_scene();
  scene.materials = {{}, {.refraction = 1, .ior = 1.5}};
  scene.groups.resize(1);
  scene.groups[0].triangles = {{{}, kMaterialOfWhole}, {{}, 0}, {{}, kMaterialOfWhole}};
  scene.groups[0].smooth_triangles = {{{}, kMaterialOfWhole}};
  scene.instances = {{{0}, 1}};
  const std::string text = text_of(scene, "povray");
  // A mesh has an inside, loose triangles do not.
  const std::size_t group = text.find("#declare Group0"), first = text.find("mesh {", group),
                    second = text.find("mesh {", first + 1);
  ASSERT_NE(second, std::string::npos) << text;
  EXPECT_EQ(text.find("mesh {", second + 1), std::string::npos);
  expect_has(text, "object { Group0 M1()");
}

TEST(Writers, WriteOnlyMaterialsThatShapesHave) {
  Scene scene = of_all_bodies();
  scene.materials.push_back({.diffuse = {0.123456789, 0, 0}});
  EXPECT_EQ(text_of(scene, "povray").find("0.123456789"), std::string::npos);
  EXPECT_EQ(text_of(scene, "tachyon").find("0.123456789"), std::string::npos);
  scene.csgs.push_back({{CsgOperation::unite, {{Box{}, 2}, {Box{}, 2}}}, 0});
  expect_has(text_of(scene, "povray"), "0.123456789");
}

TEST(Writers, WriteGroupsOutForTachyonUnlessTheyAreTooMany) {
  Scene scene = lab_scene();
  scene.materials = {{}};
  scene.groups.resize(1);
  scene.groups[0].spheres = {{{{1, 0, 0}, 0.5}, kMaterialOfWhole}};
  scene.transforms = {{{2, 0, 0}, {0, 2, 0}, {0, 0, 2}, {0, 1, 0}},
                      {{1, 0, 0}, {0, 3, 0}, {0, 0, 1}, {0, 0, 0}}};
  scene.instances = {{{0}, 0, 1}, {{0}, 0, 2}};
  const Scene again = through(scene, "tachyon");
  ASSERT_EQ(again.spheres.size(), 1u);
  EXPECT_EQ(again.spheres[0].shape.center, (Vec3{2, 1, 0}));
  EXPECT_EQ(again.spheres[0].shape.radius, 1);
  EXPECT_GT(again.smooth_triangles.size(), 1000u) << "a squashed sphere";
  expect_has(text_of(scene, "povray"), "object { Group0 M0() matrix <2,");
  // Ten instances of ten instances of ten…
  for (std::uint32_t i = 1; i <= 9; ++i) {
    scene.groups.emplace_back();
    scene.groups[i].instances.assign(10, {{i - 1}, kMaterialOfWhole});
  }
  scene.instances = {{{9}, 0}};
  expect_has(losses(scene, "tachyon"),
             "error: Tachyon cannot say this scene: it knows no instances, and without them there "
             "are 2111111111 shapes\n");
}

TEST(Writers, RefuseCamerasThatTachyonDoesNotKnow) {
  Scene scene = of_all_bodies();
  scene.camera.kind = CameraKind::fisheye;
  expect_has(losses(scene, "tachyon"),
             "error: Tachyon cannot say what this scene's camera is: it knows perspective, "
             "orthographic and panorama\n");
  scene.camera.kind = CameraKind::pinhole;
  scene.camera.window_up = {1, 2, 0};
  expect_has(losses(scene, "tachyon"), "its sides are askew\n");
}

TEST(Writers, KeepParallelRaysAndPanoramas) {
  for (const CameraKind kind : {CameraKind::orthographic, CameraKind::panorama}) {
    Scene scene = held_by_tachyon();
    scene.camera.kind = kind;
    if (kind == CameraKind::panorama) scene.camera.latitude_middle_deg = 10;
    const Camera again = through(scene, "tachyon").camera;
    EXPECT_EQ(again.kind, kind);
    EXPECT_EQ(again.eye, scene.camera.eye);
    EXPECT_GT(again.window_right.x, 0);
    EXPECT_EQ(again.longitude_deg, 360);
    EXPECT_NEAR(again.latitude_middle_deg, scene.camera.latitude_middle_deg, 1e-9);
  }
}

TEST(Tessellation, LiesOnTheSurfaceWithItsNormals) {
  const auto expect_near = [](const auto& body, double tolerance) {
    using Body = std::decay_t<decltype(body)>;
    const std::vector<SmoothTriangle> all = tessellated(AnyBody(body));
    EXPECT_GT(all.size(), 100u);
    for (const SmoothTriangle& t : all) {
      EXPECT_LT(ShapeTraits<Body>::distance_to(body, t.a), tolerance);
      const Vec3 &a = t.a, &b = t.b, &c = t.c, &n = t.normal_a;
      const Vec3 u{b.x - a.x, b.y - a.y, b.z - a.z}, v{c.x - a.x, c.y - a.y, c.z - a.z};
      const Vec3 w{u.y * v.z - u.z * v.y, u.z * v.x - u.x * v.z, u.x * v.y - u.y * v.x};
      const double along =
          (w.x * n.x + w.y * n.y + w.z * n.z) /
          std::sqrt((w.x * w.x + w.y * w.y + w.z * w.z) * (n.x * n.x + n.y * n.y + n.z * n.z));
      EXPECT_GT(std::fabs(along), 0.8);
    }
  };
  expect_near(Ellipsoid{{1, 2, 3}, {1, 2, 0.7}}, 1e-9);
  expect_near(Torus{{1, 0, 0}, {1, 1, 0}, 2, 0.5}, 1e-9);
  expect_near(Frustum{{0, 0, 0}, 1, {0, 0, 2}, 0.5}, 1e-9);
  expect_near(Disc{{0, 1, 0}, {0, 1, 1}, 2, 1}, 1e-9);
  EXPECT_EQ(tessellated(Box{}).size(), 12u);
  EXPECT_TRUE(tessellated(Quadric{}).empty());
}

}  // namespace
}  // namespace zraka
