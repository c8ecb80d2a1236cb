// SPDX-License-Identifier: Apache-2.0
// The scene language: what it means, and the exact answer to each way of getting it wrong.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cmath>
#include <string>
#include <zraka/formats.hpp>

#include "equal_scenes.hpp"
#include "formats/formats.hpp"
#include "language/shapes.hpp"

namespace zraka {
namespace {

Result<ReadScene> read(const std::string& text) {
  return parse_toml(text, "s.toml");
}
std::string answer(const std::string& text) {
  const Result<ReadScene> scene = read(text);
  std::string all;
  for (const Diagnostic& d : scene ? scene->warnings : scene.error()) all += to_string(d);
  return all;
}
Scene scene(const std::string& text) {
  const Result<ReadScene> scene = read(text);
  if (!scene) ADD_FAILURE() << answer(text);
  return scene ? scene->scene : Scene{};
}

std::string names_of_kinds() {
  std::string names;
  for (const language::Kind* kind : language::kShapeFamily.kinds)
    names += (names.empty() ? "" : ", ") + std::string(kind->name);
  return names;
}

const std::string kSphere = "[[shape]]\nkind = \"sphere\"\ncenter = [1, 2, 3]\nradius = 0.5\n";

TEST(SceneLanguage, HasDefaultsForAllThatIsNotSaid) {
  const Scene s = scene("");
  EXPECT_EQ(s.resolution.width, 400u);
  EXPECT_EQ(s.ambient_light, (Color{0.5, 0.5, 0.5}));
  EXPECT_EQ(s.background, (Color{}));
  EXPECT_EQ(s.defaults, RenderDefaults());
  EXPECT_EQ(s.camera.eye, (Vec3{0, 0, 5}));
  EXPECT_EQ(s.camera.window_center, (Vec3{0, 0, 4})) << "looks towards -z";
  EXPECT_EQ(s.shape_count(), 0u);
}

TEST(SceneLanguage, HasAPerspectiveCameraWithItsAngleOverTheHeight) {
  const Scene s = scene(
      "[image]\nwidth = 40\nheight = 20\n[camera]\neye = [0, 0, 5]\n"
      "look_at = [0, 0, 1]\nfov_deg = 90\n");
  EXPECT_EQ(s.camera.window_center, (Vec3{0, 0, 4}));
  EXPECT_NEAR(s.camera.window_up.y, 2, 1e-12);  // 90 degrees at distance 1
  EXPECT_NEAR(s.camera.window_right.x, 4, 1e-12);
}

TEST(SceneLanguage, HasTheLabsWindow) {
  const Scene s = scene(
      "[camera]\nkind = \"window\"\nwindow = {center = [0, 0, 1], right = [2, 0, 0], "
      "up = [0, 3, 0]}\n");
  EXPECT_EQ(s.camera.eye, (Vec3{0, 0, 2}));
  EXPECT_EQ(s.camera.window_center, (Vec3{0, 0, 1}));
  EXPECT_EQ(s.camera.window_right, (Vec3{2, 0, 0}));
  EXPECT_EQ(s.camera.window_up, (Vec3{0, 3, 0}));
}

TEST(SceneLanguage, SaysHowToRender) {
  const Scene s = scene(
      "[render]\nprofile = \"lab\"\nmax_depth = 7\nshadows = \"off\"\nsamples = 1\n"
      "filter = \"box\"\nmin_contribution = 0\nseed = 0\nwavelengths = 12\n");
  EXPECT_EQ(s.defaults, (RenderDefaults{ProfileName::lab, 7, Shadows::off}));
}

TEST(SceneLanguage, HasColoursOfThreeKinds) {
  const Scene s = scene(
      "[scene]\nambient = 0.25\nbackground = [0.1, 0.2, 3]\n"
      "[[light]]\nposition = [0, 0, 1]\ncolor = \"#ff8000\"\n");
  EXPECT_EQ(s.ambient_light, (Color{0.25, 0.25, 0.25}));
  EXPECT_EQ(s.background, (Color{0.1, 0.2, 3}));
  ASSERT_EQ(s.lights.size(), 1u);
  EXPECT_EQ(s.lights[0].color.r, 1);
  EXPECT_EQ(s.lights[0].color.b, 0);
  for (int byte = 0; byte < 256; ++byte) {  // IEC 61966-2-1 by the C library's power
    const double v = byte / 255.0;
    const double light = v <= 0.04045 ? v / 12.92 : std::pow((v + 0.055) / 1.055, 2.4);
    const Scene grey = scene(fmt::format("[scene]\nambient = \"#{0:02x}{0:02X}{0:02x}\"\n", byte));
    EXPECT_NEAR(grey.ambient_light.g, light, 2e-15 * light) << byte;
  }
}

TEST(SceneLanguage, HasMaterialsByName) {
  const Scene s = scene(
      "[material.a]\nreflection = 0.5\ndiffuse = 0.25\ncolor = [1, 0, 0]\nior = 1.5\n"
      "[material.\"b c\"]\nspecular = 0.5\nshininess = 3\nrefraction = 0.75\n" +
      kSphere + "material = \"b c\"\n" + kSphere + "material = \"a\"\n" + kSphere);
  ASSERT_EQ(s.materials.size(), 3u);
  EXPECT_EQ(s.materials[0].ambient, (Color{1, 0, 0})) << "color is short for both";
  EXPECT_EQ(s.materials[0].diffuse, (Color{0.25, 0.25, 0.25})) << "what is said wins, wherever";
  EXPECT_EQ(s.materials[0].reflection, 0.5);
  EXPECT_EQ(s.materials[0].ior, 1.5);
  EXPECT_EQ(s.materials[1].specular, (Color{0.5, 0.5, 0.5}));
  EXPECT_EQ(s.materials[1].shininess, 3);
  EXPECT_EQ(s.materials[1].refraction, 0.75);
  EXPECT_EQ(s.materials[2], Material{}) << "default";
  ASSERT_EQ(s.spheres.size(), 3u);
  EXPECT_EQ(s.spheres[0].material, 1u);
  EXPECT_EQ(s.spheres[1].material, 0u);
  EXPECT_EQ(s.spheres[2].material, 2u);
  const Scene both = scene("[material.a]\ncolor = 0.5\n");
  EXPECT_EQ(both.materials[0].ambient, (Color{0.5, 0.5, 0.5}));
  EXPECT_EQ(both.materials[0].diffuse, (Color{0.5, 0.5, 0.5}));
  const Scene own = scene("[material.default]\ndiffuse = 1\n" + kSphere);
  ASSERT_EQ(own.materials.size(), 1u);
  EXPECT_EQ(own.materials[0].diffuse, (Color{1, 1, 1}));
}

TEST(SceneLanguage, HasShapes) {
  const Scene s = scene(
      kSphere + "name = \"ball\"\n" +
      "[[shape]]\nkind = \"cylinder\"\nbase = [0, 0, 0]\ntop = [0, 1, 0]\nradius = 2\ncaps = "
      "false\n"
      "[[shape]]\nkind = \"cone\"\nbase = [0, 0, 0]\ntop = [0, 1, 0]\nbase_radius = 2\ncaps = "
      "false\n"
      "name = \"hat\"\n"
      "[[shape]]\nkind = \"triangle\"\na = [0, 0, 0]\nb = [1, 0, 0]\nc = [0, 1, 0]\n"
      "[[shape]]\nkind = \"triangle\"\na = [0, 0, 0]\nb = [1, 0, 0]\nc = [0, 1, 0]\n"
      "normals = [[0, 0, 1], [0, 1, 1], [1, 0, 1]]\n"
      "[[shape]]\nkind = \"polygon\"\npoints = [[0, 0, 0], [1, 0, 0], [1, 1, 0], [0, 1, 0]]\n");
  ASSERT_EQ(s.spheres.size(), 1u);
  EXPECT_EQ(s.spheres[0].shape.center, (Vec3{1, 2, 3}));
  EXPECT_EQ(s.spheres[0].shape.radius, 0.5);
  ASSERT_EQ(s.cones.size(), 2u);
  EXPECT_EQ(s.cones[0].shape.base_radius, 2);
  EXPECT_EQ(s.cones[0].shape.apex_radius, 2);
  EXPECT_EQ(s.cones[1].shape.apex_radius, 0);
  ASSERT_EQ(s.smooth_triangles.size(), 1u);
  EXPECT_EQ(s.smooth_triangles[0].shape.normal_b, (Vec3{0, 1, 1}));
  EXPECT_EQ(s.triangles.size(), 3u) << "a square is two";
  EXPECT_EQ(s.names.size(), 2u);
  EXPECT_EQ(s.names.at({0, 0}), "ball");
  EXPECT_EQ(s.names.at({3, 1}), "hat");
}

TEST(SceneLanguage, SuggestsWhatMayBeMeant) {
  EXPECT_EQ(answer("[[shape]]\nkind = \"sphere\"\ncenter = [0, 1, 0]\nradus = 1\nradius = 1\n"),
            "s.toml:4:1: error: unknown field 'radus' of sphere\n"
            "  radus = 1\n  ^\n"
            "  did you mean 'radius'?\n");
  EXPECT_EQ(answer("[[shape]]\nkind = \"shpere\"\n"),
            "s.toml:2:8: error: unknown kind 'shpere' of shape\n"
            "  kind = \"shpere\"\n         ^\n"
            "  did you mean 'sphere'?\n");
  EXPECT_EQ(
      answer("[lihgt]\n"),
      "s.toml:1:2: error: unknown section 'lihgt'\n  [lihgt]\n   ^\n  did you mean 'light'?\n");
  EXPECT_EQ(answer("[material.glass]\n" + kSphere + "material = \"glas\"\n"),
            "s.toml:6:12: error: unknown material 'glas'\n"
            "  material = \"glas\"\n             ^\n"
            "  did you mean 'glass'?\n");
  EXPECT_EQ(answer(kSphere + "material = \"glass\"\n"),
            "s.toml:5:12: error: unknown material 'glass'\n"
            "  material = \"glass\"\n             ^\n"
            "  there are no materials\n");
  EXPECT_EQ(answer("[material.a]\nkd = 1\n"),
            "s.toml:2:1: error: unknown field 'kd' of material a\n"
            "  kd = 1\n  ^\n"
            "  did you mean 'diffuse'?\n");
  EXPECT_EQ(answer("[image]\ncolour_depth = 1\n"),
            "s.toml:2:1: error: unknown field 'colour_depth' of image\n"
            "  colour_depth = 1\n  ^\n"
            "  fields of image: width, height\n");
  EXPECT_EQ(answer("[render]\nprofile = \"Lab\"\n"),
            "s.toml:2:11: error: profile of render is \"Lab\": expected \"lab\", \"physical\", "
            "\"spd\" or \"tachyon\"\n"
            "  profile = \"Lab\"\n            ^\n"
            "  did you mean 'lab'?\n");
}

TEST(SceneLanguage, SaysWhatIsWrongWithValuesThatDoNotGoTogether) {
  EXPECT_EQ(answer("[image]\nwidth = 100000\nheight = 100000\n"),
            "s.toml:1:1: error: an image of 100000×100000 pixels is too large: expected 134217728 "
            "pixels at most\n"
            "  [image]\n  ^\n");
  EXPECT_EQ(answer("[camera]\neye = [1, 2, 3]\nlook_at = [1, 2, 3]\n"),
            "s.toml:3:11: error: the camera's eye is at the point that it looks at\n"
            "  look_at = [1, 2, 3]\n            ^\n");
  EXPECT_EQ(answer("[camera]\nfov_deg = 1e-200\n"),
            "s.toml:2:11: error: the angle of view is too small to be told from 0\n"
            "  fov_deg = 1e-200\n            ^\n");
  EXPECT_EQ(answer("[camera]\nup = [0, 0, 2]\n"),
            "s.toml:2:6: error: up of perspective camera is the direction of view\n"
            "  up = [0, 0, 2]\n       ^\n"
            "  expected a direction that is not the one from eye to look_at\n");
  EXPECT_EQ(
      answer("[camera]\nkind = \"window\"\nwindow = {center = [0, 0, 0], right = [1, 0, 0], up = "
             "[2, 0, 0]}\n"),
      "s.toml:3:10: error: right and up of the camera's window span no plane\n"
      "  window = {center = [0, 0, 0], right = [1, 0, 0], …\n           ^\n");
  EXPECT_EQ(
      answer("[[shape]]\nkind = \"polygon\"\npoints = [[0, 0, 0], [1, 0, 0], [1, 1, 0.5], [0, 1, "
             "0]]\n"),
      "s.toml:3:10: error: points of polygon are in no plane: one is out of it by 0.24 of the "
      "polygon's reach\n"
      "  points = [[0, 0, 0], [1, 0, 0], [1, 1, 0.5], [0, …\n           ^\n");
  EXPECT_EQ(
      answer("[[shape]]\nkind = \"polygon\"\npoints = [[0, 0, 0], [1, 1, 1], [2, 2, 2]]\n"),
      "s.toml:3:10: error: points of polygon are all on one line, or its edges cross: corners "
      "are named in turn, round the polygon\n"
      "  points = [[0, 0, 0], [1, 1, 1], [2, 2, 2]]\n           ^\n");
  EXPECT_EQ(
      answer("[[shape]]\nkind = \"cone\"\nbase = [0, 0, 0]\ntop = [0, 0, 0]\nbase_radius = 1\n"
             "caps = false\n"),
      "s.toml:1:1: error: cone: its ends are one point\n  [[shape]]\n  ^\n");
}

TEST(SceneLanguage, SaysHowSectionsAreWritten) {
  EXPECT_EQ(answer("image = 3\n"),
            "s.toml:1:1: error: 'image' is not written as a section: expected [image]\n"
            "  image = 3\n  ^\n");
  EXPECT_EQ(answer("[light]\nposition = [0, 0, 0]\n"),
            "s.toml:1:2: error: 'light' is not written as a section: expected [[light]]\n"
            "  [light]\n   ^\n");
  EXPECT_EQ(answer("[material]\ndiffuse = 1\n"),
            "s.toml:2:1: error: 'material' is not written as a section: expected [material.NAME]\n"
            "  diffuse = 1\n  ^\n");
  EXPECT_EQ(answer("[[shape]]\n"),
            "s.toml:1:1: error: shape has no kind\n  [[shape]]\n  ^\n"
            "  kinds of shape: " +
                names_of_kinds() + "\n");
}

TEST(SceneLanguage, TellsAllProblemsInTheOrderOfTheFile) {
  EXPECT_EQ(
      answer(
          "[[shape]]\nkind = \"sphere\"\nradius = 0\n[camera]\neye = [0, 0]\n[image]\nwidth = 0\n"),
      "s.toml:1:1: error: sphere has no center: expected its centre, [x, y, z], finite numbers\n"
      "  [[shape]]\n  ^\n"
      "s.toml:3:10: error: radius of sphere is 0: expected a number greater than 0\n"
      "  radius = 0\n           ^\n"
      "s.toml:5:7: error: eye of perspective camera is [0, 0]: expected [x, y, z], finite "
      "numbers\n"
      "  eye = [0, 0]\n        ^\n"
      "s.toml:7:9: error: width of image is 0: expected a whole number from 1 to 134217728\n"
      "  width = 0\n          ^\n");
  // What cannot be read may hold what is missed.
  EXPECT_EQ(answer("[[shape]]\nkind = \"sphere\"\ncenter = oops\nradius = -1\n"),
            "s.toml:3:10: error: 'oops' is not a value\n"
            "  center = oops\n           ^\n"
            "  text stands in quotes: \"…\"\n"
            "s.toml:4:10: error: radius of sphere is -1: expected a number greater than 0\n"
            "  radius = -1\n           ^\n");
}

TEST(SceneLanguage, TellsABoundedNumberOfProblems) {
  std::string text = "[material.a]\n";
  for (int i = 0; i < 1000; ++i) text += fmt::format("k{} = 1\n", i);
  const Result<ReadScene> broken = read(text);
  ASSERT_FALSE(broken);
  EXPECT_EQ(broken.error().size(), 101u);
  EXPECT_EQ(to_string(broken.error().back()),
            "s.toml: error: too many problems; no more of them are shown\n");
}

TEST(SceneLanguage, IsKnownByItsContent) {
  for (const char* text : {"[image]\nwidth = 3\n", "# a comment\n\n[[shape]]\n",
                           "image.width = 3\n", "image = {width = 3}\n", "\xEF\xBB\xBF[image]\n"})
    EXPECT_EQ(likeness_to_toml(std::string_view(text).substr(text[0] == '\xEF' ? 3 : 0)),
              Likeness::sure)
        << text;
  for (const char* text : {"", "# only a comment\n", "v\nfrom 0 0 5\n", "s 1 2 3 4\n",
                           "<oko => 0, 0, 2:", "0,0,2:2:400:0,2,-2:0", "eye => 0, 0, 2:"})
    EXPECT_EQ(likeness_to_toml(text), Likeness::none) << text;
}

TEST(SceneLanguage, WritesWhatReadsAsTheEqualScene) {
  const Scene s = scene(
      "[image]\nwidth = 7\n[camera]\neye = [1e-300, -0.0, 12345678.90123456789]\n[render]\n"
      "profile = \"spd\"\nshadows = \"off\"\n[scene]\nambient = [0.1, 0.2, 0.3]\n"
      "[[light]]\nposition = [1, 2, 3]\n[[light]]\nposition = [4, 5, 1e21]\ncolor = 0.1\n"
      "[material.\"čudno \\\"ime\\\"\\n\"]\ndiffuse = \"#123456\"\n[material.\"\"]\n" +
      kSphere + "name = \"[[shape]]\"\nmaterial = \"\"\n" + kSphere +
      "[[shape]]\nkind = \"cone\"\nbase = [0, 0, 0]\ntop = [0, 1, 0]\nbase_radius = 0.1\ncaps = "
      "false\n"
      "[[shape]]\nkind = \"cylinder\"\nbase = [0, 0, 0]\ntop = [0, 1, 0]\nradius = 0.3\ncaps = "
      "false\n"
      "[[shape]]\nkind = \"triangle\"\na = [0, 0, 0]\nb = [1, 0, 0]\nc = [0, 1, 0]\n"
      "normals = [[0, 0, 1], [0, 1, 1], [1, 0, 1]]\n");
  const std::string text = write_toml(s).value();
  EXPECT_NE(text.find("eye = [1e-300, -0.0, "), std::string::npos)
      << "a whole number has no -0 in TOML";
  const Scene again = scene(text);
  expect_equal(s, again);
  EXPECT_EQ(s.material_names, again.material_names);
  EXPECT_EQ(write_toml(again).value(), text);
}

TEST(SceneLanguage, RefusesToWriteWhatItWouldNotRead) {
  Scene s = scene(kSphere);
  s.materials[0].reflection = -0.5;
  s.spheres[0].shape.radius = 0;
  const Result<std::string> written = write_toml(s);
  ASSERT_FALSE(written);
  ASSERT_EQ(written.error().size(), 2u);
  EXPECT_EQ(
      to_string(written.error()[0]),
      "error: the scene language cannot say this: reflection of material default is -0.5: expected "
      "a colour: [r, g, b], each 0 or more, one number for grey, or \"#rrggbb\", or a texture\n");
  EXPECT_EQ(to_string(written.error()[1]),
            "error: the scene language cannot say this: radius of sphere is 0: expected a number "
            "greater than 0\n");
}

}  // namespace
}  // namespace zraka
