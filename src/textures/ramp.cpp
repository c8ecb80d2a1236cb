// SPDX-License-Identifier: Apache-2.0
#include "textures/ramp.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

namespace zraka {
namespace {

/// Narrower ones are taken as points: the difference of two integrals would have lost its digits.
constexpr double kNarrowest = 1e-4;

double eased(double t) {
  return t * t * (3 - 2 * t);
}

}  // namespace

Ramp::Ramp(std::vector<Knot> knots, bool is_eased, TextureWrap wrap)
    : knots_(std::move(knots)), eased_(is_eased), wrap_(wrap) {
  V3<double> sum{};
  for (std::size_t i = 0; i < knots_.size(); ++i) {
    before_.push_back(sum);
    if (i + 1 == knots_.size()) break;
    // Both ways from one colour to the next have half of each in the mean.
    const double length = knots_[i + 1].at - knots_[i].at;
    sum = sum + (knots_[i].color + knots_[i + 1].color) * (length / 2);
  }
}

std::vector<Ramp::Knot> Ramp::evenly(const std::vector<V3<double>>& colors) {
  std::vector<Knot> knots;
  for (std::size_t i = 0; i < colors.size(); ++i)
    knots.push_back({static_cast<double>(i) / static_cast<double>(colors.size() - 1), colors[i]});
  return knots;
}

Ramp::Part Ramp::part_at(double s) const {
  std::size_t i = 0;
  while (i + 2 < knots_.size() && knots_[i + 1].at <= s) ++i;
  const double length = knots_[i + 1].at - knots_[i].at;
  return {i, length, (s - knots_[i].at) / length};
}

V3<double> Ramp::value(double s) const {
  if (wrap_ == TextureWrap::repeat) s -= std::floor(s);
  if (wrap_ == TextureWrap::mirror) {
    s -= 2 * std::floor(s / 2);
    if (s > 1) s = 2 - s;
  }
  const Part part = part_at(std::clamp(s, 0.0, 1.0));
  const double next = eased_ ? eased(part.share) : part.share;
  return knots_[part.knot].color * (1 - next) + knots_[part.knot + 1].color * next;
}

V3<double> Ramp::integral_within(double s) const {
  const Part part = part_at(s);
  const double t = part.share;
  const double next = eased_ ? t * t * t * (1 - t / 2) : t * t / 2;
  return before_[part.knot] +
         (knots_[part.knot].color * (t - next) + knots_[part.knot + 1].color * next) * part.length;
}

V3<double> Ramp::integral(double s) const {
  const V3<double>& whole = before_.back();
  if (wrap_ == TextureWrap::repeat) {
    const double periods = std::floor(s);
    return whole * periods + integral_within(s - periods);
  }
  const double periods = std::floor(s / 2), rest = s - 2 * periods;
  const V3<double> end = rest > 1 ? whole * 2.0 - integral_within(2 - rest) : integral_within(rest);
  return whole * (2 * periods) + end;
}

V3<double> Ramp::mean_clamped(double s, double width) const {
  s = std::clamp(s, -width - 1, width + 2);  // further out it does not change
  const double begin = s - width / 2, end = s + width / 2;
  const V3<double> before = knots_.front().color * (std::min(end, 0.0) - std::min(begin, 0.0));
  const V3<double> after = knots_.back().color * (std::max(end, 1.0) - std::max(begin, 1.0));
  const V3<double> within =
      integral_within(std::clamp(end, 0.0, 1.0)) - integral_within(std::clamp(begin, 0.0, 1.0));
  return (before + within + after) * (1 / (end - begin));
}

V3<double> Ramp::mean(double s, double width) const {
  if (!(width > kNarrowest)) return value(s);
  if (wrap_ == TextureWrap::clamp) return mean_clamped(s, width);
  s -= wrap_ == TextureWrap::repeat ? std::floor(s) : 2 * std::floor(s / 2);
  return (integral(s + width / 2) - integral(s - width / 2)) * (1 / width);
}

}  // namespace zraka
