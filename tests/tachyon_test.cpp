// SPDX-License-Identifier: Apache-2.0
// Tachyon's scenes: what they mean, and the exact answer to each way of getting them wrong.
#include "formats/tachyon.hpp"

#include <gtest/gtest.h>
#include <unistd.h>

#include <chrono>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <string>
#include <zraka/formats.hpp>
#include <zraka/render.hpp>

namespace zraka {
namespace {

const std::string kHead = "BEGIN_SCENE\nRESOLUTION 40 20\n";
const std::string kCamera =
    "Camera\nZoom 1 Aspectratio 1 Antialiasing 0 Raydepth 5\n"
    "Center 0 0 -5 Viewdir 0 0 2 Updir 0 1 0\nEnd_Camera\n";
const std::string kRed =
    "TEXDEF red AMBIENT 0.1 DIFFUSE 0.5 SPECULAR 0.25 OPACITY 1\n"
    "PHONG PLASTIC 0.75 PHONG_SIZE 30 COLOR 1 0.5 0 TEXFUNC 0\n";

std::string told(const Result<ReadScene>& read) {
  std::string all;
  for (const Diagnostic& d : read ? read->warnings : read.error()) all += to_string(d);
  return all;
}
std::string answer(const std::string& text) {
  return told(parse_scene(text, "f.dat"));
}
/// The first line alone: no excerpt, no hint.
std::string first_line(const std::string& text) {
  const std::string all = answer(text);
  return all.substr(0, all.find('\n'));
}
Scene scene(const std::string& text, const TachyonSettings& settings = {}) {
  const Result<ReadScene> read = parse_tachyon(text, "f.dat", {}, settings);
  if (!read) ADD_FAILURE() << told(read);
  return read ? read->scene : Scene{};
}
void expect_near(const Vec3& a, const Vec3& b) {
  EXPECT_NEAR(a.x, b.x, 1e-12);
  EXPECT_NEAR(a.y, b.y, 1e-12);
  EXPECT_NEAR(a.z, b.z, 1e-12);
}
void expect_near(const Color& a, const Color& b) {
  expect_near(Vec3{a.r, a.g, a.b}, Vec3{b.r, b.g, b.b});
}

class TachyonFiles : public testing::Test {
 protected:
  void SetUp() override {
    folder_ =
        std::filesystem::temp_directory_path() / ("zraka_tachyon_" + std::to_string(getpid()));
    std::filesystem::create_directories(folder_ / "scene");
  }
  void TearDown() override { std::filesystem::remove_all(folder_); }
  void write(const std::string& name, const std::string& text) {
    std::ofstream(folder_ / name, std::ios::binary) << text;
  }
  std::string answer_of(const std::string& text, bool outside = false) {
    write("scene/f.dat", text);
    ReadOptions options;
    options.allow_outside = outside;
    const std::string path = (folder_ / "scene" / "f.dat").string();
    std::string all = told(read_scene(path, options));
    for (std::size_t at; (at = all.find(path)) != std::string::npos;)
      all.replace(at, path.size(), "f.dat");
    return all;
  }
  std::filesystem::path folder_;
};

TEST(Tachyon, CameraIsLeftHandedAndLooksThroughUpperRightCorners) {
  const Scene s = scene(kHead + kCamera);
  EXPECT_EQ(s.resolution.width, 40u);
  EXPECT_EQ(s.resolution.height, 20u);
  expect_near(s.camera.eye, {0, 0, -5});
  // One high, two wide at the distance 1, and half a pixel to the right and up.
  expect_near(s.camera.window_center, {0.025, 0.025, -4});
  expect_near(s.camera.window_right, {2, 0, 0});
  expect_near(s.camera.window_up, {0, 1, 0});
  EXPECT_EQ(s.defaults.max_depth, 4);
  EXPECT_EQ(s.defaults.sampling.count, 1);
  EXPECT_EQ(s.defaults.profile, ProfileName::tachyon);
}

TEST(Tachyon, FrustumHasLeftRightBottomTop) {
  std::string text = kHead + kCamera;
  text.replace(text.find("End_Camera"), 10, "Frustum -1 3 0 2 End_Camera");
  const Scene s = scene(text);
  expect_near(s.camera.window_center, {1 + 0.05, 1 + 0.05, -4});
  expect_near(s.camera.window_right, {4, 0, 0});
  expect_near(s.camera.window_up, {0, 2, 0});
}

TEST(Tachyon, DepthOfFieldHasBothSpellings) {
  for (const char* const word : {"FocalLength", "FocalDist"}) {
    std::string text = kHead + kCamera;
    text.replace(text.find("Zoom"), 4,
                 std::string("Projection Perspective_DoF ") + word + " 4 Aperture 0.1 Zoom");
    EXPECT_EQ(scene(text).camera.aperture, 0);  // one sample goes through its middle
    text.replace(text.find("Antialiasing 0"), 14, "Antialiasing 8");
    const Scene s = scene(text);
    EXPECT_EQ(s.camera.focus_distance, 4);
    expect_near(s.camera.window_center, {0.025, 0.025, -4});
    EXPECT_NEAR(s.camera.aperture, 0.1 * std::sqrt(2), 1e-12);  // of a window of 2 by 1
  }
}

TEST(Tachyon, TextureIsAmbientDiffuseMirrorAndBlinnHighlight) {
  const Scene s = scene(kHead + kRed + "SPHERE CENTER 1 2 3 RAD 0.5 red\n");
  ASSERT_EQ(s.spheres.size(), 1u);
  const Material& m = s.materials[s.spheres[0].material];
  expect_near(m.ambient, {0.1, 0.05, 0});
  expect_near(m.diffuse, {0.5, 0.25, 0});
  expect_near(m.specular, {0.75, 0.75, 0.75});
  EXPECT_EQ(m.shininess, 30);
  EXPECT_EQ(m.highlight, Highlight::blinn);
  EXPECT_EQ(m.reflection.r, 0.25);
  EXPECT_EQ(m.refraction.r, 0);
  EXPECT_EQ(s.ambient_light, (Color{1, 1, 1}));
}

TEST(Tachyon, MetalShinesInItsColourWhateverTheLight) {
  std::string text = kHead + kRed + "DIRECTIONAL_LIGHT DIRECTION 0 0 1 COLOR 0.5 0.5 0.5\n" +
                     "SPHERE CENTER 1 2 3 RAD 0.5 red\n";
  text.replace(text.find("PLASTIC"), 7, "METAL");
  const Scene s = scene(text);
  expect_near(s.materials[s.spheres[0].material].specular, {1.5, 0.75, 0});
}

TEST(Tachyon, OpacityGoesStraightThroughAndFiltersShadows) {
  std::string text = kHead + kRed + "SPHERE CENTER 1 2 3 RAD 0.5 red\n";
  text.replace(text.find("OPACITY 1"), 9, "OPACITY 0.25");
  const Scene s = scene(text);
  const Material& m = s.materials[s.spheres[0].material];
  EXPECT_EQ(m.refraction.r, 0.75);
  EXPECT_EQ(m.ior, 1);
  EXPECT_EQ(s.defaults.shadows, Shadows::transparent);
  const Scene off = scene(text + "SHADER_MODE FULL SHADOW_FILTER_OFF TRANS_VMD END_SHADER_MODE\n");
  EXPECT_EQ(off.defaults.shadows, Shadows::opaque);
  EXPECT_FALSE(off.materials[0].casts_shadow);
  expect_near(off.materials[0].diffuse, {0.125, 0.0625, 0});
  EXPECT_EQ(off.materials[0].refraction.r, 0.75);
}

TEST(Tachyon, LightsAreSeenAndThrowNoShadow) {
  const Scene s = scene(kHead +
                        "LIGHT CENTER 1 2 3 RAD 0.5 ATTENUATION CONSTANT 1 LINEAR 2 QUADRATIC 3 "
                        "COLOR 0.5 0.6 0.7\n"
                        "DIRECTIONAL_LIGHT DIRECTION 0 -3 4 COLOR 0.1 0.2 0.3\n"
                        "SPOTLIGHT CENTER 0 9 0 RAD 0 DIRECTION 0 -1 0 FALLOFF_START 10 "
                        "FALLOFF_END 20 COLOR 1 1 1\n");
  ASSERT_EQ(s.lights.size(), 3u);
  EXPECT_EQ(s.lights[0].attenuation, (Vec3{1, 2, 3}));
  expect_near(s.lights[1].color, {0.1, 0.2, 0.3});
  EXPECT_EQ(s.lights[2].outer_deg, 20);
  EXPECT_TRUE(s.lights[2].linear_edge);
  ASSERT_EQ(s.spheres.size(), 1u);
  const Material& m = s.materials[s.spheres[0].material];
  EXPECT_FALSE(m.casts_shadow);
  expect_near(m.ambient, {0.5, 0.6, 0.7});
  expect_near(m.diffuse, {0, 0, 0});
}

TEST(Tachyon, ModesLeaveOutMoreAndMore) {
  const std::string text =
      kHead + kRed + "SPHERE CENTER 1 2 3 RAD 0.5 red BACKGROUND 0.1 0.2 0.3\n";
  EXPECT_EQ(scene(text, {.mode = TachyonMode::medium}).defaults.shadows, Shadows::off);
  const Scene low = scene(text, {.mode = TachyonMode::low});
  expect_near(low.materials[0].ambient, {1, 0.5, 0});
  EXPECT_EQ(low.materials[0].reflection.r, 0);
  EXPECT_EQ(low.background, (Color{0.1, 0.2, 0.3}));
  const Scene lowest = scene(text, {.mode = TachyonMode::lowest});
  expect_near(lowest.materials[0].ambient, {1, 1, 1});
  EXPECT_EQ(lowest.background, (Color{}));
}

TEST(Tachyon, AmbientOcclusionIsLightOfTheDiffuseShare) {
  const Scene s =
      scene(kHead + kRed +
            "SPHERE CENTER 1 2 3 RAD 0.5 red LIGHT CENTER 0 0 0 RAD 0 COLOR 1 1 1\n"
            "SHADER_MODE FULL AMBIENT_OCCLUSION AMBIENT_COLOR 0.5 0.6 0.7 RESCALE_DIRECT "
            "0.2 SAMPLES 12 END_SHADER_MODE\n");
  EXPECT_EQ(s.ambient_occlusion.samples, 12);
  EXPECT_EQ(s.ambient_occlusion.color, (Color{0.5, 0.6, 0.7}));
  expect_near(s.materials[0].ambient, {0.6, 0.3, 0});
  expect_near(s.lights[0].color, {0.2, 0.2, 0.2});
}

TEST(Tachyon, CornersOfPaintedTrianglesKeepTheirColours) {
  const Scene s = scene(kHead +
                        "VCSTRI V0 0 0 0 V1 1 0 0 V2 0 1 0 N0 0 0 1 N1 0 0 1 N2 0 0 1\n"
                        "C0 1 0 0 C1 0 1 0 C2 0 0 1\n"
                        "AMBIENT 0 DIFFUSE 0.5 SPECULAR 0 OPACITY 1 VCST\n");
  ASSERT_EQ(s.smooth_triangles.size(), 1u);
  ASSERT_EQ(s.smooth_triangle_uvs.size(), 1u);
  const Material& m = s.materials[s.smooth_triangles[0].material];
  ASSERT_EQ(m.textures.size(), 1u);
  const Image& image = *s.textures[m.textures[0].texture].image;
  ASSERT_EQ(image.width, 2u);
  // The middle of the texel that each corner's u and v lead to has half its colour.
  for (std::size_t i = 0; i < 3; ++i) {
    const auto [u, v] = s.smooth_triangle_uvs[0][i];
    const float* const texel =
        image.row(static_cast<std::uint32_t>((1 - v) * 2)) + 3 * static_cast<std::size_t>(u * 2);
    for (std::size_t k = 0; k < 3; ++k) EXPECT_EQ(texel[k], i == k ? 0.5f : 0.0f) << i << k;
  }
}

TEST(Tachyon, StripsOfVertexArraysTurnEverySecondTriangle) {
  const Scene s = scene(kHead +
                        "VERTEXARRAY NUMVERTS 4 COORDS 0 0 0 1 0 0 0 1 0 1 1 0\n"
                        "NORMALS 0 0 1 0 0 1 0 0 1 0 0 1 TRISTRIP 4 0 1 2 3 END_VERTEXARRAY\n");
  ASSERT_EQ(s.smooth_triangles.size(), 2u);
  EXPECT_EQ(s.smooth_triangles[1].shape.a, (Vec3{0, 1, 0}));
  EXPECT_EQ(s.smooth_triangles[1].shape.b, (Vec3{1, 0, 0}));
}

TEST(Tachyon, PolycylinderIsSpheresAndCylindersBetween) {
  const Scene s = scene(kHead + kRed + "POLYCYLINDER POINTS 3 0 0 0 1 0 0 1 1 0 RAD 0.5 red\n");
  EXPECT_EQ(s.spheres.size(), 3u);
  EXPECT_EQ(s.cones.size(), 2u);
}

TEST(Tachyon, ImagesInTheFileAreLaidOntoPlanes) {
  const Scene s = scene(kHead +
                        "IMAGEDEF ::i FORMAT RGB24 RESOLUTION 3 2 1 ENCODING HEX\n"
                        "f00 00ff00 000000fff fff fff fff\n"
                        "PLANE CENTER 0 0 5 NORMAL 0 0 -1 TEXTURE AMBIENT 0 DIFFUSE 1 SPECULAR 0 "
                        "OPACITY 1 COLOR 1 1 1 TEXFUNC 9 ::i CENTER 0 0 0 ROTATE 0 0 0 SCALE 1 1 1 "
                        "UAXIS 1 0 0 VAXIS 0 1 0\n");
  ASSERT_EQ(s.textures.size(), 1u);
  const Image& image = *s.textures[0].image;
  ASSERT_EQ(image.width, 3u);
  EXPECT_EQ(image.row(0)[0], 1.0f);
  EXPECT_EQ(image.row(0)[3 + 1], 1.0f);
  EXPECT_EQ(s.textures[0].filter, TextureFilter::distance);
  EXPECT_EQ(s.textures[0].reach, 20);
}

TEST(Tachyon, ClipGroupsCutTheShapesWithinThem) {
  const Scene s = scene(
      kHead + kCamera +
      "TEXDEF a AMBIENT 0 DIFFUSE 1 SPECULAR 0 OPACITY 1 COLOR 1 1 1 TEXFUNC 0\n" +
      "START_CLIPGROUP NUMPLANES 2 2 0 0 1 0 1 0 -3\nSPHERE CENTER 0 0 0 RAD 1 a\nEND_CLIPGROUP\n" +
      "SPHERE CENTER 0 0 5 RAD 1 a\n" +
      "START_CLIPGROUP NUMPLANES 2 2 0 0 1 0 1 0 -3 SPHERE CENTER 0 0 9 RAD 1 a END_CLIPGROUP\n" +
      "START_CLIPGROUP NUMPLANES 1 2 0 0 1 SPHERE CENTER 0 0 9 RAD 1 a END_CLIPGROUP\n");
  ASSERT_EQ(s.cuts.size(), 3u) << "those of the first group are the second's";
  EXPECT_EQ(s.cuts[0], (Cut{.point = {0.5, 0, 0}, .normal = {2, 0, 0}, .caps = false, .group = 1}));
  EXPECT_EQ(s.cuts[1], (Cut{.point = {0, -3, 0}, .normal = {0, 1, 0}, .caps = false, .group = 1}));
  ASSERT_EQ(s.spheres.size(), 4u);
  EXPECT_EQ(s.materials[s.spheres[0].material].cut_group, 1u);
  EXPECT_EQ(s.materials[s.spheres[2].material].cut_group, 1u);
  EXPECT_EQ(s.materials[s.spheres[3].material].cut_group, 2u);
  EXPECT_EQ(s.materials[s.spheres[1].material].cut_group, 0u);
}

TEST(Tachyon, WhatIsLeftOutIsSaidWithItsLine) {
  EXPECT_EQ(answer(kHead + kCamera + "START_CLIPGROUP NUMPLANES 1 0 0 0 2 END_CLIPGROUP\n"),
            "f.dat:7:17: warning: a plane of START_CLIPGROUP has no normal: it cuts nothing off\n"
            "  START_CLIPGROUP NUMPLANES 1 0 0 0 2 END_CLIPGROUP\n"
            "                  ^\n");
  EXPECT_EQ(
      first_line(kHead + kCamera + "SPHERE CENTER 0 0 0 RAD 1 nobody\n" +
                 "SPHERE CENTER 0 0 0 RAD 1 nobody\n"),
      "f.dat:7:27: warning: there is no TEXDEF 'nobody' before this: white is taken (2 times)");
}

TEST(Tachyon, SaysWhatWasExpectedAndWhere) {
  EXPECT_EQ(answer(kHead + kCamera + "SPHERE CENTER 0 0 0 RADIUS 1 red\n"),
            "f.dat:7:21: error: 'RADIUS' does not belong here: expected RAD of SPHERE\n"
            "  SPHERE CENTER 0 0 0 RADIUS 1 red\n"
            "                      ^\n");
  const std::string at = "f.dat:3:";
  const auto says = [&](const std::string& line, const std::string& expected) {
    EXPECT_EQ(first_line(kHead + line), at + expected);
  };
  says("SPHERE CENTER 0 nan 0",
       "17: error: 'nan' is not a finite number: expected CENTER of SPHERE");
  says("SPHERE CENTER 0 inf 0",
       "17: error: 'inf' is not a finite number: expected CENTER of SPHERE");
  says("SPHERE CENTER 0 1e999 0",
       "17: error: '1e999' is not a finite number: expected CENTER of SPHERE");
  says("SPHERE CENTER 0", "16: error: the file ends: expected CENTER of SPHERE");
  says("SPHEER CENTER 0", "1: error: 'SPHEER' is no statement of Tachyon");
  says("#glued", "1: error: '#glued' is no statement of Tachyon");
  says("VERTEXARRAY NUMVERTS 2000000000",
       "22: error: NUMVERTS of VERTEXARRAY is 2000000000: expected a whole number from 0 to "
       "1000000000");
  says("VERTEXARRAY NUMVERTS 900000000 COORDS",
       "22: error: NUMVERTS of VERTEXARRAY is 900000000, more than the rest of the file can hold");
  says("POLYCYLINDER POINTS 1e300",
       "21: error: POINTS of POLYCYLINDER is 1e+300: expected a whole number from 0 to 1000000000");
  says("VERTEXARRAY NUMVERTS 1 COORDS 0 0 0 NORMALS 0 0 1 TRIMESH 1 0 0 1 END_VERTEXARRAY",
       "65: error: the index 1 is none of VERTEXARRAY: expected a whole number, less than 1");
  says("IMAGEDEF i FORMAT RGB24 RESOLUTION 99999 99999 99999 ENCODING HEX fff",
       "36: error: RESOLUTION of IMAGEDEF is 99999, more than the rest of the file can hold");
  says("IMAGEDEF i FORMAT RGB24 RESOLUTION 1 1 1 ENCODING HEX fg0 ",
       "55: error: 'fg0' is no colour of IMAGEDEF: expected 3, 6, 9 or 12 hexadecimal digits");
  says("FOG THICK", "5: error: 'THICK' is no fog: expected LINEAR, EXP, EXP2 or OFF");
  says("RESOLUTION 100000 100000",
       "12: error: RESOLUTION is 100000 100000: expected 134217728 pixels at most");
  says("INCLUDE other.dat",
       "9: error: other.dat cannot be read: files beside the scene need a folder");
  EXPECT_EQ(first_line("BEGIN_SCEN\n"),
            "f.dat:1:1: error: 'BEGIN_SCEN' does not belong here: expected "
            "BEGIN_SCENE of the scene");
}

TEST(Tachyon, ReadsOnAfterAProblem) {
  const Result<ReadScene> read =
      parse_scene(kHead + "SPHERE CENTRE 0 0 0\nTRI V0 0 0\nBACKGROUND 1 1\n", "f.dat");
  ASSERT_FALSE(read);
  EXPECT_EQ(read.error().size(), 3u);
}

TEST(Tachyon, LineEndsOfAnyKindAndALongWordAreNoMatter) {
  std::string text = kHead + "# a comment\n" + kRed + "SPHERE CENTER 1 2 3 RAD 0.5 red\n";
  for (char& c : text) c = c == '\n' ? '\r' : c;
  EXPECT_EQ(scene(text).spheres.size(), 1u);
  const std::string answer_to_long = first_line(kHead + std::string(10'000'000, 'x'));
  EXPECT_LT(answer_to_long.size(), 300u);
  EXPECT_EQ(answer_to_long.substr(0, 30), "f.dat:3:1: error: 'xxxxxxxxxxx");
}

TEST(Tachyon, Utf16IsNamed) {
  std::string wide = "\xFF\xFE";
  for (const char c : kHead) wide += c, wide += '\0';
  const std::string all = answer(wide);
  EXPECT_NE(all.find("it looks like UTF-16: save it as UTF-8"), std::string::npos) << all;
}

TEST_F(TachyonFiles, IncludedFilesAreReadInTheirFolderAlone) {
  write("scene/part.dat", kRed + "SPHERE CENTER 1 2 3 RAD 0.5 red\nEND_SCENE\n");
  EXPECT_EQ(answer_of(kHead + kCamera + "INCLUDE part.dat\nSPHERE CENTER 1 2 3 RAD 0.5 red\n"), "");
  write("part.dat", kRed);
  EXPECT_EQ(
      answer_of(kHead + kCamera + "INCLUDE ../part.dat\n"),
      "f.dat:7:9: error: ../part.dat cannot be read: '../part.dat' lies outside of the scene's "
      "folder\n"
      "  INCLUDE ../part.dat\n"
      "          ^\n"
      "  put it beside the scene, or allow it with --allow-outside\n");
  EXPECT_EQ(answer_of(kHead + kCamera + "INCLUDE ../part.dat\n", true), "");
  write("scene/bad.dat", "SPHERE CENTER x\n");
  EXPECT_EQ(answer_of(kHead + kCamera + "INCLUDE bad.dat\n"),
            "bad.dat:1:15: error: 'x' is not a finite number: expected CENTER of SPHERE\n"
            "  SPHERE CENTER x\n"
            "                ^\n");
}

TEST_F(TachyonFiles, FilesThatIncludeEachOtherEnd) {
  write("scene/loop.dat", "INCLUDE loop.dat\nINCLUDE loop.dat\n");
  EXPECT_EQ(answer_of(kHead + kCamera + "INCLUDE loop.dat\n"),
            "loop.dat:1:9: error: files include each other more than 16 deep\n"
            "  INCLUDE loop.dat\n"
            "          ^\n"
            "  does one of them include itself?\n");
}

TEST_F(TachyonFiles, PolygonsAreScaledTurnedAndMoved) {
  write("scene/t.tpoly", "3 1 0 0 0 1 0 0 0 1\n0\n");
  write("scene/f.dat", kHead + kCamera + kRed +
                           "TPOLYFILE SCALE 2 2 2 ROT 0 0 90 CENTER 5 0 0 FILE t.tpoly red\n");
  const Result<ReadScene> read = read_scene((folder_ / "scene" / "f.dat").string());
  ASSERT_TRUE(read) << told(read);
  ASSERT_EQ(read->scene.triangles.size(), 1u);
  expect_near(read->scene.triangles[0].shape.b, {5, 2, 0});
}

/// A sphere as large as the picture, from the front: what the middle pixel is.
Color middle_of(const std::string& more) {
  Scene s = scene(
      "BEGIN_SCENE RESOLUTION 3 3\n"
      "CAMERA ZOOM 1 ASPECTRATIO 1 ANTIALIASING 0 RAYDEPTH 4 CENTER 0 0 -5 VIEWDIR 0 0 1 "
      "UPDIR 0 1 0 FRUSTUM -0.002 0.001 -0.002 0.001 END_CAMERA\n"
      "TEXDEF white AMBIENT 0.25 DIFFUSE 0 SPECULAR 0 OPACITY 1 COLOR 1 1 1 TEXFUNC 0\n"
      "SPHERE CENTER 0 0 0 RAD 1 white\n" +
      more);
  const Result<Rendering> picture =
      render(s, {.profile = profile_of(ProfileName::tachyon), .threads = 1});
  if (!picture) return {};
  const float* const p = picture->image.row(1) + 3;
  return {p[0], p[1], p[2]};
}

TEST(TachyonPicture, FogTakesTheShareThatTheDistanceLeaves) {
  EXPECT_NEAR(middle_of("").r, 0.25, 1e-6);
  const Color linear = middle_of("FOG LINEAR START 2 END 6 DENSITY 1 COLOR 1 0 0\n");
  EXPECT_NEAR(linear.r, 0.25 * 0.5 + 0.5, 1e-4);
  EXPECT_NEAR(linear.g, 0.125, 1e-4);
  EXPECT_NEAR(middle_of("FOG EXP START 2 END 6 DENSITY 0.5 COLOR 0 0 0\n").r, 0.25 * std::exp(-1.0),
              1e-4);
  EXPECT_NEAR(middle_of("FOG EXP2 START 2 END 6 DENSITY 0.75 COLOR 0 0 0\n").r,
              0.25 * std::exp(-2.25), 1e-4);
}

TEST(TachyonPicture, ALightsOwnSphereIsSeenAndLetsItsLightOut) {
  // The light's sphere is in front of the white one, which it lights through itself.
  const Color seen = middle_of("LIGHT CENTER 0 0 -3 RAD 0.5 COLOR 0.5 0.25 0.75\n");
  expect_near(Color{std::round(seen.r * 100) / 100, std::round(seen.g * 100) / 100,
                    std::round(seen.b * 100) / 100},
              {0.5, 0.25, 0.75});
  const std::string matt =
      "TEXDEF matt AMBIENT 0 DIFFUSE 1 SPECULAR 0 OPACITY 1 COLOR 1 1 1 TEXFUNC 0\n"
      "SPHERE CENTER 0 0 0 RAD 1.5 matt\n";
  EXPECT_NEAR(middle_of(matt + "LIGHT CENTER 0 0 -9 RAD 0.5 COLOR 0.5 0.25 0.75\n").r, 0.5, 1e-3);
}

}  // namespace
}  // namespace zraka
