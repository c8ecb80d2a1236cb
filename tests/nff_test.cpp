// SPDX-License-Identifier: Apache-2.0
// NFF: what it means, and the exact answer to each way of getting it wrong.
#include <fmt/format.h>
#include <gtest/gtest.h>
#include <unistd.h>

#include <cmath>
#include <filesystem>
#include <fstream>
#include <string>
#include <zraka/formats.hpp>

#include "core/file.hpp"
#include "formats/formats.hpp"
#include "scene/polygon.hpp"
#include "scenes.hpp"

namespace zraka {
namespace {

const std::string kView =
    "b 0.1 0.2 0.3\nv\nfrom 0 0 5\nat 0 0 0\nup 0 1 0\nangle 90\nhither 1\nresolution 40 20\n";
const std::string kMaterial = "f 1 0.5 0 0.8 0.3 20 0.4 1.5\n";

const std::string kByteOrder = "\xEF\xBB\xBF";

std::string answer(const std::string& text) {
  const Result<ReadScene> read = parse_scene(text, "f.nff");
  std::string all;
  for (const Diagnostic& d : read ? read->warnings : read.error()) all += to_string(d);
  return all;
}
Scene scene(const std::string& text) {
  const Result<ReadScene> read = parse_scene(text, "f.nff");
  if (!read) ADD_FAILURE() << to_string(read.error().front());
  return read ? read->scene : Scene{};
}

/// All that a reader gives, as text.
std::string told(const Result<ReadScene>& read) {
  std::string all;
  if (!read) {
    for (const Diagnostic& d : read.error()) all += to_string(d) + "\n";
    return all;
  }
  for (const Diagnostic& d : read->warnings) all += to_string(d) + "\n";
  const Scene& s = read->scene;
  const auto add = [&](const Vec3& v) { all += fmt::format("{} {} {} ", v.x, v.y, v.z); };
  for (const Material& m : s.materials)
    all += fmt::format("{} {} {}\n", m.diffuse.r, m.refraction.r, m.ior);
  for (const auto& [shape, material, transform] : s.spheres)
    add(shape.center), all += fmt::format("{} {}\n", shape.radius, material);
  for (const auto& [shape, material, transform] : s.cones)
    add(shape.base), add(shape.apex), all += fmt::format("{}\n", material);
  for (const auto& [shape, material, transform] : s.triangles)
    add(shape.a), add(shape.b), add(shape.c), all += fmt::format("{}\n", material);
  for (const auto& [shape, material, transform] : s.smooth_triangles)
    add(shape.a), add(shape.normal_c), all += fmt::format("{}\n", material);
  for (const Light& l : s.lights) add(l.position), all += fmt::format("{}\n", l.color.g);
  return all;
}

// Blocks are read side by side: whatever the place of their borders, the scene and the words about
// a broken file are those of one reader.
TEST(Nff, IsTheSameFromBlocksOfAnySize) {
  std::string shapes;
  for (int i = 0; i < 40; ++i) {
    shapes += fmt::format("s {} 2 3 0.5 # f 1 2\n", i);
    if (i % 3 == 0) shapes += fmt::format("f {} 0.5 0 0.8 0.3 20 0.4 1.5\n", i % 4);
    if (i % 4 == 0) shapes += "c 0 0 0 1\n 0 0 2 0.5\n# s 1 1 1 1\n";
    if (i % 5 == 0) shapes += "p 4\n0 0 0\n1 0 0\n1 1 0\n0 1 0\n";
    if (i % 7 == 0) shapes += "pp 3\n0 0 0 0 0 1\n1 0 0 0 0 1\n1 1 0 0 0 1\n";
  }
  const std::string whole = kView + kMaterial + "l 1 2 3\n" + shapes;
  const std::string texts[] = {
      whole,
      kView + shapes,                                     // shapes before any material
      shapes + kView,                                     // the view at the end
      kMaterial + shapes + kView + shapes + "l 4 5 6\n",  // in the middle
      whole + "c 0 0 0 1\n" + shapes,                     // a cone that a sphere breaks off
      whole + "p 3\n0 0 0\n1 0 0\n" + shapes,
      whole + "s 1 2 3 -0.5\n" + shapes + "s 1 2 3 -0.5\n",
      whole + "x 1\n" + shapes + "s 1 2\n",
      whole + "s 1 2 3 0\ns a 1 2 3\n" + shapes + "s 1 2 3",
      kMaterial + shapes,  // no view
      "v\nfrom 0 0 5\ns 1 2 3 4\n" + shapes,
  };
  for (const std::string& text : texts) {
    const std::string wanted = told(parse_nff(text, "f.nff"));
    for (const std::size_t block : {1u, 2u, 7u, 20u, 100u, 1000u, 100000u})
      ASSERT_EQ(told(parse_nff_by_blocks(text, "f.nff", block)), wanted)
          << "blocks of " << block << ":\n"
          << text.substr(0, 200);
  }
}

/// A file that is read by parts, for as long as this is there.
class LargeText {
 public:
  /// `text` and, behind it, spheres.
  explicit LargeText(const std::string& text, std::size_t bytes = std::size_t{17} << 20)
      : path(fmt::format("{}zraka-large-{}.nff", testing::TempDir(), ::getpid())) {
    std::string all = text;
    for (int i = 0; all.size() < bytes; ++i) {
      if (i % 1000 == 0) all += fmt::format("f {} 0.5 0 0.8 0.3 20 0.4 1.5\n", i % 7000 / 1e4);
      all += i % 5000 == 0
                 ? fmt::format("p 3\n0 0 {}\n1 0 0\n# a comment\n0 1 0\n", i)
                 : fmt::format("s {} {} {} 0.5\n", i % 97 / 7.0, i % 89 / 11.0, i % 83 / 13.0);
    }
    std::ofstream(path) << all;
    content = all;
  }
  ~LargeText() { std::filesystem::remove(path); }
  const std::string path;
  std::string content;
};

TEST(Nff, OfALargeFileIsTheSameAsOfItsText) {
  const std::string lights = "l 1 2 3\n";
  for (const std::string& text :
       {lights + kView + kMaterial, kByteOrder + kView + kMaterial,
        kView + kMaterial + "s 1 2 3 -0.5\n",                        // a warning
        kView + kMaterial + "s 1 2 3 0\n",                           // an error
        kView + kMaterial + "#" + std::string(3 << 20, ' ') + "\n",  // a comment of many blocks
        kMaterial, std::string()}) {
    LargeText file(text);
    EXPECT_TRUE(told(read_scene(file.path)) == told(parse_scene(file.content, file.path)));
  }
  {
    LargeText file(kView + kMaterial);
    file.content += kView + "x 1\n";
    std::ofstream(file.path, std::ios::app) << kView << "x 1\n";
    EXPECT_TRUE(told(read_scene(file.path)) == told(parse_scene(file.content, file.path)));
    std::optional<LargeFile> opened = LargeFile::open(file.path, std::uint64_t{1} << 36);
    ASSERT_TRUE(opened);
    EXPECT_FALSE(read_nff_by_blocks(*opened, file.path, 1 << 20));
  }
  LargeText file(kView + kMaterial);
  for (const std::size_t block : {1000u, 100000u, 1u << 20}) {
    std::optional<LargeFile> opened = LargeFile::open(file.path, std::uint64_t{1} << 36);
    ASSERT_TRUE(opened);
    std::optional<ReadScene> read = read_nff_by_blocks(*opened, file.path, block);
    ASSERT_TRUE(read) << "it needs no second reading";
    read->scene.format = "NFF";
    EXPECT_TRUE(told(std::move(*read)) == told(parse_scene(file.content, file.path))) << block;
  }
}

TEST(Nff, ThatIsShortenedWhileItIsReadIsToldOf) {
  LargeText file(kView + kMaterial);
  std::optional<LargeFile> opened = LargeFile::open(file.path, std::uint64_t{1} << 36);
  ASSERT_TRUE(opened);
  std::filesystem::resize_file(file.path, file.content.find("\ns ", 5 << 20) + 1);
  EXPECT_FALSE(read_nff_by_blocks(*opened, file.path, 1 << 20));
  EXPECT_TRUE(opened->shortened());
}

TEST(Nff, HasAViewThroughAWindow) {
  const Scene s = scene(kView);
  EXPECT_EQ(s.background, (Color{0.1, 0.2, 0.3}));
  EXPECT_EQ(s.camera.eye, (Vec3{0, 0, 5}));
  EXPECT_EQ(s.camera.window_center, (Vec3{0, 0, 4}));
  EXPECT_NEAR(s.camera.window_up.y, 2, 1e-12);     // 90 degrees at distance 1
  EXPECT_NEAR(s.camera.window_right.x, 4, 1e-12);  // twice as wide as tall
  EXPECT_EQ(s.resolution.width, 40u);
  EXPECT_EQ(s.resolution.height, 20u);
  EXPECT_EQ(s.defaults.profile, ProfileName::physical);
}

TEST(Nff, HasLightsOfTheDatabasesRule) {
  const Scene s = scene(kView + "l 1 2 3\nl 4 5 6 # plain too\nl 7 8 9 0.1 0.2 0.3\nl 0 0 0\n");
  ASSERT_EQ(s.lights.size(), 4u);
  const double each = std::sqrt(4.0) / 8;
  EXPECT_EQ(s.lights[0].color, (Color{each, each, each}));
  EXPECT_EQ(s.lights[1].color, (Color{each, each, each}));
  EXPECT_EQ(s.lights[2].color, (Color{0.1, 0.2, 0.3}));
  EXPECT_EQ(s.ambient_light, (Color{each, each, each}));
}

TEST(Nff, HasShapesWithTheMaterialBeforeThem) {
  const Scene s = scene(
      kView + kMaterial + "s 1 2 3 0.5\nf 0 0 1 1 0 100000 0 0\nc 0 0 0 1\n 0 0 2 0.5\n" +
      kMaterial + "p 4\n0 0 0\n1 0 0\n1 1 0\n0 1 0\npp 3\n0 0 0 0 0 1\n1 0 0 0 0 1\n1 1 0 0 0 1");
  EXPECT_EQ(s.materials.size(), 2u) << "the same 'f' is one material";
  ASSERT_EQ(s.spheres.size(), 1u);
  EXPECT_EQ(s.spheres[0].material, 0u);
  ASSERT_EQ(s.cones.size(), 1u);
  EXPECT_EQ(s.cones[0].shape.apex_radius, 0.5);
  EXPECT_EQ(s.cones[0].material, 1u);
  EXPECT_EQ(s.triangles.size(), 2u);
  EXPECT_EQ(s.triangles[0].material, 0u);
  ASSERT_EQ(s.smooth_triangles.size(), 1u);
  EXPECT_EQ(s.smooth_triangles[0].shape.normal_c, (Vec3{0, 0, 1}));
  const Material want{{0.8, 0.4, 0}, {0.8, 0.4, 0}, {0.3, 0.3, 0.3}, 20, 0.3, 0.4, 1.5};
  EXPECT_EQ(s.materials[0], want);
  EXPECT_EQ(s.materials[1].ior, 1) << "an index of 0 is not divided by";
}

TEST(Nff, SaysWhatIsWrongAndGoesOn) {
  EXPECT_EQ(answer(kView + kMaterial + "s 1 2 x 4\nq 1\ns 1 2 3 0\n"),
            "f.nff:10:7: error: 'x' is not a finite number: expected the sphere's centre\n"
            "  s 1 2 x 4\n"
            "        ^\n"
            "f.nff:11:1: error: 'q' is no word of NFF: expected v, b, l, f, s, c, p or pp\n"
            "  q 1\n"
            "  ^\n"
            "f.nff:12:2: error: the sphere's radius is 0\n"
            "  s 1 2 3 0\n"
            "   ^\n");
}

TEST(Nff, SaysWhatIsMissing) {
  EXPECT_EQ(answer("b 0 0 0"),
            "f.nff:1:8: error: the file has no view: expected 'v'\n  b 0 0 0\n         ^\n");
  EXPECT_EQ(answer(kView + "s 0 0 0 1"),
            "f.nff:9:1: error: 's' has no material: expected 'f' before the first shape\n"
            "  s 0 0 0 1\n"
            "  ^\n");
  EXPECT_EQ(answer(kView + kMaterial + "s 0 0"),
            "f.nff:10:6: error: the file ends: expected the sphere's centre\n"
            "  s 0 0\n"
            "       ^\n");
  EXPECT_EQ(answer("v\nfrom 0 0 5\nup 0 1 0\n").substr(0, 64),
            "f.nff:3:1: error: 'up' does not belong here: expected 'at' of th");
}

TEST(Nff, IsKnownByItsFirstStatementAlsoIfItIsAShape) {
  EXPECT_EQ(answer("# a sphere\ns 1 2\n"),
            "f.nff:2:1: error: 's' has no material: expected 'f' before the first shape\n"
            "  s 1 2\n"
            "  ^\n"
            "f.nff:3:1: error: the file ends: expected the sphere's centre\n"
            "  \n"
            "  ^\n"
            "f.nff:3:1: error: the file has no view: expected 'v'\n"
            "  \n"
            "  ^\n");
  for (const std::string first : {"s 0 0 0 1\n", "p 3\n", "pp 3\n", "c\n"})
    EXPECT_EQ(answer(first).find("eye"), std::string::npos) << first;
  EXPECT_NE(to_string(parse_scene("s kuglama\n", "a").error().front()).find("eye"),
            std::string::npos)
      << "a word of the lab's";
}

TEST(Nff, IsElseKnownByItsName) {
  EXPECT_EQ(answer(""), "f.nff:1:1: error: the file has no view: expected 'v'\n  \n  ^\n");
  EXPECT_EQ(answer("// by a converter\nv\n").find("f.nff:1:1: error: '//' is no word of NFF"), 0u);
  EXPECT_EQ(answer(kByteOrder + kView + kMaterial + "s 0 0 0 1\n"), "");
  const auto answer_of_unknown = [](const std::string& text) {
    return to_string(parse_scene(text, "a.abc").error().front());
  };
  EXPECT_EQ(answer_of_unknown("// notes\n// of somebody\n"),
            "a.abc: error: is of no format that can be read\n"
            "  scenes are TOML (docs/scene-language/), glTF and meshes (docs/gltf.md), NFF "
            "(docs/nff.md), Tachyon's (docs/tachyon.md), files of particles (docs/particles.md) or "
            "the course's input.txt (docs/input-txt.md)\n");
  EXPECT_EQ(parse_scene("<oko => 0, 0, 2:", "f.nff").error().front().message.find("NFF"),
            std::string::npos)
      << "what begins with a label is the lab's, whatever its name";
}

TEST(Nff, SpeaksOnceOfAViewThatIsWrong) {
  EXPECT_EQ(answer("v\nfrom 0 0 5\nup 0 1 0\nangle 45\nhither 1\nresolution 9 9\n" + kMaterial +
                   "s 0 0 0 1\n"),
            "f.nff:3:1: error: 'up' does not belong here: expected 'at' of the view\n"
            "  up 0 1 0\n"
            "  ^\n");
  EXPECT_EQ(answer("v\nfrom 0 0 5\nat 0 0 0\nup 0 1 0\nangle 180\nhither 1\nresolution 9 9\n"),
            "f.nff:5:6: error: angle is 180: expected degrees from 0 to 180\n"
            "  angle 180\n"
            "       ^\n");
  EXPECT_EQ(answer("from 0 0 5\n").find("f.nff:1:1: error: 'from' is no word of NFF"), 0u);
}

TEST(Nff, RefusesViewsOfNothing) {
  const auto view = [](const std::string& at, const std::string& up, const std::string& angle,
                       const std::string& size) {
    const std::string text = answer("v\nfrom 0 0 5\nat " + at + "\nup " + up + "\nangle " + angle +
                                    "\nhither 1\nresolution " + size + "\n");
    return text.substr(0, text.find('\n'));
  };
  EXPECT_EQ(view("0 0 5", "0 1 0", "45", "9 9"),
            "f.nff:7:15: error: the eye is at the place that it looks at");
  EXPECT_EQ(view("0 0 0", "0 0 1", "45", "9 9"),
            "f.nff:7:15: error: the upward direction is the one of the view");
  EXPECT_EQ(view("0 0 0", "0 1 0", "180", "9 9"),
            "f.nff:5:6: error: angle is 180: expected degrees from 0 to 180");
  EXPECT_EQ(view("0 0 0", "0 1 0", "45", "0 9"),
            "f.nff:7:11: error: resolution is 0 9: expected whole numbers, 1 or more");
  EXPECT_EQ(view("0 0 0", "0 1 0", "45", "99999 99999"),
            "f.nff:7:11: error: resolution is 99999 99999: expected 134217728 pixels at most");
}

TEST(Nff, RefusesMoreCornersThanThereAre) {
  EXPECT_EQ(answer(kView + kMaterial + "p 1000000000\n0 0 0\n"),
            "f.nff:10:3: error: number of corners is 1000000000: expected a whole number from 3 to "
            "20000, and as many "
            "corners\n"
            "  p 1000000000\n"
            "    ^\n"
            "f.nff:11:1: error: '0' is no word of NFF: expected v, b, l, f, s, c, p or pp\n"
            "  0 0 0\n"
            "  ^\n");
}

TEST(Nff, WarnsOfWhatItDrawsOtherwise) {
  EXPECT_EQ(answer(kView + kMaterial + "s 0 0 0 -1\n"),
            "f.nff:10:2: warning: a negative radius makes only the inside visible in NFF; here "
            "both sides are\n"
            "  s 0 0 0 -1\n"
            "   ^\n");
  EXPECT_EQ(answer(kView + kMaterial + "c 0 0 0 1 0 0 1 -1\nc 0 0 0 -1 0 0 1 -1\n"),
            "f.nff:10:2: warning: a negative radius makes only the inside visible in NFF; here "
            "both sides are\n"
            "  c 0 0 0 1 0 0 1 -1\n"
            "   ^\n");
}

TEST(Nff, WarnsOnceOfColoursThatCountTo255) {
  EXPECT_EQ(answer(kView + "f 255 128 0 1 0 1 0 1\ns 0 0 0 1\nf 0 0 1.5 1 0 1 0 1\n"),
            "f.nff:9:2: warning: a colour of 255 is brighter than white: NFF's are from 0 to 1\n"
            "  f 255 128 0 1 0 1 0 1\n"
            "   ^\n");
}

/// A view along no axis of all shapes, everything this many times as large.
std::string scaled_scene(double k) {
  const auto v = [&](double x, double y, double z) {
    return fmt::format(" {} {} {}", x * k, y * k, z * k);
  };
  return "v\nfrom" + v(6, 7, 2) + "\nat" + v(0.1, 0.2, 0) +
         "\nup 0 0 1\nangle 40\nhither 0\nresolution 100 100\nb 0.2 0.3 0.5\nl" + v(5, 3, 8) +
         "\nf 0.8 0.3 0.2 0.8 0.3 30 0 1\ns" + v(0, 0, 0) + fmt::format(" {}\ns", k) + v(1, 2, 0) +
         fmt::format(" {}", 0.7 * k) + "\nf 0.3 0.8 0.2 0.8 0.3 30 0 1\nc" + v(2, -0.5, -1) +
         fmt::format(" {}", 0.4 * k) + v(2, -0.5, 2) + fmt::format(" {}\np 4\n", 0.1 * k) +
         v(-5, -5, -1) + v(5, -5, -1) + v(5, 5, -1) + v(-5, 5, -1) + "\n";
}

TEST(Nff, HasTheSamePictureInAnyUnit) {
  const auto picture = [](double k) { return render(scene(scaled_scene(k)), {}).value().image; };
  const Image want = picture(1);
  for (int power = -30; power <= 30; power += 5)
    EXPECT_GE(agreement(picture(std::pow(10, power)), want, 1.0f / 255), 0.999) << power;
  for (const int power : {-90, -60, 12, 16, 60, 90})
    EXPECT_GE(agreement(picture(std::pow(10, power)), want, 1.0f / 255), 0.999) << power;
}

TEST(Nff, LooksWhereItSaysFromAnyDistanceToTheOrigin) {
  // The eye's place has digits for 2^-20 here; where it looks has as many as everywhere.
  const double far = 0x1p32;
  const Scene s =
      scene(fmt::format("v\nfrom {0} {0} {0}\nat {1} {2} {0}\nup 0 0 1\nangle 40\n"
                        "hither 0\nresolution 8 8\n",
                        far, far + 3, far + 4));
  const double x = s.camera.window_center.x - far, y = s.camera.window_center.y - far;
  EXPECT_NEAR(x / y, 0.75, 1e-9);
  EXPECT_NEAR(s.camera.window_center.z - far, 0, 1e-9 * y);
  EXPECT_NEAR(std::hypot(s.camera.window_up.x, s.camera.window_up.y, s.camera.window_up.z) /
                  std::hypot(x, y),
              2 * std::tan(M_PI / 9), 1e-9);
}

/// Sum of the triangles' areas, and whether each turns the way that the polygon does.
double area(const std::vector<Vec3>& corners) {
  double sum = 0;
  for (const auto& [a, b, c] : triangulate(corners)) {
    const Vec3 &p = corners[a], &q = corners[b], &r = corners[c];
    const double turn = (q.x - p.x) * (r.y - p.y) - (q.y - p.y) * (r.x - p.x);
    EXPECT_GE(turn, 0);
    sum += turn / 2;
  }
  return sum;
}

TEST(Polygon, IsCoveredByItsTriangles) {
  EXPECT_DOUBLE_EQ(area({{0, 0, 0}, {2, 0, 0}, {2, 1, 0}, {0, 1, 0}}), 2);
  EXPECT_DOUBLE_EQ(area({{0, 0, 0}, {4, 0, 0}, {4, 4, 0}, {2, 1, 0}, {0, 4, 0}}), 10) << "a notch";
  EXPECT_DOUBLE_EQ(area({{0, 0, 0},
                         {2, 0, 0},
                         {9, 0, 0},
                         {9, 5, 0},
                         {0.5, 0.5, 0},
                         {5, 9, 0},
                         {0, 9, 0},
                         {0, 2, 0}}),
                   47)
      << "the shortest cut would go over the notch";
  std::vector<Vec3> gear;
  double want = 0;
  for (int i = 0; i < 144; ++i) {
    const double angle = 2 * M_PI * i / 144, r = i / 2 % 2 == 0 ? 1 : 0.8;
    gear.push_back({r * std::cos(angle), r * std::sin(angle), 0});
  }
  for (std::size_t i = 0; i < gear.size(); ++i) {
    const Vec3 &a = gear[i], &b = gear[(i + 1) % gear.size()];
    want += (a.x * b.y - a.y * b.x) / 2;
  }
  EXPECT_NEAR(area(gear), want, 1e-12);
  EXPECT_EQ(triangulate(gear).size(), 142u);
}

TEST(Polygon, IsHalvedWhereItIsRound) {
  std::vector<Vec3> round;
  for (int i = 0; i < 64; ++i)
    round.push_back({std::cos(2 * M_PI * i / 64), std::sin(2 * M_PI * i / 64), 0});
  const auto length = [&](std::uint32_t a, std::uint32_t b) {
    return std::hypot(round[a].x - round[b].x, round[a].y - round[b].y);
  };
  double cuts = -2 * 64 * std::sin(M_PI / 64);  // the polygon's own edges
  for (const auto& [a, b, c] : triangulate(round))
    cuts += length(a, b) + length(b, c) + length(c, a);
  // 32 cuts over two edges, 16 over four, …, the last through the middle; both triangles count
  // them.
  double want = 0;
  for (int over = 2; over <= 32; over *= 2)
    want += 2 * (over == 32 ? 1 : 64 / over) * 2 * std::sin(M_PI * over / 64);
  EXPECT_LT(cuts, 1.1 * want);  // rounding decides between equal cuts; a fan has 3 times as much
}

TEST(Polygon, WithHolesOnBridgesIsCovered) {
  EXPECT_DOUBLE_EQ(area({{0, 0, 0},
                         {4, 0, 0},
                         {4, 4, 0},
                         {0, 4, 0},
                         {0, 0, 0},
                         {1, 1, 0},
                         {1, 3, 0},
                         {3, 3, 0},
                         {3, 1, 0},
                         {1, 1, 0}}),
                   12);
  // After a cut more than its neighbours may have become ears.
  EXPECT_DOUBLE_EQ(area({{0, 0, 0},
                         {8, 3, 0},
                         {9, 1, 0},
                         {7, 1, 0},
                         {8, 3, 0},
                         {0, 0, 0},
                         {18, 0, 0},
                         {18, 18, 0},
                         {15, 2, 0},
                         {13, 2, 0},
                         {14, 4, 0},
                         {15, 2, 0},
                         {18, 18, 0},
                         {0, 18, 0}}),
                   320);
}

TEST(Polygon, WithRepeatedCornersIsCovered) {
  EXPECT_DOUBLE_EQ(area({{29, 0, 0},
                         {41, 41, 0},
                         {41, 41, 0},
                         {0, 36, 0},
                         {-30, 30, 0},
                         {-30, 30, 0},
                         {-26, 0, 0},
                         {-20, -20, 0},
                         {-20, -20, 0},
                         {0, -27, 0},
                         {29, -29, 0},
                         {29, -29, 0}}),
                   3604.5);
}

TEST(Polygon, OfThousandsOfCornersIsCovered) {
  // Half of the corners turn right; looking at all of them for each ear would take minutes.
  constexpr int kCorners = 20000;
  const auto area_of = [](const std::vector<Vec3>& corners) {
    double sum = 0;
    for (std::size_t i = 0; i < corners.size(); ++i) {
      const Vec3 &a = corners[i], &b = corners[(i + 1) % corners.size()];
      sum += (a.x * b.y - a.y * b.x) / 2;
    }
    return std::fabs(sum);
  };
  std::vector<Vec3> star, spiral;
  for (int i = 0; i < kCorners; ++i) {
    const double angle = 2 * M_PI * i / kCorners, r = i % 2 == 0 ? 1 : 0.5;
    star.push_back({r * std::cos(angle), r * std::sin(angle), 0});
    const bool in = i >= kCorners / 2;  // out along one side and in along the other
    const double turned = (in ? kCorners - 1 - i : i) * 80 * M_PI / kCorners;
    const double away = turned + (in ? 0 : 0.3);
    spiral.push_back({away * std::cos(turned), away * std::sin(turned), 0});
  }
  for (const auto& corners : {star, spiral}) {
    EXPECT_NEAR(area(corners), area_of(corners), 1e-6 * area_of(corners));
    EXPECT_EQ(triangulate(corners).size(), corners.size() - 2);
  }
}

TEST(Polygon, WithoutAnAreaHasFewTriangles) {
  const std::vector<Vec3> point(20000, {1, 2, 3});
  EXPECT_TRUE(triangulate(point).empty());
  std::vector<Vec3> line, there_and_back, twice;
  for (int i = 0; i < 20000; ++i) {
    line.push_back({static_cast<double>(i), 0, 0});
    there_and_back.push_back({static_cast<double>(i < 10000 ? i : 20000 - i), 0, 0});
    const double angle = 2 * M_PI * (i / 2) / 10000;
    twice.push_back({std::cos(angle), std::sin(angle), 0});
  }
  EXPECT_LE(triangulate(line).size(), 1u);
  EXPECT_LE(triangulate(there_and_back).size(), 1u);
  EXPECT_EQ(triangulate(twice).size(), 9998u) << "each corner once";
  for (const auto& triangle : triangulate(twice))
    for (const std::uint32_t corner : triangle) EXPECT_EQ(corner % 2, 0u) << "the first of equals";
}

TEST(Polygon, FacesAnyWay) {
  const std::vector<Vec3> notch = {{0, 0, 0}, {4, 0, 0}, {4, 4, 0}, {2, 1, 0}, {0, 4, 0}};
  std::vector<Vec3> turned, mirrored;
  for (const Vec3& c : notch)
    turned.push_back({c.z, c.x, c.y}), mirrored.push_back({-c.x, c.y, c.z});
  EXPECT_EQ(triangulate(turned), triangulate(notch));
  EXPECT_EQ(triangulate(mirrored), triangulate(notch));
}

TEST(Polygon, ThatIsNoneEndsTheWork) {
  EXPECT_TRUE(triangulate({{0, 0, 0}, {1, 0, 0}}).empty());
  std::vector<Vec3> star;  // with a small loop the other way round its middle: no corner is an ear
  for (int i = 0; i < 1501; ++i)
    star.push_back({std::cos(750 * 2 * M_PI * i / 1501), std::sin(750 * 2 * M_PI * i / 1501), 0});
  for (int i = 0; i < 200; ++i)
    star.push_back(
        {0.001 * std::cos(-2 * M_PI * i / 200), 0.001 * std::sin(-2 * M_PI * i / 200), 0});
  triangulate(star);
  triangulate({{0, 0, 0}, {1, 0, 0}, {2, 0, 0}, {3, 0, 0}, {4, 0, 0}});    // a line
  triangulate({{0, 0, 0}, {0, 0, 0}, {0, 0, 0}, {0, 0, 0}});               // a point
  triangulate({{0, 0, 0}, {1, 1, 0}, {1, 0, 0}, {0, 1, 0}, {0.5, 2, 0}});  // crosses itself
}

}  // namespace
}  // namespace zraka
