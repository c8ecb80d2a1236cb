// SPDX-License-Identifier: Apache-2.0
// Where a shape has its part, found again pixel by pixel in the explanations.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <map>
#include <set>

#include "shape_scenes.hpp"

namespace zraka {
namespace {

using Key = std::tuple<std::vector<RayKind>, bool, bool>;

/// Whether a path goes through a shape of a group that is named so.
bool goes_through(const ExplainedPath& path, const std::string& group, const ShapeId& shape) {
  for (std::size_t i = 0; i < path.instances.size(); ++i) {
    const NamedShape& next =
        i + 1 < path.instances.size() ? path.instances[i + 1].shape : *path.inner;
    if (path.instances[i].group_name == group && next.id == shape) return true;
  }
  return false;
}

/// The ways of a pixel by which a shape is hit, from its trees; of the scene, or of a group.
std::set<Key> ways_of_pixel(const Explanation& explanation, const ShapeId& shape,
                            const std::string& group = "") {
  const auto is_it = [&](const auto& hit) {
    return group.empty() ? hit.shape.id == shape : goes_through(hit.path, group, shape);
  };
  std::set<Key> ways;
  for (const RayTree& tree : explanation.trees) {
    std::vector<std::vector<RayKind>> paths(tree.rays.size());
    for (std::size_t r = 0; r < tree.rays.size(); ++r) {
      const ExplainedRay& ray = tree.rays[r];
      if (ray.parent >= 0) {
        paths[r] = paths[static_cast<std::size_t>(ray.parent)];
        paths[r].push_back(ray.kind);
      }
      if (!ray.hit) continue;
      std::vector<RayKind> path = paths[r];
      const bool longer = path.size() > kInfluencePath;
      path.resize(std::min(path.size(), kInfluencePath));
      if (is_it(*ray.hit)) ways.insert({path, longer, false});
      for (const LightTerms& at : ray.hit->lights)
        if (at.blocker && is_it(*at.blocker)) ways.insert({path, longer, true});
    }
  }
  return ways;
}

unsigned bits_of(const std::set<Key>& ways) {
  unsigned bits = 0;
  for (const auto& [path, longer, shadow] : ways) {
    bool reflected = false, refracted = false;
    for (const RayKind kind : path) (kind == RayKind::reflected ? reflected : refracted) = true;
    bits |= shadow                   ? kShadow
            : reflected && refracted ? kBothWays
            : reflected              ? kMirrored
            : refracted              ? kThroughGlass
                                     : kSeen;
  }
  return bits;
}

TEST(Influence, IsWhatTheExplanationsSay) {
  for (NamedScene& named : test_scenes(24))
    for (const ProfileName profile : {ProfileName::lab, ProfileName::physical, ProfileName::spd}) {
      named.scene.resolution = {24, 24};
      RenderOptions options{.profile = profile_of(profile)};
      options.max_depth = 7;
      options.tile = 5;
      const ShapeId shape{0, 2};
      std::map<Key, std::uint64_t> want;
      Explainer explainer = Explainer::create(named.scene, options).value();
      const Influence found = influence(named.scene, options, shape).value();
      std::uint64_t reached = 0;
      for (std::uint32_t y = 0; y < 24; ++y)
        for (std::uint32_t x = 0; x < 24; ++x) {
          const std::set<Key> ways = ways_of_pixel(explainer.pixel(x, y).value(), shape);
          for (const Key& way : ways) ++want[way];
          reached += !ways.empty();
          ASSERT_EQ(found.pixels[y * 24 + x], bits_of(ways))
              << named.name << " (" << x << ", " << y << ")";
        }
      std::map<Key, std::uint64_t> got;
      for (const InfluenceWay& way : found.ways)
        got[{way.path, way.longer, way.shadow}] += way.pixels;
      EXPECT_EQ(got, want) << named.name;
      EXPECT_EQ(found.count(0xFF), reached);
    }
}

TEST(Influence, OfWhatIsInGroupsIsThatOfAllItsInstances) {
  const Scene scene = chairs_scene(40);
  const RenderOptions options{.profile = profile_of(ProfileName::physical)};
  Explainer explainer = Explainer::create(scene, options).value();
  for (const auto& [name, group] : {std::pair{"chair/seat", "chair"},
                                    {"shank", "leg"},
                                    {"foot", "leg"},
                                    {"right leg", "chair"},
                                    {"ball", "chair"},
                                    {"left", ""}}) {
    const ShapeInScene shape = find_shape(scene, name).value();
    const Influence found = influence(scene, options, shape).value();
    std::uint64_t reached = 0, shadowed = 0;
    for (std::uint32_t y = 0; y < 40; ++y)
      for (std::uint32_t x = 0; x < 40; ++x) {
        const unsigned bits =
            bits_of(ways_of_pixel(explainer.pixel(x, y).value(), shape.id, group));
        ASSERT_EQ(found.pixels[y * 40 + x], bits) << name << " (" << x << ", " << y << ")";
        reached += bits != 0;
        shadowed += (bits & kShadow) != 0;
      }
    EXPECT_GT(reached, 10u) << name;
    EXPECT_GT(shadowed, 5u) << name;
  }
}

TEST(Influence, OfOneSphereIsItsSilhouetteAndItsShadow) {
  // A white floor and a black sphere above it: what is dark is one of the two.
  Scene scene = lab_scene(80);
  scene.lights[0].position = {0, 5, -3};
  add_sphere(scene, {0, -101, -3}, 100, {.ambient = {1, 1, 1}, .diffuse = {1, 1, 1}});
  add_sphere(scene, {0, 0.3, -3}, 0.5, {});
  const RenderOptions options{.profile = profile_of(ProfileName::lab)};
  const Influence found = influence(scene, options, {0, 1}).value();
  RenderOptions without_shadows = options;
  without_shadows.terms = terms_of(Stage::specular);
  const Image lit = render(scene, without_shadows).value().image;
  const Image image = render(scene, options).value().image;
  std::uint64_t shadowed = 0;
  for (std::size_t i = 0; i < found.pixels.size(); ++i) {
    // Its own dark side may be shadowed by itself, at grazing angles; the floor is not.
    if ((found.pixels[i] & kSeen) != 0) continue;
    const bool darker = image.pixels[3 * i] < lit.pixels[3 * i];
    EXPECT_EQ(darker, (found.pixels[i] & kShadow) != 0) << i;
    shadowed += darker;
  }
  EXPECT_GT(shadowed, 20u);
  EXPECT_GT(found.count(kSeen), 50u);
  EXPECT_EQ(found.count(kMirrored | kThroughGlass | kBothWays), 0u);
}

TEST(Influence, DoesNotDependOnThreadsAndTiles) {
  const Scene scene = tangled_scene(70);
  RenderOptions options{.profile = profile_of(ProfileName::physical)};
  const Influence want = influence(scene, options, {0, 40}).value();
  EXPECT_GT(want.count(kSeen), 100u);
  for (const auto& [threads, tile] : {std::pair{1, 64}, {2, 1}, {3, 7}})
    for (const Isa isa : available_isas()) {
      options.threads = threads;
      options.tile = tile;
      options.isa = isa;
      const Influence found = influence(scene, options, {0, 40}).value();
      EXPECT_EQ(found.pixels, want.pixels);
      ASSERT_EQ(found.ways.size(), want.ways.size());
      for (std::size_t i = 0; i < want.ways.size(); ++i) {
        EXPECT_EQ(found.ways[i].path, want.ways[i].path);
        EXPECT_EQ(found.ways[i].pixels, want.ways[i].pixels);
      }
    }
}

TEST(Influence, CanBeCancelled) {
  std::atomic<bool> cancel{true};
  RenderOptions options;
  options.cancel = &cancel;
  EXPECT_EQ(influence(tangled_scene(), options, {0, 1}).error().front().message,
            "the search was cancelled");
}

TEST(Influence, NeedsAShapeOfTheScene) {
  EXPECT_EQ(influence(tangled_scene(), {}, {0, 42}).error().front().message,
            "the scene does not have this shape");
  EXPECT_EQ(influence(tangled_scene(), {}, {1, 0}).error().front().message,
            "the scene does not have this shape");
}

TEST(FindShape, KnowsNamesAndNumbers) {
  Scene scene = mixed_scene();
  scene.names = {{{0, 3}, "Zelena"}, {{1, 2}, "krov"}, {{1, 5}, "Krov"}, {{3, 0}, "zelena"}};
  const auto found = [&](const std::string& name) { return find_shape(scene, name).value(); };
  EXPECT_EQ(found("sphere 3"), (ShapeId{0, 2}));
  EXPECT_EQ(found("Sphere3"), (ShapeId{0, 2}));
  EXPECT_EQ(found("kugla 3"), (ShapeId{0, 2}));
  EXPECT_EQ(found(" smooth triangle 50 "), (ShapeId{2, 49}));
  EXPECT_EQ(found("stožac 1"), (ShapeId{3, 0}));
  EXPECT_EQ(found("krov"), (ShapeId{1, 2})) << "the exact name wins";
  EXPECT_EQ(found("Krov"), (ShapeId{1, 5}));
}

TEST(FindShape, KnowsNamesInGroups) {
  Scene scene = chairs_scene();
  constexpr std::int32_t kEllipsoid = kind_in_list<Ellipsoid>(), kBox = kind_in_list<Box>(),
                         kCsg = kind_in_list<Csg>(), kInstance = kind_in_list<Instance>();
  const auto found = [&](const std::string& name) { return find_shape(scene, name).value(); };
  EXPECT_EQ(found("left"), (ShapeInScene{kInstance, 0}));
  EXPECT_EQ(found("instance 2"), (ShapeInScene{kInstance, 1}));
  EXPECT_EQ(found("primjerak 2"), (ShapeInScene{kInstance, 1}));
  EXPECT_EQ(found("seat"), (ShapeInScene{{kBox, 0}, 1}));
  EXPECT_EQ(found("Chair/Seat"), (ShapeInScene{{kBox, 0}, 1}));
  EXPECT_EQ(found("chair/box 1"), (ShapeInScene{{kBox, 0}, 1}));
  EXPECT_EQ(found("chair/kvadar 1"), (ShapeInScene{{kBox, 0}, 1}));
  EXPECT_EQ(found("leg/shank"), (ShapeInScene{{kEllipsoid, 0}, 0}));
  EXPECT_EQ(found("chair/right leg"), (ShapeInScene{{kInstance, 1}, 1}));
  EXPECT_EQ(found("bore"), (ShapeInScene{{kCsg, 0}, 1})) << "a member is its whole";
  EXPECT_EQ(found("chair/block"), (ShapeInScene{{kCsg, 0}, 1})) << "of a member, too";
  EXPECT_EQ(found("chair/csg 1"), (ShapeInScene{{kCsg, 0}, 1}));
  EXPECT_EQ(find_shape(csg_scene(), "drilled").value(), (ShapeInScene{kCsg, 0}));
  // What the scene itself has goes before what groups have.
  scene.names[{0, 0}] = "seat";
  EXPECT_EQ(found("seat"), (ShapeInScene{0, 0}));
  scene.groups[0].name = "";
  EXPECT_EQ(found("group 1/foot"), (ShapeInScene{{0, 0}, 0}));

  const auto error = [&](const std::string& name) {
    return to_string(find_shape(scene, name).error().front());
  };
  EXPECT_EQ(
      error("arm"),
      "error: the scene has no shape 'arm'\n  it has sphere 1, instance 1 to instance 2; names "
      "are 'seat', 'left'; groups are 'group 1', 'chair': say GROUP/NAME for a shape in one\n");
  EXPECT_EQ(
      error("chair/arm"),
      "error: group 'chair' has no shape 'arm'\n  it has box 1, csg 1, instance 1 to instance "
      "2; names are 'seat', 'right leg'\n");
  scene.groups[0].names[{kEllipsoid, 0}] = "right leg";
  EXPECT_EQ(error("right leg"),
            "error: 2 shapes are called 'right leg'\n  say which: group 1/ellipsoid 1, "
            "chair/instance 2\n");
}

TEST(FindShape, SaysWhatThereIs) {
  Scene scene = mixed_scene();
  const auto error = [&](const std::string& name) {
    return to_string(find_shape(scene, name).error().front());
  };
  const std::string there =
      "  it has sphere 1 to sphere 50, triangle 1 to triangle 50, smooth triangle 1 to smooth "
      "triangle 50, cone 1 to cone 50";
  EXPECT_EQ(error("green"), "error: the scene has no shape 'green'\n" + there + "\n");
  for (const char* name :
       {"sphere 0", "sphere 51", "sphere -1", "sphere 1x", "3", "", "sphere", "sphere 99999999999"})
    EXPECT_EQ(error(name), fmt::format("error: the scene has no shape '{}'\n{}\n", name, there));
  scene.names = {{{0, 3}, "krov"}, {{1, 2}, "krov"}};
  EXPECT_EQ(error("x"),
            "error: the scene has no shape 'x'\n" + there + "; names are 'krov', 'krov'\n");
  EXPECT_EQ(error("krov"),
            "error: 2 shapes are called 'krov'\n  say which: sphere 4, triangle 3\n");
  scene = lab_scene();
  EXPECT_EQ(error("x"), "error: the scene has no shape 'x'\n  it has no shapes\n");
}

}  // namespace
}  // namespace zraka
