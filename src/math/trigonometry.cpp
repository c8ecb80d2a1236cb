// SPDX-License-Identifier: Apache-2.0
// Sine, cosine and their inverses from Taylor series; every angle has its own bits of 2/π.
#include <array>
#include <cmath>
#include <cstdint>
#include <limits>

#include "math/elementary.hpp"
#include "math/pair.hpp"

namespace zraka::elementary {
namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();
constexpr double kNan = std::numeric_limits<double>::quiet_NaN();
constexpr Pair kHalfPi{0x1.921fb54442d18p+0, 0x1.1a62633145c07p-54};
constexpr Pair kPi{0x1.921fb54442d18p+1, 0x1.1a62633145c07p-53};

/// An angle as quarter turns and a rest of at most an eighth of a turn.
struct Turned {
  unsigned quarters = 0;  ///< modulo 4
  Pair rest;
};

__extension__ using Wide = unsigned __int128;

/// The bits of 2/π behind the point, after a word of zeros.
constexpr std::array<std::uint64_t, 20> kPerHalfPi = {
    0x0000000000000000, 0xA2F9836E4E441529, 0xFC2757D1F534DDC0, 0xDB6295993C439041,
    0xFE5163ABDEBBC561, 0xB7246E3A424DD2E0, 0x06492EEA09D1921C, 0xFE1DEB1CB129A73E,
    0xE88235F52EBB4484, 0xE99C7026B45F7E41, 0x3991D639835339F4, 0x9C845F8BBDF9283B,
    0x1FF897FFDE05980F, 0xEF2F118B5A0A6D1F, 0x6D367ECF27CB09B7, 0x4F463F669E5FEA2D,
    0x7527BAC7EBE5F17B, 0x3D0739F78A5292EA, 0x6BFB5FB11F8D5D08, 0x56033046FC7B6BAB};

/// The 192 bits from `at` on, the first word first.
std::array<std::uint64_t, 3> bits_of_per_half_pi(unsigned at) {
  std::array<std::uint64_t, 3> bits{};
  const unsigned word = at / 64, shift = at % 64;
  for (unsigned i = 0; i < 3; ++i) {
    bits[i] = kPerHalfPi[word + i] << shift;
    if (shift > 0) bits[i] |= kPerHalfPi[word + i + 1] >> (64 - shift);
  }
  return bits;
}

/// For any finite x of π/4 or more. Of x·2/π only what is left of whole turns is computed, in whole
/// numbers of 192 bits (Payne and Hanek, "Radian reduction for trigonometric functions", 1983).
Turned turned(double x) {
  // x = m·2^e. Bits of 2/π of weight 2^(2-e) and more give whole turns.
  const Parts p = parts(x);
  const auto m = static_cast<std::uint64_t>(p.fraction * 0x1p52);
  const int e = p.exponent - 52;
  const auto k = bits_of_per_half_pi(static_cast<unsigned>(62 + e));
  const Wide p0 = Wide{m} * k[2];
  const Wide p1 = Wide{m} * k[1] + (p0 >> 64);
  std::uint64_t turn[3] = {m * k[0] + static_cast<std::uint64_t>(p1 >> 64),
                           static_cast<std::uint64_t>(p1), static_cast<std::uint64_t>(p0)};

  // The first two bits count quarters; half a quarter more rounds to the nearest.
  const auto quarters = static_cast<unsigned>((turn[0] + (std::uint64_t{1} << 61)) >> 62);
  turn[0] -= std::uint64_t{quarters} << 62;
  const bool negative = turn[0] >> 63;
  if (negative) {
    for (std::uint64_t& word : turn) word = ~word;
    turn[2] += 1;  // a carry further up would be 2^-126
  }
  Pair rest;
  double weight = 0x1p-30;
  for (const std::uint64_t word : turn)
    for (const unsigned shift : {32u, 0u}) {
      const Pair s = sum(rest.high, static_cast<double>(word >> shift & 0xFFFFFFFF) * weight);
      rest = {s.high, rest.low + s.low};
      weight *= 0x1p-32;
    }
  rest = product(sum(rest.high, rest.low), kHalfPi);
  return {quarters, negative ? Pair{-rest.high, -rest.low} : rest};
}

constexpr std::array<double, 9> kSine = {-1.0 / 6,
                                         1.0 / 120,
                                         -1.0 / 5040,
                                         1.0 / 362880,
                                         -1.0 / 39916800,
                                         1.0 / 6227020800,
                                         -1.0 / 1307674368000,
                                         1.0 / 355687428096000,
                                         -1.0 / 121645100408832000};
constexpr std::array<double, 8> kCosine = {
    1.0 / 24,        -1.0 / 720,         1.0 / 40320,          -1.0 / 3628800,
    1.0 / 479001600, -1.0 / 87178291200, 1.0 / 20922789888000, -1.0 / 6402373705728000};

double sine_of_rest(const Pair& r) {
  if (std::fabs(r.high) < 0x1p-27) return r.high;
  const double z = r.high * r.high;
  return r.high + (r.low * (1 - 0.5 * z) + r.high * z * series(z, kSine));
}

double cosine_of_rest(const Pair& r) {
  const double z = r.high * r.high;
  const double half = 0.5 * z, high = 1 - half;
  return high + (((1 - high) - half) + (z * z * series(z, kCosine) - r.high * r.low));
}

/// For x of π/4 or more and less than kFewTurns, without whole numbers: what π/2 has in three parts
/// with zeros behind them is taken from it so many times (Cody and Waite, "Software manual for the
/// elementary functions", 1980).
constexpr double kFewTurns = 64;
Turned turned_a_little(double x) {
  constexpr double kPerQuarter = 0x1.45f306dc9c883p-1;
  constexpr double kParts[] = {0x1.921fb544p+0, 0x1.0b4611a6p-34, 0x1.3198a2ep-69,
                               0x1.b839a252049c1p-104};
  const auto quarters = static_cast<unsigned>(x * kPerQuarter + 0.5);
  const double times = quarters;
  const Pair s = sum(x - times * kParts[0], -times * kParts[1]);
  return {quarters, sum(s.high, (s.low - times * kParts[2]) - times * kParts[3])};
}

/// Of any finite angle.
Turned reduced(double x) {
  if (!(std::fabs(x) > 0.78)) return {0, {x, 0}};
  const Turned t = std::fabs(x) < kFewTurns ? turned_a_little(std::fabs(x)) : turned(x);
  return x < 0 ? Turned{4 - t.quarters, {-t.rest.high, -t.rest.low}} : t;
}

/// The sine of an angle that is so many quarter turns ahead.
double sine(const Turned& t, unsigned ahead) {
  const unsigned quarters = (t.quarters + ahead) % 4;
  const double value = quarters % 2 == 0 ? sine_of_rest(t.rest) : cosine_of_rest(t.rest);
  return quarters < 2 ? value : -value;
}

/// The arc tangents of 0, 1/8, 2/8, … 1.
constexpr std::array<Pair, 9> kArcTangents = {{{0, 0},
                                               {0x1.fd5ba9aac2f6ep-4, -0x1.cd37686760c17p-59},
                                               {0x1.f5b75f92c80ddp-3, 0x1.8ab6e3cf7afbdp-57},
                                               {0x1.6f61941e4def1p-2, -0x1.c63aae6f6e918p-56},
                                               {0x1.dac670561bb4fp-2, 0x1.a2b7f222f65e2p-56},
                                               {0x1.1e00babdefeb4p-1, -0x1.928df287a668fp-58},
                                               {0x1.4978fa3269ee1p-1, 0x1.2419a87f2a458p-56},
                                               {0x1.700a7c5784634p-1, -0x1.8c34d25aadef6p-56},
                                               {0x1.921fb54442d18p-1, 0x1.1a62633145c07p-55}}};
constexpr std::array<double, 7> kArcTangent = {-1.0 / 3,  1.0 / 5,  -1.0 / 7, 1.0 / 9,
                                               -1.0 / 11, 1.0 / 13, -1.0 / 15};

/// atan(y/x) for finite 0 ≤ y ≤ x, x > 0: that of the nearest eighth c, and that of
/// (y - c·x)/(x + c·y), which is 1/16 at most.
Pair arc_tangent(double y, double x) {
  const double eighth = std::floor(y / x * 8 + 0.5);
  const double c = eighth / 8;
  const double t = (y - c * x) / (x + c * y);
  const double z = t * t;
  const Pair& base = kArcTangents[static_cast<std::size_t>(eighth)];
  if (eighth == 0) return {t, t * z * series(z, kArcTangent)};
  return sum(base, {t, t * z * series(z, kArcTangent)});
}

}  // namespace

