// SPDX-License-Identifier: Apache-2.0
// Meshes from files, and the shapes of the scene language that are made of them.
#include "mesh/mesh.hpp"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cstring>
#include <filesystem>
#include <fstream>
#include <functional>

#include "language_helpers.hpp"

namespace zraka {
namespace {

namespace fs = std::filesystem;

using Parse = Result<Mesh> (*)(std::string_view, const std::string&);

std::string told(Parse parse, std::string_view bytes) {
  const Result<Mesh> mesh = parse(bytes, "m");
  return mesh ? "" : to_string(mesh.error().front());
}

std::vector<std::array<std::uint32_t, 3>> points_of(const Mesh& mesh) {
  std::vector<std::array<std::uint32_t, 3>> all;
  for (const Mesh::Triangle& t : mesh.triangles)
    all.push_back({t[0].point, t[1].point, t[2].point});
  return all;
}

const std::string kSquare = "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\n";

TEST(Obj, HasPointsNormalsAndCoordinates) {
  const Mesh mesh = parse_obj("# a comment\r\nmtllib x.mtl\no thing\n" + kSquare +
                                  "vn 0 0 1\nvt 0 0.5\nvt +1e-1\t1 0\ns off\n"
                                  "f 1/1/1 2/2/1 3//1\nf -4 -3/-1 \\\n -1\n",
                              "m")
                        .value();
  EXPECT_EQ(mesh.points.size(), 4u);
  EXPECT_EQ(mesh.uvs[1], (std::array<float, 2>{0.1f, 1}));
  EXPECT_EQ(points_of(mesh), (std::vector<std::array<std::uint32_t, 3>>{{0, 1, 2}, {0, 1, 3}}));
  EXPECT_EQ(mesh.triangles[0][1].uv, 1u);
  EXPECT_EQ(mesh.triangles[0][2].uv, Mesh::kNone);
  EXPECT_EQ(mesh.triangles[0][2].normal, 0u);
  EXPECT_EQ(mesh.triangles[1][1].uv, 1u);
  EXPECT_EQ(mesh.triangles[1][0].normal, Mesh::kNone);
}

TEST(Obj, CutsPolygonsAlsoConcaveOnes) {
  using Triangles = std::vector<std::array<std::uint32_t, 3>>;
  EXPECT_EQ(points_of(parse_obj(kSquare + "f 1 2 3 4\n", "m").value()),
            (Triangles{{0, 1, 2}, {2, 3, 0}}));
  // An arrow's head: the cut from the first corner to the third would go outside.
  const Mesh arrow = parse_obj("v 0 0 0\nv 2 1 0\nv 0 2 0\nv 1 1 0\nf 1 2 3 4\n", "m").value();
  EXPECT_EQ(points_of(arrow), (Triangles{{1, 2, 3}, {3, 0, 1}}));
  const Mesh star = parse_obj(kSquare + "v 0.5 0.5 0\nf 1 2 3 4 5\n", "m").value();
  double area = 0;
  for (const auto& [a, b, c] : points_of(star)) {
    const Vec3 &p = star.points[a], &q = star.points[b], &r = star.points[c];
    area += ((q.x - p.x) * (r.y - p.y) - (q.y - p.y) * (r.x - p.x)) / 2;
  }
  EXPECT_EQ(star.triangles.size(), 3u);
  EXPECT_EQ(area, 0.75);
}

TEST(Obj, SaysWhatIsWrongAtItsPlace) {
  EXPECT_EQ(told(parse_obj, kSquare + "f 1 2 5\n"),
            "m:5:7: error: point 5 is not there: so far there are 4\n");
  EXPECT_EQ(told(parse_obj, kSquare + "f 1 2 -5\n"),
            "m:5:7: error: point -5 is not there: so far there are 4\n");
  EXPECT_EQ(told(parse_obj, kSquare + "f 0 1 2\n"),
            "m:5:3: error: point 0 is not there: so far there are 4\n");
  EXPECT_EQ(told(parse_obj, kSquare + "f 1 2/1 3\n"),
            "m:5:7: error: uv 1 is not there: so far there are 0\n");
  EXPECT_EQ(told(parse_obj, kSquare + "f 1 2//9 3\n"),
            "m:5:8: error: normal 9 is not there: so far there are 0\n");
  EXPECT_EQ(told(parse_obj, kSquare + "f 1 2 x\n"), "m:5:7: error: 'x' is no index of a point\n");
  EXPECT_EQ(told(parse_obj, kSquare + "f 1 99999999999999999999 2\n"),
            "m:5:5: error: '99999999999999999999' is no index of a point\n");
  EXPECT_EQ(told(parse_obj, kSquare + "f 1 2\n"),
            "m:5:1: error: a face has 2 corners: expected 3 or more\n");
  EXPECT_EQ(told(parse_obj, "v 0 0\n"),
            "m:1:6: error: the line ends: expected x, y and z of a point\n");
  EXPECT_EQ(told(parse_obj, "\nv 0 nan 0\n"),
            "m:2:5: error: 'nan' is no number: expected x, y and z of a point\n");
  EXPECT_EQ(told(parse_obj, "v 0 \\\n0 \\\n0\nvn 0 a 0\n"),
            "m:4:6: error: 'a' is no number: expected x, y and z of a normal\n");
  EXPECT_EQ(told(parse_obj, "vt 1e300 0\n"), "m:1:1: error: u and v are too large\n");
  EXPECT_EQ(told(parse_obj, "v 0 0 0\n"), "m: error: has no faces: no line begins with f\n");
}

const std::string kPlyHead =
    "ply\nformat ascii 1.0\ncomment by hand\nelement vertex 4\nproperty float x\nproperty float y\n"
    "property double z\nproperty uchar red\nelement face 2\n"
    "property list uchar int vertex_indices\nend_header\n";
const std::string kPlyPoints = "0 0 0 255\n1 0 0 255\n1 1 0 255\n0 1 0.5 255\n";

TEST(Ply, IsReadAsText) {
  const Mesh mesh = parse_ply(kPlyHead + kPlyPoints + "3 0 1 2\n3 0 2 3\n", "m").value();
  EXPECT_EQ(mesh.points[3], (Vec3{0, 1, 0.5}));
  EXPECT_EQ(points_of(mesh), (std::vector<std::array<std::uint32_t, 3>>{{0, 1, 2}, {0, 2, 3}}));
}

/// A file of bytes, each number in an order.
std::string binary_ply(bool big) {
  std::string bytes = fmt::format(
      "ply\nformat binary_{}_endian 1.0\nelement vertex 3\nproperty float32 x\nproperty float32 y\n"
      "property float64 z\nproperty float nx\nproperty float ny\nproperty float nz\n"
      "property float s\nproperty float t\nelement face 1\nproperty uchar flags\n"
      "property list uint8 uint32 vertex_index\nend_header\n",
      big ? "big" : "little");
  const auto put = [&](auto value) {
    char own[sizeof value];
    std::memcpy(own, &value, sizeof value);
    if (big) std::reverse(own, own + sizeof value);
    bytes.append(own, sizeof value);
  };
  for (int i = 0; i < 3; ++i) {
    put(static_cast<float>(i)), put(static_cast<float>(i * i)), put(0.25);
    put(0.0f), put(0.0f), put(1.0f), put(0.5f), put(static_cast<float>(i));
  }
  put(std::uint8_t{7}), put(std::uint8_t{3});
  for (std::uint32_t i = 0; i < 3; ++i) put(i);
  return bytes;
}

TEST(Ply, IsReadAsBytesOfEitherOrder) {
  for (const bool big : {false, true}) {
    const Mesh mesh = parse_ply(binary_ply(big), "m").value();
    ASSERT_EQ(mesh.points.size(), 3u);
    EXPECT_EQ(mesh.points[2], (Vec3{2, 4, 0.25}));
    EXPECT_EQ(mesh.normals[1], (Vec3{0, 0, 1}));
    EXPECT_EQ(mesh.uvs[2], (std::array<float, 2>{0.5f, 2}));
    EXPECT_EQ(mesh.triangles.at(0)[2].point, 2u);
    EXPECT_EQ(mesh.triangles[0][2].normal, 2u);
  }
}

TEST(Ply, SaysWhatIsWrongAtItsPlace) {
  EXPECT_EQ(told(parse_ply, kPlyHead + kPlyPoints + "3 0 1 4\n3 0 2 3\n"),
            "m:16:8: error: point 4 of face 0 is not there: there are 4\n");
  EXPECT_EQ(told(parse_ply, kPlyHead + kPlyPoints + "3 0 1 2\n3 0 2 -1\n"),
            "m:17:9: error: point -1 of face 1 is not there: there are 4\n");
  EXPECT_EQ(told(parse_ply, kPlyHead + kPlyPoints + "2 0 1\n3 0 2 3\n"),
            "m:16:6: error: face 0 has 2 corners: expected 3 or more\n");
  EXPECT_EQ(told(parse_ply, kPlyHead + "0 0 0 255\n1 0 x 255\n1 1 0 255\n0 1 0.5 255\n3 0 1 2\n"),
            "m:13:5: error: expected a number of an element 'vertex'\n");
  EXPECT_EQ(told(parse_ply, kPlyHead + kPlyPoints + "3 0 1 2\n3 0"),
            "m:17:4: error: is cut off among its elements 'face'\n");
  EXPECT_EQ(told(parse_ply, kPlyHead + "0 0 0 255\n"),
            "m: error: is cut off: 4 of vertex do not fit into the 10 bytes that are left\n");
  EXPECT_EQ(told(parse_ply, "ply\nformat ascii 1.0\nelement vertex 300000000\n"),
            "m:3:1: error: 300000000 of vertex are too many: at most 268435456 fit\n");
  EXPECT_EQ(told(parse_ply, "plx\n"), "m:1:1: error: the first line of a PLY file is ply\n");
  EXPECT_EQ(told(parse_ply, "ply\nformat binary 1.0\n"),
            "m:2:1: error: 'binary' is no format of PLY: expected ascii, binary_little_endian or "
            "binary_big_endian\n");
  EXPECT_EQ(told(parse_ply, "ply\nelement vertex 1\nproperty half x\n"),
            "m:3:1: error: 'half' is no type of PLY\n");
  EXPECT_EQ(told(parse_ply, "ply\nproperty float x\n"),
            "m:2:1: error: 'property float x' is no line of a PLY header\n");
  EXPECT_EQ(told(parse_ply, "ply\nformat ascii 1.0\n"), "m: error: is cut off in its header\n");
}

const std::string kFacet =
    "facet normal 0 0 1\n outer loop\n  vertex 0 0 0\n  vertex 1 0 0\n  vertex 0 1 0\n endloop\n"
    "endfacet\n";

TEST(Stl, IsReadAsTextWithPointsMadeOneAgain) {
  const Mesh mesh = parse_stl("solid two words\n" + kFacet +
                                  "facet normal 0 0 1\n outer loop\n  vertex 1 0 -0\n  vertex 1 1 "
                                  "0\n  vertex 0 1 0\n endloop\nendfacet\nendsolid\n",
                              "m")
                        .value();
  EXPECT_EQ(mesh.points.size(), 4u);
  EXPECT_EQ(points_of(mesh), (std::vector<std::array<std::uint32_t, 3>>{{0, 1, 2}, {1, 3, 2}}));
}

std::string binary_stl(std::uint32_t count, std::uint32_t announced) {
  std::string bytes = "solid in name only";
  bytes.resize(80, ' ');
  const auto put = [&](auto value) {
    char own[sizeof value];
    std::memcpy(own, &value, sizeof value);
    bytes.append(own, sizeof value);
  };
  put(announced);
  for (std::uint32_t i = 0; i < count; ++i) {
    for (int k = 0; k < 12; ++k) put(k == 3 || k == 7 ? 1.5f : 0.0f);
    put(std::uint16_t{0});
  }
  return bytes;
}

TEST(Stl, IsReadAsBytes) {
  const Mesh mesh = parse_stl(binary_stl(2, 2), "m").value();
  EXPECT_EQ(mesh.triangles.size(), 2u);
  EXPECT_EQ(mesh.points, (std::vector<Vec3>{{1.5, 0, 0}, {0, 1.5, 0}, {0, 0, 0}}));
}

TEST(Stl, SaysWhatIsWrongAtItsPlace) {
  EXPECT_EQ(told(parse_stl, "solid\n" + kFacet),
            "m: error: is cut off: it does not end with endsolid\n");
  EXPECT_EQ(told(parse_stl, "solid\nfacet normal 0 0 1\nvertex 0 0 x\n"),
            "m:3:12: error: 'x' is no number: expected x, y and z of a corner\n");
  EXPECT_EQ(told(parse_stl, "solid\nfacet normal 0 0 1\nvertex 0 0 0\nendfacet\n"),
            "m:4:1: error: a facet has 1 corners: expected 3\n");
  EXPECT_EQ(told(parse_stl, "solid\nfacte\n"), "m:2:1: error: 'facte' is no keyword of STL\n");
  EXPECT_EQ(told(parse_stl, "solid\nendsolid\n"), "m: error: has no triangles\n");
  std::string cut = binary_stl(2, 3);
  cut[1] = '\0';
  EXPECT_EQ(told(parse_stl, cut),
            "m: error: is cut off: 3 triangles take 234 bytes, but it has 184\n");
  EXPECT_EQ(told(parse_stl, "x"),
            "m: error: is no STL file: it neither begins with solid nor has a header\n");
}

TEST(Mesh, BlendsNormalsByArea) {
  Mesh mesh =
      parse_obj("v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 2\nvn 0 5 0\nf 1//1 2 3\nf 1 3 4\n", "m").value();
  mesh.add_normals();
  const auto normal = [&](std::size_t triangle, std::size_t corner) {
    return mesh.normals.at(mesh.triangles[triangle][corner].normal);
  };
  EXPECT_EQ(normal(0, 0), (Vec3{0, 5, 0})) << "the file's";
  EXPECT_EQ(normal(0, 1), (Vec3{0, 0, 1}));
  EXPECT_EQ(normal(1, 0), (Vec3{2, 0, 1}));
  EXPECT_EQ(normal(1, 2), (Vec3{2, 0, 0}));
  // A face and its back: each has its own.
  Mesh sheet = parse_obj("v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\nf 1 3 2\n", "m").value();
  sheet.add_normals();
  EXPECT_EQ(sheet.normals.at(sheet.triangles[0][0].normal), (Vec3{0, 0, 1}));
  EXPECT_EQ(sheet.normals.at(sheet.triangles[1][0].normal), (Vec3{0, 0, -1}));
}

class LanguageMeshes : public testing::Test {
 protected:
  LanguageMeshes() {
    fs::create_directories(folder_);
    write("square.obj", kSquare + "vt 0 0\nvt 1 0\nvt 1 1\nf 1/1 2/2 3/3 4\n");
    write("smooth.obj", kSquare + "vn 0 0 1\nf 1//1 2//1 3//1\n");
    write("land.pgm", "P2 3 2 100 0 50 100 0 0 25\n");
  }
  ~LanguageMeshes() override { fs::remove_all(folder_); }

