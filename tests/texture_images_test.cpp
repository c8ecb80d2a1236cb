// SPDX-License-Identifier: Apache-2.0
// Images as textures: texels, edges, smaller sizes, and long footprints.
#include <gtest/gtest.h>

#include <cmath>
#include <zraka/render.hpp>

#include "texture_places.hpp"
#include "textures/pyramid.hpp"

namespace zraka {
namespace {

Texture texture_of_image(std::shared_ptr<const Image> image, TextureFilter filter,
                         TextureWrap wrap = TextureWrap::repeat) {
  Texture texture = texture_of(TextureKind::image);
  texture.mapping = TextureMapping::uv;
  texture.image = std::move(image);
  texture.filter = filter;
  texture.wrap = wrap;
  return texture;
}

/// With a footprint of half axes that are given in texels of an image.
TexturePoint uv_at(double u, double v) {
  TexturePoint at;
  at.u = u;
  at.v = v;
  return at;
}
TexturePoint uv_at(double u, double v, const Image& image, const double (&widths)[2][2]) {
  TexturePoint at = uv_at(u, v);
  for (int i = 0; i < 2; ++i) {
    at.footprint_u[i] = widths[i][0] / 2 / image.width;
    at.footprint_v[i] = widths[i][1] / 2 / image.height;
  }
  return at;
}

/// A texel, counted from the left and from below.
Color texel(const Image& image, std::uint32_t x, std::uint32_t y) {
  const float* t = image.row(image.height - 1 - y) + std::size_t{3} * x;
  return {t[0], t[1], t[2]};
}

TEST(ImageTexture, IsExactInTheMiddlesOfTexels) {
  for (const auto& image : {any_image(7, 5), any_image(16, 8), any_image(1, 1), any_image(1, 9)})
    for (const TextureFilter filter :
         {TextureFilter::nearest, TextureFilter::bilinear, TextureFilter::mip}) {
      const TextureSet set({texture_of_image(image, filter)});
      for (std::uint32_t y = 0; y < image->height; ++y)
        for (std::uint32_t x = 0; x < image->width; ++x) {
          const double u = (x + 0.5) / image->width, v = (y + 0.5) / image->height;
          expect_color(set.value(0, uv_at(u, v)), texel(*image, x, y), 1e-14);
          expect_color(set.value(0, uv_at(u - 3, v + 2)), texel(*image, x, y), 1e-14);
        }
    }
}

TEST(ImageTexture, ShowsTheNearestTexelOrWhatLiesBetweenFour) {
  const auto image = any_image(4, 4);
  const TextureSet set({texture_of_image(image, TextureFilter::nearest),
                        texture_of_image(image, TextureFilter::bilinear)});
  expect_color(set.value(0, uv_at(0.26, 0.74)), texel(*image, 1, 2));
  expect_color(set.value(0, uv_at(0.49, 0.51)), texel(*image, 1, 2));
  // A quarter from the middle of (1, 2) to that of (2, 2), half way up to (…, 3).
  const Color a = texel(*image, 1, 2), b = texel(*image, 2, 2), c = texel(*image, 1, 3),
              d = texel(*image, 2, 3);
  expect_color(set.value(1, uv_at(0.4375, 0.75)),
               {(3 * (a.r + c.r) + b.r + d.r) / 8, (3 * (a.g + c.g) + b.g + d.g) / 8,
                (3 * (a.b + c.b) + b.b + d.b) / 8},
               1e-12);
}

TEST(ImageTexture, GoesOnBeyondItsEdgesAsItsWrapSays) {
  const auto image = any_image(3, 2);
  const struct {
    TextureWrap wrap;
    int x;
    std::uint32_t column;
  } cases[] = {
      {TextureWrap::repeat, -1, 2}, {TextureWrap::repeat, 3, 0},  {TextureWrap::repeat, 11, 2},
      {TextureWrap::clamp, -1, 0},  {TextureWrap::clamp, 3, 2},   {TextureWrap::clamp, 11, 2},
      {TextureWrap::mirror, -1, 0}, {TextureWrap::mirror, -3, 2}, {TextureWrap::mirror, 3, 2},
      {TextureWrap::mirror, 4, 1},  {TextureWrap::mirror, 6, 0},  {TextureWrap::mirror, 11, 0},
  };
  for (const auto& c : cases)
    for (const TextureFilter filter : {TextureFilter::nearest, TextureFilter::bilinear}) {
      const TextureSet set({texture_of_image(image, filter, c.wrap)});
      expect_color(set.value(0, uv_at((c.x + 0.5) / 3, 0.25)), texel(*image, c.column, 0), 1e-14);
    }
  // On the edge itself, what is half way to the neighbour.
  const Color left = texel(*image, 0, 1), right = texel(*image, 2, 1);
  const auto on_edge = [&](TextureWrap wrap) {
    return TextureSet({texture_of_image(image, TextureFilter::bilinear, wrap)})
        .value(0, uv_at(1, 0.75))
        .x;
  };
  EXPECT_NEAR(on_edge(TextureWrap::repeat), (left.r + right.r) / 2, 1e-12);
  EXPECT_NEAR(on_edge(TextureWrap::clamp), right.r, 1e-12);
  EXPECT_NEAR(on_edge(TextureWrap::mirror), right.r, 1e-12);
}

TEST(ImageTexture, DoesNotMixTheTwoPolesOfASphere) {
  const auto image = any_image(4, 4);
  Texture twice = texture_of_image(image, TextureFilter::bilinear);
  twice.transform.along_y = {0, 0.5, 0};
  const TextureSet set({texture_of_image(image, TextureFilter::bilinear), twice});
  TexturePoint pole = uv_at(0.125, 1);
  const Color top = texel(*image, 0, 3), bottom = texel(*image, 0, 0);
  EXPECT_NEAR(set.value(0, pole).x, (top.r + bottom.r) / 2, 1e-12) << "a plane goes on";
  pole.v_ends = true;
  EXPECT_NEAR(set.value(0, pole).x, top.r, 1e-12);
  pole.v = 0;
  EXPECT_NEAR(set.value(0, pole).x, bottom.r, 1e-12);
  pole.v = 0.5;
  EXPECT_NEAR(set.value(1, pole).x, (top.r + bottom.r) / 2, 1e-12)
      << "where it is there twice, it goes on in the middle";
}

TEST(ImageTexture, InSpaceLiesInThePlaneOfXAndY) {
  const auto image = any_image(4, 4);
  Texture texture = texture_of_image(image, TextureFilter::bilinear);
  texture.mapping = TextureMapping::solid;
  expect_color(TextureSet({texture}).value(0, point_at(0.375, 0.875, -77)), texel(*image, 1, 3),
               1e-14);
}

TEST(ImageTexture, WithoutAnImageIsBlack) {
  for (const auto& image : {std::shared_ptr<const Image>(), std::make_shared<const Image>()})
    expect_color(
        TextureSet({texture_of_image(image, TextureFilter::mip)}).value(0, uv_at(0.5, 0.5)),
        {0, 0, 0});
}

/// The mean of an image over a part that is given in pixels, from the top.
double mean_over(const Image& image, double left, double top, double right, double bottom) {
  double sum = 0;
  for (std::uint32_t y = 0; y < image.height; ++y)
    for (std::uint32_t x = 0; x < image.width; ++x) {
      const double wide = std::fmin(right, x + 1.0) - std::fmax(left, x);
      const double high = std::fmin(bottom, y + 1.0) - std::fmax(top, y);
      if (wide > 0 && high > 0) sum += wide * high * static_cast<double>(image.row(y)[3 * x]);
    }
  return sum / ((right - left) * (bottom - top));
}

TEST(Pyramid, HalvesDownToOnePixelAndKeepsTheMean) {
  for (const auto& image : {any_image(64, 16), any_image(37, 23), any_image(1, 5), any_image(3, 1),
                            any_image(701, 400)}) {
    const Pyramid pyramid(image, true);
    const double mean = mean_over(*image, 0, 0, image->width, image->height);
    for (std::size_t i = 1; i < pyramid.levels(); ++i) {
      const Image &larger = pyramid.level(i - 1), &level = pyramid.level(i);
      EXPECT_EQ(level.width, std::max(larger.width / 2, 1u));
      EXPECT_EQ(level.height, std::max(larger.height / 2, 1u));
      EXPECT_NEAR(mean_over(level, 0, 0, level.width, level.height), mean, 1e-6);
      const double wide = static_cast<double>(larger.width) / level.width;
      const double high = static_cast<double>(larger.height) / level.height;
      for (std::uint32_t y = 0; y < level.height; y += 1 + level.height / 5)
        for (std::uint32_t x = 0; x < level.width; x += 1 + level.width / 5)
          ASSERT_NEAR(level.row(y)[3 * x],
                      mean_over(larger, x * wide, y * high, (x + 1) * wide, (y + 1) * high), 1e-6);
    }
    const Image& last = pyramid.level(pyramid.levels() - 1);
    EXPECT_EQ(last.width * last.height, 1u);
  }
  EXPECT_EQ(Pyramid(any_image(64, 16), false).levels(), 1u);
}

TEST(ImageTexture, LooksAtTheLevelWhoseTexelsAreAsWideAsTheFootprint) {
  const auto image = any_image(64, 32);
  const Pyramid pyramid(image, true);
  const TextureSet set({texture_of_image(image, TextureFilter::mip)});
  for (std::size_t i = 0; i < pyramid.levels(); ++i) {
    const Image& level = pyramid.level(i);
    const double w = static_cast<double>(image->width) / level.width;
    const double u = 0.5 / level.width, v = 0.5 / level.height;
    // As a circle, turned, and with axes that a map has turned towards each other.
    for (const auto& at : {uv_at(u, v, *image, {{w, 0}, {0, w}}),
                           uv_at(u, v, *image, {{0.6 * w, 0.8 * w}, {-0.8 * w, 0.6 * w}})})
      expect_color(set.value(0, at), texel(level, 0, 0), 1e-6);
  }
  // Between two levels, by the logarithm.
  const double w = std::sqrt(8.);
  const Color fine = texel(pyramid.level(1), 0, 0);
  const TextureValue middle = set.value(0, uv_at(1 / 64., 1 / 32., *image, {{w, 0}, {0, w}}));
  TexturePoint coarse = uv_at(1 / 64., 1 / 32., *image, {{4, 0}, {0, 4}});
  EXPECT_NEAR(middle.x, (fine.r + set.value(0, coarse).x) / 2, 1e-6);
  // From the widest on, the mean of all.
  const double mean = mean_over(*image, 0, 0, 64, 32);
  for (const double far : {64., 1e3, 1e20})
    EXPECT_NEAR(set.value(0, uv_at(0.3, 0.7, *image, {{far, 0}, {0, far}})).x, mean, 1e-6);
}

TEST(ImageTexture, StaysSharpAcrossALongFootprint) {
  // Rows of colours: along a row nothing changes, from row to row all.
  Image rows(64, 64);
  const auto random = any_image(1, 64);
  for (std::uint32_t y = 0; y < 64; ++y)
    for (std::uint32_t x = 0; x < 64; ++x)
      for (std::size_t c = 0; c < 3; ++c) rows.row(y)[3 * x + c] = random->row(y)[c];
  const auto image = std::make_shared<const Image>(rows);
  const TextureSet set({texture_of_image(image, TextureFilter::mip)});
  for (std::uint32_t y = 0; y < 64; ++y) {
    const double v = (y + 0.5) / 64;
    expect_color(set.value(0, uv_at(0.3, v, *image, {{16, 0}, {0, 1}})), texel(*image, 0, y),
                 1e-12);
    expect_color(set.value(0, uv_at(0.3, v, *image, {{0, 0.5}, {12, 0}})), texel(*image, 0, y),
                 1e-12);
    // The same ellipse by two other half axes of it, which are not at right angles.
    const double s = std::sqrt(0.5);
    expect_color(set.value(0, uv_at(0.3, v, *image, {{16 * s, s}, {-16 * s, s}})),
                 texel(*image, 0, y), 1e-9);
  }
}

TEST(ImageTexture, IsTheMeanAlongALongFootprint) {
  const auto image = any_image(64, 64);
  const TextureSet mip({texture_of_image(image, TextureFilter::mip)});
  const TextureSet point({texture_of_image(image, TextureFilter::bilinear)});
  for (const auto& axis : {Point{16, 0, 0}, Point{0, 16, 0}, Point{9.6, 12.8, 0}}) {
    double sum = 0;
    for (int i = 0; i < 1600; ++i) {
      const double share = (i + 0.5) / 1600 - 0.5;
      sum += point.value(0, uv_at(0.4 + share * axis.x / 64, 0.9 + share * axis.y / 64)).x;
    }
    const double across[] = {-axis.y / 16, axis.x / 16};
    const double value =
        mip.value(0, uv_at(0.4, 0.9, *image, {{axis.x, axis.y}, {across[0], across[1]}})).x;
    EXPECT_NEAR(value, sum / 1600, 0.01);
  }
}

TEST(ImageTexture, DoesNotShimmerOnAFloorToTheHorizon) {
  // Black and white texels, seen so flat that a pixel is 1 texel wide and hundreds long: grey all
  // over.
  Image board(64, 64);
  for (std::uint32_t y = 0; y < 64; ++y)
    for (std::uint32_t x = 0; x < 64; ++x)
      for (std::size_t c = 0; c < 3; ++c) board.row(y)[3 * x + c] = (x + y) % 2 == 0 ? 1 : 0;
  const auto image = std::make_shared<const Image>(board);
  const TextureSet set({texture_of_image(image, TextureFilter::mip)});
  Random random(1);
  for (int i = 0; i < 500; ++i) {
    const auto at = uv_at(any(random, 9), any(random, 9), *image,
                          {{1, 0}, {any(random, 0.3), 150 + 300 * random.unit()}});
    EXPECT_NEAR(set.value(0, at).x, 0.5, 0.01);
  }
}

TEST(TextureSet, CountsTheMemoryOfSmallerImages) {
  const auto image = any_image(64, 32);
  EXPECT_EQ(TextureSet({texture_of_image(image, TextureFilter::bilinear)}).bytes(), 0u);
  const std::uint64_t texels = 32 * 16 + 16 * 8 + 8 * 4 + 4 * 2 + 2 + 1;
  EXPECT_EQ(TextureSet({texture_of_image(image, TextureFilter::mip)}).bytes(), texels * 12);
  EXPECT_TRUE(TextureSet().empty());
}

/// Columns of 0, 80, 160 and 240.
std::shared_ptr<const Image> four_columns() {
  Image image(4, 4);
  for (std::uint32_t y = 0; y < 4; ++y)
    for (std::uint32_t x = 0; x < 4; ++x)
      for (std::size_t c = 0; c < 3; ++c)
        image.row(y)[std::size_t{3} * x + c] = static_cast<float>(80 * x) / 255;
  return std::make_shared<const Image>(std::move(image));
}

TEST(ImagesByDistance, AreTakenFromSmallerOnes) {
  Texture texture = texture_of_image(four_columns(), TextureFilter::distance);
  texture.reach = 10;
  const TextureSet set({texture});
  const auto value = [&](double u, double distance) {
    TexturePoint at;
    at.u = u, at.v = 0.3;
    at.distance = distance;
    return set.value(0, at).x * 255;
  };
  // Of a level the first and the last column stand at 0 and 1.
  EXPECT_NEAR(value(0, 0), 0, 1e-4);
  EXPECT_NEAR(value(0.5, 0), 120, 1e-4);
  EXPECT_NEAR(value(1 - 1e-9, 0), 240, 1e-4);
  EXPECT_NEAR(value(1, 0), 0, 1e-4);
  // The next has 40 and 200, the last one 120; three levels are spread over the reach.
  EXPECT_NEAR(value(0, 2), 0.2 * 2.0001 * 40, 1e-3);
  EXPECT_NEAR(value(0.25, 2), 60 + 0.2 * 2.0001 * (80 - 60), 1e-3);
  EXPECT_NEAR(value(0.25, 6), 120, 1e-4) << "the last but one is not looked at";
  EXPECT_NEAR(value(0.25, 100), 120, 1e-4);
}

TEST(ImagesByDistance, SeeTheWholeWayFromTheEye) {
  // A mirror at z = 0 shows a wall at z = 6 to an eye at z = 4: 10 units of way.
  Scene scene;
  scene.resolution = {3, 3};
  scene.camera = {{0, 0, 4}, {0, 0, 0}, {0.001, 0, 0}, {0, 0.001, 0}};
  scene.ambient_light = {1, 1, 1};
  scene.materials = {{.ambient = {}, .diffuse = {}, .reflection = 1}, {.ambient = {1, 1, 1}}};
  scene.parallelograms = {{Parallelogram{{-1, -1, 0}, {2, 0, 0}, {0, 2, 0}}, 0},
                          {Parallelogram{{-3, -3, 6}, {6, 0, 0}, {0, 6, 0}}, 1}};
  Texture texture = texture_of_image(four_columns(), TextureFilter::distance);
  texture.mapping = TextureMapping::solid;  // the wall's middle is the picture's left edge
  texture.reach = 40;
  scene.textures = {texture};
  scene.materials[1].textures = {{Coefficient::ambient, 0}};
  const Result<Rendering> rendering = render(scene);
  ASSERT_TRUE(rendering);
  EXPECT_NEAR(rendering->image.row(1)[3] * 255, 0.25 * 2.0001 * 40, 0.1);
}

/// Coefficients of a material often have one picture in several strengths; what is known of the
/// first serves the others, and nothing else.
TEST(TextureLookup, GivesWhatEachTextureGivesByItself) {
  Image large(13, 7), small(6, 7);
  Random random(3);
  for (Image* image : {&large, &small})
    for (float& v : image->pixels) v = static_cast<float>(random.unit());
  Texture first = texture_of_image(std::make_shared<Image>(large), TextureFilter::distance);
  first.reach = 20;
  std::vector<Texture> all(12, first);
  for (float& v : large.pixels) v *= 0.5f;
  all[1].image = std::make_shared<Image>(large);
  all[2].image = std::make_shared<Image>(small);
  all[3].reach = 7;
  all[4].filter = TextureFilter::bilinear;
  all[5].filter = TextureFilter::mip;
  all[6].mapping = TextureMapping::sphere;
  all[7].mapping = TextureMapping::cylinder;
  all[8].mapping = TextureMapping::solid, all[8].transform.along_x = {0.5, 0.25, 0};
  all[9] = all[8], all[9].image = all[1].image;
  all[10].mapping = TextureMapping::cylinder, all[10].repeat_u = 3;
  all[11].kind = TextureKind::checker;
  const TextureSet set(all);
  const auto any = [&] { return 8 * random.unit() - 4; };
  for (int i = 0; i < 3000; ++i) {
    TexturePoint at = footprint_at({any(), any(), any()}, {any(), any(), 0}, {0, any(), any()});
    at.u = any(), at.v = any(), at.distance = 10 + 2 * any();
    TextureLookup known;
    for (int ask = 0; ask < 6; ++ask) {
      const auto texture = static_cast<std::uint32_t>(random.below(all.size()));
      const TextureValue wanted = set.value(texture, at), value = set.value(texture, at, known);
      ASSERT_TRUE(value.x == wanted.x && value.y == wanted.y && value.z == wanted.z) << texture;
    }
  }
}

}  // namespace
}  // namespace zraka
