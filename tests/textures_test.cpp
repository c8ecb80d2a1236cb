// SPDX-License-Identifier: Apache-2.0
// Textures of cells, layers and rings against closed forms and means by brute force.
#include <gtest/gtest.h>

#include <bit>
#include <cmath>
#include <limits>

#include "texture_places.hpp"
#include "textures/perlin.hpp"

namespace zraka {
namespace {

constexpr TextureKind kAllKinds[] = {
#define ZRAKA_KIND(kind) TextureKind::kind,
    ZRAKA_TEXTURES(ZRAKA_KIND)
#undef ZRAKA_KIND
};

TEST(Checker, CountsCellsFromTheOriginInEveryDirection) {
  for (const double size : {1.0, 0.3, 7.0}) {
    Texture checker = texture_of(TextureKind::checker, {{0.9, 0.8, 0.7}, {0.1, 0.2, 0.3}});
    checker.size = size;
    const TextureSet set({checker});
    for (int x = -4; x < 4; ++x)
      for (int y = -4; y < 4; ++y)
        for (int z = -4; z < 4; ++z)
          for (const double inside : {0.001, 0.5, 0.999}) {
            const auto at = point_at((x + inside) * size, (y + inside) * size, (z + inside) * size);
            const std::size_t odd = (x + y + z) & 1;
            expect_color(set.value(0, at), checker.colors[odd]);
          }
  }
}

TEST(Checker, HasOneColorOnAFaceBetweenTwoCells) {
  const TextureSet set({texture_of(TextureKind::checker)});
  for (const double face : {-2.0, 0.0, 3.0})
    for (const double off : {-4e-7, -1e-9, -1e-300, 0.0, 1e-9, 4e-7})
      for (const double x : {0.5, -1.5, 12.5}) {
        const bool odd = static_cast<int>(std::floor(x) + face) & 1;
        EXPECT_EQ(set.value(0, point_at(x, face + off, 0.5)).x, odd ? 0 : 1) << x << " " << face;
        EXPECT_EQ(set.value(0, point_at(0.5, x, face + off)).x, odd ? 0 : 1) << x << " " << face;
      }
  // Where the engine's numbers are coarse, it says so.
  TexturePoint rough = point_at(0.5, -1e-4, 0.5);
  EXPECT_EQ(set.value(0, rough).x, 0);
  rough.error = 2e-4;
  EXPECT_EQ(set.value(0, rough).x, 1);
  rough.point.y = -0.3;
  rough.error = 100;
  EXPECT_EQ(set.value(0, rough).x, 0) << "never more than a quarter of a cell";
}

TEST(Checker, ScalesWhatRoundingMovedWithItsTransform) {
  Texture checker = texture_of(TextureKind::checker);
  checker.transform.along_y = {0, 1e-3, 0};
  const TextureSet set({checker});
  TexturePoint at = point_at(0.5, -1e-6, 0.5);  // -1e-3 of a cell
  at.error = 5e-7;
  EXPECT_EQ(set.value(0, at).x, 0);
  at.error = 2e-6;
  EXPECT_EQ(set.value(0, at).x, 1);
}

TEST(Checker, IsSharpUntilAFootprintIsHalfACellWide) {
  const TextureSet set({texture_of(TextureKind::checker)});
  Random random(1);
  for (int i = 0; i < 1000; ++i) {
    const Point p{any(random, 9), any(random, 9), any(random, 9)};
    const TextureValue sharp = set.value(0, point_at(p.x, p.y, p.z));
    EXPECT_TRUE(sharp.x == 0 || sharp.x == 1);
    EXPECT_EQ(set.value(0, footprint_at(p, {0.5, 0, 0}, {0, 0.3, 0.4})).x, sharp.x);
  }
}

TEST(Checker, IsTheMeanOverAFootprintFromACellOn) {
  const Texture checker = texture_of(TextureKind::checker, {{0.9, 0.8, 1.7}, {0.1, 0.2, 0.3}});
  const TextureSet set({checker});
  Random random(2);
  for (int i = 0; i < 30; ++i) {
    const Point p{any(random, 9), any(random, 9), any(random, 9)};
    const Point a{1 + 3 * random.unit(), 0, 0}, b{0, 0, 1 + 3 * random.unit()};
    const TextureValue wanted = mean_by_force(set, p, a, b, 150);
    expect_color(set.value(0, footprint_at(p, a, b)), to_color(wanted), 0.015);
    // One wide side alone is filtered along it alone.
    const TextureValue line = mean_by_force(set, p, a, 300);
    expect_color(set.value(0, footprint_at(p, {}, a)), to_color(line), 0.015);
  }
}

TEST(Checker, GoesFromSharpToMeanWithoutAJump) {
  const TextureSet set({texture_of(TextureKind::checker)});
  double before = 1;
  for (int i = 0; i <= 2000; ++i) {
    const double width = 0.4 + i * 0.001;
    const double value = set.value(0, footprint_at({0.7, 0.5, 0.5}, {width, 0, 0}, {})).x;
    EXPECT_NEAR(value, before, 0.004);
    before = value;
  }
}

TEST(Checker, IsGreyAtTheHorizon) {
  const TextureSet set({texture_of(TextureKind::checker)});
  Random random(3);
  const double infinity = std::numeric_limits<double>::infinity();
  for (const double width : {1e3, 1e9, 1e200, infinity})
    for (int i = 0; i < 100; ++i) {
      const Point p{any(random, 1e5), 0, any(random, 1e5)};
      EXPECT_NEAR(set.value(0, footprint_at(p, {0, 0, width}, {0.01, 0, 0})).x, 0.5, 0.6e-3);
    }
}

TEST(Checker, OverASurfaceGoesByUAndV) {
  Texture checker = texture_of(TextureKind::checker);
  checker.mapping = TextureMapping::uv;
  checker.size = 0.25;
  const TextureSet set({checker});
  TexturePoint at = point_at(77, -3, 12);
  for (int i = -5; i < 5; ++i)
    for (int j = -5; j < 5; ++j) {
      at.u = 0.25 * (i + 0.5);
      at.v = 0.25 * (j + 0.5);
      EXPECT_EQ(set.value(0, at).x, (i + j) & 1 ? 0 : 1);
    }
  at.footprint_v[1] = 1;
  EXPECT_NEAR(set.value(0, at).x, 0.5, 1e-12);
}

TEST(Textures, GoWithTheirTransform) {
  Transform transform;
  transform.along_x = {0.2, 1.1, 0.3};
  transform.along_y = {-0.9, 0.4, 0.1};
  transform.along_z = {0.3, 0.2, 2.5};
  transform.origin = {10, -20, 5};
  Random random(4);
  for (const TextureKind kind : kAllKinds) {
    Texture plain = texture_of(kind);
    plain.turbulence = 0.5;
    plain.direction = {1, 2, -1};
    Texture moved = plain;
    moved.transform = transform;
    const TextureSet set({plain, moved});
    for (int i = 0; i < 200; ++i) {
      const auto map = [&](const Point& p) {
        return Point{
            p.x * transform.along_x.x + p.y * transform.along_y.x + p.z * transform.along_z.x,
            p.x * transform.along_x.y + p.y * transform.along_y.y + p.z * transform.along_z.y,
            p.x * transform.along_x.z + p.y * transform.along_y.z + p.z * transform.along_z.z};
      };
      const Point p{any(random, 5), any(random, 5), any(random, 5)};
      const Point a{any(random, 1), any(random, 1), any(random, 1)}, b{0.3, any(random, 1), 0.1};
      const Point o{transform.origin.x, transform.origin.y, transform.origin.z};
      const TextureValue wanted = set.value(0, footprint_at(p, a, b));
      const TextureValue value = set.value(1, footprint_at(map(p) + o, map(a), map(b)));
      EXPECT_NEAR(value.x, wanted.x, 1e-9);
    }
  }
}

TEST(Textures, WithoutAnInverseAreWhatTheyAreAtTheirOrigin) {
  Texture flat = texture_of(TextureKind::stripes, {{1, 0, 0}, {0, 1, 0}});
  flat.transform.along_z = {0, 0, 0};
  expect_color(TextureSet({flat}).value(0, point_at(5.5, 3, 2)), {1, 0, 0});
}

TEST(Stripes, TakeTurnsAcrossTheirDirection) {
  Texture stripes = texture_of(TextureKind::stripes, {{1, 0, 0}, {0, 1, 0}, {0, 0, 1}});
  stripes.size = 0.5;
  stripes.direction = {0, 3, 4};
  const TextureSet set({stripes});
  for (int i = -9; i < 9; ++i) {
    const double along = 0.5 * (i + 0.5);
    const auto turn = static_cast<std::size_t>(((i % 3) + 3) % 3);
    expect_color(set.value(0, point_at(17, 0.6 * along + 8, 0.8 * along - 6)),
                 stripes.colors[turn]);
  }
}

TEST(Stripes, AreTheMeanOverAFootprintFromAStripeOn) {
  Texture stripes = texture_of(TextureKind::stripes, {{1, 0, 0}, {0, 1, 0}, {0, 0, 1}});
  stripes.direction = {3, 0, 4};
  const TextureSet set({stripes});
  Random random(5);
  for (int i = 0; i < 60; ++i) {
    const Point p{any(random, 50), any(random, 50), any(random, 50)};
    const Point a = Point{0.6, 0, 0.8} * (1 + 8 * random.unit());
    const TextureValue wanted = mean_by_force(set, p, a, 1000);
    // Along the stripes nothing changes.
    expect_color(set.value(0, footprint_at(p, {-80, 5, 60}, a)), to_color(wanted), 0.003);
  }
}

TEST(Gradient, GoesEvenlyThroughItsColorsAndRepeats) {
  Texture gradient = texture_of(TextureKind::gradient, {{1, 0, 0}, {0, 1, 0}, {0, 0, 1}});
  gradient.size = 4;
  gradient.direction = {0, 10, 0};
  const struct {
    TextureWrap wrap;
    double y;
    Color wanted;
  } cases[] = {
      {TextureWrap::repeat, 0, {1, 0, 0}},     {TextureWrap::repeat, 1, {0.5, 0.5, 0}},
      {TextureWrap::repeat, 2, {0, 1, 0}},     {TextureWrap::repeat, 3, {0, 0.5, 0.5}},
      {TextureWrap::repeat, 4, {1, 0, 0}},     {TextureWrap::repeat, -1, {0, 0.5, 0.5}},
      {TextureWrap::repeat, -1e-9, {1, 0, 0}}, {TextureWrap::clamp, -7, {1, 0, 0}},
      {TextureWrap::clamp, 1, {0.5, 0.5, 0}},  {TextureWrap::clamp, 4, {0, 0, 1}},
      {TextureWrap::clamp, 90, {0, 0, 1}},     {TextureWrap::mirror, 4, {0, 0, 1}},
      {TextureWrap::mirror, 5, {0, 0.5, 0.5}}, {TextureWrap::mirror, -1, {0.5, 0.5, 0}},
      {TextureWrap::mirror, 8, {1, 0, 0}},     {TextureWrap::mirror, 17, {0.5, 0.5, 0}},
  };
  for (const auto& c : cases) {
    gradient.wrap = c.wrap;
    SCOPED_TRACE(testing::Message() << static_cast<int>(c.wrap) << " at " << c.y);
    expect_color(TextureSet({gradient}).value(0, point_at(3, c.y, -8)), c.wanted, 1e-8);
  }
}

TEST(Gradient, IsTheMeanOverAnyFootprint) {
  Random random(6);
  for (const TextureWrap wrap : {TextureWrap::repeat, TextureWrap::clamp, TextureWrap::mirror}) {
    Texture gradient = texture_of(TextureKind::gradient, {{1, 0, 0.5}, {0, 1, 0.5}, {0, 2, 1}});
    gradient.wrap = wrap;
    const TextureSet set({gradient});
    for (int i = 0; i < 100; ++i) {
      const Point p{any(random, 3), 0, 0}, a{3 * random.unit() * random.unit(), 0, 0};
      const TextureValue wanted = mean_by_force(set, p, a, 1000);
      expect_color(set.value(0, footprint_at(p, a, {0, 9, 0})), to_color(wanted), 0.003);
    }
    const TextureValue far = set.value(0, footprint_at({5, 0, 0}, {1e12, 0, 0}, {}));
    if (wrap == TextureWrap::clamp)
      expect_color(set.value(0, footprint_at({1e17, 0, 0}, {3, 0, 0}, {})), {0, 2, 1}, 1e-12);
    const Color mean = wrap == TextureWrap::clamp ? Color{0.5, 1, 0.75} : Color{0.25, 1, 0.625};
    expect_color(far, mean, 1e-6);
  }
}

TEST(Rings, TakeTurnsAroundTheirAxis) {
  Texture rings = texture_of(TextureKind::rings, {{1, 0, 0}, {0, 1, 0}, {0, 0, 1}});
  rings.size = 2;
  rings.direction = {0, 0, -5};
  const TextureSet set({rings});
  for (int i = 0; i < 9; ++i)
    for (const double angle : {0.3, 2.0, 4.4}) {
      const double radius = 2 * (i + 0.5);
      const auto at = point_at(radius * std::cos(angle), radius * std::sin(angle), 7);
      expect_color(set.value(0, at), rings.colors[static_cast<std::size_t>(i) % 3]);
    }
}

TEST(Rings, AreTheMeanOverAFootprintThatLooksOutwards) {
  const TextureSet set({texture_of(TextureKind::rings, {{1, 0, 0}, {0, 1, 0}, {0, 0, 1}})});
  Random random(7);
  for (int i = 0; i < 60; ++i) {
    const double radius = 5 + 20 * random.unit();
    const Point out{0, std::cos(i), std::sin(i)};
    const Point a = out * (1 + 6 * random.unit());
    const TextureValue wanted = mean_by_force(set, out * radius, a, 1000);
    expect_color(set.value(0, footprint_at(out * radius, a, {8, 0, 0})), to_color(wanted), 0.005);
  }
  // Along a ring, as far as it curves away: √(5² + 12²) - 5.
  expect_color(set.value(0, footprint_at({0, 5, 0}, {0, 0, 24}, {})),
               to_color(mean_by_force(set, {0, 5, 0}, {0, 8, 0}, 1000)), 0.005);
  // There are none on the other side of the axis: a whole one and half of the next.
  expect_color(set.value(0, footprint_at({0, 0, 0}, {0, 3, 0}, {0, 0, 3})), {2 / 3., 1 / 3., 0},
               1e-12);
  expect_color(set.value(0, footprint_at({0, 0, 0}, {0, 0.2, 0}, {0, 0, 0.2})), {1, 0, 0});
  expect_color(set.value(0, footprint_at({0, 1e4, 0}, {0, 1e9, 0}, {})), {1 / 3., 1 / 3., 1 / 3.},
               1e-3);
}

TEST(Marble, IsPureAtWholeSizesAndBlendsBetween) {
  Texture marble = texture_of(TextureKind::marble, {{1, 0, 0}, {0, 1, 0}, {0, 0, 1}});
  marble.size = 2;
  const TextureSet set({marble});
  for (int i = -6; i < 7; ++i) {
    const auto turn = static_cast<std::size_t>((i % 3 + 3) % 3), next = (turn + 1) % 3;
    expect_color(set.value(0, point_at(2 * i, 5, 5)), marble.colors[turn], 1e-12);
    const Color &a = marble.colors[turn], &b = marble.colors[next];
    expect_color(set.value(0, point_at(2 * i + 1, 5, 5)),
                 {(a.r + b.r) / 2, (a.g + b.g) / 2, (a.b + b.b) / 2}, 1e-12);
    // Level where it is pure, steepest between: t²·(3 - 2·t).
    expect_color(
        set.value(0, point_at(2 * i + 0.5, 5, 5)),
        {a.r + (b.r - a.r) * 0.15625, a.g + (b.g - a.g) * 0.15625, a.b + (b.b - a.b) * 0.15625},
        1e-12);
  }
}

TEST(Wood, GoesThroughItsColorsAndBackInEachRing) {
  Texture wood = texture_of(TextureKind::wood, {{1, 0, 0}, {0, 1, 0}, {0, 0, 1}});
  wood.direction = {0, 1, 0};
  const TextureSet set({wood});
  for (int ring = 0; ring < 5; ++ring) {
    expect_color(set.value(0, point_at(0, 8, ring)), {1, 0, 0}, 1e-12);
    expect_color(set.value(0, point_at(0, 8, ring + 0.4)), {0, 1, 0}, 1e-12);
    expect_color(set.value(0, point_at(ring + 0.8, 8, 0)), {0, 0, 1}, 1e-12);
    expect_color(set.value(0, point_at(0, 8, -ring - 0.9)), {0.5, 0, 0.5}, 1e-12);
  }
}

TEST(Marble, AndWoodAreTheMeanOverAnyFootprint) {
  Random random(16);
  for (const TextureKind kind : {TextureKind::marble, TextureKind::wood}) {
    const TextureSet set({texture_of(kind, {{1, 0, 0.5}, {0, 1, 0.5}, {0, 2, 1}})});
    for (int i = 0; i < 60; ++i) {
      const Point p{5 + any(random, 3), 0, 0}, a{3 * random.unit() * random.unit(), 0, 0};
      const Point q = kind == TextureKind::wood ? Point{0, p.x, 0} : p;  // its axis is x
      const Point b = kind == TextureKind::wood ? Point{0, a.x, 0} : a;
      expect_color(set.value(0, footprint_at(q, b, {})), to_color(mean_by_force(set, q, b, 1000)),
                   0.003);
    }
  }
}

TEST(Turbulence, BendsLayersAndRingsByASumOfOctaves) {
  // Its grain is two sizes; along the axis of rings it is four times as long.
  std::vector<Texture> textures;
  for (const TextureKind kind : {TextureKind::marble, TextureKind::wood})
    for (const double turbulence : {0.8, 0.0}) {
      Texture& t = textures.emplace_back(texture_of(kind));
      t.size = 0.5;
      t.turbulence = turbulence;
      t.octaves = 3;
      t.seed = 9;
    }
  const TextureSet set(textures);
  const Fractal fractal{3, 9};
  Random random(17);
  for (int i = 0; i < 200; ++i) {
    const Point p{any(random, 5), 1 + any(random, 5), any(random, 5)};
    const double layer = p.x + 0.5 * 0.8 * fractal.turbulence(p, 0);
    EXPECT_NEAR(set.value(0, point_at(p.x, p.y, p.z)).x, set.value(1, point_at(layer, 0, 0)).x,
                1e-9);
    const double radius = std::sqrt(p.y * p.y + p.z * p.z);
    const double ring = radius + 0.5 * 0.8 * fractal({p.x / 4, p.y, p.z}, 0);
    if (ring > 0) {
      EXPECT_NEAR(set.value(2, point_at(p.x, p.y, p.z)).x, set.value(3, point_at(0, ring, 0)).x,
                  1e-9);
    }
  }
}

TEST(Turbulence, MixesMoreIntoAFootprint) {
  // Along the layers nothing would change without it; with it six of them come into four sizes.
  Texture marble = texture_of(TextureKind::marble), wood = texture_of(TextureKind::wood);
  marble.turbulence = wood.turbulence = 3;
  const TextureSet set({marble, wood});
  EXPECT_NEAR(set.value(0, footprint_at({0.2, 3, 1}, {0, 4, 0}, {})).x, 0.5, 1e-9);
  EXPECT_NEAR(set.value(1, footprint_at({3, 0.2, 1}, {4, 0, 0}, {})).x, 0.5, 1e-9);
}

TEST(Turbulence, BendsLayersAndRingsBySizes) {
  Random random(8);
  for (const TextureKind kind : {TextureKind::marble, TextureKind::wood, TextureKind::rings}) {
    Texture plain = texture_of(kind), slightly = plain, bent = plain;
    slightly.turbulence = 1e-4;
    bent.turbulence = 1;
    const TextureSet set({plain, slightly, bent});
    double small = 0, large = 0;
    for (int i = 0; i < 2000; ++i) {
      const auto at = point_at(any(random, 9), any(random, 9), any(random, 9));
      const double value = set.value(0, at).x;
      small += std::fabs(set.value(1, at).x - value);
      large += std::fabs(set.value(2, at).x - value);
    }
    EXPECT_LT(small / 2000, 3e-3);
    EXPECT_GT(large / 2000, 0.1);
  }
}

TEST(Textures, AnswerPointsThatAreNowhere) {
  const double bad[] = {std::nan(""),
                        std::numeric_limits<double>::infinity(),
                        -std::numeric_limits<double>::infinity(),
                        1e308,
                        -1e300,
                        1e20,
                        0};
  Random random(14);
  for (const TextureKind kind : kAllKinds)
    for (const TextureMapping mapping : {TextureMapping::solid, TextureMapping::uv})
      for (const TextureWrap wrap :
           {TextureWrap::repeat, TextureWrap::clamp, TextureWrap::mirror}) {
        Texture texture = texture_of(kind);
        texture.mapping = mapping;
        texture.wrap = wrap;
        texture.turbulence = 2;
        texture.image = any_image(7, 5);
        const TextureSet set({texture});
        for (int i = 0; i < 300; ++i) {
          const auto one = [&] { return bad[random.below(std::size(bad))]; };
          TexturePoint at = point_at(one(), one(), one());
          for (int axis = 0; axis < 2; ++axis) {
            at.footprint[axis] = {one(), one(), one()};
            at.footprint_u[axis] = one();
            at.footprint_v[axis] = one();
          }
          at.u = one();
          at.v = one();
          at.error = one();
          const TextureValue v = set.value(0, at);
          for (const double c : {v.x, v.y, v.z}) {
            ASSERT_GE(c, -1e-6);
            ASSERT_LE(c, 1 + 1e-6);
          }
          const Point slope = set.slope(0, at);
          ASSERT_TRUE(std::isfinite(slope.x + slope.y + slope.z));
        }
      }
}

TEST(Textures, AnswerWhateverTheirNumbersAre) {
  const double bad[] = {
      std::nan(""), std::numeric_limits<double>::infinity(), 1e300, 1e-300, 0, -1};
  Random random(18);
  for (const TextureKind kind : kAllKinds)
    for (int i = 0; i < 300; ++i) {
      const auto one = [&] { return bad[random.below(std::size(bad))]; };
      Texture texture = texture_of(kind);
      texture.size = one();
      texture.direction = {one(), one(), one()};
      texture.turbulence = one();
      texture.octaves = static_cast<int>(random.below(100)) - 50;
      texture.transform.along_y.y = one();
      texture.colors.resize(random.below(3));
      texture.image = any_image(3, 2);
      const TextureSet set({texture});
      const TextureValue v =
          set.value(0, footprint_at({any(random, 9), 1e20, 3}, {one(), 0, 0}, {0, one(), 0}));
      ASSERT_TRUE(v.x >= -1e-6 && v.x <= 1 + 1e-6) << v.x;
    }
  Texture stripes = texture_of(TextureKind::stripes);
  stripes.direction = {0, 0, -1e300};
  EXPECT_EQ(TextureSet({stripes}).value(0, point_at(0, 0, 0.5)).x, 0) << "any finite direction";
}

TEST(Textures, HaveTheSameBitsEverywhere) {
  // Changes only with a reason: pictures change, too.
  std::uint64_t hash = 14695981039346656037u;  // FNV-1a
  Random random(15);
  for (const TextureKind kind : kAllKinds) {
    Texture texture = texture_of(kind, {{0.9, 0.1, 0.3}, {0.2, 0.7, 0.4}, {0.1, 0.3, 0.8}});
    texture.turbulence = 0.7;
    texture.direction = {1, 2, 3};
    texture.image = any_image(13, 10);
    texture.seed = 5;
    const TextureSet set({texture});
    for (int i = 0; i < 200; ++i) {
      const auto three = [&](double size) {
        const double x = any(random, size), y = any(random, size);
        return Point{x, y, any(random, size)};
      };
      const Point p = three(10), a = three(1), b = three(0.2);
      const TextureValue v = set.value(0, footprint_at(p, a, b));
      for (const double c : {v.x, v.y, v.z})
        hash = (hash ^ std::bit_cast<std::uint64_t>(c)) * 1099511628211u;
    }
  }
  EXPECT_EQ(hash, 13108533553190857551u);
}

TEST(RolledTextures, GoRoundTheYAxisWhateverTheShape) {
  Texture checker;
  checker.mapping = TextureMapping::cylinder;
  checker.repeat_u = 4, checker.repeat_v = 2;
  const auto value = [](const Texture& texture, const V3<double>& point) {
    TexturePoint at;
    at.point = point;
    return TextureSet({texture}).value(0, at).x;
  };
  // A quarter of the way round, and half a unit of height, for each cell.
  EXPECT_EQ(value(checker, {1, 0.25, 0.1}), 1);
  EXPECT_EQ(value(checker, {9, 0.25, 0.9}), 1);
  EXPECT_EQ(value(checker, {-0.1, 0.25, 1}), 0);
  EXPECT_EQ(value(checker, {-1, 0.25, -0.1}), 1);
  EXPECT_EQ(value(checker, {1, 0.25, -0.1}), 0);
  EXPECT_EQ(value(checker, {1, 0.75, 0.1}), 0);
  checker.offset_u = 1;
  EXPECT_EQ(value(checker, {1, 0.25, 0.1}), 0);
  // From straight down to straight up in two cells, however far.
  checker.mapping = TextureMapping::sphere;
  checker.offset_u = 0;
  EXPECT_EQ(value(checker, {1, -5, 0.1}), 1);
  EXPECT_EQ(value(checker, {1, 5, 0.1}), 0);
  EXPECT_EQ(value(checker, {10, -0.1, 0.1}), 1);
}

}  // namespace
}  // namespace zraka
