// SPDX-License-Identifier: Apache-2.0
#include "school/grade/correlation.hpp"

#include <algorithm>
#include <cmath>

namespace zraka {
namespace {

/// This much of the picture has to be in the submission, in pixels and in outlines.
constexpr double kLeast = 0.5;

/// So much at a template's edges is not compared: a window's frame there would pull at them.
std::uint32_t margin(std::uint32_t size) {
  return (size + 59) / 60;
}

/// Sums of a correlation.
struct Sums {
  double n = 0, t = 0, tt = 0, s = 0, ss = 0, ts = 0;
  /// Less what is not visible, in pixels `all` and in squares `energy` of the template.
  double likeness(double all, double energy) const {
    if (n < kLeast * all || tt < kLeast * energy) return -1;
    const double of_t = tt - t * t / n, of_s = ss - s * s / n;
    if (of_t <= 1e-9 || of_s <= 1e-9) return -1;
    return (ts - t * s / n) / std::sqrt(of_t * of_s) * (0.7 + 0.3 * tt / energy);
  }
};

}  // namespace

double SearchLevel::likeness(const GridPlacement& at) const {
  const Grid& grid = searched_.grid;
  const double width = submission_.width, height = submission_.height;
  // What is visible is a rectangle.
  const auto visible = [](double start, double step, double size, std::uint32_t count) {
    std::pair<std::uint32_t, std::uint32_t> seen{0, count};
    const auto inside = [&](std::uint32_t i) {
      const double u = start + (i + 0.5) * step;
      return u >= 0 && u <= size;
    };
    while (seen.first < seen.second && !inside(seen.first)) ++seen.first;
    while (seen.first < seen.second && !inside(seen.second - 1)) --seen.second;
    return seen;
  };
  auto [x0, x1] = visible(at.left, at.across, width, grid.width);
  auto [y0, y1] = visible(at.top, at.down, height, grid.height);
  x0 = std::max(x0, margin(grid.width));
  y0 = std::max(y0, margin(grid.height));
  x1 = std::min(x1, grid.width - margin(grid.width));
  y1 = std::min(y1, grid.height - margin(grid.height));
  if (x0 >= x1 || y0 >= y1) return -1;
  struct Tap {
    std::uint32_t first;
    float weight;
  };
  const auto tap = [](double u, double size) {
    const double c = std::clamp(u - 0.5, 0.0, size - 1.001);
    const double whole = std::floor(c);
    return Tap{static_cast<std::uint32_t>(whole), static_cast<float>(c - whole)};
  };
  std::vector<Tap> taps;
  for (std::uint32_t x = x0; x < x1; ++x)
    taps.push_back(tap(at.left + (x + 0.5) * at.across, width));
  const std::uint32_t from = std::min(taps.front().first, taps.back().first),
                      next = submission_.width > 1 ? 1 : 0,
                      to = std::max(taps.front().first, taps.back().first) + next + 1;
  std::vector<float> mixed(submission_.width);
  Sums sums;
  for (std::uint32_t y = y0; y < y1; ++y) {
    const Tap row = tap(at.top + (y + 0.5) * at.down, height);
    const float *a = submission_.row(row.first),
                *b = submission_.row(std::min(row.first + 1, submission_.height - 1));
    for (std::uint32_t x = from; x < to; ++x) mixed[x] = a[x] + row.weight * (b[x] - a[x]);
    const float* t = grid.row(y) + x0;
    float s = 0, ss = 0, ts = 0;
    for (std::size_t i = 0; i < taps.size(); ++i) {
      const float* p = mixed.data() + taps[i].first;
      const float value = p[0] + taps[i].weight * (p[next] - p[0]);
      s += value;
      ss += value * value;
      ts += value * t[i];
    }
    sums.s += static_cast<double>(s);
    sums.ss += static_cast<double>(ss);
    sums.ts += static_cast<double>(ts);
  }
  sums.n = (x1 - x0) * static_cast<double>(y1 - y0);
  const std::array<double, 2> of_template = searched_.table.over(x0, y0, x1, y1);
  sums.t = of_template[0];
  sums.tt = of_template[1];
  return sums.likeness(static_cast<double>(grid.values.size()), searched_.table.energy());
}

double SearchLevel::refine(GridPlacement& at, double first, double last) const {
  double best = likeness(at);
  const double w = searched_.grid.width, h = searched_.grid.height;
  for (double step = first; step >= last; step /= 2) {
    for (int round = 0; round < 6; ++round) {
      bool better = false;
      for (int move = 0; move < 10; ++move) {
        GridPlacement next = at;
        const double by = move % 2 == 0 ? step : -step;
        // About the middle, so that scale and shift do not mix.
        const auto stretch = [by](double& start, double& scale, double size) {
          const double grown = scale * (1 + 2 * by / size);
          start -= (grown - scale) * size / 2;
          scale = grown;
        };
        if (move < 2)
          next.left += by * at.across;
        else if (move < 4)
          next.top += by * at.down;
        else if (move < 6)
          stretch(next.left, next.across, w);
        else if (move < 8)
          stretch(next.top, next.down, h);
        else
          stretch(next.left, next.across, w), stretch(next.top, next.down, h);
        if (next.across / next.down > 1.08 || next.down / next.across > 1.08) continue;
        if (const double like = likeness(next); like > best + 1e-7)
          best = like, at = next, better = true;
      }
      if (!better) break;
    }
  }
  return best;
}

void slide(const Searched& small, const Grid& where, double least,
           const std::function<void(std::int32_t left, std::int32_t top, double likeness)>& found) {
  const auto w = static_cast<std::int32_t>(small.grid.width),
             h = static_cast<std::int32_t>(small.grid.height);
  const auto width = static_cast<std::int32_t>(where.width),
             height = static_cast<std::int32_t>(where.height);
  const Table table(where);
  const auto sums_of = [](const Table& of, std::int32_t x0, std::int32_t y0, std::int32_t x1,
                          std::int32_t y1) {
    return of.over(static_cast<std::size_t>(x0), static_cast<std::size_t>(y0),
                   static_cast<std::size_t>(x1), static_cast<std::size_t>(y1));
  };
  for (std::int32_t top = -2 * h / 5; top <= height - 3 * h / 5; ++top)
    for (std::int32_t left = -2 * w / 5; left <= width - 3 * w / 5; ++left) {
      const std::int32_t x0 = std::max(0, -left), x1 = std::min(w, width - left),
                         y0 = std::max(0, -top), y1 = std::min(h, height - top);
      if ((x1 - x0) * (y1 - y0) * 2 < w * h) continue;
      std::array<float, 4> ts{};
      for (std::int32_t y = y0; y < y1; ++y) {
        const float* a = small.grid.row(static_cast<std::uint32_t>(y));
        const float* b = where.row(static_cast<std::uint32_t>(y + top)) + left;
        std::int32_t x = x0;
        for (; x + 4 <= x1; x += 4)
          for (std::int32_t i = 0; i < 4; ++i)
            ts[static_cast<std::size_t>(i)] += a[x + i] * b[x + i];
        for (; x < x1; ++x) ts[0] += a[x] * b[x];
      }
      const std::array<double, 2> t = sums_of(small.table, x0, y0, x1, y1),
                                  s = sums_of(table, x0 + left, y0 + top, x1 + left, y1 + top);
      const Sums sums{static_cast<double>((x1 - x0) * (y1 - y0)),
                      t[0],
                      t[1],
                      s[0],
                      s[1],
                      static_cast<double>((ts[0] + ts[1]) + (ts[2] + ts[3]))};
      if (const double like = sums.likeness(w * h, small.table.energy()); like > least)
        found(left, top, like);
    }
}

}  // namespace zraka
