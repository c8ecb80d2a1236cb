// SPDX-License-Identifier: Apache-2.0
// Hypotheses are made with few pixels and refined with more (a pyramid); the measure is the
// normalised cross-correlation of outlines over what is visible.
#include "school/grade/registration.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>

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
  void add(double of_template, double of_submission) {
    n += 1;
    t += of_template;
    tt += of_template * of_template;
    s += of_submission;
    ss += of_submission * of_submission;
    ts += of_template * of_submission;
  }
  /// Less what is not visible, in pixels `all` and in squares `energy` of the template.
  double likeness(double all, double energy) const {
    if (n < kLeast * all || tt < kLeast * energy) return -1;
    const double of_t = tt - t * t / n, of_s = ss - s * s / n;
    if (of_t <= 1e-9 || of_s <= 1e-9) return -1;
    return (ts - t * s / n) / std::sqrt(of_t * of_s) * (0.7 + 0.3 * tt / energy);
  }
};

double energy_of(const Grid& plane) {
  double sum = 0;
  for (const float v : plane.values) sum += static_cast<double>(v) * static_cast<double>(v);
  return sum;
}

/// A template in one of its sizes, and the submission in its own; positions are of the template's
/// pixels in the submission's.
struct Level {
  const Grid& searched;
  const Grid& submission;
  double energy;

  double likeness(const GridPlacement& at) const {
    Sums sums;
    std::vector<float> weight(searched.width);
    std::vector<std::int32_t> column(searched.width);
    const double width = submission.width, height = submission.height;
    for (std::uint32_t x = 0; x < searched.width; ++x) {
      const double u = at.left + (x + 0.5) * at.across;
      const bool inside = u >= 0 && u <= width;
      const double c = std::clamp(u - 0.5, 0.0, width - 1.001);
      column[x] = inside ? static_cast<std::int32_t>(c) : -1;
      weight[x] = static_cast<float>(c - std::floor(c));
    }
    for (std::uint32_t y = 0; y < searched.height; ++y) {
      const double v = at.top + (y + 0.5) * at.down;
      if (v < 0 || v > height) continue;
      const double r = std::clamp(v - 0.5, 0.0, height - 1.001);
      const auto first = static_cast<std::uint32_t>(r);
      const auto w = static_cast<float>(r - std::floor(r));
      const float *a = submission.row(first),
                  *b = submission.row(std::min(first + 1, submission.height - 1));
      const float* t = searched.row(y);
      for (std::uint32_t x = 0; x < searched.width; ++x) {
        if (column[x] < 0) continue;
        const float *p = a + column[x], *q = b + column[x];
        const float f = weight[x];
        const std::size_t next = submission.width > 1 ? 1 : 0;
        const float upper = p[0] + f * (p[next] - p[0]), lower = q[0] + f * (q[next] - q[0]);
        sums.add(static_cast<double>(t[x]), static_cast<double>(upper + w * (lower - upper)));
      }
    }
    return sums.likeness(static_cast<double>(searched.values.size()), energy);
  }

  /// Climbs from a placement: shifts and scales of both axes by steps that are halved. The first
  /// ones are in the template's pixels.
  double refine(GridPlacement& at, double first, double last) const {
    double best = likeness(at);
    const double w = searched.width, h = searched.height;
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
void slide(const Grid& small, double energy, const Grid& where, double least,
           const auto& found) {
  const auto w = static_cast<std::int32_t>(small.width), h = static_cast<std::int32_t>(small.height);
  const auto width = static_cast<std::int32_t>(where.width),
             height = static_cast<std::int32_t>(where.height);
  for (std::int32_t top = -2 * h / 5; top <= height - 3 * h / 5; ++top)
    for (std::int32_t left = -2 * w / 5; left <= width - 3 * w / 5; ++left) {
      const std::int32_t x0 = std::max(0, -left), x1 = std::min(w, width - left),
                         y0 = std::max(0, -top), y1 = std::min(h, height - top);
      if ((x1 - x0) * (y1 - y0) * 2 < w * h) continue;
      float t = 0, tt = 0, s = 0, ss = 0, ts = 0;
      for (std::int32_t y = y0; y < y1; ++y) {
        const float* a = small.row(static_cast<std::uint32_t>(y));
        const float* b = where.row(static_cast<std::uint32_t>(y + top)) + left;
        for (std::int32_t x = x0; x < x1; ++x) {
          t += a[x], tt += a[x] * a[x];
          s += b[x], ss += b[x] * b[x];
          ts += a[x] * b[x];
        }
      }
      const Sums sums{static_cast<double>((x1 - x0) * (y1 - y0)), static_cast<double>(t),
                      static_cast<double>(tt), static_cast<double>(s), static_cast<double>(ss),
                      static_cast<double>(ts)};
      if (const double like = sums.likeness(w * h, energy); like > least) found(left, top, like);
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

Template::Template(const std::vector<const Image*>& pictures) {
  for (const Image* picture : pictures) {
    const Grid one = outlines(*picture);
    if (outlines_.values.empty()) outlines_ = Grid(one.width, one.height);
    for (std::size_t i = 0; i < one.values.size(); ++i) outlines_.values[i] += one.values[i];
  }
}

Template Template::mirrored() const {
  Template other = *this;
  for (std::uint32_t y = 0; y < outlines_.height; ++y)
    std::reverse(other.outlines_.row(y), other.outlines_.row(y) + outlines_.width);
  return other;
}

std::vector<Position> Template::find(const Image& submission) const {
  const Grid drawn = outlines(submission);
  const Grid &full = outlines_, coarse = reduced_to(full, kCoarse),
              middle = reduced_to(full, kMiddle), fine = reduced_to(full, kFine);
  const double of_coarse = energy_of(coarse), of_middle = energy_of(middle),
               of_fine = energy_of(fine);
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
    hypothesis.likeness = Level{middle, small, of_middle}.refine(at, first, last);
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
        slide(coarse, of_coarse, small, 0.2, [&](std::int32_t left, std::int32_t top, double like) {
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
  const Level level{fine, small, of_fine};
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