double sin(double x) {
  return std::fabs(x) < kInfinity ? sine(reduced(x), 0) : kNan;
}

double cos(double x) {
  return std::fabs(x) < kInfinity ? sine(reduced(x), 1) : kNan;
}

SineCosine sine_cosine(double x) {
  if (!(std::fabs(x) < kInfinity)) return {kNan, kNan};
  const Turned t = reduced(x);
  return {sine(t, 0), sine(t, 1)};
}

double atan2(double y, double x) {
  if (y != y || x != x) return kNan;
  double a = std::fabs(x), b = std::fabs(y);
  if (a == kInfinity || b == kInfinity) {
    a = a == kInfinity ? 1 : 0;
    b = b == kInfinity ? 1 : 0;
  }
  const bool steep = b > a, left = std::signbit(x);
  double longer = steep ? b : a, shorter = steep ? a : b;
  // A sum of both must not run over, nor an eighth be lost below the least number.
  const double scale = longer > 0x1p1000 ? 0x1p-100 : longer < 0x1p-900 ? 0x1p100 : 1.0;
  longer *= scale;
  shorter *= scale;
  Pair angle = longer > 0 ? arc_tangent(shorter, longer) : Pair{};
  if (steep) angle = sum(kHalfPi, {-angle.high, -angle.low});
  if (left) angle = sum(kPi, {-angle.high, -angle.low});
  return std::copysign(angle.high + angle.low, y);
}

double asin(double x) {
  if (!(std::fabs(x) <= 1)) return kNan;
  return atan2(x, std::sqrt((1 - x) * (1 + x)));
}

}  // namespace zraka::elementary
