// SPDX-License-Identifier: Apache-2.0
// Hypotheses are made with few pixels and refined with more (a pyramid); the measure is the
// normalised cross-correlation of outlines over what is visible.
#include "school/grade/registration.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <utility>

namespace zraka {
namespace {

/// Sides of the right picture in the steps of the search.
constexpr std::uint32_t kCoarse = 24, kMiddle = 64, kFine = 200;
/// This much of the picture has to be in the submission, in pixels and in outlines.
constexpr double kLeast = 0.5;
/// A position that is as good as this needs no search.
constexpr double kGood = 0.8;
constexpr double kSmallest = 0.45, kLargest = 3.3, kStep = 1.07;

Grid reduced_to(const Grid& plane, std::uint32_t side) {
  const std::uint32_t most = std::max(plane.width, plane.height);
  if (most <= side) return plane;
  const double by = static_cast<double>(most) / side;
  const auto size = [&](std::uint32_t n) {
    return std::max(1U, static_cast<std::uint32_t>(std::lround(n / by)));
  };
  const std::uint32_t width = size(plane.width), height = size(plane.height);
  return resampled(plane,
                   {0, 0, static_cast<double>(plane.width) / width,
                    static_cast<double>(plane.height) / height},
                   width, height);
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

/// Sums over any rectangle of a grid, of its values and of their squares.
class Table {
 public:
  explicit Table(const Grid& grid)
      : stride_(std::size_t{grid.width} + 1), sums_(stride_ * (std::size_t{grid.height} + 1)) {
    for (std::uint32_t y = 0; y < grid.height; ++y) {
      std::array<double, 2> row{};
      for (std::uint32_t x = 0; x < grid.width; ++x) {
        const auto value = static_cast<double>(grid.row(y)[x]);
        row[0] += value;
        row[1] += value * value;
        const std::size_t here = (y + 1) * stride_ + x + 1;
        for (std::size_t i = 0; i < 2; ++i) sums_[here][i] = sums_[here - stride_][i] + row[i];
      }
    }
  }
  /// Right and bottom are outside.
  std::array<double, 2> over(std::size_t left, std::size_t top, std::size_t right,
                             std::size_t bottom) const {
    std::array<double, 2> sum{};
    for (std::size_t i = 0; i < 2; ++i)
      sum[i] = sums_[bottom * stride_ + right][i] - sums_[bottom * stride_ + left][i] -
               sums_[top * stride_ + right][i] + sums_[top * stride_ + left][i];
    return sum;
  }
  double energy() const { return sums_.back()[1]; }

 private:
  std::size_t stride_;
  std::vector<std::array<double, 2>> sums_;
};

/// The template in one of its sizes.
struct Searched {
  explicit Searched(Grid grid_of) : grid(std::move(grid_of)), table(grid) {}
  Grid grid;
  Table table;
};

/// A template in one of its sizes, and the submission in its own; positions are of the template's
/// pixels in the submission's.
class Level {
 public:
  Level(const Searched& searched, const Grid& submission)
      : searched_(searched), submission_(submission) {}

  double likeness(const GridPlacement& at) const {
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
    const auto [x0, x1] = visible(at.left, at.across, width, grid.width);
    const auto [y0, y1] = visible(at.top, at.down, height, grid.height);
    if (x0 == x1 || y0 == y1) return -1;
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
    for (std::uint32_t x = x0; x < x1; ++x) taps.push_back(tap(at.left + (x + 0.5) * at.across, width));
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

  /// Climbs from a placement: shifts and scales of both axes by steps that are halved. The first
  /// ones are in the template's pixels.
  double refine(GridPlacement& at, double first, double last) const {
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
          if (move < 2) next.left += by * at.across;
          else if (move < 4) next.top += by * at.down;
          else if (move < 6) stretch(next.left, next.across, w);
          else if (move < 8) stretch(next.top, next.down, h);
          else stretch(next.left, next.across, w), stretch(next.top, next.down, h);
          if (next.across / next.down > 1.08 || next.down / next.across > 1.08) continue;
          if (const double like = likeness(next); like > best + 1e-7)
            best = like, at = next, better = true;
        }
        if (!better) break;
      }
    }
    return best;
  }

