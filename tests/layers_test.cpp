// SPDX-License-Identifier: Apache-2.0
// What a picture knows of its pixels, against rays that the tests trace themselves and against
// explanations.
#include <gtest/gtest.h>

#include <bit>
#include <cmath>
#include <optional>
#include <string>
#include <zraka/zraka.hpp>

#include "render/crypto.hpp"

namespace zraka {
namespace {

struct Ray {
  Vec3 origin, direction;
};

Vec3 plus(const Vec3& a, const Vec3& b, double times = 1) {
  return {a.x + b.x * times, a.y + b.y * times, a.z + b.z * times};
}
double dot(const Vec3& a, const Vec3& b) {
  return a.x * b.x + a.y * b.y + a.z * b.z;
}

/// Through a pixel's centre, or where in it the numbers say.
Ray ray_through(const Scene& scene, double x, double y, double in_pixel = 0.5) {
  const Camera& c = scene.camera;
  const double right = (x + in_pixel) / scene.resolution.width - 0.5;
  const double up = 0.5 - (y + in_pixel) / scene.resolution.height;
  const Vec3 to =
      plus(plus(plus(c.window_center, c.window_right, right), c.window_up, up), c.eye, -1);
  const double length = std::sqrt(dot(to, to));
  return {c.eye, {to.x / length, to.y / length, to.z / length}};
}

/// The distance to a sphere; and how far the ray's nearest point is from its edge.
struct SphereHit {
  std::optional<double> t;
  double from_edge;
};
SphereHit hit(const Sphere& sphere, const Ray& ray) {
  const Vec3 to = plus(sphere.center, ray.origin, -1);
  const double along = dot(to, ray.direction), off2 = dot(to, to) - along * along;
  const double inside = sphere.radius * sphere.radius - off2;
  SphereHit found{std::nullopt, std::fabs(sphere.radius - std::sqrt(std::max(off2, 0.0)))};
  if (inside >= 0) found.t = along - std::sqrt(inside);
  return found;
}

/// Two spheres, one before the other, of which the second one has a name and the third material.
Scene two_spheres() {
  Scene scene;
  scene.resolution = {61, 47};
  scene.camera.window_up = {0, 2 * 47.0 / 61, 0};
  scene.background = {0.2, 0.4, 0.6};
  scene.lights = {{{0, 3, 3}}};
  scene.materials = {{}, {.diffuse = {1, 0, 0}, .reflection = 0.3}, {.diffuse = {0, 1, 0}}};
  scene.spheres = {{{{-0.2, 0.1, -1}, 0.5}, 1}, {{{0.3, -0.1, -2}, 0.8}, 2}};
  scene.names[{0, 1}] = "the second";
  return scene;
}

RenderOptions with(LayerSet layers, ProfileName profile = ProfileName::physical) {
  RenderOptions options;
  options.profile = profile_of(profile);
  options.layers = layers;
  return options;
}
LayerSet of(std::initializer_list<Layer> list) {
  LayerSet layers;
  for (const Layer layer : list) layers.add(layer);
  return layers;
}
const std::vector<float>& floats(const Layers& layers, const char* name) {
  return *layers.find(name)->floats();
}
const std::vector<std::uint32_t>& ids(const Layers& layers, const char* name) {
  return *layers.find(name)->ids();
}

TEST(Layers, AreOfTheNearestHitOfThePixelsRay) {
  const Scene scene = two_spheres();
  for (const ProfileName profile : {ProfileName::physical, ProfileName::lab}) {
    const Layers layers = render(scene, with(LayerSet::all(), profile)).value().layers;
    ASSERT_EQ(layers.width, 61u);
    ASSERT_EQ(layers.height, 47u);
    std::size_t seen[3] = {};
    for (std::uint32_t y = 0; y < 47; ++y)
      for (std::uint32_t x = 0; x < 61; ++x) {
        const Ray ray = ray_through(scene, x, y, profile == ProfileName::lab ? 0 : 0.5);
        const SphereHit first = hit(scene.spheres[0].shape, ray),
                        second = hit(scene.spheres[1].shape, ray);
        if (std::min(first.from_edge, second.from_edge) < 1e-6) continue;
        const std::uint32_t id = first.t ? 1 : second.t ? 2 : 0;
        ++seen[id];
        const std::size_t at = 61 * y + x;
        ASSERT_EQ(ids(layers, "objectId.X")[at], id) << x << ", " << y;
        ASSERT_EQ(ids(layers, "materialId.X")[at], id == 0 ? 0 : id + 1);
        if (id == 0) {
          ASSERT_EQ(floats(layers, "Z")[at], kNoDepth);
          ASSERT_EQ(floats(layers, "normal.Z")[at], 0);
          ASSERT_EQ(ids(layers, "rays.X")[at], 1u);
          continue;
        }
        const double t = id == 1 ? *first.t : *second.t;
        const Vec3 point = plus(ray.origin, ray.direction, t);
        const Sphere& sphere = scene.spheres[id - 1].shape;
        const Vec3 normal = plus(point, sphere.center, -1);
        ASSERT_NEAR(floats(layers, "Z")[at], t,
                    1e-3);  // where rays graze, less exact than the rest
        const double off[3] = {floats(layers, "position.X")[at] - point.x,
                               floats(layers, "position.Y")[at] - point.y,
                               floats(layers, "position.Z")[at] - point.z};
        for (const double d : off) ASSERT_NEAR(d, 0, 1e-3);
        ASSERT_NEAR(floats(layers, "normal.X")[at], normal.x / sphere.radius, 2e-3);
        ASSERT_NEAR(floats(layers, "normal.Y")[at], normal.y / sphere.radius, 2e-3);
        ASSERT_NEAR(floats(layers, "normal.Z")[at], normal.z / sphere.radius, 2e-3);
      }
    for (const std::size_t count : seen) EXPECT_GT(count, 200u);
  }
}

/// Shapes of all ways to stand in a scene: primitives, bodies, CSG, groups, textures where asked.
Scene many_shapes(bool textured) {
  Scene scene = two_spheres();
  scene.transforms = {{{0.6, 0, -0.3}, {0, 0.5, 0}, {0.3, 0, 0.6}, {-0.7, 0.5, 0}},
                      {{0.4, 0, 0}, {0, 0.4, 0}, {0, 0, 0.4}, {0.5, 0.5, 0.2}},
                      {{0.8, 0, -0.6}, {0, 1, 0}, {0.6, 0, 0.8}, {}}};
  scene.spheres[1].transform = 3;  // which only turns its u and v
  scene.materials.push_back({.diffuse = {1, 1, 1}});
  if (textured) {
    Texture& checker = scene.textures.emplace_back();
    checker.kind = TextureKind::checker;
    checker.colors[0] = {0.9, 0.8, 0.7};
    for (Material& material : scene.materials) material.textures = {{Coefficient::diffuse, 0}};
  }
  const auto last = static_cast<std::uint32_t>(scene.materials.size() - 1);
  scene.triangles = {{{{-1, -1, -1}, {0, -0.9, 0}, {-1, 0, 0}}, 0},
                     {{{0, -1, 0}, {1, -0.9, 0}, {1, 0, 0}}, 1}};
  scene.triangle_uvs = {{{{0, 0}, {2, 0}, {0, 3}}}, {{{0.5f, 0}, {1, 0.25f}, {0, 1}}}};
  scene.cones = {{{{0.2, -0.8, 0.3}, 0.3, {0.2, -0.3, 0.3}, 0.1}, 2}};
  scene.ellipsoids = {{{{0, 0, 0}, {0.3, 0.5, 0.4}}, last, 1}};
  Group& group = scene.groups.emplace_back();
  group.spheres = {{{{0, 0, 0}, 0.5}, 1}};
  group.triangles = {{{{0, 0, 0.6}, {1, 0, 0.6}, {0, 1, 0.6}}, last}};
  scene.instances = {{{.group = 0}, 0, 2}};
  return scene;
}

TEST(Layers, SayOfUvWhatTexturesSee) {
  const Scene scene = many_shapes(true);
  const Rendering rendering = render(scene, with(of({Layer::uv, Layer::object_id}))).value();
  // What explains finds u and v through the tables that the engine keeps for textures.
  Explainer explainer = Explainer::create(scene, with({})).value();
  std::size_t seen = 0;
  for (std::uint32_t y = 0; y < 47; y += 2)
    for (std::uint32_t x = 0; x < 61; x += 2) {
      const Explanation e = explainer.pixel(x, y).value();
      const auto& first = e.trees[0].rays[0].hit;
      const std::size_t at = 61 * y + x;
      ASSERT_EQ(first.has_value(), ids(rendering.layers, "objectId.X")[at] != 0);
      if (!first || !first->own || !first->own->uv) continue;
      ++seen;
      ASSERT_EQ(floats(rendering.layers, "uv.U")[at], static_cast<float>((*first->own->uv)[0]))
          << x << ", " << y;
      ASSERT_EQ(floats(rendering.layers, "uv.V")[at], static_cast<float>((*first->own->uv)[1]));
    }
  EXPECT_GT(seen, 150u);
  // Nor are they others where the scene has no textures.
  const Layers plain = render(many_shapes(false), with(of({Layer::uv}))).value().layers;
  EXPECT_EQ(floats(plain, "uv.U"), floats(rendering.layers, "uv.U"));
  EXPECT_EQ(floats(plain, "uv.V"), floats(rendering.layers, "uv.V"));
}

TEST(Layers, CountTheRaysThatThePictureTraces) {
  const Scene scene = many_shapes(false);
  const Rendering rendering = render(scene, with(of({Layer::rays, Layer::tree_depth}))).value();
  std::uint64_t rays = 0;
  for (const std::uint32_t count : ids(rendering.layers, "rays.X")) rays += count;
  EXPECT_EQ(rays, rendering.stats.rays.total());
  Explainer explainer = Explainer::create(scene, with({})).value();
  for (std::uint32_t y = 0; y < 47; y += 3)
    for (std::uint32_t x = 0; x < 61; x += 3) {
      int deepest = 0;
      const Explanation explanation = explainer.pixel(x, y).value();
      for (const ExplainedRay& ray : explanation.trees[0].rays)
        deepest = std::max(deepest, ray.depth);
      ASSERT_EQ(ids(rendering.layers, "treeDepth.X")[61 * y + x],
                static_cast<std::uint32_t>(deepest))
          << x << ", " << y;
    }
}

bool same_bits(const Channel& a, const Channel& b) {
  if (const auto* of_a = a.ids()) return *of_a == *b.ids();
  const std::vector<float>&x = *a.floats(), &y = *b.floats();
  return std::equal(x.begin(), x.end(), y.begin(), y.end(), [](float p, float q) {
    return std::bit_cast<std::uint32_t>(p) == std::bit_cast<std::uint32_t>(q);
  });
}

TEST(Layers, AreTheSameFromAnyThreadsTilesAndInstructionSets) {
  const Scene scene = many_shapes(true);
  RenderOptions options = with(LayerSet::all());
  options.transparent = true;
  const Rendering first = render(scene, options).value();
  for (const Isa isa : available_isas())
    for (const auto& [threads, tile] : {std::pair{1, 5}, {3, 16}, {2, 64}}) {
      options.isa = isa;
      options.threads = threads;
      options.tile = tile;
      const Rendering again = render(Scene(scene), options).value();
      EXPECT_EQ(again.image.pixels, first.image.pixels);
      ASSERT_EQ(again.layers.channels.size(), first.layers.channels.size());
      for (std::size_t i = 0; i < first.layers.channels.size(); ++i) {
        const Channel &a = first.layers.channels[i], &b = again.layers.channels[i];
        EXPECT_EQ(a.name, b.name);
        EXPECT_TRUE(same_bits(a, b)) << a.name << " " << name_of(isa);
      }
    }
  options.isa = Isa::oracle;
  const Layers truth = render(scene, options).value().layers;
  std::size_t other = 0;
  for (std::size_t i = 0; i < 61 * 47; ++i)
    other += ids(truth, "objectId.X")[i] != ids(first.layers, "objectId.X")[i];
  EXPECT_LE(other, 10u);  // centres of pixels on edges, to a float
}

TEST(Layers, DoNotChangeThePicture) {
  const Scene scene = many_shapes(true);
  for (const ProfileName profile : {ProfileName::lab, ProfileName::physical, ProfileName::spd})
    EXPECT_EQ(render(scene, with(LayerSet::all(), profile)).value().image.pixels,
              render(scene, with({}, profile)).value().image.pixels);
}

TEST(Transparent, TakesTheBackgroundAndNothingElse) {
  const Scene scene = two_spheres();
  RenderOptions options = with(of({Layer::object_id}));
  const Rendering whole = render(scene, options).value();
  options.transparent = true;
  const Rendering cut = render(scene, options).value();
  EXPECT_EQ(whole.layers.alpha(), nullptr);
  for (std::size_t i = 0; i < 61 * 47; ++i) {
    const bool covered = ids(cut.layers, "objectId.X")[i] != 0;
    ASSERT_EQ(cut.layers.alpha()[i], covered ? 1 : 0);
    for (std::size_t c = 3 * i; c < 3 * i + 3; ++c)
      ASSERT_EQ(cut.image.pixels[c], covered ? whole.image.pixels[c] : 0);
  }
}

TEST(Transparent, AddsUpToThePictureWithCornersAveraged) {
  // What is transparent, over the background, is the picture that is not.
  const Scene scene = two_spheres();
  RenderOptions options = with({}, ProfileName::spd);
  const Image whole = render(scene, options).value().image;
  options.transparent = true;
  const Rendering cut = render(scene, options).value();
  ASSERT_EQ(cut.layers.width, 61u);
  std::size_t partial = 0;
  for (std::size_t i = 0; i < 61 * 47; ++i) {
    const float alpha = cut.layers.alpha()[i];
    partial += alpha > 0 && alpha < 1;
    const double background[3] = {0.2, 0.4, 0.6};
    for (std::size_t c = 0; c < 3; ++c)
      ASSERT_NEAR(static_cast<double>(cut.image.pixels[3 * i + c]) +
                      (1 - static_cast<double>(alpha)) * background[c],
                  whole.pixels[3 * i + c], 1e-6);
  }
  EXPECT_GT(partial, 50u);
}

TEST(Transparent, CountsTheSamplesThatHitSomething) {
  const Scene scene = two_spheres();
  RenderOptions options;
  options.sampling.count = 4;
  const Image whole = render(scene, options).value().image;
  options.transparent = true;
  const Rendering cut = render(scene, options).value();
  std::size_t partial = 0;
  for (std::size_t i = 0; i < 61 * 47; ++i) {
    const float alpha = cut.layers.alpha()[i];
    EXPECT_EQ(4 * alpha, std::round(4 * alpha));
    partial += alpha > 0 && alpha < 1;
    const double background[3] = {0.2, 0.4, 0.6};
    for (std::size_t c = 0; c < 3; ++c)
      ASSERT_NEAR(static_cast<double>(cut.image.pixels[3 * i + c]) +
                      (1 - static_cast<double>(alpha)) * background[c],
                  whole.pixels[3 * i + c], 1e-6);
  }
  EXPECT_GT(partial, 50u);
}

TEST(Cryptomatte, HashesAsMurmur3Does) {
  // Values of the reference implementation.
  EXPECT_EQ(murmur_hash(""), 0u);
  EXPECT_EQ(murmur_hash("hello"), 0x248BFA47u);
  EXPECT_EQ(murmur_hash("hello, world"), 0x149BBB7Fu);
  EXPECT_EQ(murmur_hash("The quick brown fox jumps over the lazy dog"), 0x2E4FF723u);
  for (int i = 0; i < 3000; ++i)
    EXPECT_TRUE(std::isnormal(std::bit_cast<float>(hash_for_float(std::to_string(i)))));
}

TEST(Cryptomatte, NamesWhatIsInThePicture) {
  const Layers layers = render(two_spheres(), with(of({Layer::cryptomatte}))).value().layers;
  ASSERT_EQ(layers.channels.size(), 4u);
  const auto bits = [](const char* name) { return std::bit_cast<float>(hash_for_float(name)); };
  std::size_t first = 0, second = 0;
  for (std::size_t i = 0; i < 61 * 47; ++i) {
    const float matte = floats(layers, "CryptoObject00.R")[i];
    first += matte == bits("object 1");
    second += matte == bits("the second");
    ASSERT_EQ(floats(layers, "CryptoObject00.G")[i], matte == 0 ? 0 : 1);
  }
  EXPECT_GT(first, 200u);
  EXPECT_GT(second, 200u);
  ASSERT_EQ(layers.notes.size(), 4u);
  const std::string& key = layers.notes[0].first;
  EXPECT_TRUE(key.starts_with("cryptomatte/") && key.ends_with("/name") && key.size() == 24) << key;
  EXPECT_EQ(layers.notes[3].second.substr(0, 2), "{\"");
  EXPECT_NE(layers.notes[3].second.find("\"the second\":\""), std::string::npos);
}

TEST(LayerNames, AreKnownAndNoOthers) {
  for (std::size_t i = 0; i < kLayerNames.size(); ++i)
    EXPECT_EQ(layer_named(kLayerNames[i]), static_cast<Layer>(i));
  EXPECT_FALSE(layer_named("colour"));
  EXPECT_TRUE(LayerSet().empty());
  EXPECT_TRUE(LayerSet::all().has(Layer::cryptomatte));
}

}  // namespace
}  // namespace zraka
