// SPDX-License-Identifier: Apache-2.0
// glTF 2.0 and GLB: geometry, materials, cameras and lights, and files that lie.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <bit>
#include <cmath>
#include <cstring>
#include <zraka/zraka.hpp>

#include "core/base64.hpp"
#include "equal_scenes.hpp"

namespace zraka {
namespace {

/// A file put together from numbers and JSON.
class GltfText {
 public:
  template <class T>
  int accessor(std::initializer_list<T> values, int component, const char* type, int width,
               const char* more = "") {
    while (bytes_.size() % 4 != 0) bytes_ += '\0';
    const std::size_t begin = bytes_.size();
    for (const T value : values) {
      char raw[sizeof(T)];
      std::memcpy(raw, &value, sizeof(T));
      bytes_.append(raw, sizeof(T));
    }
    views_ += fmt::format("{}{{\"buffer\":0,\"byteOffset\":{},\"byteLength\":{}}}",
                          views_.empty() ? "" : ",", begin, bytes_.size() - begin);
    accessors_ +=
        fmt::format("{}{{\"bufferView\":{},\"componentType\":{},\"count\":{},\"type\":\"{}\"{}}}",
                    accessors_.empty() ? "" : ",", count_, component,
                    values.size() / static_cast<std::size_t>(width), type, more);
    return count_++;
  }
  int floats(std::initializer_list<float> values, int width = 3) {
    const char* const types[] = {"", "SCALAR", "VEC2", "VEC3", "VEC4"};
    return accessor(values, 5126, types[width], width);
  }
  int view(const std::string& bytes) {
    views_ += fmt::format("{}{{\"buffer\":0,\"byteOffset\":{},\"byteLength\":{}}}",
                          views_.empty() ? "" : ",", bytes_.size(), bytes.size());
    bytes_ += bytes;
    accessors_ += fmt::format("{}{{\"componentType\":5126,\"count\":0,\"type\":\"SCALAR\"}}",
                              accessors_.empty() ? "" : ",");
    return count_++;
  }
  /// With `more` members of the file: nodes, meshes and so on.
  std::string json(const std::string& more, bool with_bytes = true) const {
    const std::string uri =
        with_bytes ? ",\"uri\":\"data:application/octet-stream;base64," + base64(bytes_) + "\""
                   : "";
    return fmt::format(
        R"({{"asset":{{"version":"2.0"}},"buffers":[{{"byteLength":{}{}}}],"bufferViews":[{}],"accessors":[{}],{}}})",
        bytes_.size(), uri, views_, accessors_, more);
  }
  std::string binary(const std::string& more) const {
    std::string text = json(more, false), bytes = bytes_;
    while (text.size() % 4 != 0) text += ' ';
    while (bytes.size() % 4 != 0) bytes += '\0';
    const auto word = [](std::size_t value) {
      std::string raw(4, '\0');
      for (std::size_t i = 0; i < 4; ++i) raw[i] = static_cast<char>(value >> (8 * i) & 0xFF);
      return raw;
    };
    return "glTF" + word(2) + word(28 + text.size() + bytes.size()) + word(text.size()) + "JSON" +
           text + word(bytes.size()) + std::string("BIN\0", 4) + bytes;
  }

