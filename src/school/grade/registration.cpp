// SPDX-License-Identifier: Apache-2.0
// Hypotheses are made with few pixels and refined with more (a pyramid); the measure is the
// normalised cross-correlation of outlines over what is visible.
#include "school/grade/registration.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>

#include "school/grade/correlation.hpp"

namespace zraka {
namespace {

/// A position that is as good as this needs no search.
constexpr double kGood = 0.8;
/// A scale that is as near to 1 as this may be 1: frames of windows pull at edges.
constexpr double kNearlyOne = 0.03;

struct Turned {
  Turn turn;
  Grid full;
};

struct Hypothesis {
  std::size_t turned;
  GridPlacement at;  ///< of the whole template in the whole submission
  double likeness;
  double bonus = 0;  ///< where nothing has to be taken for granted
};

}  // namespace

Grid reduced_to(const Grid& plane, std::uint32_t side) {
  const std::uint32_t most = std::max(plane.width, plane.height);
  if (most <= side) return plane;
  const double by = static_cast<double>(most) / side;
  const auto size = [&](std::uint32_t n) {
    return std::max(1U, static_cast<std::uint32_t>(std::lround(n / by)));
  };
  const std::uint32_t width = size(plane.width), height = size(plane.height);
  return resampled(
      plane,
      {0, 0, static_cast<double>(plane.width) / width, static_cast<double>(plane.height) / height},
      width, height);
}

GridPlacement rescaled(const GridPlacement& p, double template_by_x, double template_by_y,
                       double submission_by_x, double submission_by_y) {
  return {p.left * submission_by_x, p.top * submission_by_y,
          p.across * submission_by_x / template_by_x, p.down * submission_by_y / template_by_y};
}

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
  explicit Sizes(const Grid& grid)
      : coarse(reduced_to(grid, kCoarseOutlines)),
        middle(reduced_to(grid, kMiddleOutlines)),
        fine(reduced_to(grid, kFineOutlines)),
        full(grid) {}
  Searched coarse, middle, fine, full;
};

Template::Template(const std::vector<const Image*>& pictures) {
  for (const Image* picture : pictures) {
    const Grid one = outlines(*picture);
    if (outlines_.values.empty()) outlines_ = Grid(one.width, one.height);
    for (std::size_t i = 0; i < one.values.size(); ++i) outlines_.values[i] += one.values[i];
  }
  sizes_ = std::make_shared<const Sizes>(outlines_);
}

/// By whole pixels, in the right picture's own size; all of its pixels are asked.
GridPlacement Template::best_shift(const Grid& submission, const GridPlacement& found) const {
  const SearchLevel level(sizes_->full, submission);
  // The middle tells best where it lies.
  const double left = std::round(found.left + outlines_.width / 2.0 * (found.across - 1)),
               top = std::round(found.top + outlines_.height / 2.0 * (found.down - 1));
  GridPlacement best{left, top, 1, 1};
  double most = -1;
  for (int y = -2; y <= 2; ++y)
    for (int x = -2; x <= 2; ++x) {
      const GridPlacement at{left + x, top + y, 1, 1};
      if (const double like = level.likeness(at); like > most) most = like, best = at;
    }
  return best;
}

std::vector<Position> Template::find(const Image& submission) const {
  const Grid drawn = outlines(submission);
  const Grid &full = outlines_, &coarse = sizes_->coarse.grid, &middle = sizes_->middle.grid,
             &fine = sizes_->fine.grid;
  std::vector<Turned> turns;
  for (const Turn& turn : kTurns) {
    Grid plane = turn.flipped_first ? upside_down(drawn) : drawn;
    if (turn.transposed) plane = transposed(plane);
    if (turn.flipped) plane = upside_down(plane);
    turns.push_back({turn, std::move(plane)});
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
    hypothesis.likeness = SearchLevel(sizes_->middle, small).refine(at, first, last);
    hypothesis.at = rescaled(at, w / middle.width, h / middle.height, 1 / sx, 1 / sy);
  };

  // The whole submission is the picture, in any size.
  std::vector<Hypothesis> all;
  const auto try_whole = [&](std::size_t i) {
    const double across = turns[i].full.width / w, down = turns[i].full.height / h;
    if (std::fabs(across / down - 1) > kAxesApart) return;
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
      for (double scale = kSmallestScale; scale <= kLargestScale; scale *= kScaleStep) {
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
    return {{{}, {0, 0, submission.width / w, submission.height / h}, 0}};

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
  const SearchLevel level(sizes_->fine, small);
  GridPlacement at = rescaled(chosen.at, fine.width / w, fine.height / h, sx, sy);
  Position position{turned.turn, {}, level.refine(at, 1, 0.06)};
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
    positions.push_back({turned.turn, p, like});
  };
  // In its own size it lies where it lies, but for a shift that outlines are sure of.
  const GridPlacement same{0, 0, 1, 1};
  const bool own_size = turned.full.width == full.width && turned.full.height == full.height;
  if (own_size && near(same)) positions.push_back({turned.turn, same, 0});
  GridPlacement shifted{0, 0, 1, 1};
  if (off(found.across, 1) < kNearlyOne && off(found.down, 1) < kNearlyOne) {
    shifted = best_shift(turned.full, found);
    if (!own_size || shifted != same)
      positions.push_back({turned.turn, shifted, position.likeness});
  }
  const GridPlacement whole{0, 0, turned.full.width / w, turned.full.height / h};
  if (near(whole)) {
    if (whole != shifted && !own_size) add(whole);
  } else if (off(submission.width / w, submission.height / h * 1.0) <
             kAxesApart * submission.width / w) {
    positions.push_back({{}, {0, 0, submission.width / w, submission.height / h}, 0});
  }
  // Screens scale both axes alike.
  const double alike = (found.across + found.down) / 2;
  GridPlacement uniform{found.left + w / 2 * (found.across - alike),
                        found.top + h / 2 * (found.down - alike), alike, alike};
  if (off(alike, 1) > 0.002 && near(uniform)) add(uniform);
  positions.push_back(position);
  return positions;
}

}  // namespace zraka
