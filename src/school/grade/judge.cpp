// SPDX-License-Identifier: Apache-2.0
// The cause of a wrong picture is the mistake whose own picture is nearest to it, if what is left
// is no more than what the picture's alteration makes of a right one: noise of a JPEG or of a
// scaled screenshot adds the same distance to all of them.
#include "school/grade/judge.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <optional>

#include "image/alter.hpp"

namespace zraka {
namespace {

/// So many candidates that come nearest with few pixels are compared with all.
constexpr std::size_t kShortList = 12;
/// A mistake explains a picture where it leaves no more than this of the pixels that differ from
/// the right one, and of all.
constexpr double kLeftOfWrong = 0.08, kLeftOfAll = 0.03;
/// Other mistakes are as likely up to this ratio of what is left.
constexpr double kAsLikely = 1.3;
/// It explains most where it leaves this much of the pixels, and of the squared differences, and
/// every other one leaves this many times as much.
constexpr double kMostOfPixels = 0.4, kMostOfSquares = 0.12, kNext = 2;
/// A mistake may be one of two if it takes away this much of the squared differences.
constexpr double kPartly = 0.1;
/// Outlines that are less alike than this tell nothing.
constexpr double kLike = 0.5, kSeen = 0.65;
constexpr std::size_t kFirstOfTwo = 4, kPairs = 4;

struct Match {
  const Candidate* candidate = nullptr;  ///< nullptr: the right picture
  std::size_t way = 0;
  double distance = std::numeric_limits<double>::infinity();  ///< mean square
  Rest rest{};
};

/// A region of a picture in another size of it.
Region scaled(const Region& r, const Image& from, const Image& to) {
  const auto one = [](std::uint32_t n, std::uint32_t of, std::uint32_t in, std::uint32_t more) {
    return static_cast<std::uint32_t>((std::uint64_t{n} * in + more) / of);
  };
  return {one(r.left, from.width, to.width, from.width - 1),
          one(r.top, from.height, to.height, from.height - 1), one(r.right, from.width, to.width, 0),
          one(r.bottom, from.height, to.height, 0)};
}

class Judge {
 public:
  Judge(const StagePictures& pictures, int stage, const Fitted& fitted, bool jpeg)
      : pictures_(pictures),
        sized_(fitted.pictures != nullptr ? *fitted.pictures : pictures),
        stage_(stage),
        wanted_(sized_.right(stage)),
        fitted_(fitted),
        close_(closeness_of(fitted, jpeg, pictures.rubric())) {
    if (stage == 1) fitted_.image = as_silhouette(fitted_.image);
    trim_frame();
    ways_ = ways_to_align();
    if (stage == 1) ways_.resize(1);
  }

  /// Two mistakes at once are only looked for where that is wanted.
  StageGrade verdict(const std::set<Mistake>* known);
  bool is_right() {
    take_way(0);
    return compare_with_right();
  }

 private:
  void trim_frame();
  std::vector<Match> nearest_by_few(const std::vector<Candidate>& candidates,
                                    const std::vector<std::size_t>& ways) const;
  void look_closely(std::vector<Match>& matches) const;
  void take_way(std::size_t way);
  bool compare_with_right();
  std::size_t best_way(const std::vector<Match>& matches) const;
  bool explains(const Match& match) const;
  std::vector<const Match*> as_likely(const std::vector<Match>& matches) const;
  bool name_two(const std::vector<Match>& singles, const std::set<Mistake>& known,
                StageGrade& grade);
  void settle(Verdict verdict, const Rest& left, StageGrade& grade) const;

  Image picture_of(const Candidate& candidate) const {
    return &sized_ == &pictures_ ? candidate.picture.image() : sized_.picture(stage_, candidate.by);
  }

