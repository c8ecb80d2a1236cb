// SPDX-License-Identifier: Apache-2.0
// Elementary functions of our own against the library's in long double, and at the ends.
#include "math/elementary.hpp"

#include <gtest/gtest.h>

#include <bit>
#include <cmath>
#include <limits>

#include "core/random.hpp"

namespace zraka {
namespace {

namespace own = elementary;

constexpr double kInfinity = std::numeric_limits<double>::infinity();
constexpr double kNan = std::numeric_limits<double>::quiet_NaN();
constexpr double kLeast = std::numeric_limits<double>::denorm_min();
constexpr double kMost = std::numeric_limits<double>::max();
constexpr double kPi = 3.14159265358979323846;

/// How many units of 2^-53, relative to the true value, a value is off: 1 is what rounding may cost
/// where the fraction is 1. Below the normal numbers, units of the last place.
double error(double value, long double truth) {
  if (static_cast<double>(truth) == value) return 0;
  const long double unit = std::fmax(std::fabs(truth) * 0x1p-53L, 0x1p-1075L);
  return static_cast<double>(std::fabs(value - truth) / unit);
}

/// Of either sign, every exponent from `least` to `most` as likely as any other.
double any_size(Random& random, int least, int most) {
  const auto exponent =
      least + static_cast<int>(random.below(static_cast<std::uint64_t>(most - least + 1)));
  const double value = std::ldexp(1 + random.unit(), exponent);
  return random.below(2) == 0 ? value : -value;
}

/// Equal, also in the sign of 0 and in being no number.
void expect_same(double value, double wanted, const char* what) {
  if (std::isnan(wanted))
    EXPECT_TRUE(std::isnan(value)) << what << ": " << value;
  else
    EXPECT_EQ(std::bit_cast<std::uint64_t>(value), std::bit_cast<std::uint64_t>(wanted))
        << what << ": " << value << ", where " << wanted << " was expected";
}
#define EXPECT_SAME(value, wanted) expect_same(value, wanted, #value)

TEST(Elementary, SineAndCosineAreRightForAnglesOfEverySize) {
  Random random(1);
  double worst = 0;
  for (int i = 0; i < 400000; ++i) {
    const double x = i % 2 == 0 ? 40 * random.unit() - 20 : any_size(random, -60, 1023);
    worst = std::fmax(worst, error(own::sin(x), std::sin(static_cast<long double>(x))));
    worst = std::fmax(worst, error(own::cos(x), std::cos(static_cast<long double>(x))));
  }
  EXPECT_LT(worst, 1.25);
}

TEST(Elementary, SineAndCosineAreTheSameTogether) {
  Random random(2);
  const auto expect = [](double x) {
    const own::SineCosine both = own::sine_cosine(x);
    EXPECT_SAME(both.sine, own::sin(x));
    EXPECT_SAME(both.cosine, own::cos(x));
  };
  for (int i = 0; i < 100000; ++i)
    expect(i % 2 == 0 ? 40 * random.unit() - 20 : any_size(random, -60, 1023));
  for (const double x : {0.0, -0.0, kInfinity, -kInfinity, kNan, kLeast, kMost}) expect(x);
}

TEST(Elementary, SineAndCosineAreRightNextToTheirZeros) {
  double worst = 0;
  for (int quarters = 1; quarters < 200000; ++quarters) {
    const double x = quarters * (kPi / 2);
    worst = std::fmax(worst, error(own::sin(x), std::sin(static_cast<long double>(x))));
    worst = std::fmax(worst, error(own::cos(x), std::cos(static_cast<long double>(x))));
  }
  // The double that is nearest to a multiple of π/2 (Kahan): its cosine is below 2^-60.
  const double nearest = std::ldexp(6381956970095103.0, 797);
  worst = std::fmax(worst, error(own::cos(nearest), -4.68716592425462761112258e-19L));
  EXPECT_LT(worst, 2);
}

TEST(Elementary, SineAndCosineKnowTheEnds) {
  EXPECT_SAME(own::sin(0.0), 0.0);
  EXPECT_SAME(own::sin(-0.0), -0.0);
  EXPECT_SAME(own::sin(kLeast), kLeast);
  EXPECT_SAME(own::cos(0.0), 1.0);
  EXPECT_SAME(own::cos(-0.0), 1.0);
  for (const double bad : {kInfinity, -kInfinity, kNan}) {
    EXPECT_SAME(own::sin(bad), kNan);
    EXPECT_SAME(own::cos(bad), kNan);
  }
  Random random(2);
  for (int i = 0; i < 10000; ++i) {
    const double x = any_size(random, -10, 100);
    EXPECT_SAME(own::sin(-x), -own::sin(x));
    EXPECT_SAME(own::cos(-x), own::cos(x));
  }
}

TEST(Elementary, ArcTangentIsRightInEveryDirection) {
  Random random(3);
  double worst = 0;
  for (int i = 0; i < 400000; ++i) {
    const int range = i % 4 == 0 ? 1020 : i % 4 == 1 ? 60 : 3;
    const double y = any_size(random, -range, range), x = any_size(random, -range, range);
    const long double truth = std::atan2(static_cast<long double>(y), static_cast<long double>(x));
    worst = std::fmax(worst, error(own::atan2(y, x), truth));
  }
  for (const double y : {kLeast, 3 * kLeast, 0x1p-1000, 1.0, 0x1p1000, kMost})
    for (const double x : {-kMost, -1.0, -7 * kLeast, kLeast, 5 * kLeast, 0x1p-1022, 3.0, kMost})
      worst = std::fmax(worst, error(own::atan2(y, x), std::atan2(static_cast<long double>(y),
                                                                  static_cast<long double>(x))));
  EXPECT_LT(worst, 2);
}

TEST(Elementary, ArcTangentKnowsZerosAndInfinities) {
  for (const double y : {0.0, -0.0, 1.0, -1.0, kInfinity, -kInfinity, kLeast, kNan})
    for (const double x : {0.0, -0.0, 1.0, -1.0, kInfinity, -kInfinity, -kLeast, kNan}) {
      SCOPED_TRACE(testing::Message() << y << ", " << x);
      EXPECT_SAME(own::atan2(y, x), std::atan2(y, x));
    }
  EXPECT_SAME(own::atan2(0, 1), 0.0);
  EXPECT_SAME(own::atan2(1, 0), kPi / 2);
  EXPECT_SAME(own::atan2(0, -1), kPi);
  EXPECT_SAME(own::atan2(3, 3), kPi / 4);
}

TEST(Elementary, ArcSineIsRightFromEndToEnd) {
  Random random(4);
  double worst = 0;
  for (int i = 0; i < 400000; ++i) {
    const double step = any_size(random, -60, -1);
    const double x = i % 2 == 0 ? std::copysign(1 - std::fabs(step), step) : step;
    worst = std::fmax(worst, error(own::asin(x), std::asin(static_cast<long double>(x))));
  }
  EXPECT_LT(worst, 3);
  EXPECT_SAME(own::asin(0), 0.0);
  EXPECT_SAME(own::asin(-0.0), -0.0);
  EXPECT_SAME(own::asin(1), kPi / 2);
  EXPECT_SAME(own::asin(-1), -kPi / 2);
  for (const double bad : {1.0000000000000002, -2.0, kInfinity, kNan})
    EXPECT_SAME(own::asin(bad), kNan);
}

TEST(Elementary, ExponentialIsRightAsFarAsDoublesReach) {
  Random random(5);
  double worst = 0;
  for (int i = 0; i < 400000; ++i) {
    const double x = i % 2 == 0 ? 1456 * random.unit() - 746 : any_size(random, -70, 9);
    const double value = own::exp(x);
    const long double truth = std::exp(static_cast<long double>(x));
    if (truth > static_cast<long double>(kMost))
      EXPECT_EQ(value, kInfinity);
    else
      worst = std::fmax(worst, error(value, truth));
  }
  EXPECT_LT(worst, 1.5);
  EXPECT_SAME(own::exp(0), 1.0);
  EXPECT_SAME(own::exp(-0.0), 1.0);
  EXPECT_SAME(own::exp(kInfinity), kInfinity);
  EXPECT_SAME(own::exp(-kInfinity), 0.0);
  EXPECT_SAME(own::exp(1e300), kInfinity);
  EXPECT_SAME(own::exp(-1e300), 0.0);
  EXPECT_SAME(own::exp(kNan), kNan);
}

TEST(Elementary, LogarithmIsRightForNumbersOfEverySize) {
  Random random(6);
  double worst = 0;
  for (int i = 0; i < 400000; ++i) {
    const double x =
        i % 2 == 0 ? std::fabs(any_size(random, -1070, 1023)) : 1 + any_size(random, -52, -1) / 2;
    worst = std::fmax(worst, error(own::log(x), std::log(static_cast<long double>(x))));
  }
  EXPECT_LT(worst, 1.1);
  EXPECT_SAME(own::log(1), 0.0);
  EXPECT_SAME(own::log(0.0), -kInfinity);
  EXPECT_SAME(own::log(-0.0), -kInfinity);
  EXPECT_SAME(own::log(kInfinity), kInfinity);
  for (const double bad : {-1.0, -kLeast, -kInfinity, kNan}) EXPECT_SAME(own::log(bad), kNan);
}

TEST(Elementary, PowersAreRightAsFarAsDoublesReach) {
  Random random(7);
  double worst = 0;
  int finite = 0;
  for (int i = 0; i < 400000; ++i) {
    const double x =
        i % 3 == 0 ? 1 + any_size(random, -52, -2) : std::fabs(any_size(random, -1070, 1023));
    const double y = i % 3 == 0 ? any_size(random, 0, 60) : any_size(random, -60, 11);
    const long double truth = std::pow(static_cast<long double>(x), static_cast<long double>(y));
    const double value = own::pow(x, y);
    if (truth > static_cast<long double>(kMost)) {
      EXPECT_EQ(value, kInfinity) << x << ", " << y;
    } else {
      worst = std::fmax(worst, error(value, truth));
      ++finite;
    }
  }
  EXPECT_LT(worst, 1.5);
  EXPECT_GT(finite, 200000);
}

TEST(Elementary, PowersOfOneAreTheNumberAndOfTwoItsSquare) {
  Random random(8);
  for (int i = 0; i < 100000; ++i) {
    const double x = any_size(random, -1000, 1000), small = any_size(random, -250, 250);
    ASSERT_EQ(own::pow(x, 1), x);
    ASSERT_LE(error(own::pow(small, 2), static_cast<long double>(small) * small), 1.02);
  }
}

TEST(Elementary, PowersKnowTheEnds) {
  for (const double x : {0.0, -0.0, 0.5, 1.0, -1.0, 2.0, -2.0, -0.5, kInfinity, -kInfinity, kNan,
                         kLeast, -kLeast, 0x1p1023, -8.0})
    for (const double y : {0.0, -0.0, 1.0, -1.0, 2.0, 3.0, -3.0, 0.5, -0.5, kInfinity, -kInfinity,
                           kNan, 1e300, -1e300, kLeast, 9007199254740991.0}) {
      SCOPED_TRACE(testing::Message() << x << ", " << y);
      EXPECT_SAME(own::pow(x, y), std::pow(x, y));
    }
}

TEST(Elementary, FunctionsThatRiseRise) {
  double exp = 0, log = -kInfinity, atan = -kPi, asin = -kPi, pow = -1, sin = -2;
  for (int i = -100000; i <= 100000; ++i) {
    const double x = i / 100000.0;
    const double values[] = {own::exp(700 * x), own::log((x + 1) / 2),    own::atan2(3 * x, 1),
                             own::asin(x),      own::pow(x / 2 + 0.5, 3), own::sin(x * 1.5707)};
    double* before[] = {&exp, &log, &atan, &asin, &pow, &sin};
    for (int k = 0; k < 6; ++k) {
      ASSERT_GE(values[k], *before[k]) << k << " at " << x;
      *before[k] = values[k];
    }
  }
}

}  // namespace
}  // namespace zraka