 private:
  std::string bytes_, views_, accessors_;
  int count_ = 0;
};

ReadScene read(const std::string& text) {
  Result<ReadScene> scene = parse_scene(text, "a.gltf");
  if (!scene) ADD_FAILURE() << to_string(scene.error().front()) << text.substr(0, 2000);
  return scene ? std::move(*scene) : ReadScene{};
}

std::string answer(const std::string& text) {
  const Result<ReadScene> scene = parse_scene(text, "a.gltf");
  return scene ? "it is read" : to_string(scene.error().front());
}

std::string notes(const ReadScene& read) {
  std::string all;
  for (const Diagnostic& d : read.warnings) all += to_string(d);
  return all;
}

const char* const kOneNode = R"("scenes":[{"nodes":[0]}],"nodes":[{"mesh":0}])";

/// A square of four points, and what else the mesh's primitive has.
struct Square : GltfText {
  int points = floats({0, 0, 0, 1, 0, 0, 1, 1, 0, 0, 1, 0});
  std::string with(const std::string& primitive, const std::string& more = "",
                   const std::string& nodes = kOneNode) const {
    return json(
        fmt::format(R"({}{}{},"meshes":[{{"primitives":[{{"attributes":{{"POSITION":{}{}]}}])",
                    nodes, more.empty() ? "" : ",", more, points, primitive));
  }
};

TEST(Gltf, ReadsIndicesOfAllWidthsAndNone) {
  for (const int component : {5121, 5123, 5125}) {
    Square square;
    const int indices =
        component == 5121   ? square.accessor<std::uint8_t>({0, 1, 2, 0, 2, 3}, 5121, "SCALAR", 1)
        : component == 5123 ? square.accessor<std::uint16_t>({0, 1, 2, 0, 2, 3}, 5123, "SCALAR", 1)
                            : square.accessor<std::uint32_t>({0, 1, 2, 0, 2, 3}, 5125, "SCALAR", 1);
    const Scene scene = read(square.with(fmt::format("}},\"indices\":{}}}", indices))).scene;
    ASSERT_EQ(scene.groups.size(), 1u);
    ASSERT_EQ(scene.groups[0].triangles.size(), 2u);
    EXPECT_EQ(scene.groups[0].triangles[0].shape.b, (Vec3{1, 0, 0}));
    EXPECT_EQ(scene.groups[0].triangles[1].shape.b, (Vec3{1, 1, 0}));
    EXPECT_EQ(scene.groups[0].triangles[1].shape.c, (Vec3{0, 1, 0}));
    EXPECT_EQ(scene.instances.size(), 1u);
  }
  const Scene scene = read(Square().with("}}")).scene;
  EXPECT_EQ(scene.groups[0].triangles.size(), 1u) << "three of four points";
}

TEST(Gltf, TurnsStripsAndFansIntoTriangles) {
  const auto triangles = [](int mode) {
    return read(Square().with(fmt::format("}},\"mode\":{}}}", mode))).scene.groups.at(0).triangles;
  };
  const auto strip = triangles(5), fan = triangles(6);
  ASSERT_EQ(strip.size(), 2u);
  EXPECT_EQ(strip[1].shape.b, (Vec3{0, 1, 0})) << "the second one is turned round";
  ASSERT_EQ(fan.size(), 2u);
  EXPECT_EQ(fan[1].shape.c, (Vec3{0, 0, 0}));
  EXPECT_EQ(fan[1].shape.a, (Vec3{1, 1, 0}));
}

TEST(Gltf, IsTheSameInOneBinaryFile) {
  Square square;
  const std::string rest = fmt::format(
      R"({},"meshes":[{{"primitives":[{{"attributes":{{"POSITION":0}}}}]}}])", kOneNode);
  expect_equal(read(square.json(rest)).scene, read(square.binary(rest)).scene);
  const std::string whole = square.binary(rest);
  for (const std::size_t size : {13u, 24u, 200u, static_cast<unsigned>(whole.size() - 5)})
    EXPECT_NE(answer(whole.substr(0, size)), "it is read") << size;
}

TEST(Gltf, MovesMeshesByTheirNodes) {
  const std::string nodes =
      R"("scenes":[{"nodes":[0]}],"nodes":[{"children":[1,2],"translation":[1,2,3],"scale":[2,2,2]},)"
      R"({"mesh":0,"rotation":[0,0,0.70710678118654757,0.70710678118654757]},)"
      R"({"mesh":0,"matrix":[1,0,0,0,0,1,0,0,0,0,1,0,5,0,0,1]}])";
  const Scene scene = read(Square().with("}}", "", nodes)).scene;
  ASSERT_EQ(scene.groups.size(), 1u) << "one mesh, whatever has it";
  ASSERT_EQ(scene.instances.size(), 2u);
  const Transform& turned = scene.transforms.at(scene.instances[0].transform - 1);
  EXPECT_NEAR(turned.along_x.y, 2, 1e-12);
  EXPECT_NEAR(turned.along_y.x, -2, 1e-12);
  EXPECT_EQ(turned.origin, (Vec3{1, 2, 3}));
  EXPECT_EQ(scene.transforms.at(scene.instances[1].transform - 1).origin, (Vec3{11, 2, 3}));
}

TEST(Gltf, TakesCamerasAndLightsOfTheFile) {
  const std::string nodes =
      R"("scenes":[{"nodes":[0,1,2,3]}],"nodes":[{"mesh":0},{"camera":0,"translation":[0,0,9]},)"
      R"({"extensions":{"KHR_lights_punctual":{"light":0}}},)"
      R"({"translation":[0,0,4],"extensions":{"KHR_lights_punctual":{"light":1}}}],)"
      R"("cameras":[{"type":"perspective","perspective":{"yfov":0.5,"aspectRatio":2,"znear":1}}],)"
      R"("extensions":{"KHR_lights_punctual":{"lights":[{"type":"directional","intensity":3.141592653589793},)"
      R"({"type":"spot","color":[1,0.5,0],"intensity":3,"spot":{"innerConeAngle":0.1,"outerConeAngle":0.2}}]}})";
  const ReadScene with = read(Square().with("},\"mode\":5}", "", nodes));
  EXPECT_EQ(notes(with), "");
  const Scene& scene = with.scene;
  EXPECT_EQ(scene.camera.eye, (Vec3{0, 0, 9}));
  EXPECT_NEAR(scene.camera.window_up.y, 2 * std::tan(0.25), 1e-12);
  EXPECT_EQ(scene.resolution.width, 2 * scene.resolution.height);
  ASSERT_EQ(scene.lights.size(), 2u);
  EXPECT_EQ(scene.lights[0].kind, LightKind::directional);
  EXPECT_EQ(scene.lights[0].direction, (Vec3{0, 0, -1}));
  EXPECT_NEAR(scene.lights[0].color.r, 1, 1e-12);
  EXPECT_EQ(scene.lights[1].position, (Vec3{0, 0, 4}));
  EXPECT_NEAR(scene.lights[1].outer_deg, 0.2 * 180 / 3.14159265358979, 1e-9);
  EXPECT_EQ(scene.lights[1].attenuation, (Vec3{0, 0, 1}));
}

TEST(Gltf, ChoosesLightsAndACameraWhereThereAreNone) {
  const ReadScene without = read(Square().with("},\"mode\":5}"));
  EXPECT_EQ(notes(without),
            "a.gltf: note: the file has no lights: two are chosen here\n"
            "a.gltf: note: the file has no camera: one is chosen that sees all of it\n");
  EXPECT_EQ(without.scene.lights.size(), 2u);
  RenderOptions options;
  Scene scene = without.scene;
  scene.resolution = {64, 36};
  const Image with = render(scene, options).value().image;
  scene.instances.clear();
  EXPECT_NE(with.pixels, render(scene, options).value().image.pixels) << "it is seen";
}

Material material(const std::string& json) {
  const Scene scene =
      read(Square().with("},\"material\":0}", "\"materials\":[" + json + "]")).scene;
  return scene.materials.at(scene.groups.at(0).triangles.at(0).material);
}

TEST(Gltf, MakesMattMirrorsAndGlassOfItsMaterials) {
  const Material matt =
      material(R"({"pbrMetallicRoughness":{"baseColorFactor":[0.5,0.25,1,1],"metallicFactor":0}})");
  EXPECT_EQ(matt.diffuse, (Color{0.5, 0.25, 1}));
  EXPECT_EQ(matt.ambient, matt.diffuse);
  EXPECT_EQ(matt.reflection.most(), 0);
  const Material metal =
      material(R"({"pbrMetallicRoughness":{"baseColorFactor":[1,0.5,0,1],"roughnessFactor":0}})");
  EXPECT_EQ(Color(metal.reflection), (Color{1, 0.5, 0}));
  EXPECT_EQ(metal.diffuse, Color{});
  const Material glass = material(
      R"({"pbrMetallicRoughness":{"metallicFactor":0,"roughnessFactor":0},"extensions":{)"
      R"("KHR_materials_transmission":{"transmissionFactor":1},"KHR_materials_ior":{"ior":1.7},)"
      R"("KHR_materials_volume":{"thicknessFactor":1,"attenuationDistance":2,"attenuationColor":[0.5,1,1]},)"
      R"("KHR_materials_dispersion":{"dispersion":0.5}}})");
  EXPECT_EQ(glass.refraction.r, 1);
  EXPECT_EQ(glass.ior, 1.7);
  EXPECT_EQ(glass.diffuse, Color{});
  EXPECT_EQ(glass.fresnel, Fresnel::exact);
  EXPECT_NEAR(glass.absorption.r, std::log(2) / 2, 1e-12);
  EXPECT_NEAR(glass.absorption.g, 0, 1e-12);
  EXPECT_EQ(glass.dispersion.numbers[0], 40);
  const Material sheet = material(
      R"({"pbrMetallicRoughness":{"metallicFactor":0},"extensions":{"KHR_materials_transmission":{"transmissionFactor":0.5}}})");
  EXPECT_EQ(sheet.ior, 1) << "without a thickness";
  const Material clear = material(
      R"({"alphaMode":"BLEND","pbrMetallicRoughness":{"metallicFactor":0,"baseColorFactor":[1,1,1,0.25]}})");
  EXPECT_EQ(clear.refraction.r, 0.75);
  EXPECT_EQ(clear.diffuse.r, 0.25);
}

TEST(Gltf, LetsSurfacesShineByAmbientLight) {
  const Scene scene =
      read(Square().with(
               "},\"material\":0}",
               R"("materials":[{"emissiveFactor":[0.5,0,0],)"
               R"("pbrMetallicRoughness":{"baseColorFactor":[0,0,0,1],"metallicFactor":0},)"
               R"("extensions":{"KHR_materials_emissive_strength":{"emissiveStrength":3}}}])"))
          .scene;
  const Material& m = scene.materials.at(scene.groups.at(0).triangles.at(0).material);
  EXPECT_NEAR(m.ambient.r * scene.ambient_light.r, 1.5, 1e-12);
  const Material unlit = material(
      R"({"pbrMetallicRoughness":{"baseColorFactor":[0.5,1,0,1]},"extensions":{"KHR_materials_unlit":{}}})");
  EXPECT_NEAR(unlit.ambient.r * scene.ambient_light.r, 0.5, 1e-12);
  EXPECT_EQ(unlit.diffuse, Color{});
}

/// Four pixels, each of a colour of its own, as a PNG.
std::string picture() {
  Image image(2, 2);
  image.pixels = {1, 0, 0, 0, 1, 0, 0, 0, 1, 1, 1, 1};
  return encode_png(image).value();
}

TEST(Gltf, ReadsTexturesFromBuffersAndDataUris) {
  for (const bool in_buffer : {true, false}) {
    Square square;
    const int uvs = square.floats({0, 0, 1, 0, 1, 1, 0, 1}, 2);
    const int view = square.view(picture());
    const std::string image =
        in_buffer ? fmt::format("\"bufferView\":{},\"mimeType\":\"image/png\"", view)
                  : "\"uri\":\"data:image/png;base64," + base64(picture()) + "\"";
    const Scene scene =
        read(
            square.with(
                fmt::format(",\"TEXCOORD_0\":{}}},\"material\":0}}", uvs),
                fmt::format(
                    R"("images":[{{{}}}],"samplers":[{{"magFilter":9728,"wrapS":33071,"wrapT":33071}}],)"
                    R"("textures":[{{"source":0,"sampler":0}}],)"
                    R"("materials":[{{"pbrMetallicRoughness":{{"metallicFactor":0,"baseColorTexture":{{"index":0}}}}}}])",
                    image)))
            .scene;
    ASSERT_EQ(scene.textures.size(), 1u) << "diffuse and ambient light share it";
    const Texture& texture = scene.textures[0];
    ASSERT_NE(texture.image, nullptr);
    EXPECT_EQ(texture.image->pixels[0], 1);
    EXPECT_EQ(texture.image->pixels[4], 1);
    EXPECT_EQ(texture.wrap, TextureWrap::clamp);
    EXPECT_EQ(texture.filter, TextureFilter::nearest);
    ASSERT_EQ(scene.groups[0].triangle_uvs.size(), scene.groups[0].triangles.size());
    EXPECT_EQ(scene.groups[0].triangle_uvs[0][0], (std::array<float, 2>{0, 1}))
        << "glTF's v goes down";
  }
}

TEST(Gltf, MovesTextures) {
  Square square;
  const int uvs = square.floats({0, 0, 1, 0, 1, 1, 0, 1}, 2);
  const Scene scene =
      read(
          square.with(
              fmt::format(",\"TEXCOORD_0\":{}}},\"material\":0}}", uvs),
              R"("images":[{"uri":"data:image/png;base64,)" + base64(picture()) +
                  R"("}],"textures":[{"source":0}],"materials":[{"pbrMetallicRoughness":{"metallicFactor":0,)"
                  R"("baseColorTexture":{"index":0,"extensions":{"KHR_texture_transform":{"offset":[0.25,0.5],"scale":[2,4]}}}}}])"))
          .scene;
  // u' = 2u + 0.25 and v' = 4v + 0.5, v downwards: 1 - v' = 4(1 - v) - 3.5.
  const Transform& t = scene.textures.at(0).transform;
  EXPECT_NEAR(t.along_x.x, 0.5, 1e-12);
  EXPECT_NEAR(t.along_y.y, 0.25, 1e-12);
  EXPECT_NEAR(t.origin.x, -0.125, 1e-12);
  EXPECT_NEAR(t.origin.y, 0.875, 1e-12);
}

TEST(Gltf, BlendsColorsOfVertices) {
  Square square;
  const int colors = square.floats({1, 0, 0, 0, 1, 0, 0, 0, 1, 1, 1, 1});
  const Scene scene = read(square.with(fmt::format(",\"COLOR_0\":{}}}}}", colors))).scene;
  ASSERT_EQ(scene.textures.size(), 1u);
  EXPECT_EQ(scene.textures[0].filter, TextureFilter::bilinear);
  EXPECT_EQ(scene.groups[0].triangle_uvs.size(), 1u);
  Square same;
  const int red =
      same.accessor<std::uint8_t>({255, 0, 0, 0, 255, 0, 0, 0, 255, 0, 0, 0, 255, 0, 0, 0}, 5121,
                                  "VEC4", 4, ",\"normalized\":true");
  const Scene flat = read(same.with(fmt::format(",\"COLOR_0\":{}}}}}", red))).scene;
  EXPECT_TRUE(flat.textures.empty());
  EXPECT_EQ(flat.materials.at(flat.groups[0].triangles[0].material).diffuse, (Color{1, 0, 0}));
}

TEST(Gltf, ReadsSparseAccessors) {
  Square square;
  const int where = square.accessor<std::uint16_t>({2}, 5123, "SCALAR", 1);
  const int what = square.floats({7, 8, 9});
  std::string text = square.with("}}");
  const std::string first = R"("count":4,"type":"VEC3")";
  text.replace(
      text.find(first), first.size(),
      fmt::format(
          R"({},"sparse":{{"count":1,"indices":{{"bufferView":{},"componentType":5123}},"values":{{"bufferView":{}}}}})",
          first, where, what));
  EXPECT_EQ(read(text).scene.groups.at(0).triangles.at(0).shape.c, (Vec3{7, 8, 9}));
}

TEST(Gltf, MorphsAndSkinsAsTheFileStands) {
  Square square;
  const int by = square.floats({0, 0, 1, 0, 0, 1, 0, 0, 1, 0, 0, 1});
  std::string text = square.with(fmt::format("}},\"targets\":[{{\"POSITION\":{}}}]}}", by));
  const std::string meshes = "\"meshes\":[{";
  text.replace(text.find(meshes), meshes.size(), meshes + "\"weights\":[0.5],");
  EXPECT_EQ(read(text).scene.groups.at(0).triangles.at(0).shape.a, (Vec3{0, 0, 0.5}));
  Square skinned;
  const int joints = skinned.accessor<std::uint8_t>(
      {0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0}, 5121, "VEC4", 4);
  const int weights = skinned.floats({1, 0, 0, 0, 1, 0, 0, 0, 1, 0, 0, 0, 1, 0, 0, 0}, 4);
  const Scene scene =
      read(
          skinned.with(
              fmt::format(",\"JOINTS_0\":{},\"WEIGHTS_0\":{}}}}}", joints, weights),
              R"("skins":[{"joints":[1]}])",
              R"("scenes":[{"nodes":[0,1]}],"nodes":[{"mesh":0,"skin":0,"translation":[99,0,0]},{"translation":[0,3,0]}])"))
          .scene;
  EXPECT_EQ(scene.groups.at(0).triangles.at(0).shape.a, (Vec3{0, 3, 0}));
  EXPECT_EQ(scene.instances.at(0).transform, 0u) << "its joints say where it is";
}

TEST(Gltf, DrawsFacesOnceThatAreThereForBothSides) {
  Square square;
  const int indices = square.accessor<std::uint8_t>({0, 1, 2, 2, 1, 0, 1, 0, 2}, 5121, "SCALAR", 1);
  EXPECT_EQ(read(square.with(fmt::format("}},\"indices\":{}}}", indices)))
                .scene.groups.at(0)
                .triangles.size(),
            1u);
}

TEST(Gltf, SeesOneTexelWhereAllCornersHaveOneUv) {
  Square square;
  // One red pixel among many blue ones.
  Image image(64, 64);
  for (std::size_t i = 2; i < image.pixels.size(); i += 3) image.pixels[i] = 1;
  float* const red = image.row(16) + 3 * 16;
  red[0] = 1, red[2] = 0;
  const std::string png = encode_png(image).value();
  const float at = 16.5f / 64;
  const int uvs = square.floats({at, at, at, at, at, at, at, at}, 2);
  Scene scene =
      read(
          square.with(
              fmt::format(",\"TEXCOORD_0\":{}}},\"mode\":6,\"material\":0}}", uvs),
              R"("images":[{"uri":"data:image/png;base64,)" + base64(png) +
                  R"("}],"textures":[{"source":0}],"materials":[{"extensions":{"KHR_materials_unlit":{}},)"
                  R"("pbrMetallicRoughness":{"metallicFactor":0,"baseColorTexture":{"index":0}}}])"))
          .scene;
  scene.resolution = {9, 9};
  scene.sky = {};
  const Image seen = render(scene, {}).value().image;
  const float* const middle = seen.row(4) + 3 * 4;
  EXPECT_NEAR(middle[0], 1, 1e-5);
  EXPECT_NEAR(middle[2], 0, 1e-5);
}

