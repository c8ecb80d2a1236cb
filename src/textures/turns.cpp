// SPDX-License-Identifier: Apache-2.0
#include "textures/turns.hpp"

#include <algorithm>
#include <cmath>

namespace zraka {
namespace {

/// The integral of the colours from 0 to x.
V3<double> integral(const std::vector<V3<double>>& colors, const V3<double>& all, double x) {
  const auto count = static_cast<double>(colors.size());
  const double rounds = std::floor(x / count);
  double left = x - rounds * count;
  V3<double> sum = all * rounds;
  for (const V3<double>& color : colors) {
    if (left <= 0) break;
    sum = sum + color * std::min(left, 1.0);
    left -= 1;
  }
  return sum;
}

V3<double> mean(const std::vector<V3<double>>& colors, double x, double width) {
  const auto count = static_cast<double>(colors.size());
  V3<double> all{};
  for (const V3<double>& color : colors) all = all + color;
  x -= count * std::floor(x / count);
  return (integral(colors, all, x + width / 2) - integral(colors, all, x - width / 2)) *
         (1 / width);
}

/// The integral of 1 and -1 in turn: up and down between 0 and 1.
double triangle(double x) {
  return 1 - std::fabs(x - 2 * std::floor(x / 2) - 1);
}

}  // namespace

double share_of_filtered(double width) {
  const double t = std::clamp(2 * width - 1, 0.0, 1.0);
  return t * t * (3 - 2 * t);
}

V3<double> color_in_turn(const std::vector<V3<double>>& colors, double x, double width,
                         double tolerance) {
  const auto count = static_cast<double>(colors.size());
  const double cell = std::floor(x + tolerance);
  const auto turn = static_cast<std::size_t>(cell - count * std::floor(cell / count));
  const V3<double>& sharp = colors[std::min(turn, colors.size() - 1)];
  const double share = share_of_filtered(width);
  if (share == 0) return sharp;
  return sharp * (1 - share) + mean(colors, x, width) * share;
}

double sign_in_turn(double x, double width, double tolerance) {
  const double cell = std::floor(x + tolerance);
  const double sharp = cell - 2 * std::floor(cell / 2) == 0 ? 1 : -1;
  const double share = share_of_filtered(width);
  if (share == 0) return sharp;
  x -= 2 * std::floor(x / 2);
  const double mean = (triangle(x + width / 2) - triangle(x - width / 2)) / width;
  return sharp * (1 - share) + mean * share;
}

}  // namespace zraka
