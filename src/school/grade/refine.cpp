// SPDX-License-Identifier: Apache-2.0
// Gauss-Newton steps (Lucas and Kanade 1981) for a shift and a scale along each axis, with weights
// that leave out what mistakes have changed (Geman and McClure 1985).
#include "school/grade/refine.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>

namespace zraka {
namespace {

constexpr int kSteps = 12;
/// Differences larger than this are mistakes rather than shifts.
constexpr float kShift = 0.1F;
/// An outline's search is never as far off as this, in pixels.
constexpr double kFarthest = 2;
/// What is as near as this to whole pixels lies there.
constexpr double kWhole = 0.06;
/// Scales as near to 1 as this are tried as 1, and are 1 if that is about as good.
constexpr double kOwnSize = 0.02, kAsNear = 1.03;
/// Pixels were repeated where that comes so much nearer.
constexpr double kRepeatedIsNearer = 0.25, kMayBeRepeated = 0.7;

/// A shift and a growth from the middle, along x and y.
using Motion = std::array<double, 4>;

std::optional<Motion> solved(std::array<std::array<double, 5>, 4> rows) {
  for (std::size_t i = 0; i < 4; ++i) {
    std::size_t pivot = i;
    for (std::size_t k = i + 1; k < 4; ++k)
      if (std::fabs(rows[k][i]) > std::fabs(rows[pivot][i])) pivot = k;
    std::swap(rows[i], rows[pivot]);
    if (std::fabs(rows[i][i]) < 1e-9) return std::nullopt;
    for (std::size_t k = 0; k < 4; ++k) {
      if (k == i) continue;
      const double by = rows[k][i] / rows[i][i];
      for (std::size_t c = i; c < 5; ++c) rows[k][c] -= by * rows[i][c];
    }
  }
  return Motion{rows[0][4] / rows[0][0], rows[1][4] / rows[1][1], rows[2][4] / rows[2][2],
                rows[3][4] / rows[3][3]};
}

float weight_of(float difference) {
  const float far = difference / kShift;
  return 1 / ((1 + far * far) * (1 + far * far));
}

double robust_distance(const Image& a, const Image& b, const Region& r) {
  double sum = 0;
  for (std::uint32_t y = r.top; y < r.bottom; ++y) {
    const float *p = a.row(y), *q = b.row(y);
    float of_row = 0;
    for (std::size_t i = std::size_t{3} * r.left; i < std::size_t{3} * r.right; ++i) {
      const float d = (p[i] - q[i]) * (p[i] - q[i]);
      of_row += d / (d + kShift * kShift);
    }
    sum += static_cast<double>(of_row);
  }
  return sum / std::max(1.0, r.pixels());
}

/// How far `image` lies from `wanted`: image(x) is about wanted(x + motion(x)).
std::optional<Motion> motion_between(const Image& image, const Image& wanted, const Region& r,
                                     bool scales) {
  std::array<std::array<double, 5>, 4> rows{};
  const std::uint32_t left = std::max(r.left, 1U), top = std::max(r.top, 1U),
                      right = std::min(r.right, wanted.width - 1),
                      bottom = std::min(r.bottom, wanted.height - 1);
  for (std::uint32_t y = top; y < bottom; ++y) {
    const float *above = wanted.row(y - 1), *here = wanted.row(y), *below = wanted.row(y + 1);
    const float* p = image.row(y);
    const auto v = static_cast<float>(y) - static_cast<float>(wanted.height) / 2;
    std::array<std::array<float, 5>, 4> sums{};
    for (std::uint32_t x = left; x < right; ++x) {
      const auto u = static_cast<float>(x) - static_cast<float>(wanted.width) / 2;
      for (std::size_t i = std::size_t{3} * x; i < std::size_t{3} * x + 3; ++i) {
        const float dx = 0.5F * (here[i + 3] - here[i - 3]), dy = 0.5F * (below[i] - above[i]);
        const float difference = p[i] - here[i];
        const std::array<float, 5> slope = {dx, dx * u, dy, dy * v, difference};
        const float weight = weight_of(difference);
        for (std::size_t a = 0; a < 4; ++a)
          for (std::size_t b = a; b < 5; ++b) sums[a][b] += weight * slope[a] * slope[b];
      }
    }
    for (std::size_t a = 0; a < 4; ++a)
      for (std::size_t b = a; b < 5; ++b) rows[a][b] += static_cast<double>(sums[a][b]);
  }
  for (std::size_t a = 1; a < 4; ++a)
    for (std::size_t b = 0; b < a; ++b) rows[a][b] = rows[b][a];
  if (!scales)
    for (const std::size_t i : {1U, 3U}) {
      for (std::size_t k = 0; k < 4; ++k) rows[i][k] = rows[k][i] = i == k ? 1 : 0;
      rows[i][4] = 0;
    }
  return solved(rows);
}

}  // namespace

namespace {

/// Where it lies in its own size, if that is near.
GridPlacement in_own_size(const GridPlacement& at, double w, double h) {
  const auto near = [](double scale) { return std::fabs(scale - 1) < kOwnSize; };
  if (!near(at.across) || !near(at.down)) return at;
  return {at.left + w / 2 * (at.across - 1), at.top + h / 2 * (at.down - 1), 1, 1};
}

/// Where it lies by whole pixels in its own size, if it is so near to that.
GridPlacement rounded(const GridPlacement& at, double w, double h) {
  const GridPlacement whole{std::round(at.left + w / 2 * (at.across - 1)),
                            std::round(at.top + h / 2 * (at.down - 1)), 1, 1};
  const auto near = [](double a, double b) { return std::fabs(a - b) < kWhole; };
  const bool is_whole = near(at.left, whole.left) && near(at.top, whole.top) &&
                        near(at.left + w * at.across, whole.left + w) &&
                        near(at.top + h * at.down, whole.top + h);
  return is_whole ? whole : at;
}

/// `scales`: it may also be scaled by a little. `soft`: it is compared with what has lost as much
/// by its scaling, without which it would rather lie by whole pixels, which lose nothing.
void move_onto(Fitted& fitted, const Image& wanted, bool scales, bool soft = false) {
  const double w = wanted.width, h = wanted.height;
  const auto lost = [&](const Fitted& there) {
    return soft ? through_scaling(wanted, there) : wanted;
  };
  Image there = lost(fitted);
  double least = robust_distance(fitted.image, there, fitted.region);
  for (int i = 0; i < kSteps; ++i) {
    if (fitted.source == nullptr) return;  // the whole, pixel by pixel
    const std::optional<Motion> motion = motion_between(fitted.image, there, fitted.region, scales);
    if (!motion) return;
    const auto& [right, wider, down, taller] = *motion;
    const double farthest = std::max(std::fabs(right) + std::fabs(wider) * w / 2,
                                     std::fabs(down) + std::fabs(taller) * h / 2);
    if (farthest > kFarthest || farthest < 0.002) return;
    const GridPlacement& at = fitted.placement;
    const GridPlacement better{at.left - at.across * (right - wider * w / 2),
                               at.top - at.down * (down - taller * h / 2), at.across * (1 - wider),
                               at.down * (1 - taller)};
    Fitted moved = placed_at(fitted, better);
    if (soft) moved.softened = true;
    Image of_moved = lost(moved);
    const double reached = robust_distance(moved.image, of_moved, moved.region);
    if (reached >= least) return;
    least = reached;
    fitted = std::move(moved);
    there = std::move(of_moved);
  }
}

/// Where its pixels lie that a screen has repeated, if that leaves no more than `most` at first:
/// which are repeated changes from one place to the next, and has no slope.
double repeat_pixels(Fitted& fitted, const Image& wanted, double most) {
  const double w = wanted.width, h = wanted.height;
  const auto repeated = [&](const Fitted& at) {
    Fitted there = at;
    there.softened = there.repeated = true;
    return there;
  };
  const auto distance = [&](const Fitted& there) {
    return robust_distance(there.image, through_scaling(wanted, there), there.region);
  };
  fitted = repeated(fitted);
  double least = distance(fitted);
  if (least > most) return least;
  for (const double step : {0.15, 0.08, 0.04, 0.02})
    for (int edge = 0; edge < 4; ++edge)
      for (const double by : {step, -step}) {
        GridPlacement at = fitted.placement;
        double &start = edge < 2 ? at.left : at.top, &scale = edge < 2 ? at.across : at.down;
        scale += (edge % 2 == 0 ? -by : by) / (edge < 2 ? w : h);
        if (edge % 2 == 0) start += by;
        Fitted moved = repeated(placed_at(fitted, at));
        if (const double reached = distance(moved); reached < least) {
          least = reached;
          fitted = std::move(moved);
        }
      }
  return least;
}

}  // namespace

void refine(Fitted& fitted, const Image& wanted) {
  if (fitted.exact) return;
  move_onto(fitted, wanted, true);
  if (const GridPlacement own = in_own_size(fitted.placement, wanted.width, wanted.height);
      own != fitted.placement) {
    // What a mistake changes may look like a growth.
    Fitted moved = placed_at(fitted, own);
    move_onto(moved, wanted, false);
    if (robust_distance(moved.image, wanted, moved.region) <=
        kAsNear * robust_distance(fitted.image, wanted, fitted.region))
      fitted = std::move(moved);
  }
  double least = robust_distance(fitted.image, through_scaling(wanted, fitted), fitted.region);
  if (!fitted.softened) {
    fitted.softened = true;
    const double soft =
        robust_distance(fitted.image, through_scaling(wanted, fitted), fitted.region);
    fitted.softened = soft < least;
    least = std::min(least, soft);
  }
  Fitted soft = fitted;
  soft.softened = true;
  move_onto(soft, wanted, soft.placement.across != 1 || soft.placement.down != 1, true);
  if (const double reached =
          robust_distance(soft.image, through_scaling(wanted, soft), soft.region);
      reached < least) {
    least = reached;
    fitted = std::move(soft);
  }
  if (fitted.placement.across > 1 && fitted.placement.down > 1) {
    Fitted again = fitted;
    if (const double reached = repeat_pixels(again, wanted, kMayBeRepeated * least);
        reached < kRepeatedIsNearer * least) {
      least = reached;
      fitted = std::move(again);
    }
  }
  const GridPlacement whole = rounded(fitted.placement, wanted.width, wanted.height);
  if (fitted.alignment.unpainted || whole == fitted.placement) return;
  Fitted moved = placed_at(fitted, whole);
  if (robust_distance(moved.image, wanted, moved.region) <= kAsNear * least)
    fitted = std::move(moved);
}

}  // namespace zraka