TEST(Gltf, RefusesWhatLies) {
  const std::string good = Square().with("}}");
  const auto changed = [&](const std::string& from, const std::string& to) {
    std::string text = good;
    const std::size_t at = text.find(from);
    EXPECT_NE(at, std::string::npos) << from;
    return answer(text.replace(at, from.size(), to));
  };
  EXPECT_EQ(changed("\"count\":4", "\"count\":4000000000"),
            "a.gltf: error: accessor 0 has 4000000000 elements of 12 bytes, more than its buffer "
            "view's 48 bytes hold\n");
  EXPECT_EQ(changed("\"byteLength\":48}", "\"byteLength\":49}"),
            "a.gltf: error: buffer view 0 is bytes 0 to 49 of a buffer that has 48\n");
  EXPECT_EQ(changed("\"nodes\":[{", "\"nodes\":[{\"children\":[0],"),
            "a.gltf: error: node 0 is in several places, or in itself\n"
            "  the nodes of glTF are trees\n");
  EXPECT_EQ(
      changed("\"version\":\"2.0\"}", "\"version\":\"2.0\"},\"extensionsRequired\":[\"X_y\"]"),
      "a.gltf: error: the file needs the extension X_y, which is not read\n"
      "  programs that convert glTF can write it without compression: for example "
      "gltf-transform copy\n");
  EXPECT_EQ(changed("\"version\":\"2.0\"", "\"version\":\"1.0\""),
            "a.gltf: error: this is glTF 1.0: expected 2.0\n"
            "  programs that convert glTF 1.0 to 2.0 exist: for example gltf-pipeline\n");
  EXPECT_EQ(changed("\"POSITION\":0", "\"POSITION\":7"),
            "a.gltf: error: 'POSITION' names none of the 1 accessors of the file\n");
  EXPECT_EQ(changed("\"mesh\":0", "\"mesh\":-1"),
            "a.gltf: error: 'mesh' names none of the 1 meshes of the file\n");
  EXPECT_NE(changed("data:application/octet-stream;base64,", "../").find("need a folder"),
            std::string::npos);
}

TEST(Gltf, RefusesMoreTrianglesThanItsBytesCanMean) {
  Square square;
  square.accessor<std::uint8_t>({0, 1, 2}, 5121, "SCALAR", 1, ",\"sparse\":{\"count\":0}");
  std::string text = square.with("},\"indices\":1}");
  // No bytes stand for four million indices; half a million triangles, twenty times.
  const std::string accessor =
      "\"bufferView\":1,\"componentType\":5121,\"count\":3,\"type\":\"SCALAR\",\"sparse\":{"
      "\"count\":0}";
  text.replace(text.find(accessor), accessor.size(),
               "\"componentType\":5121,\"count\":1500000,\"type\":\"SCALAR\"");
  const std::string one = "{\"attributes\":{\"POSITION\":0},\"indices\":1}";
  std::string many = one;
  for (int i = 0; i < 3; ++i) many += "," + one;
  text.replace(text.find(one), one.size(), many);
  EXPECT_NE(answer(text).find("more than"), std::string::npos) << answer(text);
}

}  // namespace
}  // namespace zraka