  void write(const char* name, const std::string& text) const {
    std::ofstream(folder_ / name) << text;
  }
  ReadOptions options() const { return {.folder = folder_.string()}; }
  static std::string mesh(const std::string& file, const std::string& more = "") {
    return "[[shape]]\nkind = \"mesh\"\nfile = \"" + file + "\"\n" + more;
  }

  fs::path folder_ = fs::path(testing::TempDir()) /
                     fmt::format("zraka_language_meshes_{}",
                                 testing::UnitTest::GetInstance()->current_test_info()->name());
};

TEST_F(LanguageMeshes, AreGroupsThatInstancesShare) {
  const Scene s = scene_of(mesh("square.obj", "name = \"a\"\n") +
                               mesh("square.obj", "transform = [{scale = 2}]\n") +
                               mesh("square.obj", "smooth = true\n") + mesh("smooth.obj"),
                           options());
  ASSERT_EQ(s.groups.size(), 3u);
  ASSERT_EQ(s.instances.size(), 4u);
  EXPECT_EQ(s.instances[0].shape.group, s.instances[1].shape.group);
  EXPECT_EQ(s.instances[1].transform, 1u);
  EXPECT_EQ(s.instances[0].material, 0u);
  EXPECT_EQ(s.names.size(), 1u);
  const Group& square = s.groups[0];
  ASSERT_EQ(square.triangles.size(), 2u);
  EXPECT_EQ(square.triangles[0].material, kMaterialOfWhole);
  EXPECT_EQ(square.triangle_uvs,
            (std::vector<CornerUvs>{{{{0, 0}, {1, 0}, {1, 1}}}, {{{1, 1}, {1, 0}, {0, 0}}}}));
  EXPECT_EQ(s.groups[1].smooth_triangles.size(), 2u);
  EXPECT_EQ(s.groups[1].smooth_triangles[0].shape.normal_a, (Vec3{0, 0, 2}));
  EXPECT_EQ(s.groups[2].smooth_triangles.size(), 1u) << "the file has normals";
  expect_rewritten(mesh("square.obj", "transform = [{scale = 2}]\n") + mesh("smooth.obj") +
                       "[[group.g.shape]]\nkind = \"mesh\"\nfile = \"square.obj\"\n",
                   options());
}

TEST_F(LanguageMeshes, SayWhatIsWrongAtTheirPlace) {
  write("bad.obj", kSquare + "f 1 2 9\n");
  write("far.obj", "v 0 0 0\nv 1 0 0\nv 0 1e200 0\nf 1 2 3\n");
  const auto first = [&](const std::string& file) { return first_answer(mesh(file), options()); };
  EXPECT_EQ(first("bad.obj"),
            "s.toml:3:8: error: file of mesh: bad.obj:5:7: point 9 is not there: so far there are "
            "4");
  EXPECT_EQ(first("far.obj"),
            "s.toml:3:8: error: triangle 0: it reaches farther than 1e+100 from the origin");
  EXPECT_EQ(first("none.obj"),
            "s.toml:3:8: error: file of mesh: none.obj: cannot be read: No such file or directory");
  EXPECT_EQ(answer_to(mesh("a.GLB"), options()),
            "s.toml:3:8: error: file of mesh: a.GLB: is a scene: meshes of .glb files are not taken out\n"
            "  file = \"a.GLB\"\n         ^\n"
            "  most programs that write them write .obj or .ply, too\n");
  EXPECT_EQ(first("land.pgm"),
            "s.toml:3:8: error: file of mesh: land.pgm: its name ends like that of no mesh: "
            "expected .obj, .ply, .stl or .off");
  EXPECT_EQ(first("../x.obj"),
            "s.toml:3:8: error: file of mesh: '../x.obj' lies outside of the scene's folder");
  EXPECT_EQ(
      first_answer("[[shape]]\nkind = \"union\"\nof = [{kind = \"mesh\", file = \"a.obj\"}]\n",
                   options()),
      "s.toml:3:15: error: mesh is no closed body, and union is of such");
}

TEST_F(LanguageMeshes, MakeLandscapesOfPictures) {
  const std::string land = "[[shape]]\nkind = \"height_field\"\nfile = \"land.pgm\"\n";
  const Scene s = scene_of(land + "size = [4, 10, 6]\n", options());
  const Group& group = s.groups.at(0);
  ASSERT_EQ(group.triangles.size(), 4u);
  EXPECT_EQ(group.triangles[0].shape.a, (Vec3{0, 0, 0})) << "the picture's upper left corner";
  EXPECT_EQ(group.triangles[0].shape.b, (Vec3{0, 0, 6})) << "the lower one is nearer";
  EXPECT_EQ(group.triangles[0].shape.c, (Vec3{2, 5, 0}));
  EXPECT_EQ(group.triangles[3].shape.a, (Vec3{4, 10, 0}));
  EXPECT_EQ(group.triangles[3].shape.c, (Vec3{4, 2.5, 6}));
  EXPECT_EQ(group.triangle_uvs[0], (CornerUvs{{{0, 1}, {0, 0}, {0.5f, 1}}}));
  EXPECT_EQ(scene_of(land + "size = [4, 10, 6]\nsmooth = true\n", options())
                .groups.at(0)
                .smooth_triangles.size(),
            4u);
  write("thin.pgm", "P2 3 1 100 0 50 100\n");
  EXPECT_EQ(first_answer("[[shape]]\nkind = \"height_field\"\nfile = \"thin.pgm\"\n"
                         "size = [1, 1, 1]\n",
                         options()),
            "s.toml:3:8: error: file of height_field is a picture of 3×1 pixels: expected 2×2 or "
            "more");
  write("huge.pgm", "P5 100000 1000 255\n");
  EXPECT_NE(first_answer("[[shape]]\nkind = \"height_field\"\nfile = \"huge.pgm\"\n"
                         "size = [1, 1, 1]\n",
                         options())
                .find("s.toml:3:8: error: file of height_field: huge.pgm: "),
            std::string::npos);
  expect_rewritten(land + "size = [4, 10, 6]\n", options());
}

}  // namespace
}  // namespace zraka
