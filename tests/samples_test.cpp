// SPDX-License-Identifier: Apache-2.0
// Pictures of several samples a pixel, of all cameras and filters, and crops of them.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstring>
#include <mutex>
#include <string>
#include <utility>
#include <vector>
#include <zraka/explain.hpp>
#include <zraka/render.hpp>

#include "scenes.hpp"

namespace zraka {
namespace {

constexpr PixelFilter kFilters[] = {PixelFilter::box, PixelFilter::tent, PixelFilter::gauss,
                                    PixelFilter::mitchell};
Scene tangled(CameraKind kind, double aperture = 0, std::uint32_t width = 50,
              std::uint32_t height = 37) {
  Scene scene = tangled_scene();
  scene.resolution = {width, height};
  scene.camera.kind = kind;
  scene.camera.aperture = aperture;
  scene.camera.focus_distance = 3;
  return scene;
}

Sampling adaptive(int count, int most, double contrast = 0.05) {
  Sampling sampling{.kind = Sampling::Kind::adaptive, .count = count, .most = most};
  sampling.contrast = contrast;
  return sampling;
}

/// Some of everything: how many samples, and by which filter.
std::vector<Sampling> samplings() {
  std::vector<Sampling> all;
  for (const PixelFilter filter : kFilters)
    for (Sampling sampling : {Sampling{.count = 3},
                              Sampling{.kind = Sampling::Kind::grid, .count = 2}, adaptive(2, 9)}) {
      sampling.filter = filter;
      all.push_back(sampling);
    }
  all.push_back({});
  return all;
}

/// The part of an image.
Image cut(const Image& image, const PixelRect& part) {
  Image out(part.width, part.height);
  for (std::uint32_t y = 0; y < part.height; ++y)
    std::copy_n(image.row(part.y + y) + 3 * part.x, 3 * part.width, out.row(y));
  return out;
}

struct NamedView {
  std::string name;
  Scene scene;
};

std::vector<NamedView> views(std::uint32_t width = 50, std::uint32_t height = 37) {
  const auto view = [&](CameraKind kind, double aperture = 0) {
    return tangled(kind, aperture, width, height);
  };
  return {{"pinhole", view(CameraKind::pinhole)},
          {"lens", view(CameraKind::pinhole, 0.3)},
          {"orthographic", view(CameraKind::orthographic)},
          {"fisheye", view(CameraKind::fisheye)},
          {"panorama", view(CameraKind::panorama)}};
}

TEST(Samples, GiveTheSameBitsHoweverTheyAreComputed) {
  for (const NamedView& view : views(24, 19))
    for (const Sampling& sampling : samplings()) {
      RenderOptions options{.max_depth = 1, .sampling = sampling};
      options.isa = Isa::portable;
      options.threads = 1;
      const Rendering whole = render(view.scene, options).value();
      const std::string want = sha256(whole.image);
      struct Way {
        int threads, tile;
      };
      const std::vector<Isa> isas = available_isas();
      for (const Isa isa : isas)
        for (const Way way : {Way{2, 7}, {3, 0}, {1, 64}}) {
          if (isa != isas.front() && way.tile != 7) continue;
          options.isa = isa;
          options.threads = way.threads;
          options.tile = way.tile;
          const Rendering got = render(view.scene, options).value();
          ASSERT_EQ(sha256(got.image), want)
              << view.name << ", filter " << static_cast<int>(sampling.filter) << ", kind "
              << static_cast<int>(sampling.kind) << ", " << name_of(isa) << ", tile " << way.tile;
          ASSERT_EQ(got.samples, whole.samples);
        }
      for (const PixelRect crop : {PixelRect{0, 0, 24, 19}, {11, 5, 9, 8}, {23, 18, 1, 1}}) {
        options.crop = crop;
        ASSERT_EQ(sha256(render(view.scene, options).value().image), sha256(cut(whole.image, crop)))
            << view.name << ", filter " << static_cast<int>(sampling.filter) << ", kind "
            << static_cast<int>(sampling.kind);
      }
    }
}

TEST(Crop, HasTheBitsOfItsPartInAllProfiles) {
  const Scene scene = tangled(CameraKind::pinhole);
  for (const ProfileName profile : {ProfileName::lab, ProfileName::physical, ProfileName::spd}) {
    RenderOptions options{.profile = profile_of(profile)};
    const Image whole = render(scene, options).value().image;
    for (const PixelRect crop : {PixelRect{0, 0, 50, 37}, {7, 9, 30, 21}, {49, 0, 1, 37}}) {
      options.crop = crop;
      const Rendering part = render(scene, options).value();
      ASSERT_EQ(part.image.width, crop.width);
      ASSERT_EQ(part.image.height, crop.height);
      ASSERT_EQ(sha256(part.image), sha256(cut(whole, crop))) << name_of(profile);
    }
  }
}

TEST(Samples, OfOneAreTodaysPicture) {
  const Scene scene = tangled(CameraKind::pinhole);
  for (const ProfileName profile : {ProfileName::lab, ProfileName::physical, ProfileName::spd}) {
    RenderOptions options{.profile = profile_of(profile)};
    const std::string want = sha256(render(scene, options).value().image);
    options.sampling.seed = 5;
    options.sampling.contrast = 1;
    EXPECT_EQ(sha256(render(scene, options).value().image), want);
    options.sampling.kind = Sampling::Kind::grid;
    EXPECT_EQ(sha256(render(scene, options).value().image), want);
  }
}

/// A sheet that everything sees, of one colour.
Scene sheet() {
  Scene scene = lab_scene(12);
  scene.resolution = {12, 9};
  scene.lights.clear();
  scene.materials = {{.ambient = {0.1, 1.0 / 3, 0.7}, .diffuse = {}}};
  scene.ambient_light = {1, 1, 1};
  scene.triangles.push_back({{{-90, -90, -3}, {90, -90, -3}, {0, 190, -3}}, 0});
  return scene;
}

TEST(Filters, KeepAConstantPictureConstant) {
  Scene scene = sheet();
  RenderOptions options;
  const Image want = render(scene, options).value().image;
  for (const float* p = want.pixels.data(); p != want.pixels.data() + want.pixels.size(); ++p)
    ASSERT_EQ(*p, want.pixels[static_cast<std::size_t>((p - want.pixels.data()) % 3)]);
  for (const PixelFilter filter : kFilters)
    for (int count = 1; count < 70; count = count * 2 + 1) {
      options.sampling = {.count = count, .filter = filter};
      ASSERT_EQ(sha256(render(scene, options).value().image), sha256(want))
          << static_cast<int>(filter) << ", " << count;
    }
}

/// White left of x, seen by parallel rays in a picture of pixels of side 1 around the origin.
Scene half_plane(double x, std::uint32_t width, std::uint32_t height) {
  Scene scene;
  scene.resolution = {width, height};
  scene.camera.kind = CameraKind::orthographic;
  scene.camera.eye = {0, 0, 2};
  scene.camera.window_right = {static_cast<double>(width), 0, 0};
  scene.camera.window_up = {0, static_cast<double>(height), 0};
  scene.materials = {{.ambient = {1, 1, 1}, .diffuse = {}}};
  scene.ambient_light = {1, 1, 1};
  scene.triangles.push_back({{{x, -500, 0}, {x, 500, 0}, {-500, 0, 0}}, 0});
  return scene;
}

TEST(Grid, OfAHalfCoveredPixelIsTheExactFraction) {
  for (int covered = 0; covered <= 8; ++covered) {
    const Scene scene = half_plane(covered / 8.0, 4, 2);  // cuts pixel column 2
    RenderOptions options;
    options.sampling = {.kind = Sampling::Kind::grid, .count = 8};
    const Image image = render(scene, options).value().image;
    for (std::uint32_t y = 0; y < 2; ++y) {
      EXPECT_EQ(image.row(y)[3 * 1], 1.0f);
      EXPECT_EQ(image.row(y)[3 * 2], static_cast<float>(covered) / 8);
      EXPECT_EQ(image.row(y)[3 * 3], 0.0f);
    }
    // Sobol's first eight have one in each eighth, too.
    options.sampling = {.count = 8};
    EXPECT_EQ(render(scene, options).value().image.row(0)[3 * 2], static_cast<float>(covered) / 8);
  }
}

TEST(Grid, LooksThroughTheMiddlesOfItsSquares) {
  RenderOptions options;
  options.sampling = {.kind = Sampling::Kind::grid, .count = 8};
  for (const auto& [covered, want] : {std::pair{3.45, 3.0f}, {3.55, 4.0f}}) {
    EXPECT_EQ(render(half_plane(covered / 8, 4, 2), options).value().image.row(0)[3 * 2], want / 8);
    // The same edge from above.
    Scene turned = half_plane(covered / 8, 4, 4);
    turned.camera.window_right = {0, -4, 0};
    turned.camera.window_up = {-4, 0, 0};
    EXPECT_EQ(render(turned, options).value().image.row(2)[0], want / 8);
  }
}

TEST(Filters, BlurAnEdgeAsTheirIntegralHasIt) {
  // The edge is in the middle, between two pixels: pixel k to its right has what of the filter lies
  // to the left of -k - 1/2.
  const Scene scene = half_plane(0, 8, 3);
  struct Case {
    PixelFilter filter;
    double first, second;
  };
  const double gauss = std::erf(1.5 * std::sqrt(2.0));
  // Mitchell's, from a to 2: with s = 2 - a it is (7·s⁴/4 - 2·s³)/18 for a ≥ 1; within 1 its other
  // piece has an integral of its own.
  const auto outer = [](double a) {
    const double s = 2 - a;
    return (7 * s * s * s * s / 4 - 2 * s * s * s) / 18;
  };
  const auto inner = [](double x) {
    return (7 * x * x * x * x / 4 - 4 * x * x * x + 16 * x / 3) / 6;
  };
  const Case cases[] = {
      {PixelFilter::box, 0, 0},
      {PixelFilter::tent, 0.125, 0},
      {PixelFilter::gauss, (gauss - std::erf(0.5 * std::sqrt(2.0))) / (2 * gauss), 0},
      {PixelFilter::mitchell, outer(1) + inner(1) - inner(0.5), outer(1.5)}};
  for (const Case& c : cases) {
    RenderOptions options;
    options.sampling = {.count = 16384, .filter = c.filter};
    const Image image = render(scene, options).value().image;
    EXPECT_NEAR(image.row(1)[3 * 4], c.first, 1.5e-3) << static_cast<int>(c.filter);
    EXPECT_NEAR(image.row(1)[3 * 5], c.second, 1.5e-3) << static_cast<int>(c.filter);
    EXPECT_NEAR(image.row(1)[3 * 3], 1 - c.first, 1.5e-3) << static_cast<int>(c.filter);
  }
}

TEST(Adaptive, SpendsItsSamplesAtEdges) {
  const Scene scene = half_plane(0.25, 16, 8);  // through pixel column 8
  RenderOptions options;
  options.sampling = adaptive(4, 64);
  const Rendering rendering = render(scene, options).value();
  ASSERT_EQ(rendering.samples.size(), 16u * 8u);
  double sum = 0;
  for (std::uint32_t y = 0; y < 8; ++y)
    for (std::uint32_t x = 0; x < 16; ++x) {
      // Its neighbours differ from it as well.
      const std::uint32_t want = x >= 7 && x <= 9 ? 64 : 4;
      EXPECT_EQ(rendering.samples[y * 16 + x], want) << x << ", " << y;
      sum += want;
    }
  EXPECT_EQ(rendering.stats.samples_per_pixel, sum / 128);
  EXPECT_EQ(rendering.stats.rays.camera, static_cast<std::uint64_t>(sum));
  // Where it has had 64, it is what 64 everywhere are.
  options.sampling = {.count = 64};
  const Rendering even = render(scene, options).value();
  EXPECT_EQ(sha256(even.image), sha256(rendering.image));
  EXPECT_TRUE(even.samples.empty());
  EXPECT_EQ(even.stats.samples_per_pixel, 64);
  EXPECT_EQ(even.stats.rays.camera, 64u * 128u);
  // Where all may differ, none has more.
  options.sampling = adaptive(4, 64, 1);
  EXPECT_EQ(render(scene, options)->stats.samples_per_pixel, 4);
}

/// Stripes of half a pixel, from the left edge of each: all pixels have the same mean.
Scene stripes(double color) {
  Scene scene = half_plane(-500, 8, 4);
  scene.triangles.clear();
  scene.materials[0].ambient = {color, color, color};
  for (int x = -4; x < 4; ++x)
    scene.triangles.push_back({{{x + 0.0, -90, 0}, {x + 0.5, -90, 0}, {x + 0.25, 1e6, 0}}, 0});
  return scene;
}

TEST(Adaptive, SeesWhatNeighboursHaveInCommonByTheSamples) {
  RenderOptions options;
  options.sampling = adaptive(4, 32);
  EXPECT_EQ(render(stripes(1), options)->stats.samples_per_pixel, 32);
  options.sampling.contrast = 0.5;
  EXPECT_EQ(render(stripes(0.4), options)->stats.samples_per_pixel, 4);
}

TEST(Adaptive, ComparesColoursAsTheyAreShown) {
  Scene scene = stripes(7);
  scene.background = {3, 3, 3};
  RenderOptions options;
  options.sampling = adaptive(4, 32);
  EXPECT_EQ(render(scene, options)->stats.samples_per_pixel, 4) << "both are white";
  scene.background = {0.5, 3, 3};
  EXPECT_EQ(render(scene, options)->stats.samples_per_pixel, 32);
}

TEST(Adaptive, StopsAtAnyGreatestNumber) {
  RenderOptions options;
  options.sampling = adaptive(3, 17);
  const Rendering rendering = render(half_plane(0.25, 16, 8), options).value();
  EXPECT_EQ(*std::max_element(rendering.samples.begin(), rendering.samples.end()), 17u);
  EXPECT_EQ(*std::min_element(rendering.samples.begin(), rendering.samples.end()), 3u);
}

TEST(Samples, WinOverTheMeanOfCorners) {
  const Scene scene = half_plane(0.25, 16, 8);
  RenderOptions options{.profile = profile_of(ProfileName::spd)};
  options.sampling = {.kind = Sampling::Kind::grid, .count = 8};
  const Rendering rendering = render(scene, options).value();
  EXPECT_EQ(rendering.image.width, 16u);
  EXPECT_EQ(rendering.stats.rays.camera, 64u * 128u);
  // A pixel is between its corners.
  EXPECT_EQ(rendering.image.row(3)[3 * 8], 0.25f);
  // The lab's pixel is its upper left corner, and a box around that.
  options.profile = profile_of(ProfileName::lab);
  EXPECT_EQ(render(scene, options).value().image.row(3)[3 * 8], 0.75f);
}

TEST(Samples, OfClampedColoursAreClampedBeforeTheyAreAveraged) {
  Scene scene = half_plane(0.5, 4, 2);
  scene.materials[0].ambient = {4, 4, 4};
  RenderOptions options{.profile = profile_of(ProfileName::lab)};
  options.sampling = {.kind = Sampling::Kind::grid, .count = 8};
  EXPECT_EQ(render(scene, options).value().image.row(0)[3 * 2], 1.0f);
  options.profile = profile_of(ProfileName::physical);
  EXPECT_EQ(render(scene, options).value().image.row(0)[3 * 2], 2.0f);
}

TEST(Samples, DependOnTheSeed) {
  const Scene scene = tangled(CameraKind::pinhole);
  RenderOptions options;
  options.sampling = {.count = 4};
  const std::string zero = sha256(render(scene, options).value().image);
  options.sampling.seed = 1;
  EXPECT_NE(sha256(render(scene, options).value().image), zero);
}

TEST(Samples, ComeNearerToThePictureTheMoreThereAre) {
  const Scene scene = tangled(CameraKind::pinhole);
  RenderOptions options{.max_depth = 0};
  options.sampling = {.count = 2048};
  options.crop = {{10, 8, 24, 20}};
  const Image want = render(scene, options).value().image;
  const auto error = [&](int count) {
    options.sampling = {.count = count, .seed = 3};
    const Image image = render(scene, options).value().image;
    double squares = 0;
    for (std::size_t i = 0; i < image.pixels.size(); ++i)
      squares += std::pow(static_cast<double>(image.pixels[i] - want.pixels[i]), 2);
    return std::sqrt(squares / static_cast<double>(image.pixels.size()));
  };
  const double few = error(4), many = error(64);
  EXPECT_GT(few / many, 5) << "random samples would gain 4";
}

/// How many pixels are not black.
int lit_pixels(const Image& image) {
  int lit = 0;
  for (std::size_t i = 0; i < image.pixels.size(); i += 3) lit += image.pixels[i] > 0;
  return lit;
}

TEST(Orthographic, SizesDoNotDependOnDistance) {
  int sizes[2] = {};
  for (const int far : {0, 1}) {
    Scene scene = lab_scene(64);
    scene.camera.kind = CameraKind::orthographic;
    add_sphere(scene, {0.1, 0, far == 1 ? -64.0 : -1.0}, 0.5, {.ambient = {1, 1, 1}});
    sizes[far] = lit_pixels(render(scene, {}).value().image);
  }
  EXPECT_EQ(sizes[0], sizes[1]);
  // A circle of 16 pixels' radius.
  EXPECT_NEAR(sizes[0], 3.14159 * 16 * 16, 16);
}

TEST(Lens, BlursASmallSphereToItsCircleOfConfusion) {
  Scene scene = lab_scene(200);
  scene.camera.eye = {0, 0, 0};
  scene.camera.window_center = {0, 0, -1};
  scene.camera.aperture = 0.8;
  scene.camera.focus_distance = 4;
  add_sphere(scene, {0, 0, -8}, 0.02, {.ambient = {1, 1, 1}});
  RenderOptions options;
  options.sampling = {.count = 256};
  options.crop = {{85, 85, 30, 30}};
  const auto width = [&] {
    const Image image = render(scene, options).value().image;
    int left = 30, right = -1;
    for (int y = 0; y < 30; ++y)
      for (int x = 0; x < 30; ++x)
        if (image.row(static_cast<std::uint32_t>(y))[3 * x] > 0)
          left = std::min(left, x), right = std::max(right, x);
    return right - left + 1;
  };
  // On the plane in focus a pixel is 8/200 wide; the lens' diameter is seen there as half of it,
  // 0.4, so ten pixels, and the sphere 0.02 more on each side, halved.
  EXPECT_NEAR(width(), 10.5, 1.1);
  scene.camera.focus_distance = 8;
  EXPECT_LE(width(), 2);
}

TEST(Fisheye, IsBlackBeyondAHalfTurn) {
  Scene scene = lab_scene(40);
  scene.camera.kind = CameraKind::fisheye;
  scene.camera.fov_deg = 360;
  scene.background = {0.5, 0.25, 1};
  add_sphere(scene, {0, 0, -4}, 1, {});
  RenderOptions options;
  options.sampling = {.count = 16};
  const Rendering rendering = render(scene, options).value();
  const Image& image = rendering.image;
  EXPECT_EQ(image.row(0)[0], 0.0f);
  EXPECT_EQ(image.row(0)[2], 0.0f);
  EXPECT_EQ(image.row(1)[3 * 20], 0.5f);
  EXPECT_EQ(image.row(20)[3 * 1], 0.5f);
  // A circle of 20 pixels' radius: no rays go where nothing is seen.
  EXPECT_NEAR(static_cast<double>(rendering.stats.rays.camera), 3.14159 * 400 * 16, 100);
}

TEST(Explainer, TellsOfSamplesThatAddUpToThePixel) {
  for (const NamedView& view : views()) {
    RenderOptions options{.max_depth = 2};
    options.sampling = {.count = 4};
    const Image image = render(view.scene, options).value().image;
    Explainer explainer = Explainer::create(view.scene, options).value();
    for (const std::uint32_t x : {12u, 25u, 31u}) {
      double sums[3] = {};
      for (std::uint32_t sample = 0; sample < 4; ++sample)
        for (int c = 0; c < 3; ++c)
          sums[c] += static_cast<double>(
              explainer.pixel(x, 18, sample).value().color[static_cast<std::size_t>(c)]);
      for (int c = 0; c < 3; ++c)
        EXPECT_EQ(static_cast<float>(sums[c] / 4), image.row(18)[3 * x + static_cast<unsigned>(c)])
            << view.name;
    }
    EXPECT_EQ(explainer.pixel(0, 0, 4).error().front().message, "a pixel of this picture has 4 samples at most");
    EXPECT_EQ(explainer.around(25, 18, 9).image.row(4)[3 * 4], image.row(18)[3 * 25]) << view.name;
  }
}

TEST(Explainer, TellsOfAPixelOfAnyCamera) {
  for (const NamedView& view : views()) {
    const RenderOptions options{.max_depth = 2};
    const Image image = render(view.scene, options).value().image;
    const Explanation explanation = explain(view.scene, options, 25, 18).value();
    EXPECT_EQ(explanation.color[0], image.row(18)[3 * 25]) << view.name;
    EXPECT_EQ(explanation.color[2], image.row(18)[3 * 25 + 2]) << view.name;
  }
  Scene scene = tangled(CameraKind::fisheye);
  scene.camera.fov_deg = 360;
  EXPECT_EQ(explain(scene, {}, 0, 0).error().front().message,
            "the camera sees nothing at pixel (0, 0)");
}

TEST(Progress, CountsPixelsOnceHoweverManySamplesTheyHave) {
  const Scene scene = tangled(CameraKind::pinhole);
  for (const Sampling& sampling : {Sampling{}, Sampling{.count = 5}, adaptive(2, 16)})
    for (const bool crop : {false, true}) {
      RenderOptions options;
      options.sampling = sampling;
      options.tile = 8;
      options.threads = 1;
      if (crop) options.crop = {{3, 4, 20, 21}};
      std::uint64_t last = 0, last_rays = 0;
      const std::uint64_t pixels = crop ? 20 * 21 : 50 * 37;
      options.progress = [&](std::uint64_t done, std::uint64_t all, std::uint64_t rays) {
        EXPECT_EQ(all, pixels);
        EXPECT_GE(done, last);
        EXPECT_LE(done, all);
        last = done, last_rays = rays;
      };
      const Rendering rendering = render(scene, options).value();
      EXPECT_EQ(last, pixels);
      EXPECT_EQ(last_rays, rendering.stats.rays.total());
    }
}

TEST(Samples, EndEarlyWhereThatIsWanted) {
  const Scene scene = tangled(CameraKind::pinhole);
  for (const Sampling& sampling : {Sampling{.count = 5}, adaptive(2, 16)}) {
    std::atomic<bool> cancel{false};
    RenderOptions options;
    options.sampling = sampling;
    options.tile = 4;
    options.cancel = &cancel;
    options.progress = [&](std::uint64_t, std::uint64_t, std::uint64_t) { cancel = true; };
    const Result<Rendering> rendering = render(scene, options);
    ASSERT_FALSE(rendering);
    EXPECT_EQ(rendering.error().front().message, "the render was cancelled");
  }
}

std::string answer(const RenderOptions& options) {
  const Result<Rendering> rendering = render(tangled(CameraKind::pinhole), options);
  return rendering ? "" : rendering.error().front().message;
}

TEST(RenderOptions, OfSamplingAreChecked) {
  const auto of_sampling = [](const Sampling& sampling) {
    RenderOptions options;
    options.sampling = sampling;
    return answer(options);
  };
  EXPECT_EQ(of_sampling({.count = 0}), "number of samples 0 is out of range: 1 to 65536");
  EXPECT_EQ(of_sampling({.count = 65537}), "number of samples 65537 is out of range: 1 to 65536");
  EXPECT_EQ(of_sampling({.kind = Sampling::Kind::grid, .count = 257}),
            "grid 257 is out of range: 1 to 256");
  EXPECT_EQ(of_sampling(adaptive(8, 4)),
            "greatest number of samples 4 is out of range: 8 to 65536");
  EXPECT_EQ(of_sampling(adaptive(4, 8, -0.1)), "contrast -0.1 is out of range: 0 to 1");
  EXPECT_EQ(of_sampling(adaptive(4, 8, std::nan(""))), "contrast nan is out of range: 0 to 1");
  RenderOptions options;
  options.wavelengths = 0;
  EXPECT_EQ(answer(options), "number of wavelengths 0 is out of range: 1 to 64");
  options = {};
  options.min_contribution = -1;
  EXPECT_EQ(answer(options), "least contribution -1 is out of range: 0 or more");
}

TEST(RenderOptions, OfCropsAreChecked) {
  RenderOptions options;
  options.crop = {{10, 10, 0, 5}};
  EXPECT_EQ(answer(options), "the crop has no pixels");
  for (const PixelRect outside :
       {PixelRect{1, 0, 50, 37}, {0, 1, 50, 37}, {0xFFFFFFFFu, 0, 50, 37}}) {
    options.crop = outside;
    EXPECT_EQ(answer(options), "the crop of 50×37 pixels from (" + std::to_string(outside.x) +
                                   ", " + std::to_string(outside.y) +
                                   ") on is not within the picture of 50×37 pixels");
  }
}

}  // namespace
}  // namespace zraka
