// SPDX-License-Identifier: Apache-2.0
#include "school/grade/unpainted.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <utility>

#include "school/grade/resample.hpp"

namespace zraka {
namespace {

/// Lines stand out by so much, in so much of them, and by so many times what others do.
constexpr float kStandsOut = 0.06F;
constexpr double kLeastOfLine = 1.0 / 16, kTimesOthers = 4;
/// Their pixels have one colour but for what a JPEG makes of it, and nearly all lines do stand out.
constexpr float kAboutOne = 0.16F;
constexpr double kOfPixels = 0.8, kOfLines = 0.7;
constexpr std::size_t kLeastLines = 5;
/// From one to the next, in pixels: a screen is scaled by 109 to 180 %.
constexpr double kNearest = 2.2, kFarthestApart = 12;
constexpr std::uint32_t kMostOfPeriod = 3;

float brightness(const float* p) {
  return (p[0] + p[1] + p[2]) / 3;
}

/// How far a pixel is above or below the mean of those on its left and right.
float away(const Image& image, std::uint32_t x, std::uint32_t y) {
  const float* p = image.row(y) + std::size_t{3} * x;
  return std::fabs(brightness(p) - 0.5F * (brightness(p - 3) + brightness(p + 3)));
}

/// Not at the first or last two of a row.
bool stands_out(const Image& image, std::uint32_t x, std::uint32_t y) {
  const float here = away(image, x, y);
  return here > kStandsOut && here > away(image, x - 1, y) && here > away(image, x + 1, y);
}

/// Of every `period` columns `lines` are unpainted: where a scale has put no pixel.
struct Lattice {
  std::uint32_t period = 0, lines = 0, phase = 0;
  bool has(std::uint32_t x) const { return (x * lines + phase) % period < lines; }
};

/// The lattice whose columns stand out most from all others.
Lattice best_lattice(const std::vector<double>& out, double& times_others) {
  Lattice best;
  times_others = 0;
  const auto width = static_cast<std::uint32_t>(out.size());
  for (std::uint32_t lines = 1; lines <= kMostOfPeriod; ++lines)
    for (std::uint32_t period = 2; period <= kFarthestApart * lines; ++period) {
      if (std::gcd(lines, period) != 1 || period < kNearest * lines) continue;
      std::vector<double> of(period);
      std::vector<std::size_t> columns(period);
      for (std::uint32_t x = 2; x + 2 < width; ++x) {
        of[x * lines % period] += out[x];
        ++columns[x * lines % period];
      }
      for (std::uint32_t phase = 0; phase < period; ++phase) {
        double on = 0, off = 1;
        std::size_t count = 0;
        for (std::uint32_t i = 0; i < period; ++i) {
          const bool has = (i + phase) % period < lines;
          (has ? on : off) += of[i];
          count += has ? columns[i] : 0;
        }
        if (count < kLeastLines) continue;
        const double times =
            on / static_cast<double>(count) / (off / static_cast<double>(width - 4 - count));
        if (times > times_others) times_others = times, best = {period, lines, phase};
      }
    }
  return best;
}

std::array<float, 3> middle_of(std::array<std::vector<float>, 3>& values) {
  std::array<float, 3> middle{};
  for (std::size_t c = 0; c < 3; ++c) {
    if (values[c].empty()) continue;
    const auto half = values[c].begin() + static_cast<std::ptrdiff_t>(values[c].size() / 2);
    std::nth_element(values[c].begin(), half, values[c].end());
    middle[c] = *half;
  }
  return middle;
}

/// The lattice of unpainted columns, if there is one; their colour.
std::optional<Lattice> columns_of(const Image& image, std::array<float, 3>& color) {
  if (image.width < 3 * kLeastLines) return std::nullopt;
  std::vector<double> out(image.width);
  std::vector<std::pair<std::uint32_t, std::uint32_t>> pixels;
  for (std::uint32_t y = 0; y < image.height; ++y)
    for (std::uint32_t x = 2; x + 2 < image.width; ++x)
      if (stands_out(image, x, y)) {
        pixels.emplace_back(x, y);
        out[x] += 1;
      }
  double times_others = 0;
  const Lattice lattice = best_lattice(out, times_others);
  if (times_others < kTimesOthers) return std::nullopt;

  std::array<std::vector<float>, 3> values;
  const auto each = [&](const auto& function) {
    for (const auto& [x, y] : pixels)
      if (lattice.has(x)) function(x, image.row(y) + std::size_t{3} * x);
  };
  each([&](std::uint32_t, const float* p) {
    for (std::size_t c = 0; c < 3; ++c) values[c].push_back(p[c]);
  });
  color = middle_of(values);
  std::vector<std::uint32_t> of_line(image.width);
  std::size_t all = 0, own = 0;
  each([&](std::uint32_t x, const float* p) {
    ++all;
    const bool is_own = std::fabs(brightness(p) - brightness(color.data())) < kAboutOne;
    own += is_own;
    of_line[x] += is_own;
  });
  // What is dark shows no dark lines: they are looked for from the first to the last that is seen.
  std::size_t lines = 0, until_last = 0, seen = 0;
  for (std::uint32_t x = 2; x + 2 < image.width; ++x) {
    if (!lattice.has(x)) continue;
    lines += seen > 0 || of_line[x] >= kLeastOfLine * image.height;
    if (of_line[x] < kLeastOfLine * image.height) continue;
    ++seen;
    until_last = lines;
  }
  const bool are_lines = static_cast<double>(own) >= kOfPixels * static_cast<double>(all) &&
                         static_cast<double>(seen) >= kOfLines * static_cast<double>(until_last);
  return are_lines && seen >= kLeastLines ? std::optional(lattice) : std::nullopt;
}

std::vector<std::uint32_t> painted_of(std::uint32_t size, const std::optional<Lattice>& lattice) {
  std::vector<std::uint32_t> painted;
  for (std::uint32_t i = 0; i < size; ++i)
    if (!lattice || !lattice->has(i)) painted.push_back(i);
  return painted;
}

/// What lines of this colour become beside what was painted tells how far it is from theirs.
void correct_color(UnpaintedLines& lines, const JpegTables& tables) {
  constexpr int kRounds = 3;
  const Image& image = lines.handed_in;
  const Image painted = lines.painted(image);
  std::vector<bool> column(image.width, true), row(image.height, true);
  for (const std::uint32_t x : lines.columns) column[x] = false;
  for (const std::uint32_t y : lines.rows) row[y] = false;
  for (int i = 0; i < kRounds; ++i) {
    const Image again =
        compressed_again(lines.unpainted(painted, 0, 0, painted.width, painted.height), tables);
    std::array<std::vector<float>, 3> apart;
    for (std::uint32_t y = 0; y < image.height; ++y)
      for (std::uint32_t x = 0; x < image.width; ++x)
        if (column[x] || row[y])
          for (std::size_t c = 0; c < 3; ++c) {
            const std::size_t at = std::size_t{3} * x + c;
            apart[c].push_back(image.row(y)[at] - again.row(y)[at]);
          }
    const std::array<float, 3> by = middle_of(apart);
    for (std::size_t c = 0; c < 3; ++c)
      lines.color[c] = std::clamp(lines.color[c] + by[c], 0.0F, 1.0F);
  }
}

}  // namespace

Image UnpaintedLines::painted(const Image& image) const {
  Image out(static_cast<std::uint32_t>(columns.size()), static_cast<std::uint32_t>(rows.size()));
  for (std::uint32_t y = 0; y < out.height; ++y)
    for (std::uint32_t x = 0; x < out.width; ++x)
      std::copy_n(image.row(rows[y]) + std::size_t{3} * columns[x], 3,
                  out.row(y) + std::size_t{3} * x);
  return out;
}

Image UnpaintedLines::unpainted(const Image& painted, std::uint32_t left, std::uint32_t top,
                                std::uint32_t right, std::uint32_t bottom) const {
  Image out = handed_in;
  if (left >= right || top >= bottom) return out;
  // Lines at the picture's end belong to it, too.
  const auto first = [](const std::vector<std::uint32_t>& kept, std::uint32_t i) {
    return i == 0 ? 0 : kept[i];
  };
  const auto last = [](const std::vector<std::uint32_t>& kept, std::uint32_t i,
                       std::uint32_t size) { return i == kept.size() ? size : kept[i]; };
  for (std::uint32_t y = first(rows, top); y < last(rows, bottom, out.height); ++y)
    for (std::uint32_t x = first(columns, left); x < last(columns, right, out.width); ++x)
      std::copy_n(color.data(), 3, out.row(y) + std::size_t{3} * x);
  for (std::uint32_t y = top; y < bottom; ++y)
    for (std::uint32_t x = left; x < right; ++x)
      std::copy_n(painted.row(y) + std::size_t{3} * x, 3,
                  out.row(rows[y]) + std::size_t{3} * columns[x]);
  return out;
}

std::optional<UnpaintedLines> find_unpainted(const Image& image, const JpegTables& tables) {
  UnpaintedLines lines;
  std::array<float, 3> of_rows{};
  const std::optional<Lattice> columns = columns_of(image, lines.color),
                               rows = columns_of(transposed(image), of_rows);
  if (!columns && !rows) return std::nullopt;
  if (!columns) lines.color = of_rows;
  lines.handed_in = image;
  lines.columns = painted_of(image.width, columns);
  lines.rows = painted_of(image.height, rows);
  correct_color(lines, tables);
  return lines;
}

}  // namespace zraka
