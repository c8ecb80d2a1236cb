// SPDX-License-Identifier: Apache-2.0
// Textures in the scene language, files that scenes name, and hints at what may be meant.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>

#include "language_helpers.hpp"

namespace zraka {
namespace {

namespace fs = std::filesystem;

TEST(LanguageTextures, AreNamedByMaterials) {
  const Scene s = scene_of(
      "[material.floor]\ndiffuse = \"tiles\"\nspecular = {kind = \"noise\", size = 3}\n"
      "shininess = \"tiles\"\nambient = \"#ffffff\"\n"
      "[texture.tiles]\nkind = \"checker\"\ncolors = [[1, 0.5, 0], 0.25]\nsize = 2\n"
      "mapping = \"uv\"\ntransform = [{scale = 2}]\n"
      "[texture.veins]\nkind = \"marble\"\n");
  ASSERT_EQ(s.textures.size(), 3u);
  EXPECT_EQ(s.texture_names, (std::map<std::uint32_t, std::string>{{0, "tiles"}, {1, "veins"}}));
  const Texture& tiles = s.textures[0];
  EXPECT_EQ(tiles.kind, TextureKind::checker);
  EXPECT_EQ(tiles.colors, (std::vector<Color>{{1, 0.5, 0}, {0.25, 0.25, 0.25}}));
  EXPECT_EQ(tiles.size, 2);
  EXPECT_EQ(tiles.mapping, TextureMapping::uv);
  EXPECT_EQ(tiles.transform, (Transform{{2, 0, 0}, {0, 2, 0}, {0, 0, 2}, {}}));
  EXPECT_EQ(s.textures[1].turbulence, 1) << "marble has veins where nothing is said";
  EXPECT_EQ(s.textures[2].kind, TextureKind::noise);
  const Material& floor = s.materials.at(0);
  EXPECT_EQ(floor.ambient, (Color{1, 1, 1})) << "a colour stays a colour";
  EXPECT_EQ(floor.textures, (std::vector<TextureUse>{{Coefficient::diffuse, 0},
                                                     {Coefficient::specular, 2},
                                                     {Coefficient::shininess, 0}}));
}

TEST(LanguageTextures, AreColoursOfTwoCoefficients) {
  const auto uses = [](const std::string& keys) {
    return scene_of("[texture.t]\nkind = \"wood\"\n[texture.u]\nkind = \"wood\"\n[material.a]\n" +
                    keys)
        .materials.at(0)
        .textures;
  };
  EXPECT_EQ(uses("color = \"t\"\n"),
            (std::vector<TextureUse>{{Coefficient::ambient, 0}, {Coefficient::diffuse, 0}}));
  EXPECT_EQ(uses("diffuse = 1\ncolor = \"t\"\n"),
            (std::vector<TextureUse>{{Coefficient::ambient, 0}}))
      << "what is said wins, wherever";
  EXPECT_EQ(uses("color = \"t\"\nambient = \"u\"\n"),
            (std::vector<TextureUse>{{Coefficient::ambient, 1}, {Coefficient::diffuse, 0}}));
}

TEST(LanguageTextures, BendNormals) {
  const Scene s = scene_of(
      "[texture.t]\nkind = \"noise\"\n[material.a]\nbump = {texture = \"t\", height = 0.5}\n"
      "[material.b]\nnormal_map = {texture = {kind = \"wood\"}}\n");
  EXPECT_EQ(s.materials[0].normals, (NormalUse{NormalUse::Kind::bump, 0, 0.5}));
  EXPECT_EQ(s.materials[1].normals.kind, NormalUse::Kind::normal_map);
  EXPECT_EQ(s.materials[1].normals.texture, 1u);
  EXPECT_EQ(first_answer("[material.a]\nbump = {texture = {kind = \"wood\"}}\n"
                         "normal_map = {texture = {kind = \"wood\"}}\n"),
            "s.toml:3:14: error: material a has bump and normal_map: expected one of them");
  EXPECT_EQ(first_answer("[material.a]\nbump = {height = 1}\n"),
            "s.toml:2:8: error: bump of material a has no texture: expected how high it is, as "
            "brightness, the name of a texture, in quotes, or a table of one: {kind = …}");
}

TEST(LanguageTextures, SayWhatIsWrong) {
  const std::string tiles = "[texture.tiles]\nkind = \"checker\"\n[material.a]\n";
  EXPECT_EQ(answer_to(tiles + "color = \"red\"\n"),
            "s.toml:4:9: error: unknown texture 'red' for color of material a\n"
            "  color = \"red\"\n          ^\n"
            "  red is \"#ff0000\"; textures: tiles\n");
  EXPECT_EQ(answer_to(tiles + "diffuse = \"tile\"\n"),
            "s.toml:4:11: error: unknown texture 'tile' for diffuse of material a\n"
            "  diffuse = \"tile\"\n            ^\n"
            "  did you mean 'tiles'?\n");
  EXPECT_EQ(answer_to("[material.a]\nspecular = \"bright\"\n"),
            "s.toml:2:12: error: unknown texture 'bright' for specular of material a\n"
            "  specular = \"bright\"\n             ^\n"
            "  colours are [r, g, b] or \"#rrggbb\"; there are no textures\n");
  EXPECT_EQ(answer_to(tiles + "shininess = \"high\"\n"),
            "s.toml:4:13: error: unknown texture 'high' for shininess of material a\n"
            "  shininess = \"high\"\n              ^\n"
            "  textures: tiles\n");
  EXPECT_EQ(first_answer("[material.a]\ndiffuse = \"#12345\"\n"),
            "s.toml:2:11: error: diffuse of material a is \"#12345\": expected a colour: "
            "[r, g, b], each 0 or more, one number for grey, or \"#rrggbb\", or a texture");
  EXPECT_EQ(first_answer("[texture.t]\nkind = \"cheker\"\n"),
            "s.toml:2:8: error: unknown kind 'cheker' of texture");
  EXPECT_EQ(first_answer("[texture.t]\nkind = \"checker\"\ncolors = [1]\n"),
            "s.toml:3:10: error: colors of checker is [1]: expected 2 colours in brackets: "
            "[r, g, b], each 0 or more, one number for grey, or \"#rrggbb\"");
  EXPECT_EQ(first_answer("[material.a]\ndiffuse = {kind = \"checker\", size = 0}\n"),
            "s.toml:2:37: error: size of checker is 0: expected a number greater than 0");
  EXPECT_EQ(answer_to("[[light]]\nposition = [0, 0, 0]\ncolor = \"red\"\n"),
            "s.toml:3:9: error: color of point light is \"red\": expected a colour: [r, g, b], "
            "each 0 or more, one number for grey, or \"#rrggbb\"\n"
            "  color = \"red\"\n          ^\n"
            "  red is \"#ff0000\"\n");
}

TEST(LanguageTextures, AreWrittenSoThatTheyReadAsTheEqualScene) {
  expect_rewritten(
      "[texture.\"a b\"]\nkind = \"noise\"\ncolors = [1, \"#123456\", 0]\n"
      "[texture.texture_5]\nkind = \"stripes\"\ndirection = [1, 2, 3]\nsize = 0.1\n"
      "[texture.c]\nkind = \"gradient\"\nwrap = \"mirror\"\nmapping = \"uv\"\n"
      "[texture.d]\nkind = \"rings\"\nturbulence = 0.5\noctaves = 7\nseed = 4294967295\n"
      "[material.a]\ncolor = \"a b\"\nreflection = {kind = \"marble\", turbulence = 0}\n"
      "bump = {texture = \"c\"}\nspecular = {kind = \"wood\"}\n"
      "[material.b]\nnormal_map = {texture = {kind = \"noise\", transform = [{scale = 3}, "
      "{rotate = [0, 1, 0], by_deg = 10}]}}\nrefraction = \"d\"\n");
}

class LanguageFiles : public testing::Test {
 protected:
  LanguageFiles() {
    fs::remove_all(folder_);
    fs::create_directories(folder_ / "scene/sub");
    for (const char* name : {"outside.ppm", "scene/a.ppm", "scene/sub/b.ppm"})
      std::ofstream(folder_ / name) << "P3 2 1 255 255 255 255 51 0 0\n";
    fs::create_symlink("../outside.ppm", folder_ / "scene/link.ppm");
    fs::create_symlink("a.ppm", folder_ / "scene/inside.ppm");
  }
  ~LanguageFiles() override { fs::remove_all(folder_); }