 private:
  const Searched& searched_;
  const Grid& submission_;
};

/// The placement of one size of template and submission in those of another.
GridPlacement rescaled(const GridPlacement& p, double template_by_x, double template_by_y,
                   double submission_by_x, double submission_by_y) {
  return {p.left * submission_by_x, p.top * submission_by_y, p.across * submission_by_x / template_by_x,
          p.down * submission_by_y / template_by_y};
}

struct Turned {
  bool transposed, flipped;
  Grid full;
};

struct Hypothesis {
  std::size_t turned;
  GridPlacement at;  ///< of the whole template in the whole submission
  double likeness;
  double bonus = 0;  ///< where nothing has to be taken for granted
};

/// All shifts of a template in a submission, both small; the best few.
void slide(const Searched& small, const Grid& where, double least, const auto& found) {
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
          for (std::int32_t i = 0; i < 4; ++i) ts[static_cast<std::size_t>(i)] += a[x + i] * b[x + i];
        for (; x < x1; ++x) ts[0] += a[x] * b[x];
      }
      const std::array<double, 2> t = sums_of(small.table, x0, y0, x1, y1),
                                  s = sums_of(table, x0 + left, y0 + top, x1 + left, y1 + top);
      const Sums sums{static_cast<double>((x1 - x0) * (y1 - y0)), t[0], t[1], s[0], s[1],
                      static_cast<double>((ts[0] + ts[1]) + (ts[2] + ts[3]))};
      if (const double like = sums.likeness(w * h, small.table.energy()); like > least)
        found(left, top, like);
    }
}

}  // namespace

Grid outlines(const Image& image) {
  Grid out(image.width, image.height);
  const auto at = [&](std::int64_t x, std::int64_t y, std::size_t c) {
    const auto u = static_cast<std::uint32_t>(std::clamp<std::int64_t>(x, 0, image.width - 1)),
               v = static_cast<std::uint32_t>(std::clamp<std::int64_t>(y, 0, image.height - 1));
    return image.row(v)[std::size_t{3} * u + c];
  };
  for (std::uint32_t y = 0; y < image.height; ++y)
    for (std::uint32_t x = 0; x < image.width; ++x) {
      float most = 0;
      for (std::size_t c = 0; c < 3; ++c) {
        const float dx = at(std::int64_t{x} + 1, y, c) - at(std::int64_t{x} - 1, y, c),
                    dy = at(x, std::int64_t{y} + 1, c) - at(x, std::int64_t{y} - 1, c);
        most = std::max(most, dx * dx + dy * dy);
      }
      // The fourth root of the squared change, less what noise makes.
      out.row(y)[x] = std::sqrt(std::sqrt(std::max(0.0F, most - 1e-3F)));
    }
  return out;
}

struct Template::Sizes {
  explicit Sizes(const Grid& full)
      : coarse(reduced_to(full, kCoarse)),
        middle(reduced_to(full, kMiddle)),
        fine(reduced_to(full, kFine)) {}
  Searched coarse, middle, fine;
};

Template::Template(const std::vector<const Image*>& pictures) {
  for (const Image* picture : pictures) {
    const Grid one = outlines(*picture);
    if (outlines_.values.empty()) outlines_ = Grid(one.width, one.height);
    for (std::size_t i = 0; i < one.values.size(); ++i) outlines_.values[i] += one.values[i];
  }
  sizes_ = std::make_shared<const Sizes>(outlines_);
}

