// SPDX-License-Identifier: Apache-2.0
// Lights, cameras, sampling and skies in the scene language.
#include <gtest/gtest.h>

#include <cmath>

#include "language_helpers.hpp"
#include "test_folder.hpp"

namespace zraka {
namespace {

Light light_of(const std::string& keys) {
  const Scene scene = scene_of("[[light]]\n" + keys);
  return scene.lights.empty() ? Light{} : scene.lights[0];
}
Camera camera_of(const std::string& keys) {
  return scene_of("[image]\nwidth = 40\nheight = 20\n[camera]\n" + keys).camera;
}
RenderDefaults render_of(const std::string& keys) {
  return scene_of("[render]\n" + keys).defaults;
}
void expect_near(const Vec3& a, const Vec3& b) {
  EXPECT_NEAR(a.x, b.x, 1e-12);
  EXPECT_NEAR(a.y, b.y, 1e-12);
  EXPECT_NEAR(a.z, b.z, 1e-12);
}

TEST(LanguageLights, AreOfSixKinds) {
  EXPECT_EQ(light_of("position = [1, 2, 3]\ncolor = 5\nattenuation = [0, 0, 1]\n"),
            (Light{.position = {1, 2, 3}, .color = {5, 5, 5}, .attenuation = {0, 0, 1}}));
  EXPECT_EQ(light_of("kind = \"directional\"\ndirection = [1, 0, -1]\n"),
            (Light{.position = {}, .kind = LightKind::directional, .direction = {1, 0, -1}}));
  EXPECT_EQ(light_of("kind = \"spot\"\nposition = [0, 4, 0]\ntarget = [1, 0, 0]\ninner_deg = 10\n"
                     "outer_deg = 20\n"),
            (Light{.position = {0, 4, 0},
                   .kind = LightKind::spot,
                   .direction = {1, -4, 0},
                   .inner_deg = 10,
                   .outer_deg = 20}));
  EXPECT_EQ(light_of("kind = \"rectangle\"\ncorner = [1, 2, 3]\nedge_u = [2, 0, 0]\n"
                     "edge_v = [0, 3, 0]\nsamples = 4\n"),
            (Light{.position = {1, 2, 3},
                   .kind = LightKind::rectangle,
                   .edge_u = {2, 0, 0},
                   .edge_v = {0, 3, 0},
                   .samples = 4}));
  EXPECT_EQ(
      light_of("kind = \"disc\"\nposition = [1, 2, 3]\nnormal = [1, 0, 0]\nradius = 0.5\n"),
      (Light{.position = {1, 2, 3}, .kind = LightKind::disc, .normal = {1, 0, 0}, .radius = 0.5}));
  EXPECT_EQ(light_of("kind = \"sphere\"\nposition = [1, 2, 3]\nradius = 2\nsamples = 1\n"),
            (Light{.position = {1, 2, 3}, .kind = LightKind::sphere, .radius = 2, .samples = 1}));
  for (const char* kind : {"disc", "sphere"})
    EXPECT_EQ(light_of(std::string("kind = \"") + kind + "\"\ncenter = [1, 2, 3]\n").position,
              (Vec3{1, 2, 3}));
}

TEST(LanguageLights, OfSpotsMakeRoomForTheAngleThatIsSaid) {
  const auto angles = [](const std::string& keys) {
    const Light light = light_of("kind = \"spot\"\nposition = [0, 4, 0]\n" + keys);
    return std::pair(light.inner_deg, light.outer_deg);
  };
  EXPECT_EQ(angles(""), std::pair(30.0, 45.0));
  EXPECT_EQ(angles("outer_deg = 20\n"), std::pair(20.0, 20.0));
  EXPECT_EQ(angles("inner_deg = 60\n"), std::pair(60.0, 60.0));
  EXPECT_EQ(light_of("kind = \"spot\"\nposition = [0, 4, 0]\n").direction, (Vec3{0, -1, 0}));
}

TEST(LanguageLights, SayWhatIsWrong) {
  const auto first = [](const std::string& keys) { return first_answer("[[light]]\n" + keys); };
  const std::string spot = "kind = \"spot\"\nposition = [0, 0, 0]\n";
  EXPECT_EQ(first(spot + "target = [0, 0, 0]\n"),
            "s.toml:4:10: error: target of spot light is its position");
  EXPECT_EQ(first(spot + "target = [0, 1, 0]\ndirection = [0, 1, 0]\n"),
            "s.toml:5:13: error: spot light has target and direction: expected one of them");
  EXPECT_EQ(first(spot + "inner_deg = 50\nouter_deg = 40\n"),
            "s.toml:4:13: error: inner_deg of spot light is 50, more than outer_deg, which is 40");
  EXPECT_EQ(first("kind = \"spot\"\nposition = [1e308, 0, 0]\ntarget = [-1e308, 0, 0]\n"),
            "s.toml:4:10: error: target of spot light is too far away for numbers");
  EXPECT_EQ(first(spot + "outer_deg = 0\n"),
            "s.toml:4:13: error: outer_deg of spot light is 0: expected a number greater than 0 "
            "and at most 180");
  EXPECT_EQ(first("kind = \"rectangle\"\n"),
            "s.toml:1:1: error: rectangle light has no corner: expected one of its corners, [x, y, "
            "z], finite numbers");
  EXPECT_EQ(first("kind = \"rectangle\"\ncorner = [0, 0, 0]\nedge_u = [0, 1, 0]\nedge_v = [0, 2, "
                  "0]\n"),
            "s.toml:5:10: error: edge_u and edge_v of rectangle light span no plane");
  EXPECT_EQ(first("kind = \"disc\"\nposition = [0, 0, 0]\ncenter = [0, 0, 0]\n"),
            "s.toml:4:1: error: disc light has position and center: expected one of them");
  EXPECT_EQ(first("kind = \"sphere\"\ncenter = [0, 0]\n"),
            "s.toml:3:10: error: position of sphere light is [0, 0]: expected [x, y, z], finite "
            "numbers");
  EXPECT_EQ(first("kind = \"sphere\"\ncenter = [0, 0, 0]\nsamples = 0\n"),
            "s.toml:4:11: error: samples of sphere light is 0: expected a whole number from 1 to "
            "65536");
  EXPECT_EQ(first("position = [0, 0, 0]\nattenuation = [0, 0, 0]\n"),
            "s.toml:3:15: error: attenuation of point light is [0, 0, 0]: expected [c, l, q], each "
            "0 or more, not all 0");
  EXPECT_EQ(first("position = [0, 0, 0]\nattenuation = [1, -1, 0]\n"),
            "s.toml:3:15: error: attenuation of point light is [1, -1, 0]: expected [c, l, q], "
            "each 0 or more, not all 0");
  EXPECT_EQ(answer_to("[rectangle]\n"),
            "s.toml:1:2: error: unknown section 'rectangle'\n  [rectangle]\n   ^\n"
            "  write [[light]] with kind = \"rectangle\"\n");
  EXPECT_EQ(answer_to("[disc]\n"),
            "s.toml:1:2: error: unknown section 'disc'\n  [disc]\n   ^\n"
            "  write [[shape]] with kind = \"disc\"\n")
      << "more often than a light";
}

TEST(LanguageLights, AreWrittenAsTheyWereRead) {
  expect_rewritten(
      "[[light]]\nposition = [1, 2, 3]\nattenuation = [0, 0.5, 1]\n"
      "[[light]]\nkind = \"directional\"\ndirection = [0.1, 0.2, 0.3]\ncolor = [1, 0, 2]\n"
      "[[light]]\nkind = \"spot\"\nposition = [1, 2, 3]\ntarget = [0, 1, 0]\nouter_deg = 20\n"
      "[[light]]\nkind = \"spot\"\nposition = [1, 2, 3]\n"
      "[[light]]\nkind = \"spot\"\nposition = [1e10, 2, 0.1]\ndirection = [1e-10, 0, 0.3]\n"
      "inner_deg = 50\n"
      "[[light]]\nkind = \"rectangle\"\ncorner = [1, 2, 3]\nedge_v = [1, 1, 1]\nsamples = 9\n"
      "[[light]]\nkind = \"disc\"\ncenter = [1, 2, 3]\nradius = 3\nnormal = [1, 0, 0]\n"
      "[[light]]\nkind = \"sphere\"\nposition = [1, 2, 3]\nradius = 3\nattenuation = [0, 0, 1]\n");
  const std::string text =
      write_toml(scene_of("[[light]]\nkind = \"spot\"\nposition = [1, 2, 3]\ntarget = [0, 1, 0]\n"))
          .value();
  EXPECT_NE(text.find("target = [0, 1, 0]"), std::string::npos) << text;
}

TEST(LanguageScenes, HaveFogAndAGradientsEnds) {
  const auto scene = [](const std::string& entries) { return scene_of("[scene]\n" + entries); };
  EXPECT_EQ(scene("").fog, Fog{});
  EXPECT_EQ(scene("fog = {kind = \"linear\", start = 2, end = 5, color = 0.5}\n").fog,
            (Fog{Fog::Kind::linear, 2, 5, 1, {0.5, 0.5, 0.5}, false}));
  EXPECT_EQ(scene("fog = {kind = \"squared\", density = 0.25, planar = true}\n").fog,
            (Fog{Fog::Kind::squared, 0, 1, 0.25, {}, true}));
  for (const char* fog : {"{kind = \"linear\", start = 2, end = 5, color = 0.5}",
                          "{kind = \"exponential\", density = 0.1, start = 1}",
                          "{kind = \"squared\", planar = true}"})
    expect_rewritten(std::string("[scene]\nfog = ") + fog + "\n");
  expect_rewritten(
      "[scene]\nbackground = {kind = \"gradient\", bottom = 0, top = 1, low = -0.25, high = "
      "0.5}\n");
  expect_rewritten(
      "[camera]\nkind = \"panorama\"\nlongitude_deg = 120\nlatitude_deg = 60\n"
      "[[light]]\nkind = \"spot\"\nposition = [1, 2, 3]\nlinear_edge = true\n"
      "[texture.t]\nkind = \"checker\"\nmapping = \"cylinder\"\n"
      "[texture.u]\nkind = \"checker\"\nmapping = \"sphere\"\n"
      "[material.m]\ndiffuse = \"t\"\nspecular = \"u\"\ncasts_shadow = false\n");
}

TEST(LanguageScenes, RefuseFogAndGradientsThatEndBeforeTheyStart) {
  EXPECT_EQ(
      answer_to("[scene]\nfog = {kind = \"linear\", start = 5, end = 2}\n"),
      "s.toml:2:7: error: fog of scene ends at 2, and starts at 5: expected an end beyond its "
      "start\n  fog = {kind = \"linear\", start = 5, end = 2}\n        ^\n");
  const std::string answer = answer_to(
      "[scene]\nbackground = {kind = \"gradient\", bottom = 0, top = 1, low = 0.5, high = 0}\n");
  EXPECT_EQ(answer.substr(0, answer.find('\n')),
            "s.toml:2:14: error: background of scene is all top from 0 on, and all bottom up to "
            "0.5: expected high to be more than low");
}

TEST(LanguageCameras, OfPerspectiveHaveALens) {
  const std::string view = "eye = [0, 0, 5]\nlook_at = [0, 0, 1]\n";
  EXPECT_EQ(camera_of(view).aperture, 0);
  const Camera lens = camera_of(view + "aperture = 0.5\n");
  EXPECT_EQ(lens.aperture, 0.5);
  EXPECT_EQ(lens.focus_distance, 4) << "as far as the point that it looks at";
  EXPECT_EQ(camera_of(view + "aperture = 0.5\nfocus_distance = 3\n").focus_distance, 3);
  EXPECT_DOUBLE_EQ(camera_of(view + "aperture = 0.5\nfocus = [7, 8, -5]\n").focus_distance, 10)
      << "along the view";
  const std::string window = "window = {center = [0, 0, 2], right = [2, 0, 0], up = [0, 2, 0]}\n";
  EXPECT_EQ(camera_of("aperture = 1\n" + window).focus_distance, 3) << "as far as the window";
  EXPECT_EQ(camera_of("kind = \"window\"\naperture = 1\neye = [9, 9, 5]\n" + window).focus_distance,
            3);
}

TEST(LanguageCameras, OfParallelRaysShowAHeight) {
  const Camera camera =
      camera_of("kind = \"orthographic\"\neye = [0, 0, 5]\nlook_at = [0, 0, 1]\nheight = 3\n");
  EXPECT_EQ(camera.kind, CameraKind::orthographic);
  expect_near(camera.window_up, {0, 3, 0});
  expect_near(camera.window_right, {6, 0, 0});
  expect_near(camera.window_center, {0, 0, 4});
}

TEST(LanguageCameras, OfViewsAllRoundSayDirections) {
  const Camera fisheye = camera_of("kind = \"fisheye\"\nlook_at = [5, 0, 5]\n");
  EXPECT_EQ(fisheye.kind, CameraKind::fisheye);
  EXPECT_EQ(fisheye.fov_deg, 180);
  EXPECT_EQ(camera_of("kind = \"fisheye\"\nfov_deg = 360\n").fov_deg, 360);
  const Camera panorama = camera_of("kind = \"panorama\"\nlook_at = [5, 0, 5]\nup = [0, 0, 1]\n");
  EXPECT_EQ(panorama.kind, CameraKind::panorama);
  for (const Camera& camera : {fisheye, panorama}) {
    expect_near(camera.window_center, {1, 0, 5});
    EXPECT_NEAR(std::hypot(camera.window_right.y, camera.window_right.z) /
                    std::hypot(camera.window_up.y, camera.window_up.z),
                2, 1e-12)
        << "the picture's aspect";
  }
  expect_near(fisheye.window_up, {0, 2, 0});
  expect_near(panorama.window_up, {0, 0, 2});
}

TEST(LanguageCameras, SayWhatIsWrong) {
  const auto first = [](const std::string& keys) { return first_answer("[camera]\n" + keys); };
  const std::string window = "window = {center = [0, 0, 0], right = [2, 0, 0], up = [0, 2, 0]}\n";
  EXPECT_EQ(first("aperture = -1\n"),
            "s.toml:2:12: error: aperture of perspective camera is -1: expected a number, 0 or "
            "more");
  EXPECT_EQ(first("focus_distance = 0\n"),
            "s.toml:2:18: error: focus_distance of perspective camera is 0: expected a number "
            "greater than 0");
  EXPECT_EQ(first("focus = [0, 0, 0]\nfocus_distance = 1\n"),
            "s.toml:3:18: error: perspective camera has focus and focus_distance: expected one of "
            "them");
  EXPECT_EQ(first("focus = [0, 0, 9]\n"),
            "s.toml:2:9: error: focus of perspective camera is not in front of the eye, or too far "
            "away");
  EXPECT_EQ(first("kind = \"orthographic\"\nheight = 1e308\n[image]\nwidth = 1000\n"),
            "s.toml:1:1: error: what orthographic camera sees is too far away, or too large, for "
            "numbers");
  EXPECT_EQ(first(window + "fov_deg = 40\n"),
            "s.toml:3:11: error: perspective camera has window and fov_deg: expected one of them");
  EXPECT_EQ(first("kind = \"orthographic\"\nheight = 1\n" + window),
            "s.toml:3:10: error: orthographic camera has window and height: expected one of them");
  EXPECT_EQ(first("kind = \"orthographic\"\nheight = 0\n"),
            "s.toml:3:10: error: height of orthographic camera is 0: expected a number greater "
            "than 0");
  EXPECT_EQ(first("kind = \"orthographic\"\nfov_deg = 40\n"),
            "s.toml:3:1: error: unknown field 'fov_deg' of orthographic camera");
  EXPECT_EQ(first("kind = \"fisheye\"\nfov_deg = 361\n"),
            "s.toml:3:11: error: fov_deg of fisheye camera is 361: expected a number greater than "
            "0 and at most 360");
  EXPECT_EQ(first("kind = \"panorama\"\nup = [0, 0, 1]\n"),
            "s.toml:3:6: error: up of panorama camera is the direction of view");
  EXPECT_EQ(first("kind = \"panorama\"\nlook_at = [0, 0, 5]\n"),
            "s.toml:3:11: error: the camera's eye is at the point that it looks at");
  EXPECT_EQ(answer_to("[camera]\nkind = \"fish\"\n"),
            "s.toml:2:8: error: unknown kind 'fish' of camera\n  kind = \"fish\"\n         ^\n"
            "  kinds of camera: perspective, window, orthographic, fisheye, panorama\n");
}

TEST(LanguageCameras, AreWrittenAsTheyWereRead) {
  const std::string view = "eye = [0.1, 0.2, 5.3]\nlook_at = [0, 1, 0.7]\nup = [0.1, 1, 0]\n";
  for (const char* keys :
       {"fov_deg = 33\n", "aperture = 0.25\n", "focus_distance = 3\n",
        "aperture = 1e-3\nfocus = [0, 0, 0]\n", "kind = \"orthographic\"\nheight = 0.3\n",
        "kind = \"fisheye\"\n", "kind = \"fisheye\"\nfov_deg = 200\n", "kind = \"panorama\"\n"})
    expect_rewritten("[image]\nwidth = 30\nheight = 20\n[camera]\n" + view + keys);
}

TEST(LanguageRendering, HasSamplesOfThreeKinds) {
  using Kind = Sampling::Kind;
  EXPECT_EQ(render_of("samples = 16\n").sampling, (Sampling{.count = 16}));
  EXPECT_EQ(render_of("samples = {grid = 4}\n").sampling,
            (Sampling{.kind = Kind::grid, .count = 4}));
  EXPECT_EQ(render_of("samples = {adaptive = [4, 32], contrast = 0.1}\n").sampling,
            (Sampling{Kind::adaptive, 4, 32, 0.1}));
  EXPECT_EQ(render_of("samples = {adaptive = [4, 32]}\n").sampling.contrast, 0.02);
  EXPECT_EQ(render_of("filter = \"mitchell\"\nseed = 4294967295\n").sampling,
            (Sampling{.filter = PixelFilter::mitchell, .seed = 4294967295u}));
  const RenderDefaults rest =
      render_of("min_contribution = 0.25\nshadows = \"transparent\"\nwavelengths = 64\n");
  EXPECT_EQ(rest.min_contribution, 0.25);
  EXPECT_EQ(rest.shadows, Shadows::transparent);
  EXPECT_EQ(rest.wavelengths, 64);
}

TEST(LanguageRendering, SaysWhatIsWrong) {
  const auto first = [](const std::string& keys) { return first_answer("[render]\n" + keys); };
  const std::string expected =
      ": expected a whole number from 1 to 65536; or a table {grid = …} or {adaptive = …, contrast "
      "= …}";
  for (const char* value : {"0", "65537", "1.5", "\"many\"", "{contrast = 1}", "[4, 64]",
                            "{grid = 2, adaptive = [1, 2]}"})
    EXPECT_EQ(first("samples = " + std::string(value) + "\n"),
              "s.toml:2:11: error: samples of render is " + std::string(value) + expected);
  EXPECT_EQ(first("samples = {grid = 257}\n"),
            "s.toml:2:19: error: grid of samples of render is 257: expected a whole number from 1 "
            "to 256");
  EXPECT_EQ(first("samples = {adaptive = [64, 4]}\n"),
            "s.toml:2:23: error: adaptive of samples of render is [64, 4]: expected the fewest, "
            "then the most");
  EXPECT_EQ(first("samples = {adaptive = 4}\n"),
            "s.toml:2:23: error: adaptive of samples of render is 4: expected 2 whole numbers in "
            "brackets each from 1 to 65536");
  EXPECT_EQ(first("samples = {grid = 2, contrast = 1}\n"),
            "s.toml:2:22: error: unknown field 'contrast' of samples of render");
  EXPECT_EQ(answer_to("[render]\nsamples = {grids = 2}\n"),
            "s.toml:2:12: error: unknown field 'grids' for samples of render\n"
            "  samples = {grids = 2}\n             ^\n"
            "  did you mean 'grid'?\n");
  EXPECT_EQ(first("min_contribution = -1\n"),
            "s.toml:2:20: error: min_contribution of render is -1: expected a number, 0 or more");
  EXPECT_EQ(first("wavelengths = 65\n"),
            "s.toml:2:15: error: wavelengths of render is 65: expected a whole number from 1 to "
            "64");
  EXPECT_EQ(first("filter = \"bell\"\n"),
            "s.toml:2:10: error: filter of render is \"bell\": expected \"box\", \"tent\", "
            "\"gauss\" or \"mitchell\"");
  EXPECT_EQ(first("seed = -1\n"),
            "s.toml:2:8: error: seed of render is -1: expected a whole number from 0 to "
            "4294967295");
}

TEST(LanguageRendering, IsWrittenAsItWasRead) {
  for (const char* keys : {"samples = 2\n", "samples = {grid = 1}\nfilter = \"gauss\"\n",
                           "samples = {adaptive = [4, 64]}\nseed = 7\n",
                           "samples = {adaptive = [1, 1], contrast = 0}\nfilter = \"tent\"\n",
                           "shadows = \"transparent\"\nmin_contribution = 1e-3\nwavelengths = 1\n"})
    expect_rewritten("[render]\n" + std::string(keys));
}

/// A folder with a picture.
const ReadOptions& with_picture() {
  static TestFolder folder("language_views");
  static const ReadOptions options{
      .folder = folder.with("sky.ppm", "P3 2 1 255 255 0 0 0 0 255\n").path()};
  return options;
}

TEST(LanguageSkies, AreGradients) {
  const Scene s = scene_of(
      "[scene]\nbackground = {kind = \"gradient\", bottom = 0.5, top = [0, 0, 1], up = [0, 0, "
      "2]}\n");
  EXPECT_EQ(s.sky, (Sky{Sky::Kind::gradient, {0.5, 0.5, 0.5}, {0, 0, 1}, {0, 0, 2}}));
  EXPECT_EQ(scene_of("[scene]\nbackground = 0.5\n").sky, Sky{});
}

TEST(LanguageSkies, ArePictures) {
  const Scene s = scene_of(
      "[texture.t]\nkind = \"wood\"\n[scene]\nbackground = {kind = \"image\", file = "
      "\"sky.ppm\"}\n",
      with_picture());
  ASSERT_EQ(s.textures.size(), 2u);
  EXPECT_EQ(s.sky, (Sky{.kind = Sky::Kind::image, .texture = 1}));
  EXPECT_EQ(s.textures[1].kind, TextureKind::image);
  EXPECT_EQ(s.textures[1].mapping, TextureMapping::uv);
  EXPECT_EQ(s.textures[1].file, "sky.ppm");
  ASSERT_NE(s.textures[1].image, nullptr);
  const Scene named = scene_of(
      "[texture.t]\nkind = \"image\"\nfile = \"sky.ppm\"\nfilter = \"nearest\"\n"
      "[scene]\nbackground = {kind = \"image\", texture = \"t\", up = [1, 0, 0]}\n"
      "[material.a]\nnormal_map = {texture = \"t\"}\n",
      with_picture());
  EXPECT_EQ(named.sky, (Sky{.kind = Sky::Kind::image, .up = {1, 0, 0}, .texture = 0}));
  EXPECT_EQ(named.textures.size(), 2u) << "a map of normals is another one, in linear numbers";
  EXPECT_EQ(named.textures[0].transfer, Transfer::srgb);
}

TEST(LanguageSkies, SayWhatIsWrong) {
  const auto first = [](const std::string& value) {
    return first_answer("[texture.t]\nkind = \"wood\"\n[scene]\nbackground = " + value + "\n",
                        with_picture());
  };
  EXPECT_EQ(first("-1"),
            "s.toml:4:14: error: background of scene is -1: expected a colour: [r, g, b], each 0 "
            "or more, one number for grey, or \"#rrggbb\"; or a table {kind = \"gradient\", bottom "
            "= …, top = …, up = …, low = …, high = …} or {kind = \"image\", file = …, texture = …, "
            "up = …}");
  EXPECT_EQ(first("{bottom = 0, top = 1}"), "s.toml:4:14: error: background of scene has no kind");
  EXPECT_EQ(first("{kind = \"radient\", bottom = 0, top = 1}"),
            "s.toml:4:22: error: unknown kind 'radient' for background of scene");
  EXPECT_EQ(first("{kind = 1}"),
            "s.toml:4:22: error: kind of background of scene is 1: expected a text in quotes");
  EXPECT_EQ(first("{kind = \"gradient\", bottom = 0}"),
            "s.toml:4:14: error: background of scene has no top: expected the colour straight up, "
            "a colour: [r, g, b], each 0 or more, one number for grey, or \"#rrggbb\"");
  EXPECT_EQ(first("{kind = \"image\"}"),
            "s.toml:4:14: error: background of scene has no file: expected the picture: PNG, JPEG, "
            "BMP, TGA, PPM, PGM, PFM, HDR or OpenEXR, the name of a picture's file, in quotes");
  EXPECT_EQ(first("{kind = \"image\", file = \"none.png\"}"),
            "s.toml:4:38: error: file of background of scene: none.png: cannot be read: No such "
            "file or directory");
  EXPECT_EQ(first("{kind = \"image\", file = \"sky.ppm\", texture = \"t\"}"),
            "s.toml:4:49: error: background of scene has file and texture: expected one of them");
  EXPECT_EQ(first("{kind = \"image\", texture = \"t\"}"),
            "s.toml:4:41: error: texture of background of scene is no texture of kind image");
  EXPECT_EQ(first("{kind = \"image\", texture = \"u\"}"),
            "s.toml:4:41: error: unknown texture 'u' for texture of background of scene");
}

TEST(LanguageSkies, HaveShadeInCorners) {
  const Scene s =
      scene_of("[scene]\nambient_occlusion = {samples = 9, distance = 2, color = 0.5}\n");
  EXPECT_EQ(s.ambient_occlusion, (AmbientOcclusion{9, 2, {0.5, 0.5, 0.5}}));
  EXPECT_EQ(scene_of("[scene]\nambient_occlusion = {}\n").ambient_occlusion.samples, 64);
  EXPECT_EQ(scene_of("").ambient_occlusion, AmbientOcclusion{});
  EXPECT_EQ(first_answer("[scene]\nambient_occlusion = {samples = 0}\n"),
            "s.toml:2:32: error: samples of ambient_occlusion of scene is 0: expected a whole "
            "number from 1 to 65536");
  EXPECT_EQ(first_answer("[scene]\nambient_occlusion = {distance = -1}\n"),
            "s.toml:2:33: error: distance of ambient_occlusion of scene is -1: expected a number, "
            "0 or more");
  EXPECT_EQ(first_answer("[scene]\nambient_occlusion = 1\n"),
            "s.toml:2:21: error: ambient_occlusion of scene is 1: expected a table {samples = …, "
            "distance = …, color = …}");
}

TEST(LanguageSkies, AreWrittenAsTheyWereRead) {
  for (const char* keys :
       {"background = {kind = \"gradient\", bottom = 0, top = [0, 0.1, 1]}\n",
        "background = {kind = \"gradient\", bottom = 2, top = 3, up = [1, 0, 0]}\n",
        "background = {kind = \"image\", file = \"sky.ppm\"}\n",
        "background = {kind = \"image\", file = \"sky.ppm\", up = [0, 0, 1]}\n"
        "[texture.t]\nkind = \"marble\"\n[material.a]\ndiffuse = \"t\"\n",
        "background = {kind = \"image\", texture = {kind = \"image\", file = \"sky.ppm\", filter = "
        "\"bilinear\"}}\n",
        "ambient_occlusion = {}\n",
        "ambient_occlusion = {samples = 7, distance = 0.5, color = [1, 0, 0]}\n"})
    expect_rewritten("[scene]\n" + std::string(keys), with_picture());
}

}  // namespace
}  // namespace zraka