  ReadOptions options(bool allow_outside = false) const {
    return {(folder_ / "scene").string(), allow_outside};
  }
  static std::string image(const std::string& file) {
    return "[texture.t]\nkind = \"image\"\nfile = \"" + file + "\"\n";
  }
  std::string first(const std::string& file, bool allow_outside = false) const {
    return first_answer(image(file), options(allow_outside));
  }

  fs::path folder_ = fs::path(testing::TempDir()) /
                     fmt::format("zraka_language_files_{}",
                                 testing::UnitTest::GetInstance()->current_test_info()->name());
};

TEST_F(LanguageFiles, AreReadFromTheScenesFolder) {
  const Scene s = scene_of(image("a.ppm"), options());
  ASSERT_NE(s.textures.at(0).image, nullptr);
  EXPECT_EQ(s.textures[0].image->width, 2u);
  EXPECT_EQ(s.textures[0].file, "a.ppm");
  EXPECT_EQ(s.textures[0].mapping, TextureMapping::uv);
  for (const char* file : {"sub/b.ppm", "sub/../a.ppm", "./a.ppm", "inside.ppm"})
    EXPECT_EQ(first(file), "") << file;
  expect_rewritten(image("sub/b.ppm") + "wrap = \"clamp\"\nfilter = \"nearest\"\n", options());
}

TEST_F(LanguageFiles, AreReadOnceEach) {
  const Scene s =
      scene_of(image("a.ppm") + "[texture.u]\nkind = \"image\"\nfile = \"a.ppm\"\n", options());
  EXPECT_EQ(s.textures[0].image, s.textures[1].image);
}

TEST_F(LanguageFiles, HoldNormalsAsTheyAreAndColoursByTheSrgbCurve) {
  const float half = 51.0f / 255;
  const auto red = [](const Texture& texture) { return texture.image->pixels[3]; };
  const Scene map =
      scene_of(image("a.ppm") + "[material.a]\nnormal_map = {texture = \"t\"}\n", options());
  EXPECT_EQ(red(map.textures.at(0)), half);
  EXPECT_EQ(map.textures[0].transfer, Transfer::linear);
  const Scene both = scene_of(image("a.ppm") +
                                  "[material.a]\nnormal_map = {texture = \"t\"}\n"
                                  "[material.b]\ndiffuse = \"t\"\n"
                                  "normal_map = {texture = \"t\"}\n",
                              options());
  ASSERT_EQ(both.textures.size(), 2u);
  EXPECT_LT(red(both.textures[0]), half / 2);
  EXPECT_EQ(red(both.textures[1]), half);
  EXPECT_EQ(both.materials[0].normals.texture, 1u);
  EXPECT_EQ(both.materials[1].normals.texture, 1u);
  const Scene said = scene_of(image("a.ppm") +
                                  "transfer = \"srgb\"\n[material.a]\n"
                                  "normal_map = {texture = \"t\"}\n",
                              options());
  EXPECT_LT(red(said.textures.at(0)), half / 2) << "what is said wins";
  expect_rewritten(image("a.ppm") +
                       "[material.a]\nnormal_map = {texture = \"t\"}\n"
                       "diffuse = \"t\"\n",
                   options());
}

TEST_F(LanguageFiles, DoNotLeaveTheFolderUnlessThatIsAllowed) {
  for (const std::string& file :
       {std::string("../outside.ppm"), std::string("link.ppm"),
        std::string("sub/../../outside.ppm"), (folder_ / "outside.ppm").string()}) {
    EXPECT_TRUE(first(file).ends_with("lies outside of the scene's folder")) << first(file);
    EXPECT_EQ(first(file, true), "");
  }
  EXPECT_EQ(answer_to(image("../outside.ppm"), options()),
            "s.toml:3:8: error: file of image texture: '../outside.ppm' lies outside of the "
            "scene's folder\n"
            "  file = \"../outside.ppm\"\n         ^\n"
            "  put it beside the scene, or allow it with --allow-outside\n");
}

TEST_F(LanguageFiles, SayWhatIsWrongAtTheirPlace) {
  EXPECT_EQ(answer_to(image("none.png"), options()),
            "s.toml:3:8: error: file of image texture: none.png: cannot be read: No such file or "
            "directory\n"
            "  file = \"none.png\"\n         ^\n"
            "  is the name right, and the folder?\n");
  EXPECT_EQ(first(""), "s.toml:3:8: error: file of image texture: '' is no name of a file");
  std::ofstream(folder_ / "scene/huge.ppm") << "P6 65536 32768 255\n";
  EXPECT_TRUE(first("huge.ppm").starts_with("s.toml:3:8: error: file of image texture: huge.ppm: "))
      << first("huge.ppm");
  EXPECT_NE(first("sub"), "");
  EXPECT_EQ(first_answer(image("a.ppm")),
            "s.toml:3:8: error: file of image texture: this scene comes from no file, and reads "
            "none");
}

TEST(LanguageHints, KnowWhatIsMeantAtTheTopOfAFile) {
  const auto hint = [](const std::string& text) {
    const std::string all = answer_to(text);
    const std::size_t line = all.rfind("\n  ", all.size() - 2);
    return all.substr(line + 3, all.size() - line - 4);
  };
  EXPECT_EQ(answer_to("[[sphere]]\ncenter = [0, 0, 0]\nradius = 1\n"),
            "s.toml:1:3: error: unknown section 'sphere'\n  [[sphere]]\n    ^\n"
            "  write [[shape]] with kind = \"sphere\"\n");
  EXPECT_EQ(hint("[spheer]\n"), "write [[shape]] with kind = \"sphere\"");
  EXPECT_EQ(hint("[checker]\n"), "write [texture.NAME] with kind = \"checker\"");
  EXPECT_EQ(hint("[[point]]\n"), "write [[light]] with kind = \"point\"");
  EXPECT_EQ(hint("fov = 40\n"), "write fov_deg = … below [camera]");
  EXPECT_EQ(hint("depth = 5\n"), "write max_depth = … below [render]");
  EXPECT_EQ(hint("width = 5\n"), "write width = … below [image]");
  EXPECT_EQ(hint("[lights]\n"), "did you mean 'light'?");
  EXPECT_EQ(hint("[bogus]\n"),
            "sections: image, camera, render, texture, scene, cut, light, material, group, shape");
  EXPECT_EQ(hint("[camera]\nfov = 40\n"), "did you mean 'fov_deg'?");
  EXPECT_EQ(hint("[render]\ndepth = 4\n"), "did you mean 'max_depth'?");
}

}  // namespace
}  // namespace zraka