Template Template::mirrored() const {
  Template other = *this;
  for (std::uint32_t y = 0; y < outlines_.height; ++y)
    std::reverse(other.outlines_.row(y), other.outlines_.row(y) + outlines_.width);
  other.sizes_ = std::make_shared<const Sizes>(other.outlines_);
  return other;
}

std::vector<Position> Template::find(const Image& submission) const {
  const Grid drawn = outlines(submission);
  const Grid &full = outlines_, &coarse = sizes_->coarse.grid, &middle = sizes_->middle.grid,
             &fine = sizes_->fine.grid;
  std::vector<Turned> turns;
  for (const bool transpose : {false, true})
    for (const bool flip : {false, true}) {
      Grid plane = transpose ? transposed(drawn) : drawn;
      if (flip) plane = upside_down(plane);
      turns.push_back({transpose, flip, std::move(plane)});
    }
  const double w = full.width, h = full.height;

  // A hypothesis at the middle size, with a submission whose pixels are about as large.
  const auto judge = [&](Hypothesis& hypothesis, double first, double last) {
    const Grid& whole = turns[hypothesis.turned].full;
    const double by_x = w / middle.width * hypothesis.at.across,
                 by_y = h / middle.height * hypothesis.at.down;
    const auto width = static_cast<std::uint32_t>(std::max(4.0, std::round(whole.width / by_x))),
               height = static_cast<std::uint32_t>(std::max(4.0, std::round(whole.height / by_y)));
    const double sx = static_cast<double>(width) / whole.width,
                 sy = static_cast<double>(height) / whole.height;
    const Grid small = resampled(whole, {0, 0, 1 / sx, 1 / sy}, width, height);
    GridPlacement at = rescaled(hypothesis.at, middle.width / w, middle.height / h, sx, sy);
    hypothesis.likeness = Level(sizes_->middle, small).refine(at, first, last);
    hypothesis.at = rescaled(at, w / middle.width, h / middle.height, 1 / sx, 1 / sy);
  };

  // The whole submission is the picture, in any size.
  std::vector<Hypothesis> all;
  const auto try_whole = [&](std::size_t i) {
    const double across = turns[i].full.width / w, down = turns[i].full.height / h;
    if (std::fabs(across / down - 1) > 0.07) return;
    Hypothesis hypothesis{i, {0, 0, across, down}, -1};
    judge(hypothesis, 0.5, 0.25);
    hypothesis.bonus = i == 0 ? 0.1 : 0.05;
    all.push_back(hypothesis);
  };
  for (std::size_t i = 0; i < turns.size(); ++i) try_whole(i);
  const auto better = [](const Hypothesis& a, const Hypothesis& b) {
    return a.likeness + a.bonus > b.likeness + b.bonus;
  };
  std::sort(all.begin(), all.end(), better);
  if (all.empty() || all.front().likeness < kGood) {
    std::vector<Hypothesis> coarse_ones;
    for (std::size_t i = 0; i < turns.size(); ++i) {
      const Grid base = reduced_to(turns[i].full, 400);
      const double base_x = static_cast<double>(base.width) / turns[i].full.width,
                   base_y = static_cast<double>(base.height) / turns[i].full.height;
      for (double scale = kSmallest; scale <= kLargest; scale *= kStep) {
        const auto width = static_cast<std::uint32_t>(
                       std::round(turns[i].full.width / scale * coarse.width / w)),
                   height = static_cast<std::uint32_t>(
                       std::round(turns[i].full.height / scale * coarse.height / h));
        if (width < coarse.width * 3 / 5 || height < coarse.height * 3 / 5) break;
        const double sx = static_cast<double>(width) / turns[i].full.width,
                     sy = static_cast<double>(height) / turns[i].full.height;
        const Grid small = resampled(base, {0, 0, base_x / sx, base_y / sy}, width, height);
        Hypothesis best{i, {}, -1, i == 0 ? 0.05 : 0};
        slide(sizes_->coarse, small, 0.2, [&](std::int32_t left, std::int32_t top, double like) {
          if (like <= best.likeness) return;
          best.likeness = like;
          best.at = rescaled({static_cast<double>(left), static_cast<double>(top), 1, 1},
                             w / coarse.width, h / coarse.height, 1 / sx, 1 / sy);
        });
        if (best.likeness > 0) coarse_ones.push_back(best);
      }
    }
    std::sort(coarse_ones.begin(), coarse_ones.end(), better);
    coarse_ones.resize(std::min<std::size_t>(coarse_ones.size(), 24));
    for (Hypothesis& hypothesis : coarse_ones) {
      judge(hypothesis, 2, 0.25);
      all.push_back(hypothesis);
    }
    std::sort(all.begin(), all.end(), better);
  }
  if (all.empty() || all.front().likeness < 0)
    return {{false, false, {0, 0, submission.width / w, submission.height / h}, 0}};

  // The finest size.
  const Hypothesis& chosen = all.front();
  const Turned& turned = turns[chosen.turned];
  const double by_x = std::max(1.0, w / fine.width * chosen.at.across),
               by_y = std::max(1.0, h / fine.height * chosen.at.down);
  const auto width = static_cast<std::uint32_t>(std::round(turned.full.width / by_x)),
             height = static_cast<std::uint32_t>(std::round(turned.full.height / by_y));
  const double sx = static_cast<double>(width) / turned.full.width,
               sy = static_cast<double>(height) / turned.full.height;
  const Grid small = resampled(turned.full, {0, 0, 1 / sx, 1 / sy}, width, height);
  const Level level(sizes_->fine, small);
  GridPlacement at = rescaled(chosen.at, fine.width / w, fine.height / h, sx, sy);
  Position position{turned.transposed, turned.flipped, {}, level.refine(at, 1, 0.06)};
  position.placement = rescaled(at, w / fine.width, h / fine.height, 1 / sx, 1 / sy);

  // Shifted by whole pixels, or scaled as a whole, where that is about as good; a picture of the
  // same shape may also be one of another view, which no outline tells.
  std::vector<Position> positions;
  const GridPlacement found = position.placement;
  const auto off = [](double x, double y) { return std::fabs(x - y); };
  const auto near = [&](const GridPlacement& p) {
    const double slack = 1.5 * std::max(1.0, found.across);
    return off(p.left, found.left) < slack && off(p.top, found.top) < slack &&
           off(p.left + w * p.across, found.left + w * found.across) < slack &&
           off(p.top + h * p.down, found.top + h * found.down) < slack;
  };
  const auto add = [&](const GridPlacement& p) {
    const double like = level.likeness(rescaled(p, fine.width / w, fine.height / h, sx, sy));
    if (like < position.likeness - 0.05) return;
    positions.push_back({turned.transposed, turned.flipped, p, like});
  };
  // In its own size it lies where it lies, but for a shift that outlines are sure of.
  const GridPlacement same{0, 0, 1, 1};
  const bool own_size = turned.full.width == full.width && turned.full.height == full.height;
  if (own_size && near(same)) positions.push_back({turned.transposed, turned.flipped, same, 0});
  GridPlacement shifted{std::round(found.left), std::round(found.top), 1, 1};
  if (near(shifted)) {
    // The middle tells best by how much.
    shifted.left = std::round(found.left + w / 2 * (found.across - 1));
    shifted.top = std::round(found.top + h / 2 * (found.down - 1));
    if (!own_size || shifted != same) add(shifted);
  }
  const GridPlacement whole{0, 0, turned.full.width / w, turned.full.height / h};
  if (near(whole)) {
    if (whole != shifted && !own_size) add(whole);
  } else if (off(submission.width / w, submission.height / h * 1.0) < 0.07 * submission.width / w) {
    positions.push_back(
        {false, false, {0, 0, submission.width / w, submission.height / h}, 0});
  }
  positions.push_back(position);
  return positions;
}

}  // namespace zraka
