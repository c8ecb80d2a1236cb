// SPDX-License-Identifier: Apache-2.0
// Meshes by themselves as scenes: light and camera are chosen, materials are those of the OBJ.
#include <gtest/gtest.h>
#include <unistd.h>

#include <filesystem>
#include <fstream>
#include <zraka/zraka.hpp>

#include "mesh/mtl.hpp"

namespace zraka {
namespace {

namespace fs = std::filesystem;

class MeshScenes : public testing::Test {
 protected:
  void SetUp() override {
    std::string name = (fs::temp_directory_path() / "meshes-XXXXXX").string();
    folder_ = mkdtemp(name.data());
  }
  void TearDown() override { fs::remove_all(folder_); }
  std::string write(const std::string& name, const std::string& text) {
    std::ofstream(folder_ / name, std::ios::binary) << text;
    return (folder_ / name).string();
  }
  fs::path folder_;
};

std::string notes(const ReadScene& read) {
  std::string all;
  for (const Diagnostic& d : read.warnings) all += d.message + "\n";
  return all;
}

constexpr const char* kTetrahedron = "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 1\n";

TEST_F(MeshScenes, TakeMaterialsFromTheFilesThatAnObjNames) {
  write("a.mtl",
        "# made by hand\nnewmtl red\nKd 0.5 0.25 0\nKs 1\nNs 20\nillum 2\n"
        "newmtl mirror of glass\nKd 0 0 0\nKs 0.5 0.5 0.5\nd 0.25\nNi 1.5\nillum 7\n");
  const std::string path =
      write("a.obj", std::string("mtllib a.mtl\n") + kTetrahedron +
                         "f 1 2 3\nusemtl red\nf 1 2 4\nusemtl mirror of glass\nf 2 3 4\nusemtl "
                         "red\nf 1 3 4\nusemtl none\nf 1 2 4\n");
  const Result<ReadScene> read = read_scene(path);
  ASSERT_TRUE(read) << to_string(read.error()[0]);
  const Scene& scene = read->scene;
  ASSERT_EQ(scene.triangles.size(), 5u);
  ASSERT_EQ(scene.materials.size(), 4u);
  EXPECT_EQ(scene.triangles[0].material, 0u);
  EXPECT_EQ(scene.triangles[1].material, 1u);
  EXPECT_EQ(scene.triangles[2].material, 2u);
  EXPECT_EQ(scene.triangles[3].material, 1u);
  EXPECT_EQ(scene.materials[1].diffuse, (Color{0.5, 0.25, 0}));
  EXPECT_EQ(scene.materials[1].specular, (Color{1, 1, 1}));
  EXPECT_EQ(scene.materials[1].reflection.most(), 0);
  EXPECT_EQ(scene.materials[2].refraction.r, 0.75);
  EXPECT_EQ(scene.materials[2].reflection.r, 0.5);
  EXPECT_EQ(scene.materials[2].ior, 1.5);
  EXPECT_EQ(scene.materials[2].fresnel, Fresnel::exact);
  EXPECT_EQ(scene.material_names.at(1), "red");
  EXPECT_EQ(notes(*read),
            "1 of its materials is in no file of materials: grey is drawn\n"
            "5 triangles; light and camera are chosen here\n");
}

TEST_F(MeshScenes, PutPicturesOnTheirTriangles) {
  Image image(1, 1);
  image.pixels = {0, 1, 0};
  ASSERT_TRUE(write_png(image, (folder_ / "green.png").string()));
  fs::create_directory(folder_ / "of");
  fs::rename(folder_ / "green.png", folder_ / "of" / "green.png");
  write("of/a.mtl", "newmtl m\nmap_Kd -s 1 1 1 green.png\nnewmtl n\nmap_Kd none.png\n");
  const std::string path = write("a.obj", std::string("mtllib of/a.mtl\nvt 0 1\n") + kTetrahedron +
                                              "usemtl m\nf 1/1 2/1 3/1\nusemtl n\nf 1 2 4\n");
  const Result<ReadScene> read = read_scene(path);
  ASSERT_TRUE(read);
  ASSERT_EQ(read->scene.textures.size(), 1u);
  EXPECT_EQ(read->scene.textures[0].file, "of/green.png");
  EXPECT_EQ(read->scene.materials[1].textures.size(), 2u);
  ASSERT_EQ(read->scene.triangle_uvs.size(), 2u);
  EXPECT_EQ(read->scene.triangle_uvs[0][2], (std::array<float, 2>{0, 1}));
  EXPECT_NE(notes(*read).find("of/none.png: cannot be read"), std::string::npos) << notes(*read);
}

TEST_F(MeshScenes, StayInTheirFolder) {
  fs::create_directory(folder_ / "in");
  write("out.mtl", "newmtl m\nKd 1 0 0\n");
  const std::string text =
      std::string("mtllib ../out.mtl\n") + kTetrahedron + "usemtl m\nf 1 2 3\n";
  const std::string path = write("in/a.obj", text);
  const Result<ReadScene> read = read_scene(path);
  ASSERT_TRUE(read);
  EXPECT_NE(notes(*read).find("lies outside of the scene's folder"), std::string::npos);
  EXPECT_NE(read->scene.materials[1].diffuse, (Color{1, 0, 0}));
  const Result<ReadScene> allowed = read_scene(path, {.allow_outside = true});
  EXPECT_EQ(allowed->scene.materials[1].diffuse, (Color{1, 0, 0}));
}

TEST_F(MeshScenes, AreKnownByTheirContentAndSeen) {
  const std::string ply =
      "ply\nformat ascii 1.0\nelement vertex 3\nproperty float x\nproperty float y\nproperty float "
      "z\nelement face 1\nproperty list uchar int vertex_indices\nend_header\n0 0 0\n1 0 0\n0 1 "
      "0\n3 0 1 2\n";
  const std::string stl =
      "solid a\nfacet normal 0 0 1\nouter loop\nvertex 0 0 0\nvertex 1 0 0\nvertex 0 0 "
      "1\nendloop\nendfacet\nendsolid\n";
  const std::string off =
      "OFF\n# a corner\n4 2 0\n0 0 0\n1 0 0\n1 1 0\n0 1 0\n4 0 1 2 3 255 0 0\n3 0 1 2\n";
  std::string binary(84, ' ');
  binary.replace(80, 4, std::string("\1\0\0\0", 4));
  const float numbers[12] = {0, 0, 1, 0, 0, 0, 1, 0, 0, 0, 0, 1};
  binary.append(reinterpret_cast<const char*>(numbers), sizeof(numbers)).append(2, '\0');
  for (const auto& [text, name, triangles] :
       {std::tuple(ply, "a.txt", 1u),
        {stl, "b.stl", 1u},
        {off, "c", 3u},
        {binary, "d", 1u},
        {std::string(kTetrahedron) + "f 1 2 3 4\n", "e.nff", 2u}}) {
    SCOPED_TRACE(name);
    Result<ReadScene> read = parse_scene(text, name);
    ASSERT_TRUE(read) << to_string(read.error()[0]);
    EXPECT_EQ(read->scene.triangles.size(), triangles);
    EXPECT_EQ(read->scene.lights.size(), 2u);
    read->scene.resolution = {64, 36};
    const Image with = render(read->scene, {}).value().image;
    read->scene.triangles.clear();
    EXPECT_NE(with.pixels, render(read->scene, {}).value().image.pixels);
  }
}

TEST_F(MeshScenes, SayWhatIsWrongWithOff) {
  const auto answer = [](const std::string& text) {
    const Result<ReadScene> read = parse_scene(text, "a.off");
    return read ? "it is read" : to_string(read.error()[0]);
  };
  EXPECT_EQ(answer("OFF\n3 1 0\n0 0 0\n1 0 0\n0 1 x\n3 0 1 2\n"),
            "a.off:5: error: point 2 has no three finite numbers\n");
  EXPECT_EQ(answer("OFF\n3 1 0\n0 0 0\n1 0 0\n0 1 0\n3 0 1 3\n"),
            "a.off:6: error: face 0: expected indices of points, less than 3\n");
  EXPECT_EQ(answer("OFF\n99999999 1 0\n0 0 0\n"),
            "a.off:2: error: 99999999 points and 1 faces are more than the file holds\n");
  EXPECT_EQ(answer("OFF\n"), "a.off:2: error: the header ends: expected three counts\n");
}

TEST(Mtl, IsReadAsPeopleWriteIt) {
  const std::vector<MtlMaterial> all = parse_mtl(
      "Kd 1 1 1\r\nnewmtl  a b \r\n  Kd 0.5\r\nTr 0.25\nKs spectral x.rfl\nNs nan\nd -halo 0.5\n"
      "map_Kd folder\\of mine.png\nwhatever\n");
  ASSERT_EQ(all.size(), 1u);
  EXPECT_EQ(all[0].name, "a b");
  EXPECT_EQ(all[0].diffuse, (Color{0.5, 0.5, 0.5}));
  EXPECT_EQ(all[0].opacity, 0.75);
  EXPECT_EQ(all[0].specular, Color{});
  EXPECT_EQ(all[0].shininess, 10);
  EXPECT_EQ(all[0].diffuse_map, "folder/of mine.png");
}

}  // namespace
}  // namespace zraka
