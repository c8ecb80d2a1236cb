// SPDX-License-Identifier: Apache-2.0
// Transforms, CSG and groups in the scene language: what they mean, how they are written, and the
// exact answer to each way of getting them wrong.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cmath>

#include "language_helpers.hpp"
#include "scene/bounds_of.hpp"

namespace zraka {
namespace {

const std::string kBall = "[[shape]]\nkind = \"sphere\"\ncenter = [1, 2, 3]\nradius = 0.5\n";

/// The transform of a body that the steps are written for.
Transform transform(const std::string& steps) {
  const Scene s = scene_of(
      "[[shape]]\nkind = \"plane\"\npoint = [0, 0, 0]\nnormal = [0, 1, 0]\ntransform = " + steps +
      "\n");
  const std::uint32_t index = s.planes.at(0).transform;
  return index == 0 ? Transform{} : s.transforms.at(index - 1);
}

void expect_near(const Vec3& a, const Vec3& b) {
  EXPECT_NEAR(a.x, b.x, 2e-15);
  EXPECT_NEAR(a.y, b.y, 2e-15);
  EXPECT_NEAR(a.z, b.z, 2e-15);
}

TEST(LanguageTransforms, AreAppliedInTheOrderWritten) {
  const Transform t = transform("[{scale = 2}, {translate = [1, 0, 0]}, {scale = [3, 1, 1]}]");
  EXPECT_EQ(moved(Vec3{1, 1, 1}, t), (Vec3{9, 2, 2}));
  EXPECT_EQ(transform("[{matrix = [[1, 2, 3, 4], [0, 1, 0, 5], [0, 0, 1, 6]]}]"),
            (Transform{{1, 0, 0}, {2, 1, 0}, {3, 0, 1}, {4, 5, 6}}));
  EXPECT_EQ(transform("[]"), Transform{});
}

TEST(LanguageTransforms, TurnRightHandedAndExactlyByQuarters) {
  EXPECT_EQ(transform("[{rotate = [0, 1, 0], by_deg = 90}]"),
            (Transform{{0, 0, -1}, {0, 1, 0}, {1, 0, 0}, {}}));
  EXPECT_EQ(transform("[{rotate = [0, 0, 7], by_deg = 90}]"),
            (Transform{{0, 1, 0}, {-1, 0, 0}, {0, 0, 1}, {}}));
  EXPECT_EQ(transform("[{rotate = [1, 0, 0], by_deg = -270}]"),
            (Transform{{1, 0, 0}, {0, 0, 1}, {0, -1, 0}, {}}));
  EXPECT_EQ(transform("[{rotate = [1, 0, 0], by_deg = 180}]"),
            (Transform{{1, 0, 0}, {0, -1, 0}, {0, 0, -1}, {}}));
  EXPECT_EQ(transform("[{rotate = [0, 1, 0], by_deg = 3600}]"), Transform{});
  EXPECT_EQ(transform("[{rotate = [0, 1, 0], by_deg = 60}]").along_x.x, 0.5);
  EXPECT_EQ(transform("[{rotate = [0, 1, 0], by_deg = 30}]").along_z.x, 0.5);
  const Transform eighth = transform("[{rotate = [0, 1, 0], by_deg = 45}]");
  EXPECT_EQ(eighth.along_x.x, eighth.along_z.x);
}

TEST(LanguageTransforms, TurnByAnyAngleRoundAnyAxis) {
  for (const double degrees : {-725.0, -91.0, -1e-3, 17.0, 44.0, 46.0, 100.0, 200.0, 300.0, 1e6}) {
    const double a = std::remainder(degrees, 360) * 3.14159265358979323846 / 180;
    const Transform y = transform(fmt::format("[{{rotate = [0, 2, 0], by_deg = {}}}]", degrees));
    expect_near(y.along_x, {std::cos(a), 0, -std::sin(a)});
    expect_near(y.along_z, {std::sin(a), 0, std::cos(a)});
    const Transform t = transform(fmt::format("[{{rotate = [1, 2, -3], by_deg = {}}}]", degrees));
    expect_near(moved(Vec3{1, 2, -3}, t), {1, 2, -3});
    EXPECT_TRUE(keeps_balls(t));
  }
  // Three times a third of a turn round the diagonal: x to y to z.
  expect_near(moved(Vec3{1, 0, 0}, transform("[{rotate = [1, 1, 1], by_deg = 120}]")), {0, 1, 0});
}

TEST(LanguageTransforms, MovePrimitives) {
  const Scene s =
      scene_of(kBall + "transform = [{scale = 2}, {rotate = [0, 0, 1], by_deg = 90}]\n" +
               "[[shape]]\nkind = \"triangle\"\na = [0, 0, 0]\nb = [1, 0, 0]\nc = [0, 1, 0]\n"
               "normals = [[0, 0, 1], [1, 1, 0], [1, 0, 1]]\ntransform = [{scale = [2, 1, 1]}]\n"
               "[[shape]]\nkind = \"polygon\"\npoints = [[0, 0, 0], [1, 0, 0], [0, 1, 0]]\n"
               "transform = [{translate = [0, 0, 5]}]\n"
               "[[shape]]\nkind = \"cylinder\"\nbase = [0, 0, 0]\ntop = [0, 1, 0]\nradius = 1\n"
               "caps = false\ntransform = [{scale = -3}]\n");
  ASSERT_EQ(s.spheres.size(), 1u);
  EXPECT_EQ(s.spheres[0].shape.center, (Vec3{-4, 2, 6}));
  EXPECT_EQ(s.spheres[0].shape.radius, 1);
  EXPECT_EQ(s.transforms.at(s.spheres[0].transform - 1).along_x, (Vec3{0, 2, 0}))
      << "textures move with it";
  const SmoothTriangle& t = s.smooth_triangles.at(0).shape;
  EXPECT_EQ(t.b, (Vec3{2, 0, 0}));
  EXPECT_EQ(t.normal_a, (Vec3{0, 0, 1}));
  EXPECT_EQ(t.normal_b, (Vec3{0.5, 1, 0})) << "stands on the surface still";
  EXPECT_EQ(s.triangles.at(0).shape.b, (Vec3{1, 0, 5}));
  EXPECT_EQ(s.cones.at(0).shape.apex, (Vec3{0, -3, 0}));
  EXPECT_EQ(s.cones.at(0).shape.base_radius, 3);
}

TEST(LanguageTransforms, MakeEllipsoidsOfSpheresThatAreNotRoundAnyMore) {
  const Scene s = scene_of(kBall + "transform = [{scale = [1, 2, 1]}]\nname = \"egg\"\n" + kBall +
                           "transform = [{rotate = [1, 2, 3], by_deg = 77}]\n");
  ASSERT_EQ(s.ellipsoids.size(), 1u);
  EXPECT_EQ(s.ellipsoids[0].shape, (Ellipsoid{{1, 2, 3}, {0.5, 0.5, 0.5}}));
  EXPECT_EQ(s.transforms.at(s.ellipsoids[0].transform - 1).along_y, (Vec3{0, 2, 0}));
  EXPECT_EQ(s.names.at({4, 0}), "egg");
  EXPECT_EQ(s.spheres.size(), 1u);
}

TEST(LanguageTransforms, MakeBodiesOfConesThatAreNotRoundAnyMore) {
  const std::string cone =
      "[[shape]]\nkind = \"cone\"\nbase = [0, 0, 0]\ntop = [0, 1, 0]\nbase_radius = 1\n";
  const Scene s = scene_of(cone + cone + "caps = false\n" + cone +
                           "caps = false\ntransform = [{scale = [1, 2, 1]}]\n");
  ASSERT_EQ(s.frustums.size(), 2u);
  EXPECT_EQ(s.frustums[0].shape, (Frustum{{}, 1, {0, 1, 0}, 0, true}));
  EXPECT_EQ(s.frustums[1].shape, (Frustum{{}, 1, {0, 1, 0}, 0, false}));
  EXPECT_EQ(s.frustums[1].transform, 1u);
  EXPECT_EQ(s.cones.size(), 1u);
  EXPECT_EQ(answer_to("[[shape]]\nkind = \"union\"\nof = [{kind = \"cylinder\", base = [0, 0, 0], "
                      "top = [0, 1, 0], radius = 1, caps = false}]\n"),
            "s.toml:3:81: error: without caps it is no closed body: CSG is of closed bodies\n"
            "  …der\", base = [0, 0, 0], top = [0, 1, 0], radius = 1, caps = false}]\n"
            "                                                               ^\n");
}

TEST(LanguageTransforms, AreSharedWhereTheyAreEqual) {
  const std::string plane = "[[shape]]\nkind = \"plane\"\npoint = [0, 0, 0]\nnormal = [0, 1, 0]\n";
  const Scene s = scene_of(plane + "transform = [{scale = 2}]\n" + plane +
                           "transform = [{scale = [2, 2, 2]}]\n" + plane +
                           "transform = [{scale = 3}]\n" + plane + "transform = [{scale = 1}]\n");
  EXPECT_EQ(s.transforms.size(), 2u);
  EXPECT_EQ(s.planes[0].transform, 1u);
  EXPECT_EQ(s.planes[1].transform, 1u);
  EXPECT_EQ(s.planes[2].transform, 2u);
  EXPECT_EQ(s.planes[3].transform, 0u) << "moves nothing";
}

TEST(LanguageTransforms, SayWhatIsWrongAtItsPlace) {
  const auto first = [](const std::string& steps) {
    return first_answer(kBall + "transform = " + steps + "\n");
  };
  const std::string steps =
      "{scale = …}, {rotate = [x, y, z], by_deg = …}, {translate = [x, y, z]} or "
      "{matrix = [[…], […], […]]}";
  EXPECT_EQ(
      first("{scale = 2}"),
      "s.toml:5:13: error: transform of sphere is {scale = 2}: expected a list of steps: " + steps);
  EXPECT_EQ(first("[{scale = 2}, 3]"),
            "s.toml:5:27: error: a step of transform of sphere is 3: expected " + steps);
  EXPECT_EQ(first("[{}]"),
            "s.toml:5:14: error: a step of transform of sphere is {}: expected " + steps);
  EXPECT_EQ(first("[{scale = 2, translate = [1, 0, 0]}]"),
            "s.toml:5:14: error: a step of transform of sphere has scale and translate: expected "
            "one of them a step");
  EXPECT_EQ(first("[{rotate = [0, 1, 0], by_deg = 3, scale = 2}]"),
            "s.toml:5:14: error: a step of transform of sphere has rotate and scale: expected one "
            "of them a step");
  EXPECT_EQ(first("[{scale = 0}]"),
            "s.toml:5:23: error: scale of transform of sphere is 0: expected a number or "
            "[x, y, z], finite and none of them 0");
  EXPECT_EQ(first("[{scale = [1, 0, 1]}]"),
            "s.toml:5:23: error: scale of transform of sphere is [1, 0, 1]: expected a number or "
            "[x, y, z], finite and none of them 0");
  EXPECT_EQ(first("[{rotate = [0, 0, 0], by_deg = 3}]"),
            "s.toml:5:24: error: rotate of transform of sphere is [0, 0, 0]: expected a direction "
            "[x, y, z], not all 0");
  EXPECT_EQ(first("[{rotate = [0, 1, 0]}]"),
            "s.toml:5:24: error: rotate of transform of sphere has no by_deg: expected the angle "
            "in degrees, a number");
  EXPECT_EQ(first("[{by_deg = 3}]"),
            "s.toml:5:24: error: by_deg of transform of sphere has no rotate: expected the axis, "
            "a direction [x, y, z], not all 0");
  EXPECT_EQ(first("[{rotate = [0, 1, 0], by_deg = \"a\"}]"),
            "s.toml:5:44: error: by_deg of transform of sphere is \"a\": expected a number");
  EXPECT_EQ(first("[{translate = 1}]"),
            "s.toml:5:27: error: translate of transform of sphere is 1: expected [x, y, z], "
            "finite numbers");
  EXPECT_EQ(first("[{matrix = [[1, 0, 0, 0], [0, 1, 0, 0]]}]"),
            "s.toml:5:24: error: matrix of transform of sphere is [[1, 0, 0, 0], [0, 1, 0, 0]]: "
            "expected three rows of four finite numbers: [[…4], […4], […4]]");
  EXPECT_EQ(first("[{matrix = [[1, 0, 0, 0], [0, 1, 0, 0], [1, 1, 0, 0]]}]"),
            "s.toml:5:24: error: matrix of transform of sphere makes all that it moves flat: "
            "expected one that has an inverse");
  EXPECT_EQ(first("[{scale = 1e200}, {scale = 1e200}]"),
            "s.toml:5:13: error: transform of sphere: its steps together are too large or too "
            "small for numbers");
  EXPECT_EQ(answer_to(kBall + "transform = [{scael = 2}]\n"),
            "s.toml:5:15: error: unknown field 'scael' of a step of transform of sphere\n"
            "  transform = [{scael = 2}]\n                ^\n"
            "  did you mean 'scale'?\n");
  EXPECT_EQ(first("[{scale = 1e150}]"),
            "s.toml:1:1: error: sphere: it reaches farther than 1e+100 from the origin");
  EXPECT_EQ(first_answer(kBall + "texture_transform = [{scale = 2}]\n"
                                 "transform = [{scale = [1, 2, 3]}]\n"),
            "s.toml:5:21: error: texture_transform for a sphere that its transform makes an "
            "ellipsoid is not built yet");
}

TEST(LanguageTriangles, HaveTextureCoordinates) {
  const std::string triangle =
      "[[shape]]\nkind = \"triangle\"\na = [0, 0, 0]\nb = [1, 0, 0]\nc = [0, 1, 0]\n";
  EXPECT_TRUE(scene_of(triangle).triangle_uvs.empty());
  const Scene s = scene_of(triangle + triangle + "uvs = [[0, 0.5], [1, 0.1], [0.25, 1]]\n" +
                           triangle + triangle +
                           "normals = [[0, 0, 1], [0, 0, 1], [0, 0, 1]]\n"
                           "uvs = [[0, 0], [2, 0], [0, 2]]\n");
  const CornerUvs none{{{0, 0}, {1, 0}, {0, 1}}};
  EXPECT_EQ(s.triangle_uvs,
            (std::vector<CornerUvs>{none, {{{0, 0.5f}, {1, 0.1f}, {0.25f, 1}}}, none}));
  EXPECT_EQ(s.smooth_triangle_uvs, (std::vector<CornerUvs>{{{{0, 0}, {2, 0}, {0, 2}}}}));
}

const std::string kMembers =
    "  {kind = \"sphere\", center = [0, 0, 0], radius = 1, name = \"round\"},\n"
    "  {kind = \"plane\", point = [0, 0.5, 0], normal = [0, 1, 0], material = \"cut\"},\n";

TEST(LanguageCsg, HasMembersOfItsOwnNestedAtWill) {
  const Scene s = scene_of(
      "[material.cut]\n[[shape]]\nkind = \"difference\"\nname = \"bowl\"\nof = [\n" + kMembers +
      "  {kind = \"union\", transform = [{scale = 2}], of = [\n    {kind = \"ellipsoid\", center = "
      "[0, 0, 0], radii = [1, 2, 3]},\n  ]},\n]\n");
  ASSERT_EQ(s.csgs.size(), 1u);
  EXPECT_EQ(s.names.size(), 1u);
  EXPECT_EQ(s.csgs[0].material, 1u) << "default";
  const Csg& csg = s.csgs[0].shape;
  EXPECT_EQ(csg.operation, CsgOperation::subtract);
  ASSERT_EQ(csg.of.size(), 3u);
  EXPECT_EQ(std::get<Ellipsoid>(csg.of[0].body), (Ellipsoid{{}, {1, 1, 1}}));
  EXPECT_EQ(csg.of[0].material, kMaterialOfWhole);
  EXPECT_EQ(csg.of[0].name, "round");
  EXPECT_EQ(csg.of[1].material, 0u);
  EXPECT_EQ(csg.of[2].transform, 1u);
  const Csg& inner = std::get<Csg>(csg.of[2].body);
  EXPECT_EQ(inner.operation, CsgOperation::unite);
  EXPECT_EQ(inner.of.size(), 1u);
}

TEST(LanguageCsg, SaysWhatIsWrongWithMembers) {
  const std::string head = "[[shape]]\nkind = \"union\"\n";
  EXPECT_EQ(answer_to(head + "of = [\n  {kind = \"polygon\", points = []},\n]\n"),
            "s.toml:4:11: error: polygon is no closed body, and union is of such\n"
            "    {kind = \"polygon\", points = []},\n            ^\n"
            "  closed bodies: " +
                closed_kinds() + "\n");
  EXPECT_EQ(first_answer(head + "of = []\n"),
            "s.toml:3:6: error: of of union is []: expected a list of shapes: [{kind = …}, …], 1 "
            "or more");
  EXPECT_EQ(first_answer(head + "of = [3]\n"),
            "s.toml:3:7: error: of of union has 3 in it: expected a list of shapes: "
            "[{kind = …}, …], 1 or more");
  EXPECT_EQ(first_answer(head + "of = [{kind = \"sphere\", center = [0, 0, 0], radus = 1}]\n"),
            "s.toml:3:7: error: sphere has no radius: expected its radius, a number greater than "
            "0");
  EXPECT_EQ(first_answer(head + "of = [{kind = \"spher\"}]\n"),
            "s.toml:3:15: error: unknown kind 'spher' of shape");
  EXPECT_EQ(first_answer(head + "of = [{kind = \"sphere\", center = [0, 0, 0], radius = 1, "
                                "material = \"x\"}]\n"),
            "s.toml:3:68: error: unknown material 'x'");
  EXPECT_EQ(
      first_answer(head + "of = [{kind = \"quadric\", coefficients = [1, 1, 1, 0, 0, 0, 0, 0, 0, "
                          "-1], min = [-1, -1, -1], max = [1, 1, 0.5]}]\n"),
      "s.toml:3:7: error: quadric: its box cuts its surface off, so it has no inside");
  // All problems are told, those of members too.
  EXPECT_EQ(answer_to(head + "material = \"none\"\nof = [{kind = \"spher\"}]\n"),
            "s.toml:3:12: error: unknown material 'none'\n"
            "  material = \"none\"\n             ^\n"
            "  there are no materials\n"
            "s.toml:4:15: error: unknown kind 'spher' of shape\n"
            "  of = [{kind = \"spher\"}]\n                ^\n"
            "  did you mean 'sphere'?\n");
}

TEST(LanguageCsg, SaysWhereItIsTooLarge) {
  const std::string ball = "{kind = \"sphere\", center = [0, 0, 0], radius = 1}";
  const auto many = [](const std::string& member, int count, const std::string& kind) {
    std::string text = fmt::format("kind = \"{}\", of = [", kind);
    for (int i = 0; i < count; ++i) text += member + ", ";
    return text + "]";
  };
  const auto shape = [](const std::string& keys) {
    return first_answer("[[shape]]\n" + fmt::format("{}\n", keys.substr(0, keys.find(", of"))) +
                        keys.substr(keys.find("of = [")) + "\n");
  };
  EXPECT_EQ(shape(many(ball, 64, "union")), "");
  EXPECT_EQ(shape(many(ball, 65, "union")),
            "s.toml:3:6: error: union: 65 of its members wait for each other: at most 64 fit");
  const std::string eight = "{" + many(ball, 32, "union") + "}";
  EXPECT_EQ(shape(many(eight, 8, "intersection")), "");
  EXPECT_EQ(shape(many(eight, 9, "intersection")),
            "s.toml:3:6: error: intersection: a ray may cross its members 576 times: at most 512 "
            "fit");
  std::string deep = ball;
  for (int i = 0; i < 63; ++i) deep = "{" + many(deep, 1, "union") + "}";
  EXPECT_EQ(shape(many(deep, 1, "union")), "");
  deep = "{" + many(deep, 1, "union") + "}";
  EXPECT_TRUE(shape(many(deep, 1, "union"))
                  .ends_with("error: CSG shapes are 65 deep in each other: at most 64 fit"));
}

TEST(LanguageGroups, AreDrawnWhereInstancesStand) {
  const Scene s = scene_of(
      "[[shape]]\nkind = \"instance\"\nof = \"chair\"\nmaterial = \"wood\"\n"
      "transform = [{translate = [1, 0, 0]}]\n"
      "[material.wood]\n"
      "[group.chair]\nshape = [\n"
      "  {kind = \"sphere\", center = [0, 0, 0], radius = 1, name = \"seat\"},\n"
      "  {kind = \"instance\", of = \"leg\"},\n"
      "  {kind = \"sphere\", center = [0, 0, 0], radius = 1, material = \"default\"},\n]\n"
      "[[group.leg.shape]]\nkind = \"sphere\"\ncenter = [0, 0, 0]\nradius = 2\n");
  ASSERT_EQ(s.groups.size(), 2u);
  EXPECT_EQ(s.groups[0].name, "chair");
  EXPECT_EQ(s.groups[0].spheres.size(), 2u);
  EXPECT_EQ(s.groups[0].spheres[0].material, kMaterialOfWhole);
  EXPECT_EQ(s.groups[0].spheres[1].material, 1u);
  EXPECT_EQ(s.groups[0].names.at({0, 0}), "seat");
  EXPECT_EQ(s.groups[0].instances.at(0).shape.group, 1u);
  EXPECT_EQ(s.groups[1].spheres.at(0).shape.radius, 2);
  ASSERT_EQ(s.instances.size(), 1u);
  EXPECT_EQ(s.instances[0].shape.group, 0u);
  EXPECT_EQ(s.instances[0].material, 0u);
  EXPECT_EQ(s.instances[0].transform, 1u);
  EXPECT_EQ(s.shape_count(), 1u);
}

TEST(LanguageGroups, SayWhatIsWrong) {
  EXPECT_EQ(answer_to("[group.chair]\nshape = []\n[[shape]]\nkind = \"instance\"\nof = "
                      "\"chiar\"\n"),
            "s.toml:5:6: error: unknown group 'chiar'\n"
            "  of = \"chiar\"\n       ^\n"
            "  did you mean 'chair'?\n");
  EXPECT_EQ(answer_to("[group.a]\nshape = [{kind = \"instance\", of = \"a\"}]\n"),
            "s.toml:2:35: error: group a has itself in it: a → a\n"
            "  shape = [{kind = \"instance\", of = \"a\"}]\n"
            "                                    ^\n");
  EXPECT_EQ(first_answer("[group.a]\nshape = [{kind = \"instance\", of = \"b\"}]\n"
                         "[group.b]\nshape = [{kind = \"instance\", of = \"c c\"}]\n"
                         "[group.\"c c\"]\nshape = [{kind = \"instance\", of = \"b\"}]\n"),
            "s.toml:6:35: error: group b has itself in it: b → \"c c\" → b");
  EXPECT_EQ(first_answer("[group.a]\nshape = 3\n"),
            "s.toml:2:9: error: shape of group a is 3: expected a list of shapes: [{kind = …}, "
            "…]");
  EXPECT_EQ(first_answer("[group.a]\nshape = [{kind = \"sphere\"}]\n"),
            "s.toml:2:10: error: sphere has no center: expected its centre, [x, y, z], finite "
            "numbers");
  EXPECT_EQ(first_answer("[group.a]\nshapes = []\n"),
            "s.toml:1:1: error: group a has no shape: expected its shapes, each as below "
            "[[shape]], a list of shapes: [{kind = …}, …]");
}

TEST(LanguageGroups, MayBeInEachOtherTo32Levels) {
  const auto chain = [](int count) {
    std::string text;
    for (int i = 0; i < count; ++i)
      text +=
          fmt::format("[group.g{}]\nshape = [{{kind = \"instance\", of = \"g{}\"}}]\n", i, i + 1);
    return text + fmt::format("[group.g{}]\nshape = []\n", count);
  };
  EXPECT_EQ(first_answer(chain(31)), "");
  EXPECT_EQ(answer_to(chain(32)),
            "s.toml:2:35: error: groups are in each other more than 32 deep\n"
            "  shape = [{kind = \"instance\", of = \"g1\"}]\n"
            "                                    ^\n");
  EXPECT_NE(first_answer(chain(100000)), "") << "and no stack is used up";
}

/// Where a line is broken, what is missing may stand in it: nothing is said of that, and nothing
/// that lacks it is used.
TEST(LanguageShapes, AreNotMadeInBrokenFilesWhereTheyLackSomething) {
  for (const char* const kind : {"instance", "mesh", "height_field", "union", "difference"}) {
    const std::string text = fmt::format("[[shape]]\nkind = \"{}\"\n[image]\nwidth 3\n", kind);
    EXPECT_EQ(answer_to(text),
              "s.toml:4:7: error: '3' stands here: expected '=' behind the key\n  width 3\n        ^\n")
        << kind;
  }
}

TEST(LanguageShapes, AreWrittenSoThatTheyReadAsTheEqualScene) {
  const std::string turn = "transform = [{rotate = [1, 2, 3], by_deg = 40}, {scale = 2}]\n";
  expect_rewritten(
      "[material.cut]\n[group.\"a b\"]\nshape = []\n" + kBall + "transform = [{scale = 2}]\n" +
      kBall + "texture_transform = [{translate = [-0.0, 1, 2]}]\n" + turn + kBall +
      "transform = [{scale = [1, 2, 3]}]\nname = \"egg\"\n"
      "[[shape]]\nkind = \"ellipsoid\"\ncenter = [0, 0, 1]\nradii = [1, 2, 3]\n" +
      turn +
      "[[shape]]\nkind = \"plane\"\npoint = [0, 0, 0]\nnormal = [0, 1, 0]\n"
      "[[shape]]\nkind = \"triangle\"\na = [0, 0, 0]\nb = [1, 0, 0]\nc = [0, 1, 0]\n" +
      turn +
      "[[shape]]\nkind = \"triangle\"\na = [0, 0, 0]\nb = [1, 0, 0]\nc = [0, 1, 0]\n"
      "uvs = [[0, 0.1], [0.3, 0.7], [1e-30, 16777217]]\n"
      "[[shape]]\nkind = \"triangle\"\na = [0, 0, 0]\nb = [1, 0, 0]\nc = [0, 1, 0]\n"
      "normals = [[0, 0, 1], [1, 1, 0], [1, 0, 1]]\nuvs = [[0, 0], [1, 0], [1, 1]]\n" +
      turn +
      "[[shape]]\nkind = \"cone\"\nbase = [0, 0, 0]\ntop = [0, 1, 0]\nbase_radius = 2\n"
      "caps = false\n" +
      turn + "[[shape]]\nkind = \"difference\"\n" + turn + "of = [\n" + kMembers +
      "  {kind = \"union\", transform = [{scale = 2}], material = \"default\", of = [\n"
      "    {kind = \"ellipsoid\", center = [0, 0, 0], radii = [1, 2, 3]}]},\n]\n"
      "[[group.c.shape]]\nkind = \"instance\"\nof = \"a b\"\nmaterial = \"default\"\n"
      "[[group.c.shape]]\nkind = \"sphere\"\ncenter = [0, 0, 0]\nradius = 1\nname = \"in c\"\n" +
      turn + "[[shape]]\nkind = \"instance\"\nof = \"c\"\n" + turn);
}

}  // namespace
}  // namespace zraka
