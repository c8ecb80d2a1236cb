// SPDX-License-Identifier: Apache-2.0
// Scenes of the Ray Tracer Challenge and of CSE 167: what they say, and pictures that follow from
// it.
#include <gtest/gtest.h>

#include <cmath>
#include <zraka/zraka.hpp>

#include "formats/yaml.hpp"

namespace zraka {
namespace {

ReadScene read(const std::string& text, const char* name = "scene") {
  Result<ReadScene> scene = parse_scene(text, name);
  if (!scene) ADD_FAILURE() << to_string(scene.error().front());
  return scene ? std::move(*scene) : ReadScene{};
}

std::string answer(const std::string& text) {
  const Result<ReadScene> scene = parse_scene(text, "scene");
  return scene ? "it is read" : to_string(scene.error().front());
}

constexpr const char* kCamera =
    "- add: camera\n  width: 9\n  height: 9\n  field-of-view: 1\n  from: [0, 0, -5]\n  to: [0, 0, "
    "0]\n"
    "  up: [0, 1, 0]\n";

TEST(Yaml, ReadsListsMapsAndBrackets) {
  const Result<yaml::Node> read = yaml::parse(
      "# a comment\n---\n- a: 1\n  b:\n    - x\n    - [1, 2,\n       3]   # and one\n  c: {d: 'e # "
      "f', g: [h]}\n"
      "-\n  - 5\n- last\n",
      "f");
  ASSERT_TRUE(read) << to_string(read.error()[0]);
  ASSERT_EQ(read->items.size(), 3u);
  const yaml::Node& first = read->items[0];
  EXPECT_EQ(first.find("a")->number(), 1);
  ASSERT_EQ(first.find("b")->items.size(), 2u);
  EXPECT_EQ(first.find("b")->items[1].items[2].text, "3");
  EXPECT_EQ(first.find("c")->find("d")->text, "e # f");
  EXPECT_EQ(first.find("c")->find("g")->items[0].text, "h");
  EXPECT_EQ(read->items[1].items[0].text, "5");
  EXPECT_EQ(read->items[2].text, "last");
  EXPECT_EQ(read->items[2].line, 11u);
}

TEST(Yaml, ReadsListsThatAreNotIndentedAndLoneReturns) {
  const Result<yaml::Node> read = yaml::parse("a:\r- 1\r- 2\rb: 3\r", "f");
  ASSERT_TRUE(read);
  EXPECT_EQ(read->find("a")->items.size(), 2u);
  EXPECT_EQ(read->find("b")->line, 4u);
}

TEST(Yaml, SaysWhereItIsNone) {
  const auto problem = [](const std::string& text) {
    const Result<yaml::Node> read = yaml::parse(text, "f");
    return read ? "it is read" : to_string(read.error()[0]);
  };
  EXPECT_EQ(problem("a: 1\nb\n"), "f:2: error: 'b' has no colon: expected key: value\n");
  EXPECT_EQ(problem("a: [1, 2\n"), "f:1: error: a bracket is not closed by ]\n");
  EXPECT_EQ(problem("a: 'b\n"), "f:1: error: a quote is not closed\n");
  EXPECT_EQ(problem("a: [1] 2\n"), "f:1: error: '2' stands behind the value's end\n");
  EXPECT_EQ(problem("  a: 1\nb: 2\n"),
            "f:2: error: this line does not belong to what stands above it\n");
  EXPECT_EQ(problem(std::string(200, '[')),
            "f:1: error: values are more than 64 deep in each other\n");
  std::string dashes;
  for (int i = 0; i < 200; ++i) dashes += "- ";
  EXPECT_EQ(problem(dashes + "1\n"), "f:1: error: values are more than 64 deep in each other\n");
}

TEST(Challenge, DrawsThePictureOfTheBook) {
  // A sphere of the book's material before a light at its eye: ambient, diffuse and highlight.
  const Scene scene =
      read(std::string(kCamera) +
           "- add: light\n  at: [0, 0, -5]\n  intensity: [1, 1, 1]\n"
           "- add: sphere\n  material:\n    color: [0.5, 0.25, 0]\n    specular: 0.25\n")
          .scene;
  ASSERT_EQ(scene.spheres.size(), 1u);
  RenderOptions options;
  options.profile = profile_of(scene.defaults.profile);
  const Image image = render(scene, options).value().image;
  const float* const middle = image.row(4) + 3 * 4;
  EXPECT_NEAR(middle[0], 0.5 * (0.1 + 0.9) + 0.25, 1e-4);
  EXPECT_NEAR(middle[1], 0.25 * (0.1 + 0.9) + 0.25, 1e-4);
  EXPECT_EQ(options.profile.transfer, Transfer::linear);
}

TEST(Challenge, IsLeftHanded) {
  const Scene scene = read(std::string(kCamera) + "- add: sphere\n").scene;
  EXPECT_GT(scene.camera.window_right.x, 0) << "looking along z, x is right";
  EXPECT_GT(scene.camera.window_up.y, 0);
  EXPECT_NEAR(scene.camera.window_up.y, 2 * std::tan(0.5), 1e-12);
}

TEST(Challenge, ExtendsDefinitions) {
  const Scene scene = read(std::string(kCamera) + R"(
- define: red
  value:
    color: [1, 0, 0]
    diffuse: 0.5
- define: shiny-red
  extend: red
  value:
    reflective: 0.25
- define: moved
  value:
    - [ scale, 2, 2, 2 ]
    - [ translate, 1, 0, 0 ]
- define: ball
  value:
    add: sphere
    material: shiny-red
    transform:
      - moved
      - [ translate, 0, 1, 0 ]
- add: ball
- add: ball
  material: { color: [0, 1, 0] }
  transform: [ [ rotate-z, 1.5707963267948966 ], [ translate, 0, 0, 3 ] ]
  shadow: false
)")
                          .scene;
  ASSERT_EQ(scene.spheres.size(), 2u);
  EXPECT_EQ(scene.spheres[0].shape.center, (Vec3{1, 1, 0}));
  EXPECT_EQ(scene.spheres[0].shape.radius, 2);
  const Material& first = scene.materials.at(scene.spheres[0].material);
  EXPECT_EQ(first.diffuse, (Color{0.5, 0, 0}));
  EXPECT_EQ(first.reflection.r, 0.25);
  EXPECT_EQ(scene.spheres[1].shape.center, (Vec3{0, 0, 3}));
  const Material& second = scene.materials.at(scene.spheres[1].material);
  EXPECT_EQ(second.diffuse, (Color{0, 0.9, 0}));
  EXPECT_FALSE(second.casts_shadow);
}

TEST(Challenge, ReadsAllItsShapes) {
  const Scene scene = read(std::string(kCamera) + R"(
- add: plane
  material:
    pattern:
      type: checkers
      colors:
        - [ 1, 1, 1 ]
        - [ 0, 0, 0 ]
      transform: [ [ scale, 2, 2, 2 ] ]
- add: cube
- add: cylinder
  min: 0
  max: 1
  closed: true
- add: cone
  min: -1
  max: 2
  closed: true
- add: triangle
  p1: [0, 0, 0]
  p2: [1, 0, 0]
  p3: [0, 1, 0]
- add: sphere
  transform:
    - [ scale, 1, 2, 1 ]
- add: group
  transform: [ [ translate, 0, 5, 0 ] ]
  material: { color: [0, 0, 1] }
  children:
    - add: sphere
      transform: [ [ translate, 1, 0, 0 ] ]
    - add: sphere
      material: { color: [1, 0, 0] }
- add: csg
  operation: difference
  left: { type: cube }
  right:
    type: csg
    operation: union
    left: { type: sphere, transform: [[scale, 1.25, 1.25, 1.25]] }
    right: { type: cylinder, min: -1, max: 1, closed: true }
- add: area_light
  corner: [1, 2, 3]
  uvec: [1, 0, 0]
  vvec: [0, 1, 0]
  usteps: 4
  vsteps: 3
  intensity: [1, 1, 1]
)")
                          .scene;
  EXPECT_EQ(scene.planes.size(), 1u);
  EXPECT_EQ(scene.materials.at(scene.planes[0].material).textures.size(), 2u);
  EXPECT_EQ(scene.boxes.size(), 1u);
  EXPECT_EQ(scene.frustums.size(), 3u) << "a cylinder and both halves of a cone";
  EXPECT_EQ(scene.discs.size(), 2u);
  EXPECT_EQ(scene.triangles.size(), 1u);
  EXPECT_EQ(scene.ellipsoids.size(), 1u);
  ASSERT_EQ(scene.spheres.size(), 2u);
  EXPECT_EQ(scene.spheres[0].shape.center, (Vec3{1, 5, 0}));
  EXPECT_EQ(scene.materials.at(scene.spheres[0].material).diffuse.b, 0.9);
  EXPECT_EQ(scene.materials.at(scene.spheres[1].material).diffuse.r, 0.9);
  ASSERT_EQ(scene.csgs.size(), 1u);
  EXPECT_EQ(scene.csgs[0].shape.operation, CsgOperation::subtract);
  EXPECT_EQ(std::get<Csg>(scene.csgs[0].shape.of.at(1).body).of.size(), 2u);
  ASSERT_EQ(scene.lights.size(), 1u);
  EXPECT_EQ(scene.lights[0].kind, LightKind::rectangle);
  EXPECT_EQ(scene.lights[0].samples, 12);
  EXPECT_TRUE(render(scene, {})) << "and it can be drawn";
}

TEST(Challenge, SaysWhatIsWrong) {
  const std::string camera = kCamera;
  EXPECT_EQ(answer("- add: sphere\n"),
            "scene:1: error: the scene has no camera: expected '- add: camera'\n");
  EXPECT_EQ(answer(camera + "- add: blob\n"),
            "scene:8: error: 'blob' is no kind of shape, and not defined before this\n"
            "  kinds: plane, sphere, cube, cylinder, cone, triangle, smooth-triangle, group, csg, "
            "obj\n");
  EXPECT_EQ(answer(camera + "- add: sphere\n  transform:\n    - [ translate, 1, 2 ]\n"),
            "scene:10: error: this is no step of a transform: expected [translate, x, y, z], "
            "[scale, x, y, z], [rotate-x, radians] or the like, or [shear, six numbers]\n");
  EXPECT_EQ(answer(camera + "- add: sphere\n  transform: [ [ scale, 0, 1, 1 ] ]\n"),
            "scene:8: error: the transform of a sphere makes it flat\n");
  EXPECT_EQ(answer(camera + "- define: a\n  value: { add: a }\n- add: a\n"),
            "scene:10: error: 'a' is defined by itself, or too deep\n");
  EXPECT_EQ(answer(camera + "- add: obj\n  file: a.obj\n"),
            "scene:9: error: a.obj: files beside the scene need a folder\n");
  EXPECT_EQ(answer(camera + "- add: sphere\n  material: { diffuse: x }\n"),
            "scene:9: error: 'x' of diffuse is no finite number\n");
  // Ten of ten of ten…
  std::string many = camera + "- define: g0\n  value: { add: sphere }\n";
  for (int i = 1; i < 12; ++i) {
    const std::string own = std::to_string(i), before = std::to_string(i - 1);
    many += "- define: g" + own + "\n  value:\n    add: group\n    children:\n";
    for (int k = 0; k < 10; ++k) many += "      - add: g" + before + "\n";
  }
  EXPECT_NE(answer(many + "- add: g11\n"), "it is read");
}

constexpr const char* kTest =
    "# a scene\nsize 9 9\nmaxdepth 3\noutput a.png\ncamera 0 0 4 0 0 0 0 1 0 30\n";

TEST(Cse167, MovesByAStackOfTransforms) {
  const ReadScene with =
      read(std::string(kTest) +
           "maxverts 3\nvertex 0 0 0\nvertex 1 0 0\nvertex 0 1 0\n"
           "pushTransform\ntranslate 1 0 0\nrotate 0 0 1 90\nscale 2 2 2\n"
           "ambient 0.1 0.1 0.1\nemission 0.2 0 0\ndiffuse 0.5 0 0\nspecular 0.25 "
           "0.25 0.25\nshininess 20\nsphere 1 0 0 1\ntri 0 1 2\npopTransform\n"
           "sphere 0 0 0 1\nscale 1 2 1\nsphere 0 0 0 1\n"
           "vertexnormal 0 0 0 0 0 1\nvertexnormal 1 0 0 0 0 1\nvertexnormal 0 1 "
           "0 0 0 1\ntrinormal 0 1 2\nwhatever 1 2\n");
  EXPECT_EQ(to_string(with.warnings.at(0)),
            "scene:29: warning: 'whatever' is no command of these scenes: it is left out\n");
  const Scene& scene = with.scene;
  ASSERT_EQ(scene.spheres.size(), 2u);
  EXPECT_NEAR(scene.spheres[0].shape.center.x, 1, 1e-12);
  EXPECT_NEAR(scene.spheres[0].shape.center.y, 2, 1e-12);
  EXPECT_NEAR(scene.spheres[0].shape.radius, 2, 1e-12);
  EXPECT_EQ(scene.spheres[1].shape.center, Vec3{});
  EXPECT_EQ(scene.ellipsoids.size(), 1u);
  ASSERT_EQ(scene.triangles.size(), 1u);
  EXPECT_NEAR(scene.triangles[0].shape.b.y, 2, 1e-12);
  ASSERT_EQ(scene.smooth_triangles.size(), 1u);
  EXPECT_EQ(scene.smooth_triangles[0].shape.c, (Vec3{0, 2, 0}));
  EXPECT_EQ(scene.materials.size(), 1u);
  const Material& m = scene.materials[0];
  EXPECT_NEAR(m.ambient.r, 0.3, 1e-12);
  EXPECT_EQ(m.reflection.r, 0.25);
  EXPECT_EQ(m.highlight, Highlight::blinn);
  EXPECT_EQ(scene.defaults.max_depth, 3);
}

TEST(Cse167, LightsBySightOfTheSun) {
  const Scene scene = read(std::string(kTest) +
                           "directional 0 0 1 0.5 1 0\nattenuation 1 0 0.5\npoint 0 0 3 1 1 1\n"
                           "ambient 0.25 0 0\ndiffuse 0.5 0.5 0.5\nsphere 0 0 0 1\n")
                          .scene;
  ASSERT_EQ(scene.lights.size(), 2u);
  EXPECT_EQ(scene.lights[0].direction.z, -1);
  EXPECT_EQ(scene.lights[1].attenuation, (Vec3{1, 0, 0.5}));
  RenderOptions options;
  options.profile = profile_of(scene.defaults.profile);
  const Image image = render(scene, options).value().image;
  const float* const middle = image.row(4) + 3 * 4;
  EXPECT_NEAR(middle[0], 0.25 + 0.5 * 0.5 + 0.5 / (1 + 0.5 * 4), 1e-4);
  EXPECT_NEAR(middle[1], 0.5 + 0.5 / 3, 1e-4);
}

TEST(Cse167, SaysWhatIsWrong) {
  EXPECT_EQ(answer("size 9 9\nsphere 0 0 0\n"),
            "scene:2: error: sphere has 3 numbers: expected 4\n");
  EXPECT_EQ(answer(std::string(kTest) + "tri 0 1 2\n"),
            "scene:6: error: vertex 0 is not there: so far there are 0\n");
  EXPECT_EQ(answer("size 9 9\nsphere 0 0 0 1\n"),
            "scene: error: the scene has no camera: expected camera with ten numbers\n");
  EXPECT_EQ(answer("size 1e9 9\n"),
            "scene:1: error: size is 1000000000 9: expected whole numbers, 1 or more, of at most "
            "134217728 pixels\n");
  EXPECT_EQ(answer(std::string(kTest) + "rotate 0 0 0 5\n"),
            "scene:6: error: the axis of rotate is 0 0 0\n");
}

}  // namespace
}  // namespace zraka
