// SPDX-License-Identifier: Apache-2.0
// What is said of bodies, CSG, instances and textures, to the letter: text, sentence, JSON, page.
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "explain/json.hpp"
#include "explain/page.hpp"
#include "explain/sentence.hpp"
#include "explain/text.hpp"
#include "language.hpp"
#include "shape_scenes.hpp"

namespace zraka {
namespace {

using nlohmann::json;

RenderOptions physical() {
  return {.profile = profile_of(ProfileName::physical)};
}

/// What a text says of the hit of the ray from the eye, before its light.
std::string said_of_surface(const Scene& scene, std::uint32_t x, std::uint32_t y,
                            Language language) {
  const std::string text =
      to_text(explain(scene, physical(), x, y).value(), {.language = language});
  const std::size_t begin = text.find("\n│ ", text.find("\n│ ") + 1) + 1;
  return text.substr(begin, text.find(language == Language::english ? "│ ambient component"
                                                                    : "│ ambijentna komponenta") -
                                begin);
}

TEST(ExplainShapesText, AreSaidInBothLanguages) {
  const Scene nested = nested_scene(), chairs = chairs_scene(), textured = textured_scene();
  EXPECT_EQ(
      said_of_surface(nested, 70, 60, Language::english),
      R"(│ hits compound solid 1 'drilled' in instance 1 'whole' at t = 2.052, in the point (0.41, -0.21, 0)
│   way: instance 1 'whole' (group 2) → instance 1 (group 'part') → compound solid 1 'drilled'
│   on the surface of member 1.1 (intersection): box 'block'
│     t = 1.762: into member 1.2 (sphere 'ball'), then outside the solid
│     t = 2.052: into member 1.1 (box 'block'), then inside the solid
│   transform to the world: x → (0, 0, -2), y → (0, 2, 0), z → (2, 0, 0), origin → (0.25, 0, -1)
│   in its own space (-0.5, -0.105, 0.08)
│ normal N = (0, 0, 1)
)");
  EXPECT_EQ(
      said_of_surface(nested, 70, 60, Language::croatian),
      R"(│ pogađa složeno tijelo 1 'drilled' u primjerku 1 'whole' za t = 2,052, u točki (0,41; -0,21; 0)
│   put: primjerak 1 'whole' (skupina 2) → primjerak 1 (skupina 'part') → složeno tijelo 1 'drilled'
│   na plohi operanda 1.1 (presjek): kvadar 'block'
│     t = 1,762: ulazi u operand 1.2 (kugla 'ball'), zatim je izvan tijela
│     t = 2,052: ulazi u operand 1.1 (kvadar 'block'), zatim je unutar tijela
│   transformacija u koordinate svijeta: x → (0; 0; -2), y → (0; 2; 0), z → (2; 0; 0), ishodište → (0,25; 0; -1)
│   u vlastitim koordinatama (-0,5; -0,105; 0,08)
│ normala N = (0; 0; 1)
)");
  EXPECT_EQ(
      said_of_surface(chairs, 70, 58, Language::english),
      R"(│ hits ellipsoid 1 'shank' in instance 2 at t = 3.134, in the point (0.6272, -0.2601, -1.06)
│   way: instance 2 (group 'chair') → instance 2 'right leg' (group 'leg') → ellipsoid 1 'shank'
│   transform to the world: x → (0.9563, 0, 0.08367), y → (0, 0.96, 0), z → (-0.08367, 0, 0.9563), origin → (0.7043, 0, -1.116)
│   in its own space (-0.07482, -0.2709, 0.06564)
│ normal N = (-0.8059, 0.03246, 0.5911)
)");
  EXPECT_EQ(
      said_of_surface(chairs, 70, 58, Language::croatian),
      R"(│ pogađa elipsoid 1 'shank' u primjerku 2 za t = 3,134, u točki (0,6272; -0,2601; -1,06)
│   put: primjerak 2 (skupina 'chair') → primjerak 2 'right leg' (skupina 'leg') → elipsoid 1 'shank'
│   transformacija u koordinate svijeta: x → (0,9563; 0; 0,08367), y → (0; 0,96; 0), z → (-0,08367; 0; 0,9563), ishodište → (0,7043; 0; -1,116)
│   u vlastitim koordinatama (-0,07482; -0,2709; 0,06564)
│ normala N = (-0,8059; 0,03246; 0,5911)
)");
  EXPECT_EQ(said_of_surface(textured, 50, 80, Language::english),
            R"(│ hits plane 1 at t = 2.742, in the point (0.01311, -0.8, -0.623)
│   in its own space (0.01311, -0.8, -0.623), u = 0.01311, v = 0.623, footprint of the pixel 0.02565
│ normal N = (0, 1, 0)
│ texture 'tiles' (checker): ka = kd = (0.9, 0.8, 0.7)
)");
  EXPECT_EQ(said_of_surface(textured, 50, 80, Language::croatian),
            R"(│ pogađa ravninu 1 za t = 2,742, u točki (0,01311; -0,8; -0,623)
│   u vlastitim koordinatama (0,01311; -0,8; -0,623); u = 0,01311; v = 0,623; otisak piksela 0,02565
│ normala N = (0; 1; 0)
│ tekstura 'tiles' (šahovnica): ka = kd = (0,9; 0,8; 0,7)
)");
  EXPECT_EQ(said_of_surface(textured, 70, 60, Language::english),
            R"(│ hits sphere 1 at t = 2.781, in the point (0.5556, -0.2846, -0.7104)
│   in its own space (0.5556, -0.2846, -0.7104), u = 0.518, v = 0.4459, footprint of the pixel 0.02676
│ normal N = (0.1351, -0.04603, 0.9898)
│   bent by the slope of texture 3 (noise); on the smooth surface N = (0.1112, -0.1692, 0.9793)
)");
  EXPECT_EQ(said_of_surface(textured, 70, 60, Language::croatian),
            R"(│ pogađa kuglu 1 za t = 2,781, u točki (0,5556; -0,2846; -0,7104)
│   u vlastitim koordinatama (0,5556; -0,2846; -0,7104); u = 0,518; v = 0,4459; otisak piksela 0,02676
│ normala N = (0,1351; -0,04603; 0,9898)
│   zakrenuta nagibom teksture 3 (šum); na glatkoj je plohi N = (0,1112; -0,1692; 0,9793)
)");
  EXPECT_EQ(said_of_surface(textured, 30, 52, Language::english),
            R"(│ hits ellipsoid 1 at t = 2.702, in the point (-0.5169, -0.06627, -0.6508)
│   transform to the world: x → (0.6894, 0, -0.5785), y → (0, 0.9, 0), z → (0.5785, 0, 0.6894), origin → (-0.5, 0.1, -1)
│   in its own space (-0.2638, -0.1847, 0.2852), u = 0.3986, v = 0.3472, footprint of the pixel 0.02626
│ normal N = (0.1423, -0.4869, 0.8618)
│ texture 'wrapped' (checker): kd = (0.9, 0.8, 0.7)
│ texture 'wrapped' (checker): k1 = 0.8
)");
  EXPECT_EQ(said_of_surface(textured, 30, 52, Language::croatian),
            R"(│ pogađa elipsoid 1 za t = 2,702, u točki (-0,5169; -0,06627; -0,6508)
│   transformacija u koordinate svijeta: x → (0,6894; 0; -0,5785), y → (0; 0,9; 0), z → (0,5785; 0; 0,6894), ishodište → (-0,5; 0,1; -1)
│   u vlastitim koordinatama (-0,2638; -0,1847; 0,2852); u = 0,3986; v = 0,3472; otisak piksela 0,02626
│ normala N = (0,1423; -0,4869; 0,8618)
│ tekstura 'wrapped' (šahovnica): kd = (0,9; 0,8; 0,7)
│ tekstura 'wrapped' (šahovnica): k1 = 0,8
)");
}

TEST(ExplainShapesText, AreInTheSentence) {
  const auto sentence = [](const Scene& scene, std::uint32_t x, std::uint32_t y,
                           Language language) {
    return in_words(language, explain(scene, physical(), x, y).value());
  };
  EXPECT_EQ(sentence(chairs_scene(), 38, 50, Language::english),
            "90 % of the colour is the diffuse component of light 1 on box 1 'seat' in instance 1 "
            "'left'.");
  EXPECT_EQ(sentence(chairs_scene(), 38, 50, Language::croatian),
            "90 % boje je difuzna komponenta svjetla 1 na kvadru 1 'seat' u primjerku 1 'left'.");
  EXPECT_EQ(sentence(chairs_scene(), 70, 58, Language::english),
            "39 % of the colour is the background, by the refracted ray of ellipsoid 1 'shank' in "
            "instance 2, then the refracted ray of ellipsoid 1 'shank' in instance 2.");
  EXPECT_EQ(sentence(chairs_scene(), 70, 58, Language::croatian),
            "39 % boje dolazi od pozadine, preko refraktirane zrake elipsoida 1 'shank' u "
            "primjerku 2, zatim refraktirane zrake elipsoida 1 'shank' u primjerku 2.");
}

TEST(ExplainShapesText, HaveMembersInJsonWhereTheyHaveMore) {
  using nlohmann::literals::operator""_json;
  const auto hit = [](const Scene& scene, std::uint32_t x, std::uint32_t y) {
    return json::parse(
        to_json(explain(scene, physical(), x, y).value(), "", "", ""))["tree"]["hit"];
  };
  const json nested = hit(nested_scene(), 62, 52);
  EXPECT_EQ(nested["shape"], R"("instance 1")"_json);
  EXPECT_EQ(nested["instances"], R"([
 {
  "shape": "instance 1",
  "name": "whole",
  "group": 2,
  "transform": {
   "x": [
    1.0,
    0.0,
    0.0
   ],
   "y": [
    0.0,
    1.0,
    0.0
   ],
   "z": [
    0.0,
    0.0,
    1.0
   ],
   "origin": [
    0.25,
    0.0,
    -1.0
   ]
  }
 },
 {
  "shape": "instance 1",
  "group": 1,
  "group_name": "part",
  "transform": {
   "x": [
    0.0,
    0.0,
    -2.0
   ],
   "y": [
    0.0,
    2.0,
    0.0
   ],
   "z": [
    2.0,
    0.0,
    0.0
   ],
   "origin": [
    0.0,
    0.0,
    0.0
   ]
  }
 }
])"_json);
  EXPECT_EQ(nested["inner"], R"({
 "shape": "csg 1",
 "name": "drilled"
})"_json);
  EXPECT_EQ(nested["csg"], R"({
 "member": "1.1",
 "shape": "box",
 "name": "block",
 "operation": "intersection",
 "operands": 2,
 "starts_inside": false,
 "crossings": [
  {
   "distance": 1.7149995741548585,
   "member": "1.2",
   "enters": true,
   "inside": false
  },
  {
   "distance": 2.0161845487527743,
   "member": "1.1",
   "enters": true,
   "inside": true
  }
 ]
})"_json);
  EXPECT_EQ(nested["transform"], R"({
 "x": [
  0.0,
  0.0,
  -2.0
 ],
 "y": [
  0.0,
  2.0,
  0.0
 ],
 "z": [
  2.0,
  0.0,
  0.0
 ],
 "origin": [
  0.25,
  0.0,
  -1.0
 ]
})"_json);
  EXPECT_EQ(nested["own"], R"({
 "point": [
  -0.5,
  -0.025,
  0.0
 ]
})"_json);
  EXPECT_FALSE(nested.contains("textures"));
  EXPECT_FALSE(nested.contains("bent"));
  const json floor = hit(textured_scene(), 50, 80);
  EXPECT_EQ(floor["own"], R"({
 "point": [
  0.0131147,
  -0.8,
  -0.6229512
 ],
 "u": 0.013114744424819968,
 "v": 0.6229512393474579,
 "footprint": 0.025652531720992133
})"_json);
  EXPECT_EQ(floor["textures"], R"([
 {
  "texture": 1,
  "name": "tiles",
  "kind": "checker",
  "coefficient": "ka",
  "value": [
   0.9,
   0.8,
   0.7
  ]
 },
 {
  "texture": 1,
  "name": "tiles",
  "kind": "checker",
  "coefficient": "kd",
  "value": [
   0.9,
   0.8,
   0.7
  ]
 }
])"_json);
  EXPECT_FALSE(floor.contains("transform"));
  EXPECT_EQ(hit(textured_scene(), 70, 60)["bent"], R"({
 "texture": 3,
 "kind": "noise",
 "by": "bump",
 "smooth": [
  0.11124597,
  -0.16917455,
  0.97928774
 ]
})"_json);
}

