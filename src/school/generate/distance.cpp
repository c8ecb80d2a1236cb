// SPDX-License-Identifier: Apache-2.0
#include "school/generate/distance.hpp"

#include <cmath>

namespace zraka {
namespace {

/// One row or column: out[q] = min over p of (q - p)² + f[p], as the lower envelope of parabolas.
void lower_envelope(const std::vector<double>& f, std::vector<double>& out) {
  const std::size_t n = f.size();
  std::vector<std::size_t> apex(n);
  std::vector<double> from(n + 1);
  std::size_t last = 0;
  apex[0] = 0;
  from[0] = -1e20;
  from[1] = 1e20;
  const auto square = [](std::size_t i) { return static_cast<double>(i) * static_cast<double>(i); };
  for (std::size_t q = 1; q < n; ++q) {
    const auto crossing = [&] {
      const std::size_t p = apex[last];
      return (f[q] + square(q) - f[p] - square(p)) / (2 * static_cast<double>(q - p));
    };
    double s = crossing();
    while (s <= from[last]) {
      --last;
      s = crossing();
    }
    apex[++last] = q;
    from[last] = s;
    from[last + 1] = 1e20;
  }
  std::size_t k = 0;
  for (std::size_t q = 0; q < n; ++q) {
    while (from[k + 1] < static_cast<double>(q)) ++k;
    const double away = static_cast<double>(q) - static_cast<double>(apex[k]);
    out[q] = away * away + f[apex[k]];
  }
}

}  // namespace

std::vector<float> distance_inside(const Coverage& shape) {
  // A rim of one pixel stands for what is beyond the edge.
  const auto width = static_cast<std::size_t>(shape.width) + 2;
  const auto height = static_cast<std::size_t>(shape.height) + 2;
  constexpr double kFar = 1e10;
  std::vector<double> squared(width * height, 0);
  for (int y = 0; y < shape.height; ++y)
    for (int x = 0; x < shape.width; ++x)
      if (shape.at(x, y) >= 128)
        squared[(static_cast<std::size_t>(y) + 1) * width + static_cast<std::size_t>(x) + 1] = kFar;

  std::vector<double> line(height), result(height);
  for (std::size_t x = 0; x < width; ++x) {
    for (std::size_t y = 0; y < height; ++y) line[y] = squared[y * width + x];
    lower_envelope(line, result);
    for (std::size_t y = 0; y < height; ++y) squared[y * width + x] = result[y];
  }
  line.resize(width);
  result.resize(width);
  std::vector<float> distance;
  for (std::size_t y = 1; y + 1 < height; ++y) {
    for (std::size_t x = 0; x < width; ++x) line[x] = squared[y * width + x];
    lower_envelope(line, result);
    for (std::size_t x = 1; x + 1 < width; ++x)
      distance.push_back(static_cast<float>(std::sqrt(result[x])));
  }
  return distance;
}

}  // namespace zraka
