// SPDX-License-Identifier: Apache-2.0
// Scenes in other formats: the same picture, and a word for all that is lost.
#include <gtest/gtest.h>

#include <algorithm>
#include <cstring>
#include <zraka/formats.hpp>

#include "equal_scenes.hpp"
#include "scenes.hpp"

namespace zraka {
namespace {

Scene read_again(const std::string& text) {
  Result<ReadScene> read = parse_scene(text, "again");
  if (!read) ADD_FAILURE() << to_string(read.error().front());
  return read ? std::move(read->scene) : Scene{};
}

Scene through(const Scene& scene, const char* format) {
  return read_again(write_scene(scene, format).value().text);
}

std::string losses(const Scene& scene, const char* format) {
  const Result<WrittenScene> written = write_scene(scene, format);
  std::string all;
  for (const Diagnostic& d : written ? written->losses : written.error()) all += to_string(d);
  return all;
}

std::vector<NamedScene> convertible_scenes() {
  std::vector<NamedScene> scenes = test_scenes(60);
  for (const char* path : {"lab/bubble.txt", "nff/benzene.nff"})
    scenes.push_back(
        {path, read_scene(std::string(ZRAKA_SOURCE_DIR "/scenes/") + path).value().scene});
  for (NamedScene& each : scenes) each.scene.resolution = {60, 60};
  return scenes;
}

/// With what its file says of rendering.
Image picture(const Scene& scene) {
  RenderOptions options;
  options.profile = profile_of(scene.defaults.profile);
  options.max_depth = scene.defaults.max_depth;
  options.terms.shadows = scene.defaults.shadows == Shadows::opaque;
  return render(scene, options).value().image;
}

TEST(Convert, ToTheSceneLanguageKeepsEveryBit) {
  for (const auto& [name, scene] : convertible_scenes()) {
    SCOPED_TRACE(name);
    EXPECT_EQ(losses(scene, "toml"), "");
    const Scene again = through(scene, "toml");
    expect_equal(scene, again);
    EXPECT_EQ(picture(scene).pixels, picture(again).pixels);
    const std::string text = write_toml(again).value();
    EXPECT_EQ(write_toml(read_again(text)).value(), text) << "the canonical form stays";
  }
}

TEST(Convert, BackToInputTxtKeepsEveryBit) {
  for (const char* file : {"input", "letter", "bubble"}) {
    const Scene scene =
        read_scene(std::string(ZRAKA_SOURCE_DIR "/scenes/lab/") + file + ".txt").value().scene;
    const Scene language = through(scene, "toml");
    EXPECT_EQ(losses(language, "lab"), "");
    expect_equal(scene, through(language, "lab"));
  }
}

TEST(Convert, BackToNffKeepsEveryShape) {
  Scene scene = read_scene(ZRAKA_SOURCE_DIR "/scenes/nff/benzene.nff").value().scene;
  Scene language = through(scene, "toml");
  EXPECT_EQ(losses(language, "nff"), "");
  Scene again = through(language, "nff");
  // The angle of view goes through functions that round.
  EXPECT_NEAR(again.camera.window_up.y / again.camera.window_right.x,
              scene.camera.window_up.y / scene.camera.window_right.x, 1e-9);
  scene.camera = again.camera = {};
  // Materials are numbered as shapes name them first: give each shape one of its own.
  const auto number_alike = [](Scene& numbered) {
    const std::vector<Material> materials = std::move(numbered.materials);
    numbered.materials.clear();
    const auto renumber = [&](auto& objects) {
      for (auto& object : objects) {
        numbered.materials.push_back(materials[object.material]);
        object.material = static_cast<std::uint32_t>(numbered.materials.size() - 1);
      }
    };
#define ZRAKA_RENUMBER(Type, plural) renumber(numbered.plural);
    ZRAKA_SHAPES(ZRAKA_RENUMBER)
#undef ZRAKA_RENUMBER
  };
  number_alike(scene);
  number_alike(again);
  expect_equal(scene, again);
}

TEST(Convert, SaysWhatNffLoses) {
  Scene scene = tangled_scene();
  scene.names[{0, 0}] = "a";
  scene.names[{0, 1}] = "b";
  scene.defaults.shadows = Shadows::off;
  scene.defaults.max_depth = 9;
  EXPECT_EQ(
      losses(scene, "nff"),
      "warning: lost in NFF: the ambient light, which NFF's rule gives\n"
      "warning: lost in NFF: names (2 times)\n"
      "warning: lost in NFF: the profile\n"
      "warning: lost in NFF: the depth of rays\n"
      "warning: lost in NFF: that there are no shadows\n"
      "warning: lost in NFF: materials: another ambient share than the diffuse one (42 times)\n"
      "warning: lost in NFF: materials: the highlight's colour (40 times)\n"
      "warning: lost in NFF: materials: another share of the reflected ray than of the highlight "
      "(41 times)\n");
  scene.camera.window_center.x = 1;
  EXPECT_EQ(
      losses(scene, "nff"),
      "error: NFF cannot say where this scene's window is: it knows those that the eye looks at "
      "straight\n");
}

/// A sphere before the lab's window, with all that formats of other people do not know.
Scene rich_scene() {
  Scene scene = lab_scene();
  add_sphere(scene, {0, 0, 0}, 1,
             {.reflection = Color{0, 0.5, 0},
              .refraction = 0.5,
              .highlight = Highlight::blinn,
              .fresnel = Fresnel::exact,
              .absorption = {1, 0, 0},
              .priority = 2,
              .dispersion = {Dispersion::Kind::abbe, {60}}});
  scene.camera.aperture = 0.1;
  scene.sky.kind = Sky::Kind::gradient;
  scene.ambient_occlusion.samples = 4;
  scene.defaults.shadows = Shadows::transparent;
  scene.defaults.min_contribution = 0.1;
  scene.defaults.wavelengths = 3;
  scene.defaults.sampling = {.count = 4, .filter = PixelFilter::tent, .seed = 1};
  return scene;
}

TEST(Convert, SaysWhatNffLosesOfOptics) {
  Scene scene = rich_scene();
  scene.lights = {{.position = {1, 2, 3}},
                  {.position = {}, .kind = LightKind::directional},
                  {.position = {}, .kind = LightKind::spot, .attenuation = {0, 0, 1}},
                  {.position = {}, .kind = LightKind::disc},
                  {.position = {0, 0, 9}, .kind = LightKind::rectangle}};
  EXPECT_EQ(
      losses(scene, "nff"),
      "warning: lost in NFF: lights: directional ones\n"
      "warning: lost in NFF: lights: the cones of spots\n"
      "warning: lost in NFF: lights: attenuation\n"
      "warning: lost in NFF: lights: the size of rectangles, discs and spheres (2 times)\n"
      "warning: lost in NFF: the camera's lens\n"
      "warning: lost in NFF: the sky's gradient\n"
      "warning: lost in NFF: ambient occlusion\n"
      "warning: lost in NFF: the ambient light, which NFF's rule gives\n"
      "warning: lost in NFF: the profile\n"
      "warning: lost in NFF: that shadows are transparent\n"
      "warning: lost in NFF: the least contribution\n"
      "warning: lost in NFF: the samples of pixels\n"
      "warning: lost in NFF: the filter of samples\n"
      "warning: lost in NFF: the seed\n"
      "warning: lost in NFF: the number of wavelengths\n"
      "warning: lost in NFF: materials: another ambient share than the diffuse one\n"
      "warning: lost in NFF: materials: Blinn's highlight\n"
      "warning: lost in NFF: materials: colours of the shares of reflected and refracted rays\n"
      "warning: lost in NFF: materials: Fresnel's law\n"
      "warning: lost in NFF: materials: absorption\n"
      "warning: lost in NFF: materials: priority\n"
      "warning: lost in NFF: materials: dispersion\n");
  const Scene again = through(scene, "nff");
  ASSERT_EQ(again.lights.size(), 4u);
  EXPECT_EQ(again.lights[3].position, (Vec3{0.5, 0, 9.5})) << "the middle of the rectangle";
  scene.camera.kind = CameraKind::fisheye;
  EXPECT_EQ(losses(scene, "nff"),
            "error: NFF cannot say what this scene's camera is: it knows pinholes alone\n");
}

TEST(Convert, SaysWhatInputTxtLosesOfOptics) {
  Scene scene = rich_scene();
  scene.defaults = {ProfileName::lab};
  scene.lights[0].attenuation = {1, 1, 0};
  const std::string sky =
      "error: the course's input.txt format cannot say another background than black or another "
      "ambient light than 0.5\n";
  EXPECT_EQ(losses(scene, "lab"), sky);
  scene.sky = {};
  EXPECT_EQ(losses(scene, "lab"),
            "warning: lost in input.txt: lights: attenuation\n"
            "warning: lost in input.txt: the camera's lens\n"
            "warning: lost in input.txt: ambient occlusion\n"
            "warning: lost in input.txt: materials: Blinn's highlight\n"
            "warning: lost in input.txt: materials: colours of the shares of reflected and "
            "refracted rays\n"
            "warning: lost in input.txt: materials: Fresnel's law\n"
            "warning: lost in input.txt: materials: absorption\n"
            "warning: lost in input.txt: materials: priority\n"
            "warning: lost in input.txt: materials: dispersion\n");
  scene.lights[0].kind = LightKind::spot;
  EXPECT_EQ(losses(scene, "lab"),
            "error: the course's input.txt format cannot say this light: it knows those that shine "
            "from a point into all directions\n");
  scene.camera.kind = CameraKind::panorama;
  EXPECT_EQ(losses(scene, "lab"),
            "error: the course's input.txt format cannot say what this scene's camera is: it knows "
            "pinholes alone\n");
}

TEST(Convert, SaysWhatInputTxtLosesAndCannotSay) {
  Scene scene = lab_scene();
  add_sphere(scene, {0, 0, 0}, 1, {});
  scene.defaults = {ProfileName::physical, 5, Shadows::opaque};
  Scene parallel = scene;
  parallel.camera.kind = CameraKind::orthographic;
  EXPECT_EQ(losses(parallel, "nff"),
            "error: NFF cannot say what this scene's camera is: it knows pinholes alone\n");
  EXPECT_EQ(losses(scene, "lab"),
            "warning: lost in input.txt: the profile\n"
            "warning: lost in input.txt: the depth of rays\n");
  EXPECT_EQ(
      losses(mixed_scene(), "lab"),
      "error: the course's input.txt format cannot say these lights: it knows one white light\n");
  EXPECT_EQ(losses(scene, "obj"),
            "error: 'obj' is no format that can be written\n  formats: nff, toml, tachyon, povray, lab\n");
}

TEST(Convert, KnowsFormatsByTheNamesOfFiles) {
  Scene scene = lab_scene();
  add_sphere(scene, {0, 0, 0}, 1, {});
  for (const auto& [file, format] :
       {std::pair("a.toml", "toml"), {"b.TXT", "lab"}, {"c.nff", "nff"}, {"d.DAT", "tachyon"}, {"e.pov", "povray"}})
    EXPECT_EQ(write_scene(scene, file).value().text, write_scene(scene, format).value().text);
}

TEST(Convert, GivesMaterialsWithoutNamesOnesThatAreFree) {
  Scene scene = lab_scene();
  for (int i = 0; i < 3; ++i) add_sphere(scene, {0, 0, 0}, 1, {});
  scene.material_names[2] = "material_1";
  const Scene again = through(scene, "toml");
  EXPECT_EQ(again.material_names.at(0), "material_1_");
  EXPECT_EQ(again.material_names.at(1), "material_2");
  EXPECT_EQ(again.material_names.at(2), "material_1");
  EXPECT_EQ(again.spheres[2].material, 2u);
}

}  // namespace
}  // namespace zraka