TEST(ExplainShapesText, TellsOfRaysThatBeginWithin) {
  const std::string text = to_text(explain(csg_scene(), physical(), 80, 45).value(), {});
  EXPECT_NE(text.find(R"(
│  │   on the surface of member 2 of 2 (difference): ellipsoid 'bore'
│  │     the ray begins inside the solid
│  │     t = 0.3948: into member 2 (ellipsoid 'bore'), then outside the solid
)"),
            std::string::npos)
      << text;
}

TEST(ExplainShapesText, StandsOnThePage) {
  for (const NamedScene& named : shape_scenes(50)) {
    Scene scene = named.scene;
    Explainer explainer = Explainer::create(named.scene, physical()).value();
    for (const auto& [x, y] : {std::pair{25u, 30u}, {15u, 25u}, {35u, 25u}}) {
      const Explanation e = explainer.pixel(x, y).value();
      const std::string page =
          to_page(scene, e,
                  {picture_for_page(scene, physical()).value(), explainer.around(x, y, 15)}, {})
              .value();
      for (const ExplainedRay& ray : e.trees[0].rays) {
        if (!ray.hit) continue;
        const auto has = [&](const std::string& text) {
          EXPECT_NE(page.find(text), std::string::npos) << named.name << ": " << text;
        };
        if (ray.hit->path.inner) has("<p class=\"place\">way: instance ");
        if (ray.hit->path.member) has("<p class=\"place\">on the surface of member ");
        if (ray.hit->transform) has("<p class=\"place\">transform to the world: x → (");
        if (ray.hit->own) has("<p class=\"place\">in its own space (");
        if (!ray.hit->textures.empty()) has("<div class=\"what\">texture ");
      }
      if (!named.scene.planes.empty()) {
        EXPECT_NE(page.find(R"("normal":[0.0,1.0,0.0])"), std::string::npos);
      }
    }
  }
}

TEST(ExplainShapesText, HaveNoEnglishWordInCroatian) {
  for (NamedScene& named : shape_scenes(60)) {
    named.scene.names.clear();
    named.scene.texture_names.clear();
    for (Group& group : named.scene.groups) group.names.clear(), group.name.clear();
    for (auto& object : named.scene.csgs) {
      if (object.shape.operation != CsgOperation::subtract) continue;
      object.shape.of[1].name.clear();
      for (CsgMember& member : std::get<Csg>(object.shape.of[0].body).of) member.name.clear();
    }
    for (Group& group : named.scene.groups) group.csgs.clear();
    Explainer explainer = Explainer::create(named.scene, physical()).value();
    for (std::uint32_t i = 0; i < 60 * 60; i += 13)
      ASSERT_EQ(english_words_in(to_text(explainer.pixel(i % 60, i / 60).value(),
                                         {.language = Language::croatian, .scene = "x.txt"})),
                "")
          << named.name;
  }
}

}  // namespace
}  // namespace zraka
