// SPDX-License-Identifier: Apache-2.0
// What the scene language says of materials beyond Phong's coefficients.
#include <gtest/gtest.h>

#include "language_helpers.hpp"
#include "materials/dispersion.hpp"
#include "materials/glasses.hpp"

namespace zraka {
namespace {

/// A material that has these keys.
Material material_of(const std::string& keys) {
  const Scene scene = scene_of("[material.a]\n" + keys);
  return scene.materials.empty() ? Material{} : scene.materials[0];
}
std::string first(const std::string& keys) {
  return first_answer("[material.a]\n" + keys);
}

TEST(LanguageOptics, HasSharesPerChannel) {
  const Material m = material_of("reflection = [1, 0.5, 0]\nrefraction = \"#ffffff\"\n");
  EXPECT_EQ(m.reflection, Share(Color{1, 0.5, 0}));
  EXPECT_EQ(m.refraction, Share(1));
  EXPECT_EQ(material_of("reflection = 0.25\n").reflection, Share(0.25));
  const std::string written =
      write_toml(scene_of("[material.a]\nreflection = [0.5, 0.5, 0.5]\nrefraction = [0, 1, 0]\n"))
          .value();
  EXPECT_NE(written.find("reflection = 0.5\nrefraction = [0, 1, 0]\n"), std::string::npos)
      << written;
  EXPECT_EQ(first("reflection = [1, -1, 0]\n"),
            "s.toml:2:14: error: reflection of material a is [1, -1, 0]: expected a colour: [r, g, "
            "b], each 0 or more, one number for grey, or \"#rrggbb\", or a texture");
}

TEST(LanguageOptics, HasHighlightsFresnelAbsorptionAndPriority) {
  const Material m = material_of(
      "highlight = \"blinn\"\nfresnel = \"schlick\"\nabsorption = [0, 0.5, 3]\npriority = -2\n");
  EXPECT_EQ(m.highlight, Highlight::blinn);
  EXPECT_EQ(m.fresnel, Fresnel::schlick);
  EXPECT_EQ(m.absorption, (Color{0, 0.5, 3}));
  EXPECT_EQ(m.priority, -2);
  EXPECT_EQ(material_of("fresnel = \"exact\"\n").fresnel, Fresnel::exact);
  EXPECT_EQ(answer_to("[material.a]\nhighlight = \"bling\"\n"),
            "s.toml:2:13: error: highlight of material a is \"bling\": expected \"phong\" or "
            "\"blinn\"\n"
            "  highlight = \"bling\"\n              ^\n"
            "  did you mean 'blinn'?\n");
  EXPECT_EQ(first("fresnel = true\n"),
            "s.toml:2:11: error: fresnel of material a is true: expected \"off\", \"exact\" or "
            "\"schlick\"");
  EXPECT_EQ(first("absorption = -1\n"),
            "s.toml:2:14: error: absorption of material a is -1: expected a colour: [r, g, b], "
            "each 0 or more, one number for grey, or \"#rrggbb\"");
  EXPECT_EQ(first("priority = 1.5\n"),
            "s.toml:2:12: error: priority of material a is 1.5: expected a whole number from "
            "-2147483648 to 2147483647");
}

TEST(LanguageOptics, HasDispersionByThreeFormulas) {
  using Kind = Dispersion::Kind;
  const Material abbe = material_of("ior = 1.5\ndispersion = {abbe = 64.2}\n");
  EXPECT_EQ(abbe.dispersion, (Dispersion{Kind::abbe, {64.2}}));
  EXPECT_EQ(abbe.ior, 1.5);
  const Material cauchy = material_of("dispersion = {cauchy = [1.5, 0.004, 0]}\n");
  EXPECT_EQ(cauchy.dispersion, (Dispersion{Kind::cauchy, {1.5, 0.004, 0}}));
  EXPECT_EQ(cauchy.ior, refractive_index(cauchy.dispersion, 1, kLineD)) << "where nothing is said";
  const Material sellmeier =
      material_of("ior = 1.25\ndispersion = {sellmeier = [1, 0.2, 1, 0.006, 0.02, 100]}\n");
  EXPECT_EQ(sellmeier.dispersion, (Dispersion{Kind::sellmeier, {1, 0.2, 1, 0.006, 0.02, 100}}));
  EXPECT_EQ(sellmeier.ior, 1.25) << "what is said holds";
}

TEST(LanguageOptics, SaysWhatIsWrongWithDispersion) {
  const std::string expected = ": expected a table {abbe = …}, {cauchy = …} or {sellmeier = …}";
  EXPECT_EQ(first("dispersion = 60\n"),
            "s.toml:2:14: error: dispersion of material a is 60" + expected);
  EXPECT_EQ(first("dispersion = {}\n"),
            "s.toml:2:14: error: dispersion of material a is {}" + expected);
  EXPECT_EQ(
      first("dispersion = {abbe = 60, cauchy = [1, 0, 0]}\n"),
      "s.toml:2:14: error: dispersion of material a is {abbe = 60, cauchy = [1, 0, 0]}" + expected);
  EXPECT_EQ(answer_to("[material.a]\ndispersion = {abe = 60}\n"),
            "s.toml:2:15: error: unknown field 'abe' for dispersion of material a\n"
            "  dispersion = {abe = 60}\n                ^\n"
            "  did you mean 'abbe'?\n");
  EXPECT_EQ(first("dispersion = {abbe = 0}\n"),
            "s.toml:2:22: error: abbe of dispersion of material a is 0: expected a number greater "
            "than 0");
  EXPECT_EQ(first("dispersion = {cauchy = [1, 2]}\n"),
            "s.toml:2:24: error: cauchy of dispersion of material a is [1, 2]: expected 3 finite "
            "numbers in brackets");
  EXPECT_EQ(first("dispersion = {sellmeier = [1, 2, 3, 4, 5]}\n"),
            "s.toml:2:27: error: sellmeier of dispersion of material a is [1, 2, 3, 4, 5]: "
            "expected 6 finite numbers in brackets");
  EXPECT_EQ(first("dispersion = {sellmeier = [1, 0, 0, 0.36, 0, 0]}\n"),
            "s.toml:2:14: error: dispersion of material a has no index above 0 for some of the "
            "light that is seen, from 0.36 to 0.83 µm");
}

TEST(LanguageOptics, KnowsGlassesByName) {
  const Material m = material_of("glass = \"sf11\"\n");
  EXPECT_EQ(m.dispersion, glass_named("SF11")->dispersion);
  EXPECT_NEAR(m.ior, 1.78472, 6e-6);
  const std::string text = write_toml(scene_of("[material.a]\nglass = \"water\"\n")).value();
  EXPECT_EQ(text.find("ior"), std::string::npos) << "that of the formula\n" << text;
  for (const Glass& glass : glasses())
    expect_rewritten("[material.a]\nglass = \"" + std::string(glass.name) + "\"\n");
}

TEST(LanguageOptics, SaysWhatIsWrongWithGlasses) {
  EXPECT_EQ(answer_to("[material.a]\nglass = \"BK77\"\n"),
            "s.toml:2:9: error: unknown glass 'BK77' for material a\n"
            "  glass = \"BK77\"\n          ^\n"
            "  did you mean 'BK7'?\n");
  EXPECT_EQ(answer_to("[material.a]\nglass = \"BK7\"\nior = 1.5\n"),
            "s.toml:3:1: error: material a has glass and ior: expected one of them\n"
            "  ior = 1.5\n  ^\n");
  EXPECT_EQ(answer_to("[material.a]\nglass = \"BK7\"\ndispersion = {abbe = 60}\n"),
            "s.toml:3:1: error: material a has glass and dispersion: expected one of them\n"
            "  dispersion = {abbe = 60}\n  ^\n");
  EXPECT_EQ(first("glass = 1\n"),
            "s.toml:2:9: error: glass of material a is 1: expected the name of a glass or of "
            "another clear material, in quotes");
}

TEST(LanguageOptics, AreWrittenAsTheyWereRead) {
  for (const char* keys :
       {"reflection = [0.1, 0.2, 0.3]\nrefraction = [0.9, 0.8, 0.7]\n",
        "highlight = \"blinn\"\nfresnel = \"exact\"\nabsorption = 0.1\npriority = 7\n",
        "dispersion = {abbe = 60}\nior = 1.5\n", "dispersion = {abbe = 60}\n",
        "dispersion = {cauchy = [1.5, 0.004, -0.0]}\n",
        "dispersion = {cauchy = [1.5, 0.004, 0]}\nior = 1\n",
        "dispersion = {sellmeier = [1, 0.2, 1, 0.006, 0.02, 100]}\nior = 2\n"})
    expect_rewritten("[material.a]\n" + std::string(keys));
  const std::string cuts =
      "[material.a]\ncut_group = 3\n\n[[cut]]\npoint = [1, 2, 3]\nnormal = [0, 1, 1]\n"
      "caps = false\neye_only = true\ngroup = 3\n\n[[cut]]\npoint = [0, 0, 0]\n";
  expect_rewritten(cuts);
  const Scene scene = scene_of(cuts);
  ASSERT_EQ(scene.cuts.size(), 2u);
  EXPECT_EQ(scene.cuts[0], (Cut{{1, 2, 3}, {0, 1, 1}, false, true, 3}));
  EXPECT_EQ(scene.cuts[1], Cut{});
  EXPECT_EQ(scene.materials.at(0).cut_group, 3u);
}

}  // namespace
}  // namespace zraka
