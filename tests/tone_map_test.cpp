// SPDX-License-Identifier: Apache-2.0
// Tone curves against their formulas.
#include "image/tone_map.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

namespace zraka {
namespace {

/// A grey light, mapped.
float mapped(float light, const ToneMapping& mapping) {
  float pixel[3] = {light, light, light};
  ToneMapper(mapping).apply(pixel, 1);
  EXPECT_EQ(pixel[0], pixel[1]);
  return pixel[1];
}

TEST(ToneMap, ClampDoesNothingWithoutExposure) {
  EXPECT_TRUE(ToneMapper({}).does_nothing());
  EXPECT_FALSE(ToneMapper({.exposure = 0.1}).does_nothing());
  EXPECT_FALSE(ToneMapper({ToneCurve::filmic}).does_nothing());
  EXPECT_EQ(mapped(0.25f, {}), 0.25f);
  EXPECT_EQ(mapped(7, {}), 1);
}

TEST(ToneMap, ExposureIsInStops) {
  for (const int stops : {-20, -3, 0, 1, 2, 7})
    EXPECT_EQ(mapped(0.3f * 0x1p-7f, {.exposure = static_cast<double>(stops)}),
              std::ldexp(0.3f, stops - 7));
  EXPECT_NEAR(mapped(0.25f, {.exposure = 0.5}), 0.25 * std::sqrt(2.0), 1e-7);
}

TEST(ToneMap, ReinhardIsOfLuminanceAndKeepsHues) {
  for (const double white : {1.5, 4.0, 100.0})
    for (const float l : {0.01f, 0.18f, 1.0f, 1.4f}) {
      const double light = static_cast<double>(l);
      EXPECT_NEAR(mapped(l, {ToneCurve::reinhard, 0, white}),
                  light * (1 + light / (white * white)) / (1 + light), 1e-6);
    }
  EXPECT_NEAR(mapped(4, {ToneCurve::reinhard}), 1, 1e-6);  // the usual white
  EXPECT_LT(mapped(3.9f, {ToneCurve::reinhard}), 1);
  float pixel[3] = {0.5f, 1.0f, 0.25f};
  ToneMapper({ToneCurve::reinhard}).apply(pixel, 1);
  EXPECT_NEAR(pixel[0] / pixel[1], 0.5, 1e-6);
  EXPECT_NEAR(pixel[2] / pixel[1], 0.25, 1e-6);
}

TEST(ToneMap, FilmicIsHablesCurve) {
  // As his page has it: bias 2, white 11.2 behind the bias.
  const auto curve = [](double x) {
    return (x * (0.15 * x + 0.05) + 0.004) / (x * (0.15 * x + 0.5) + 0.06) - 0.02 / 0.3;
  };
  for (const float l : {0.001f, 0.18f, 1.0f, 3.0f})
    EXPECT_NEAR(mapped(l, {ToneCurve::filmic}), curve(2 * static_cast<double>(l)) / curve(11.2),
                1e-6);
  EXPECT_EQ(mapped(5.6f, {ToneCurve::filmic}), 1);
  EXPECT_EQ(mapped(3, {ToneCurve::filmic, 0, 3}), 1);
}

TEST(ToneMap, CurvesGrowFromBlackToWhite) {
  constexpr float kInfinity = std::numeric_limits<float>::infinity();
  for (const ToneCurve curve : {ToneCurve::clamp, ToneCurve::reinhard, ToneCurve::filmic}) {
    float before = 0;
    for (int i = -40; i < 40; ++i) {
      const float now = mapped(std::exp2(static_cast<float>(i) / 4), {curve});
      EXPECT_GE(now, before);
      EXPECT_LE(now, 1);
      before = now;
    }
    for (const float no_light : {0.0f, -1.0f, -kInfinity, std::nanf("")})
      EXPECT_EQ(mapped(no_light, {curve}), 0);
    for (const float bright : {1e38f, kInfinity})
      for (const double exposure : {0.0, 100.0}) EXPECT_EQ(mapped(bright, {curve, exposure}), 1);
  }
}

TEST(ToneMap, NamesAreThoseOfTheCurves) {
  EXPECT_EQ(tone_curve_named("reinhard"), ToneCurve::reinhard);
  EXPECT_FALSE(tone_curve_named("Reinhardt"));
}

}  // namespace
}  // namespace zraka