  const StagePictures& pictures_;
  const StagePictures& sized_;  ///< in the size that it was drawn in
  int stage_;
  const Image& wanted_;
  Fitted fitted_;
  Closeness close_;
  std::vector<Alignment> ways_;
  std::size_t way_ = 0;
  Image taken_, smooth_;  ///< in the chosen way
  Match right_;
};

/// Rows and columns at the edges that are mostly of one colour, which the right picture has not,
/// are a frame over it, or were transparent: they were not handed in.
void Judge::trim_frame() {
  Region& r = fitted_.region;
  const std::uint32_t most_clear = std::max(3U, wanted_.width / 50);
  const auto foreign = [&](std::uint32_t trimmed, std::uint32_t x0, std::uint32_t x1,
                           std::uint32_t y0, std::uint32_t y1) {
    std::array<std::vector<float>, 3> channels;
    for (std::uint32_t y = y0; y < y1; ++y)
      for (std::uint32_t x = x0; x < x1; ++x)
        for (std::size_t c = 0; c < 3; ++c)
          channels[c].push_back(fitted_.image.row(y)[std::size_t{3} * x + c]);
    std::array<float, 3> middle{};
    for (std::size_t c = 0; c < 3; ++c) {
      std::vector<float> sorted = channels[c];
      const auto half = sorted.begin() + static_cast<std::ptrdiff_t>(sorted.size() / 2);
      std::nth_element(sorted.begin(), half, sorted.end());
      middle[c] = *half;
    }
    std::size_t count = 0, same = 0, others = 0, i = 0;
    for (std::uint32_t y = y0; y < y1; ++y)
      for (std::uint32_t x = x0; x < x1; ++x, ++i) {
        bool plain = true, other = false;
        for (std::size_t c = 0; c < 3; ++c) {
          plain = plain && std::fabs(channels[c][i] - middle[c]) < 0.05F;
          other = other ||
                  std::fabs(channels[c][i] - wanted_.row(y)[std::size_t{3} * x + c]) > 0.06F;
        }
        count += plain && other;
        same += plain;
        others += other;
      }
    // A line that is all of one colour may be a part of the background, if there are many.
    return count * 10 > i * 6 || (same * 100 >= 97 * i && others > 0 && trimmed < most_clear);
  };
  const Region whole = r;
  const std::uint32_t across = (r.right - r.left) / 7, down = (r.bottom - r.top) / 7;
  while (r.top < whole.top + down &&
         foreign(r.top - whole.top, r.left, r.right, r.top, r.top + 1))
    ++r.top;
  while (r.bottom > whole.bottom - down &&
         foreign(whole.bottom - r.bottom, r.left, r.right, r.bottom - 1, r.bottom))
    --r.bottom;
  while (r.left < whole.left + across &&
         foreign(r.left - whole.left, r.left, r.left + 1, r.top, r.bottom))
    ++r.left;
  while (r.right > whole.right - across &&
         foreign(whole.right - r.right, r.right - 1, r.right, r.top, r.bottom))
    --r.right;
  // What was scaled has mixed the next one with it.
  if (fitted_.exact) return;
  r.left += r.left > whole.left;
  r.top += r.top > whole.top;
  r.right -= r.right < whole.right;
  r.bottom -= r.bottom < whole.bottom;
}

std::vector<Match> Judge::nearest_by_few(const std::vector<Candidate>& candidates,
                                         const std::vector<std::size_t>& ways) const {
  const Image& coarse = pictures_.coarse(stage_);
  const Image less =
      resampled(fitted_.image,
                {0, 0, static_cast<double>(wanted_.width) / coarse.width,
                 static_cast<double>(wanted_.height) / coarse.height},
                coarse.width, coarse.height);
  const Region part = scaled(fitted_.region, wanted_, less);
  std::vector<Match> all;
  for (const std::size_t way : ways) {
    const Image small = aligned(less, ways_[way]);
    for (const Candidate& candidate : candidates)
      all.push_back({&candidate, way, mean_square(small, candidate.coarse, part)});
    all.push_back({nullptr, way, mean_square(small, pictures_.coarse(stage_), part)});
  }
  return all;
}

/// As it was handed in, unless another way fits much better.
std::size_t Judge::best_way(const std::vector<Match>& matches) const {
  double as_is = std::numeric_limits<double>::infinity(), best = as_is;
  std::size_t way = 0;
  for (const Match& match : matches) {
    if (match.way == 0) as_is = std::min(as_is, match.distance);
    // Of two ways that are as good, the plainer.
    if (match.distance < 0.9 * best) best = match.distance, way = match.way;
  }
  return best > 0.5 * as_is ? 0 : way;
}

void Judge::take_way(std::size_t way) {
  way_ = way;
  taken_ = aligned(fitted_.image, ways_[way]);
  smooth_ = smoothed(taken_, close_.blur);
}

/// Keeps the best few, compared pixel by pixel, the nearest first.
void Judge::look_closely(std::vector<Match>& matches) const {
  std::erase_if(matches, [&](const Match& m) { return m.candidate == nullptr || m.way != way_; });
  const auto nearer = [](const Match& a, const Match& b) { return a.distance < b.distance; };
  std::sort(matches.begin(), matches.end(), nearer);
  matches.resize(std::min(matches.size(), kShortList));
  for (Match& match : matches) {
    const Image picture = through_scaling(picture_of(*match.candidate), fitted_);
    match.distance = mean_square(taken_, picture, fitted_.region);
    match.rest = rest_of(smooth_, picture, fitted_.region, close_);
  }
  std::sort(matches.begin(), matches.end(), nearer);
}

bool Judge::explains(const Match& match) const {
  const double wrong = right_.rest.share;
  const double least = 0.4 * close_.share;
  return match.rest.share <= std::max(least, kLeftOfWrong * wrong) &&
         match.rest.share <= std::max(least, kLeftOfAll) &&
         match.rest.biased <= close_.biased &&
         match.rest.energy <= 0.1 * right_.rest.energy && match.distance < right_.distance;
}

/// Those that explain the picture and that it cannot tell from the best one.
std::vector<const Match*> Judge::as_likely(const std::vector<Match>& matches) const {
  std::vector<const Match*> likely;
  for (const Match& match : matches)
    if (explains(match) &&
        (likely.empty() || match.distance <= kAsLikely * likely.front()->distance + kSame))
      likely.push_back(&match);
  return likely;
}

void Judge::settle(Verdict verdict, const Rest& left, StageGrade& grade) const {
  const Alignment& way = ways_[way_];
  grade.verdict = verdict;
  grade.alignment = fitted_.alignment;
  grade.alignment.swapped = way.swapped;
  grade.alignment.curve = way.curve;
  if (&sized_ != &pictures_) {
    grade.alignment.drawn_width = wanted_.width;
    grade.alignment.drawn_height = wanted_.height;
  }
  grade.alignment.visible =
      fitted_.region.pixels() / (wanted_.width * static_cast<double>(wanted_.height));
  grade.share_wrong = right_.rest.share;
  grade.share_left = left.share;
}

/// Two mistakes at once: one that was known before or that explains a part, and another one.
bool Judge::name_two(const std::vector<Match>& singles, const std::set<Mistake>& known,
                     StageGrade& grade) {
  std::vector<Mistake> firsts(known.begin(), known.end());
  for (const Match& match : singles) {
    if (firsts.size() >= kFirstOfTwo + known.size()) break;
    const Mistake mistake = match.candidate->by.first;
    if (match.rest.energy < (1 - kPartly) * right_.rest.energy && !known.contains(mistake))
      firsts.push_back(mistake);
  }
  // All pairs with few pixels, the nearest with all.
  const std::uint32_t stride = pictures_.stride();
  const Image& full = pictures_.right(stage_);
  const Image few = sampled(taken_, full.width / stride, full.height / stride);
  const Region& r = fitted_.region;
  const Region part = scaled(r, wanted_, few);
  std::vector<Match> pairs;
  for (const Mistake first : firsts) {
    if (entry_of(first).first_stage > stage_) continue;
    for (const Candidate& candidate : pictures_.mistaken_besides(stage_, first))
      pairs.push_back({&candidate, way_, mean_square(few, candidate.coarse, part)});
  }
  const auto nearer = [](const Match& a, const Match& b) { return a.distance < b.distance; };
  std::sort(pairs.begin(), pairs.end(), nearer);
  pairs.resize(std::min(pairs.size(), kPairs));
  // The nearest explains most, or none of them everything.
  if (pairs.empty() || pairs.front().distance > 0.3 * right_.distance) return false;
  std::vector<Image> whole;
  for (Match& pair : pairs) {
    whole.push_back(sized_.picture(stage_, pair.candidate->by));
    const Image picture = through_scaling(whole.back(), fitted_);
    pair.distance = mean_square(taken_, picture, r);
    pair.rest = rest_of(smooth_, picture, r, close_);
  }
  const auto image_of = [&](const Match& match) -> const Image& {
    return whole[static_cast<std::size_t>(&match - pairs.data())];
  };
  const Match* best = nullptr;
  for (const Match& pair : pairs)
    if (explains(pair) && (best == nullptr || pair.distance < best->distance)) best = &pair;
  if (best == nullptr) return false;
  // Both have to be in every pair that is as likely.
  const MistakenBy two = best->candidate->by;
  for (const Match& pair : pairs) {
    if (!explains(pair) || pair.distance > kAsLikely * best->distance + kSame) continue;
    const MistakenBy& by = pair.candidate->by;
    const bool same = by == two || by == MistakenBy(two.second, two.first);
    if (!same && mean_square(image_of(pair), image_of(*best), r) >= kSame) return false;
  }
  settle(Verdict::mistaken, best->rest, grade);
  grade.mistakes = {two.first, two.second};
  grade.both = true;
  return true;
}

bool Judge::compare_with_right() {
  const Image picture = through_scaling(wanted_, fitted_);
  right_ = {nullptr, way_, mean_square(taken_, picture, fitted_.region),
            rest_of(smooth_, picture, fitted_.region, close_)};
  return right_.rest.share <= close_.share && right_.rest.biased <= close_.biased &&
         shows(taken_, picture, fitted_.region);
}

StageGrade Judge::verdict(const std::set<Mistake>* known) {
  StageGrade grade{.stage = stage_};
  const auto finish = [&]() -> StageGrade& {
    Image there = taken_;
    if (grade.verdict != Verdict::right) {
      there = wanted_;  // what was cut off differs nowhere
      const Region& r = fitted_.region;
      for (std::uint32_t y = r.top; y < r.bottom; ++y)
        std::copy(taken_.row(y) + std::size_t{3} * r.left,
                  taken_.row(y) + std::size_t{3} * r.right,
                  there.row(y) + std::size_t{3} * r.left);
      grade.pixels = worst_pixels(there, wanted_, static_cast<double>(close_.tolerance), 3);
    }
    grade.aligned = std::move(there);
    return grade;
  };

  take_way(0);
  if (compare_with_right()) {
    settle(Verdict::right, right_.rest, grade);
    return finish();
  }
  std::vector<std::size_t> ways(ways_.size());
  for (std::size_t i = 0; i < ways.size(); ++i) ways[i] = i;
  const std::vector<Match> by_few = nearest_by_few(pictures_.mistaken(stage_), ways);
  if (const std::size_t way = best_way(by_few); way != 0) {
    take_way(way);
    if (compare_with_right()) {
      settle(Verdict::right, right_.rest, grade);
      return finish();
    }
  }
  // What hardly differs shows no mistake for sure.
  if (right_.rest.share < close_.share / 2 && close_.blur > 0) {
    settle(Verdict::unknown, right_.rest, grade);
    return finish();
  }
  std::vector<Match> matches = by_few;
  look_closely(matches);
  const std::vector<const Match*> likely = as_likely(matches);
  const auto seen = [&](const Match& match) {
    return shows(taken_, through_scaling(picture_of(*match.candidate), fitted_), fitted_.region);
  };
  if (!likely.empty() && seen(*likely.front())) {
    settle(Verdict::mistaken, likely.front()->rest, grade);
    for (const Match* match : likely) grade.mistakes.push_back(match->candidate->by.first);
    return finish();
  }
  settle(Verdict::unknown, right_.rest, grade);
  if (matches.empty() || !seen(matches.front())) return finish();
  if (known != nullptr && name_two(matches, *known, grade)) return finish();
  const Match& best = matches.front();
  const auto apart = [&](const Match& other) {
    return &other == &best || other.rest.energy > kNext * best.rest.energy ||
           std::fabs(other.distance - best.distance) < kSame;
  };
  if (best.rest.share <= kMostOfPixels * right_.rest.share && best.rest.share <= 0.2 &&
      best.rest.energy <= kMostOfSquares * right_.rest.energy &&
      std::all_of(matches.begin(), matches.end(), apart)) {
    settle(Verdict::probable, best.rest, grade);
    for (const Match& match : matches)
      if (std::fabs(match.distance - best.distance) < kSame)
        grade.mistakes.push_back(match.candidate->by.first);
  }
  return finish();
}

}  // namespace

StageGrade judge(const StagePictures& pictures, int stage, const Registered& submitted,
                 const std::set<Mistake>& known) {
  const Fitted* best = nullptr;
  for (const Fitted& fitted : submitted.fitted) {
    // A second mistake is easily lost in what an inexact fit allows.
    StageGrade grade =
        Judge(pictures, stage, fitted, submitted.jpeg).verdict(fitted.exact ? &known : nullptr);
    if (grade.verdict == Verdict::right || grade.verdict == Verdict::mistaken) return grade;
    // A picture that may lie anywhere is rather where its outlines say.
    if (best == nullptr || fitted.likeness > std::max(best->likeness, kLike)) best = &fitted;
  }
  StageGrade grade = Judge(pictures, stage, *best, submitted.jpeg).verdict(&known);
  if (stage == 1 || grade.verdict != Verdict::unknown || best->likeness >= kSeen) return grade;
  // A mirrored picture in a window. One of another view may be the right one, scaled.
  for (const Fitted& fitted : fit(*submitted.handed_in, pictures.mirrored_outlines(),
                                  pictures.right(7).width, pictures.right(7).height)) {
    StageGrade mirrored = Judge(pictures, stage, fitted, submitted.jpeg).verdict(nullptr);
    if (mirrored.verdict == Verdict::mistaken && mirrored.alignment.visible > 0.9 &&
        mirrored.mistakes.front() == Mistake::x_mirrored)
      return mirrored;
  }
  return grade;
}

int right_stage(const StagePictures& pictures, const Registered& submitted, int named) {
  const auto is_right = [&](int stage) {
    return std::any_of(submitted.fitted.begin(), submitted.fitted.end(), [&](const Fitted& fitted) {
      if (stage == 1 && !is_flat(fitted.image, fitted.region)) return false;
      return Judge(pictures, stage, fitted, submitted.jpeg).is_right();
    });
  };
  if (named != 0 && is_right(named)) return named;
  for (int stage = 7; stage >= 1; --stage)
    if (stage != named && is_right(stage)) return stage;
  return 0;
}

int nearest_stage(const StagePictures& pictures, const Registered& submitted) {
  const Fitted& fitted = submitted.fitted.back();
  int nearest = 7;
  double least = std::numeric_limits<double>::infinity();
  // Any picture of the scene has its silhouette.
  for (int stage = 7; stage >= (is_flat(fitted.image, fitted.region) ? 1 : 2); --stage) {
    const Image& wanted = pictures.right(stage);
    const double d = mean_square(stage == 1 ? as_silhouette(fitted.image) : fitted.image, wanted,
                                 fitted.region);
    if (d < least) least = d, nearest = stage;
  }
  return nearest;
}

}  // namespace zraka
