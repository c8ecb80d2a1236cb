// SPDX-License-Identifier: Apache-2.0
// What instruction sets find of textures of many hits at a time: the bits that come of it hit by hit.
#include <gtest/gtest.h>

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstring>
#include <set>
#include <string>
#include <vector>

#include "core/random.hpp"
#include "engine/coefficients.hpp"
#include "language_helpers.hpp"
#include "render/isa.hpp"
#include "render/prepare.hpp"
#include "render/workspace.hpp"

namespace zraka {
namespace {

constexpr std::int32_t kRays = 2003;  // not a multiple of any number of lanes
constexpr TextureMapping kMappings[] = {TextureMapping::solid, TextureMapping::cylinder,
                                        TextureMapping::sphere, TextureMapping::uv};

/// A floor and shapes of two spaces, on which one texture is the diffuse coefficient and another
/// one the share that is reflected.
Scene textured(const std::string& diffuse, const std::string& reflection) {
  return scene_of(R"(
[camera]
eye = [0, 2, 6]
look_at = [0, 0, 0]
[[light]]
position = [0, 9, 0]
[texture.one]
)" + diffuse + R"(
[texture.two]
)" + reflection + R"(
[material.floor]
ambient = "one"
diffuse = "one"
reflection = "two"
[material.tiles]
diffuse = "one"
[material.plain]
color = 0.5
reflection = 0.5
[[shape]]
kind = "plane"
material = "floor"
point = [0, 0, 0]
normal = [0, 1, 0]
[[shape]]
kind = "sphere"
material = "tiles"
center = [-1, 0.5, 0]
radius = 1
transform = [{rotate = [1, 2, 3], by_deg = 40}, {scale = [1, 1.5, 0.8]}]
[[shape]]
kind = "triangle"
material = "tiles"
a = [-4, 0, -3]
b = [4, 0, -3]
c = [0, 5, -3]
[[shape]]
kind = "sphere"
material = "plain"
center = [1.2, 0.7, 1]
radius = 0.7
)");
}

/// Rays from one point, with cones of all kinds.
template <class R>
void start_rays(Level<R>& level) {
  Random random{7};
  for (std::size_t i = 0; i < kRays; ++i) {
    V3<double> way{4 * random.unit() - 2, 1.5 * random.unit() - 1.2, -3};
    way = way * (1 / std::sqrt(dot(way, way)));
    level.rays.ox[i] = R(0.3), level.rays.oy[i] = R(0.7), level.rays.oz[i] = R(2);
    level.rays.dx[i] = static_cast<R>(way.x), level.rays.dy[i] = static_cast<R>(way.y);
    level.rays.dz[i] = static_cast<R>(way.z);
    const double widths[] = {0, 1e-4, 0.01, -0.02, 0.3, 3};
    level.rays.width[i] = static_cast<R>(widths[i % std::size(widths)]);
    level.rays.spread[i] = static_cast<R>(widths[i / 7 % std::size(widths)] / 3);
    level.rays.travelled[i] = static_cast<R>(5 * random.unit());
  }
  // Straight down, where a cone is as long as it is wide.
  level.rays.dx[5] = level.rays.dz[5] = R(0), level.rays.dy[5] = R(-1);
  level.ray_count = level.in_batch = kRays;
  level.done = 0;
}

/// What is known of the hits of one batch; how many different rows of coefficients there are.
template <class R>
struct Known {
  std::vector<R> rows;
  std::vector<double> cones;
  std::size_t different() const {
    std::set<std::vector<R>> all;
    for (auto row = rows.begin(); row != rows.end(); row += kMaterialReals)
      all.insert({row, row + kMaterialReals});
    return all.size();
  }
};

template <class R>
Known<R> known_of(const FrozenScene<R>& scene, const Services<R>& services, ColorHits<R>* lanes) {
  WorkspaceMemory<R> memory(WorkspaceNeeds{.batch = kRays, .textured = true});
  Level<R>& level = memory.workspace().levels[0];
  Scratch<R>& scratch = memory.workspace().scratch;
  start_rays(level);
  services.find_hits(scene, level, scratch);
  find_coefficients(scene, level, scratch, lanes);
  const auto count = static_cast<std::size_t>(level.hit_count);
  Known<R> known{{scratch.own_rows, scratch.own_rows + count * kMaterialReals}, {}};
  for (std::size_t h = 0; h < count; ++h) {
    known.cones.push_back(scratch.cones[h].width);
    // Only what reflects asks for it.
    const R* const row = scratch.own_rows + h * kMaterialReals;
    known.cones.push_back(row[kReflection] > R(0) ? scratch.cones[h].curvature : 0);
  }
  return known;
}

template <class T>
bool same_bits(const std::vector<T>& a, const std::vector<T>& b) {
  return a.size() == b.size() && std::memcmp(a.data(), b.data(), a.size() * sizeof(T)) == 0;
}

template <class R>
void expect_same(const Scene& scene, const Services<R>& services, std::string_view name,
                 std::size_t least) {
  const PreparedScene<R> prepared = prepare<R>(scene, RenderOptions{});
  const FrozenScene<R>& frozen = prepared.store->scene;
  const Known<R> one = known_of<R>(frozen, services, nullptr);
  const Known<R> many = known_of<R>(frozen, services, services.color_hits);
  EXPECT_GT(one.rows.size(), 1000u * kMaterialReals) << name;
  EXPECT_GE(one.different(), least) << name;
  EXPECT_TRUE(same_bits(one.rows, many.rows)) << name;
  EXPECT_TRUE(same_bits(one.cones, many.cones)) << name;
}

void expect_same_bits(const Scene& scene, std::size_t least) {
  for (const Isa isa : available_isas())
    expect_same(scene, *kernel_of(isa).services, name_of(isa), least);
  expect_same(scene, isa_oracle::kServices, "oracle", least);
}

TEST(Texturing, HasTheBitsOfSingleHitsForCheckers) {
  for (const char* const checker :
       {"kind = \"checker\"", "kind = \"checker\"\nsize = 0.3",
        "kind = \"checker\"\nsize = 0.125\ncolors = [[0.9, 0.5, 0.1], [0.1, 0.2, 0.3]]\n"
        "transform = [{rotate = [1, 1, 0], by_deg = 33}, {scale = [1, 2, 0.5]}]"}) {
    SCOPED_TRACE(checker);
    expect_same_bits(textured(checker, "kind = \"checker\"\nsize = 0.7\ncolors = [0.1, 0.4]"), 30);
  }
}

TEST(Texturing, HasTheBitsOfSingleHitsForEveryKindInSpace) {
  for (const std::string kind : {"stripes", "gradient", "rings", "marble", "wood", "noise"})
    for (const char* const mapping : {"", "mapping = \"cylinder\"\n", "mapping = \"sphere\"\n"}) {
      SCOPED_TRACE(kind + " " + mapping);
      expect_same_bits(
          textured("kind = \"" + kind + "\"\nsize = 0.2\n" + mapping, "kind = \"checker\""), 30);
    }
}

std::shared_ptr<const Image> noisy(std::uint32_t width, std::uint32_t height) {
  auto image = std::make_shared<Image>(width, height);
  Random random{3};
  for (float& value : image->pixels) value = static_cast<float>(random.unit());
  return image;
}

/// One image on everything.
Scene pictured(const std::shared_ptr<const Image>& image, TextureFilter filter,
               TextureMapping mapping, TextureWrap wrap) {
  Scene scene = textured("kind = \"checker\"", "kind = \"checker\"");
  for (Texture& texture : scene.textures) {
    texture.kind = TextureKind::image;
    texture.image = image;
    texture.filter = filter;
    texture.mapping = mapping;
    texture.wrap = wrap;
    texture.reach = 300;
  }
  return scene;
}

TEST(Texturing, HasTheBitsOfSingleHitsForImages) {
  const auto image = noisy(37, 21);
  for (const TextureFilter filter : {TextureFilter::nearest, TextureFilter::bilinear,
                                     TextureFilter::mip, TextureFilter::distance})
    for (const TextureMapping mapping : kMappings) {
      SCOPED_TRACE(testing::Message() << static_cast<int>(filter) << static_cast<int>(mapping));
      expect_same_bits(pictured(image, filter, mapping, TextureWrap::repeat), 30);
    }
}

TEST(Texturing, HasTheBitsOfSingleHitsForSmallerSizesOfImages) {
  // One that is all levels, one that is wide, and one that has no smaller size.
  const std::shared_ptr<const Image> images[] = {noisy(64, 32), noisy(1, 5), noisy(1, 1)};
  for (const auto& image : images)
    for (const TextureWrap wrap : {TextureWrap::repeat, TextureWrap::clamp, TextureWrap::mirror})
      for (const TextureMapping mapping : kMappings) {
        SCOPED_TRACE(testing::Message() << image->width << static_cast<int>(wrap)
                                        << static_cast<int>(mapping));
        expect_same_bits(pictured(image, TextureFilter::mip, mapping, wrap),
                         image->width > 1 ? 30 : 1);
      }
}

}  // namespace
}  // namespace zraka
