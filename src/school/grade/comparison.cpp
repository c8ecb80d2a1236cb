// SPDX-License-Identifier: Apache-2.0
#include "school/grade/comparison.hpp"

#include <algorithm>
#include <cmath>

#include "school/grade/refine.hpp"

namespace zraka {
namespace {

/// So many candidates that come nearest with few pixels are compared with all.
constexpr std::size_t kShortList = 12;
/// Of these the nearest, and those that leave up to so many times as much, are looked at closely.
constexpr std::size_t kLookedAt = 2;
constexpr double kFar = 4;

/// A region of a picture in another size of it.
Region scaled(const Region& r, std::uint32_t width, std::uint32_t height, std::uint32_t to_width,
              std::uint32_t to_height) {
  const auto one = [](std::uint32_t n, std::uint32_t of, std::uint32_t in, std::uint32_t more) {
    return static_cast<std::uint32_t>((std::uint64_t{n} * in + more) / of);
  };
  return {one(r.left, width, to_width, width - 1), one(r.top, height, to_height, height - 1),
          one(r.right, width, to_width, 0), one(r.bottom, height, to_height, 0)};
}

/// Do few pixels tell nothing of it?
bool is_small_shift(Mistake mistake) {
  return mistake == Mistake::pixel_center || mistake == Mistake::shifted;
}

}  // namespace

StageComparison::StageComparison(const StagePictures& pictures, int stage, const Fitted& fitted,
                                 const Compression& compression, const MistakenBy& by)
    : pictures_(pictures),
      sized_(fitted.pictures != nullptr ? *fitted.pictures : pictures),
      stage_(stage),
      wanted_(sized_.right(stage)),
      fitted_(fitted),
      jpeg_(compression.jpeg),
      tables_(compression.tables),
      unpainted_(compression.unpainted) {
  const Image mistaken = by == MistakenBy{} ? Image() : sized_.picture(stage, by);
  const Image& shown = by == MistakenBy{} ? wanted_ : mistaken;
  if (stage > 1) lie_best_on(shown);
  close_ = closeness_of(fitted_, jpeg_, pictures.rubric());
  if (stage == 1) {
    fitted_.image = as_silhouette(fitted_.image);
    close_.biased = 1;  // at outlines it is white or black
  }
  trim_frame(fitted_, shown, jpeg_);
  ways_ = ways_to_align();
  if (stage == 1) ways_.resize(1);
}

/// A frame or clear edges pull at where it lies, until they are known to be none of it.
void StageComparison::lie_best_on(const Image& picture) {
  refine(fitted_, picture);
  if (fitted_.exact) return;
  Fitted trimmed = fitted_;
  trim_frame(trimmed, picture, jpeg_);
  const Region &whole = fitted_.region, &part = trimmed.region;
  const GridPlacement& at = fitted_.placement;
  Shown shown;
  // The region leaves out the outermost pixels, which are mixed with what lies outside.
  if (part.left > whole.left) shown.left = at.left + at.across * (part.left - 1);
  if (part.top > whole.top) shown.top = at.top + at.down * (part.top - 1);
  if (part.right < whole.right) shown.right = at.left + at.across * (part.right + 1);
  if (part.bottom < whole.bottom) shown.bottom = at.top + at.down * (part.bottom + 1);
  if (shown == Shown{}) return;
  trimmed.shown = shown;
  refine(trimmed, picture);
  fitted_ = trimmed;
}

void StageComparison::take_way(std::size_t way) {
  way_ = way;
  // Of what was compressed with other colours the same colours lose something else.
  as_handed_in_ = RoundTrip(fitted_, way == 0 && stage_ != 1 ? tables_ : nullptr, unpainted_);
  taken_ = aligned(fitted_.image, ways_[way]);
  smooth_ = smoothed(taken_, close_.blur);
}

void StageComparison::lie_on(const MistakenBy& by) {
  if (fitted_.exact || stage_ == 1) return;
  Fitted there = fitted_;
  if (way_ != 0)
    there.source = std::make_shared<const Image>(aligned(*fitted_.source, ways_[way_]));
  there = placed_at(there, there.placement);
  refine(there, sized_.picture(stage_, by));
  if (there.placement == fitted_.placement) return;
  fitted_ = placed_at(fitted_, there.placement);
  fitted_.softened = there.softened;
  trim_frame(fitted_, wanted_, jpeg_);
  take_way(way_);
}

bool StageComparison::compare_with_right() {
  const Image picture = as_handed_in_(wanted_);
  right_ = {nullptr, way_, mean_square(taken_, picture, fitted_.region),
            rest_of(smooth_, picture, fitted_.region, close_)};
  return right_.rest.share <= close_.share && right_.rest.biased <= close_.biased &&
         (close_.blur == 0 || stage_ == 1 || right_.rest.solid == 0) &&
         zraka::shows(taken_, picture, fitted_.region);
}

Image StageComparison::few(std::uint32_t width, std::uint32_t height) const {
  return sampled(taken_, width, height);
}

Region StageComparison::region_of_few(std::uint32_t width, std::uint32_t height) const {
  return scaled(fitted_.region, wanted_.width, wanted_.height, width, height);
}

std::vector<Match> StageComparison::nearest_by_few() const {
  const Image& coarse = pictures_.coarse(stage_);
  const Image less = sampled(fitted_.image, coarse.width, coarse.height);
  const Region part = region_of_few(coarse.width, coarse.height);
  std::vector<Match> all;
  for (std::size_t way = 0; way < ways_.size(); ++way) {
    const Image small = aligned(less, ways_[way]);
    for (const Candidate& candidate : pictures_.mistaken(stage_))
      all.push_back({&candidate, way, mean_square(small, candidate.coarse, part)});
    all.push_back({nullptr, way, mean_square(small, coarse, part)});
  }
  return all;
}

std::size_t StageComparison::best_way(const std::vector<Match>& matches) const {
  double as_is = std::numeric_limits<double>::infinity(), best = as_is;
  std::size_t way = 0;
  for (const Match& match : matches) {
    if (match.way == 0) as_is = std::min(as_is, match.distance);
    // Of two ways that are as good, the plainer.
    if (match.distance < 0.9 * best) best = match.distance, way = match.way;
  }
  return best > 0.5 * as_is ? 0 : way;
}

Match StageComparison::look_at(const Candidate& candidate, const Image& picture) const {
  return {&candidate, way_, mean_square(taken_, picture, fitted_.region),
          rest_of(smooth_, picture, fitted_.region, close_)};
}

Rest StageComparison::left_of_rounding(const Image& picture) const {
  Closeness close = close_;
  close.reach = false;
  close.tolerance = static_cast<float>((pictures_.rubric().tolerance + 0.5) / 255);
  return rest_of(smooth_, picture, fitted_.region, close);
}

LeftOfChange StageComparison::left_of_change(const Image& picture) const {
  constexpr float kChanged = 1.5F / 255;
  constexpr float kSamePixel = 0.5F / 255;
  constexpr int kTooFew = 32;
  const Image right = picture_of({});
  LeftOfChange left;
  int changed = 0, unchanged = 0, same = 0;
  const Region& r = fitted_.region;
  for (std::uint32_t y = r.top; y < r.bottom; ++y)
    for (std::uint32_t x = r.left + 1; x < r.right; ++x) {
      const std::size_t at = std::size_t{3} * x;
      const float *p = picture.row(y) + at, *q = right.row(y) + at, *t = taken_.row(y) + at;
      float change = 0, slope = 0, most = 0, rest = 0, of_right = 0;
      for (std::size_t c = 0; c < 3; ++c) {
        change = std::max(change, std::fabs(p[c] - q[c]));
        slope = std::max(slope, std::fabs(q[c] - (q - 3)[c]));
        most = std::max(most, std::fabs(t[c] - p[c]));
        rest += (t[c] - p[c]) * (t[c] - p[c]) / 3;
        of_right += (t[c] - q[c]) * (t[c] - q[c]) / 3;
      }
      if (change > kChanged) {
        ++changed;
        left.changed += static_cast<double>(rest);
        left.of_right += static_cast<double>(of_right);
      } else if (slope > 0) {
        ++unchanged;
        same += most < kSamePixel;
        left.noise += static_cast<double>(rest);
      }
    }
  left.changed /= std::max(changed, 1);
  left.of_right /= std::max(changed, 1);
  if (unchanged < kTooFew) {
    left.noise = std::numeric_limits<double>::infinity();
    return left;
  }
  left.noise /= unchanged;
  left.same_there = same >= unchanged / 2;
  return left;
}

void StageComparison::look_closely(std::vector<Match>& matches) const {
  std::erase_if(matches, [&](const Match& m) { return m.candidate == nullptr || m.way != way_; });
  const auto nearer = [](const Match& a, const Match& b) { return a.distance < b.distance; };
  std::sort(matches.begin(), matches.end(), nearer);
  std::size_t place = 0;
  std::erase_if(matches, [&](const Match& m) {
    return place++ >= kShortList && !is_small_shift(m.candidate->by.first);
  });
  std::vector<Image> pictures;
  for (Match& match : matches) {
    pictures.push_back(picture_of(match.candidate->by));
    match.distance = mean_square(taken_, pictures.back(), fitted_.region);
  }
  std::vector<std::size_t> order(matches.size());
  for (std::size_t i = 0; i < order.size(); ++i) order[i] = i;
  std::sort(order.begin(), order.end(),
            [&](std::size_t a, std::size_t b) { return nearer(matches[a], matches[b]); });
  std::vector<Match> sorted;
  for (const std::size_t i : order) {
    sorted.push_back(matches[i]);
    // What is far cannot be the cause.
    if (sorted.size() <= kLookedAt || sorted.back().distance <= kFar * sorted.front().distance)
      sorted.back() = look_at(*matches[i].candidate, pictures[i]);
    else
      sorted.back().rest = {1, 1, 1, 1};
  }
  matches = std::move(sorted);
}

Image StageComparison::picture_of(const MistakenBy& by) const {
  return as_handed_in_(sized_.picture(stage_, by));
}

bool StageComparison::shows(const MistakenBy& by) const {
  return zraka::shows(taken_, picture_of(by), fitted_.region);
}

bool StageComparison::has_its_powers(const MistakenBy& by) const {
  const auto is_power = [](Mistake mistake) {
    return mistake == Mistake::exponent_halved || mistake == Mistake::exponent_fourfold;
  };
  if (!is_power(by.first) && !is_power(by.second)) return true;
  // Where a parabola through three powers' distances is lowest, in steps.
  constexpr double kStep = 1.5, kMostSteps = 0.4;
  const auto distance = [&](const Image& picture) {
    return mean_square(taken_, as_handed_in_(picture), fitted_.region);
  };
  const double less = distance(sized_.with_power_times(1 / kStep, stage_, by)),
               own = distance(sized_.picture(stage_, by)),
               more = distance(sized_.with_power_times(kStep, stage_, by));
  const double bend = less - 2 * own + more;
  return own < less && own < more && std::fabs(less - more) < 2 * kMostSteps * bend;
}

bool StageComparison::is_near(const MistakenBy& by, double share) const {
  const Image picture = picture_of(by);
  return mean_square(taken_, picture, fitted_.region) <= share * spread(picture, fitted_.region);
}

namespace {

/// From one picture to another.
struct ChangeOf {
  const Image &from, &to;
};
/// Of two changes, the sums of squares and of products.
struct Products {
  double first = 0, second = 0, both = 0;
};

Products products(const Region& r, const ChangeOf& first, const ChangeOf& second) {
  Products sums;
  for (std::uint32_t y = r.top; y < r.bottom; ++y) {
    const float *a = first.from.row(y), *b = first.to.row(y);
    const float *x = second.from.row(y), *t = second.to.row(y);
    float dd = 0, ee = 0, de = 0;
    for (std::size_t i = std::size_t{3} * r.left; i < std::size_t{3} * r.right; ++i) {
      const float d = b[i] - a[i], e = t[i] - x[i];
      dd += d * d;
      ee += e * e;
      de += d * e;
    }
    sums.first += static_cast<double>(dd);
    sums.second += static_cast<double>(ee);
    sums.both += static_cast<double>(de);
  }
  return sums;
}

}  // namespace

Likeness StageComparison::likeness_of_change(const Image& from, const Image& to) const {
  const Image first = smoothed(from, close_.blur), second = smoothed(to, close_.blur);
  const auto [changed, left, both] = products(fitted_.region, {first, second}, {first, smooth_});
  if (changed <= 0 || left <= 0) return {};
  return {both / changed, both * both / (changed * left)};
}

std::vector<double> StageComparison::products_with(const std::vector<Candidate>& candidates) const {
  const Image& right = pictures_.coarse(stage_);
  const Image small = few(right.width, right.height);
  const Region r = region_of_few(right.width, right.height);
  std::vector<double> products;
  for (const Candidate& candidate : candidates) {
    double sum = 0;
    for (std::uint32_t y = r.top; y < r.bottom; ++y) {
      const float *t = small.row(y), *a = right.row(y), *b = candidate.coarse.row(y);
      float part = 0;
      for (std::size_t i = std::size_t{3} * r.left; i < std::size_t{3} * r.right; ++i)
        part += (t[i] - a[i]) * (b[i] - a[i]);
      sum += static_cast<double>(part);
    }
    products.push_back(sum);
  }
  return products;
}

std::vector<Mistake> StageComparison::likely_besides(const MistakenBy& by, const Image& picture,
                                                     std::size_t most) const {
  const Image& right = pictures_.coarse(stage_);
  const Image small = few(right.width, right.height),
              explained = sampled(picture, right.width, right.height);
  const Region r = region_of_few(right.width, right.height);
  std::vector<std::pair<double, Mistake>> all;
  for (const Candidate& candidate : pictures_.mistaken(stage_)) {
    const Mistake mistake = candidate.by.first;
    // Where a picture lies was searched for.
    if (entry_of(mistake).first_stage == 1 || mistake == by.first || mistake == by.second) continue;
    const auto [changed, left, both] = products(r, {right, candidate.coarse}, {explained, small});
    if (changed > 0 && left > 0 && both > 0.15 * changed)
      all.emplace_back(both * both / (changed * left), mistake);
  }
  std::sort(all.rbegin(), all.rend());
  std::vector<Mistake> mistakes;
  for (std::size_t i = 0; i < std::min(most, all.size()); ++i) mistakes.push_back(all[i].second);
  return mistakes;
}

}  // namespace zraka
