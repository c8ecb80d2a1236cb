// SPDX-License-Identifier: Apache-2.0
// The cause of a wrong picture is the mistake whose own picture is nearest to it, if what is left
// is no more than what the picture's alteration makes of a right one: noise of a JPEG or of a
// scaled screenshot adds the same distance to all of them.
#include "school/grade/verdict.hpp"

#include <algorithm>
#include <cmath>

namespace zraka {
namespace {

/// A mistake explains a picture where it leaves no more than this of the pixels that differ from
/// the right one, of half as many where none was altered, and no more than a right one may.
constexpr double kLeftOfWrong = 0.08;
/// Where it changes something it leaves no more than this of what the right picture leaves there,
/// in squares, nor more than so many times what it leaves where it changes nothing: noise is there,
/// too. Where a JPEG's own tables leave no noise, nothing is left.
constexpr double kMostOfChange = 0.1, kTimesNoise = 5, kFarFromNoise = 20, kLeastOfChange = 0.005,
                 kNothing = 0.25 / (255 * 255.0);
/// Other mistakes are as likely up to this ratio of what is left.
constexpr double kAsLikely = 1.3;
/// It explains most where it leaves this much of the pixels, and of the squared differences, and
/// every other one leaves this many times as much.
constexpr double kMostOfPixels = 0.1, kMostOfSquares = 0.05, kNext = 2;
/// And of the blocks that all differ: what leaves such is another mistake, which is like it.
constexpr double kMostOfBlocks = 0.004, kFewBlocks = 2;
/// Pictures that lie so near to whole pixels may lie there.
constexpr double kPartOfPixel = 0.25;
/// A mistake may be one of two if it takes away this much of the squared differences.
constexpr double kPartly = 0.1;
/// What an alteration hides is there if it explains this share of what is left in squares, and is
/// as strong as it should be. What explains less, or is weaker, is a sign of something else.
constexpr double kHiddenShare = 0.5, kWeakest = 0.75, kStrongest = 1.3;
constexpr double kSignShare = 0.3, kSignStrength = 0.2;
/// So few pixels show no mistake for sure.
constexpr double kHardly = 0.005;
/// What leaves more than this many times what the best one does is not named.
constexpr double kFarFromBest = 4;
constexpr std::size_t kHiddenOnes = 5;
constexpr std::size_t kFirstOfTwo = 3, kPairsByFew = 16, kPairs = 8;

bool nearer(const Match& a, const Match& b) {
  return a.distance < b.distance;
}

}  // namespace

bool Judge::explains(const Match& match) const {
  const Closeness& close = compared_.close();
  const Match& right = compared_.right();
  const double least = 0.4 * close.share, more = close.blur > 0 ? 1 : 0.5;
  return match.rest.share <= std::max(least, more * kLeftOfWrong * right.rest.share) &&
         match.rest.share <= close.share && match.rest.biased <= close.biased &&
         match.rest.solid == 0 && match.rest.energy <= 0.1 * right.rest.energy &&
         match.distance < right.distance;
}

/// Is something left that a JPEG's tolerance hides, and that rounding does not make?
bool Judge::leaves_a_shape(const Match& match) const {
  const Fitted& fitted = compared_.fitted();
  // Of other colours the same ones would have lost something else.
  if (compared_.close().blur == 0 || stage_ == 1 || compared_.way() != 0) return false;
  if (!fitted.exact) {
    // It may lie by whole pixels where that is near: fractions hide as much.
    const GridPlacement& at = fitted.placement;
    const GridPlacement whole{std::round(at.left), std::round(at.top), 1, 1};
    const auto off = [](double a, double b) { return std::fabs(a - b) > kPartOfPixel; };
    if (fitted.source == nullptr || fitted.alignment.unpainted || off(at.left, whole.left) ||
        off(at.top, whole.top) || at.across != 1 || at.down != 1)
      return false;
    Judge there(pictures_, stage_, placed_at(fitted, whole), compression_);
    there.compared_.take_way(compared_.way());
    return there.leaves_a_shape(match);
  }
  const Image picture = compared_.picture_of(match.candidate->by);
  const double of_right = compared_.left_of_rounding(compared_.picture_of({})).solid;
  return compared_.left_of_rounding(picture).solid > std::max(kFewBlocks, kMostOfBlocks * of_right);
}

/// What a mistake leaves where it changes the picture: nothing but noise, perhaps no more than
/// that, or something else that was changed there.
Judge::Left Judge::left_where_changed(const MistakenBy& by) const {
  const LeftOfChange left = compared_.left_of_change(compared_.picture_of(by));
  // Compressed by the same program, what is the same stays so to the bit.
  if (compared_.compresses_alike() && left.changed > kNothing &&
      left.changed > kLeastOfChange * left.of_right &&
      (left.same_there || left.changed > kFarFromNoise * left.noise))
    return Left::more;
  if (compared_.close().blur == 0 || stage_ == 1 || left.changed <= kMostOfChange * left.of_right)
    return Left::noise;
  return left.changed > kTimesNoise * left.noise ? Left::more : Left::perhaps;
}

/// Those that explain the picture and that it cannot tell from the best one.
std::vector<Match> Judge::as_likely(const std::vector<Match>& matches) const {
  std::vector<Match> likely;
  for (const Match& match : matches)
    if (explains(match) &&
        (likely.empty() || match.distance <= kAsLikely * likely.front().distance + kSame))
      likely.push_back(match);
  return likely;
}

/// Mistakes whose change is most of what a picture leaves, though that may be called close: the
/// best one, and those that cannot be told from it. `sign`: something differs that is like one.
std::vector<Match> Judge::hidden_besides(const MistakenBy& by, const Image& picture,
                                         bool& sign) const {
  std::vector<Match> hidden;
  for (const Mistake mistake : compared_.likely_besides(by, picture, kHiddenOnes)) {
    const MistakenBy both =
        by == MistakenBy{} ? MistakenBy(mistake) : MistakenBy(by.first, mistake);
    const Image changed = compared_.picture_of(both);
    const Likeness likeness = compared_.likeness_of_change(picture, changed);
    sign = sign || (likeness.share >= kSignShare && likeness.strength >= kSignStrength);
    if (likeness.share < kHiddenShare || likeness.strength < kWeakest ||
        likeness.strength > kStrongest)
      continue;
    made_.push_back({both, {}});
    hidden.push_back(compared_.look_at(made_.back(), changed));
  }
  std::sort(hidden.begin(), hidden.end(), nearer);
  std::erase_if(hidden, [&](const Match& match) {
    return match.distance > kAsLikely * hidden.front().distance + kSame;
  });
  return hidden;
}

/// Where it lies in what was handed in, with the lines that were left unpainted.
static void put_lines_back(const UnpaintedLines& lines, Alignment& alignment) {
  const double across = static_cast<double>(lines.handed_in.width) /
                        static_cast<double>(lines.columns.size()),
               down = static_cast<double>(lines.handed_in.height) /
                      static_cast<double>(lines.rows.size());
  const bool turned = alignment.transposed;
  alignment.across *= turned ? down : across;
  alignment.left *= turned ? down : across;
  alignment.down *= turned ? across : down;
  alignment.top *= turned ? across : down;
  alignment.scaled = alignment.unpainted = true;
}

void Judge::settle(Verdict verdict, const Rest& left, StageGrade& grade) const {
  const Alignment& way = compared_.ways()[compared_.way()];
  const Image& wanted = compared_.wanted();
  grade.verdict = verdict;
  grade.alignment = compared_.fitted().alignment;
  grade.alignment.swapped = way.swapped;
  grade.alignment.curve = way.curve;
  if (compression_.unpainted != nullptr) put_lines_back(*compression_.unpainted, grade.alignment);
  if (compared_.fitted().pictures != nullptr) {
    grade.alignment.drawn_width = wanted.width;
    grade.alignment.drawn_height = wanted.height;
  }
  grade.alignment.visible =
      compared_.region().pixels() / (wanted.width * static_cast<double>(wanted.height));
  grade.share_wrong = compared_.right().rest.share;
  grade.share_left = left.share;
}

/// The named mistake explains the picture; a second one may hide in what is called close.
void Judge::name_second(const Match& first, StageGrade& grade) const {
  const MistakenBy by = first.candidate->by;
  bool sign = false;
  const std::vector<Match> hidden = hidden_besides(by, compared_.picture_of(by), sign);
  if (hidden.empty()) {
    if (sign) grade.verdict = Verdict::probable;
    return;
  }
  settle(Verdict::mistaken, hidden.front().rest, grade);
  grade.mistakes = {by.first};
  for (const Match& match : hidden) grade.mistakes.push_back(match.candidate->by.second);
  grade.both = true;
}

/// Pairs of mistakes that come near with few pixels, the nearest first: those that begin with one
/// that was known before or explains a part, and those whose changes add up to what differs.
std::vector<Match> Judge::likely_pairs(const std::vector<Match>& singles,
                                       const std::set<Mistake>& known) const {
  std::vector<Mistake> firsts(known.begin(), known.end());
  for (const Match& match : singles) {
    if (firsts.size() >= kFirstOfTwo + known.size()) break;
    const Mistake mistake = match.candidate->by.first;
    if (match.rest.energy < (1 - kPartly) * compared_.right().rest.energy &&
        !known.contains(mistake))
      firsts.push_back(mistake);
  }
  std::vector<Match> pairs;
  for (const Mistake first : firsts) {
    if (entry_of(first).first_stage > stage_) continue;
    for (const Candidate& candidate : pictures_.mistaken_besides(stage_, first))
      pairs.push_back({&candidate, compared_.way()});
  }
  const std::vector<Candidate>& all = pictures_.mistaken(stage_);
  const std::vector<double>& products = pictures_.products(stage_);
  const std::vector<double> shares = compared_.products_with(all);
  std::vector<std::pair<double, std::pair<std::size_t, std::size_t>>> sums;
  for (std::size_t i = 0; i < all.size(); ++i)
    for (std::size_t j = 0; j < i; ++j) {
      const auto product = [&](std::size_t a, std::size_t b) {
        return products[a * all.size() + b];
      };
      sums.push_back(
          {product(i, i) + product(j, j) + 2 * product(i, j) - 2 * shares[i] - 2 * shares[j],
           {j, i}});
    }
  std::sort(sums.begin(), sums.end());
  const auto begins = [&](std::size_t i) {
    return std::find(firsts.begin(), firsts.end(), all[i].by.first) != firsts.end();
  };
  std::size_t made = 0;
  for (const auto& [distance, pair] : sums) {
    if (distance >= 0 || made == kPairsByFew) break;
    if (begins(pair.first) || begins(pair.second)) continue;
    const MistakenBy by(all[pair.first].by.first, all[pair.second].by.first);
    made_.push_back({by, pictures_.besides(stage_, by)});
    pairs.push_back({&made_.back(), compared_.way()});
    ++made;
  }
  if (pairs.empty()) return pairs;
  const Image& coarse = pairs.front().candidate->coarse;
  const Image few = compared_.few(coarse.width, coarse.height);
  const Region part = compared_.region_of_few(coarse.width, coarse.height);
  for (Match& pair : pairs) pair.distance = mean_square(few, pair.candidate->coarse, part);
  std::sort(pairs.begin(), pairs.end(), nearer);
  return pairs;
}

/// Two mistakes at once.
bool Judge::name_two(const std::vector<Match>& singles, const std::set<Mistake>& known,
                     StageGrade& grade) {
  std::vector<Match> pairs = likely_pairs(singles, known);
  pairs.resize(std::min(pairs.size(), kPairs));
  // The nearest explains most, or none of them everything.
  if (pairs.empty() || pairs.front().distance > 0.3 * compared_.right().distance) return false;
  std::vector<Image> pictures;
  for (Match& pair : pairs) {
    pictures.push_back(compared_.picture_of(pair.candidate->by));
    pair = compared_.look_at(*pair.candidate, pictures.back());
  }
  const Match* best = nullptr;
  for (const Match& pair : pairs)
    if (explains(pair) && (best == nullptr || pair.distance < best->distance)) best = &pair;
  if (best == nullptr || !compared_.shows(best->candidate->by) ||
      !compared_.has_its_powers(best->candidate->by) ||
      left_where_changed(best->candidate->by) == Left::more)
    return false;
  // One of them has to be in every pair that is as likely; another one may be as good as the other.
  const MistakenBy two = best->candidate->by;
  std::vector<Mistake> named = {two.first, two.second};
  const Image& picture = pictures[static_cast<std::size_t>(best - pairs.data())];
  for (std::size_t i = 0; i < pairs.size(); ++i) {
    if (!explains(pairs[i]) || pairs[i].distance > kAsLikely * best->distance + kSame) continue;
    const MistakenBy& by = pairs[i].candidate->by;
    if (by == two || by == MistakenBy(two.second, two.first)) continue;
    if (mean_square(pictures[i], picture, compared_.region()) >= kSame) return false;
    const bool first = by.first == named[0] || by.second == named[0],
               second = by.first == named[1] || by.second == named[1];
    if (first == second || (second && named.size() > 2)) return false;
    if (second) std::swap(named[0], named[1]);
    const Mistake other = by.first == named[0] ? by.second : by.first;
    if (std::find(named.begin(), named.end(), other) == named.end()) named.push_back(other);
  }
  settle(Verdict::mistaken, best->rest, grade);
  grade.mistakes = std::move(named);
  grade.both = true;
  return true;
}

bool Judge::name_probable(const std::vector<Match>& matches, StageGrade& grade) const {
  const Match &best = matches.front(), &right = compared_.right();
  const auto apart = [&](const Match& other) {
    return &other == &best || other.rest.energy > kNext * best.rest.energy ||
           std::fabs(other.distance - best.distance) < kSame;
  };
  if (best.rest.share > kMostOfPixels * right.rest.share || best.rest.share > 0.2 ||
      best.rest.energy > kMostOfSquares * right.rest.energy ||
      best.rest.solid > kMostOfBlocks * right.rest.solid ||
      !std::all_of(matches.begin(), matches.end(), apart) || leaves_a_shape(best))
    return false;
  settle(Verdict::probable, best.rest, grade);
  for (const Match& match : matches)
    if (std::fabs(match.distance - best.distance) < kSame)
      grade.mistakes.push_back(match.candidate->by.first);
  return true;
}

StageGrade& Judge::finish(StageGrade& grade) const {
  const Image &taken = compared_.taken(), &wanted = compared_.wanted();
  Image there = taken;
  if (grade.verdict != Verdict::right) {
    there = wanted;  // what was cut off differs nowhere
    const Region& r = compared_.region();
    for (std::uint32_t y = r.top; y < r.bottom; ++y)
      std::copy(taken.row(y) + std::size_t{3} * r.left, taken.row(y) + std::size_t{3} * r.right,
                there.row(y) + std::size_t{3} * r.left);
    grade.pixels = worst_pixels(there, wanted, static_cast<double>(compared_.close().tolerance), 3);
  }
  grade.aligned = std::move(there);
  return grade;
}

/// In the way that it was handed in, or in the best one.
bool Judge::find_right(std::vector<Match>& by_few) {
  compared_.take_way(0);
  if (compared_.compare_with_right()) return true;
  by_few = compared_.nearest_by_few();
  const std::size_t way = compared_.best_way(by_few);
  if (way == 0) return false;
  compared_.take_way(way);
  return compared_.compare_with_right();
}

/// A mistake that changes much, or another view, lies better on its own picture.
void Judge::lie_on_nearest(const std::vector<Match>& by_few) {
  const Match *best = nullptr, *right = nullptr;
  for (const Match& match : by_few) {
    if (match.way != compared_.way()) continue;
    if (match.candidate == nullptr)
      right = &match;
    else if (best == nullptr || match.distance < best->distance)
      best = &match;
  }
  if (best == nullptr || right == nullptr || best->distance > 0.7 * right->distance) return;
  compared_.lie_on(best->candidate->by);
  compared_.compare_with_right();
}

StageGrade Judge::verdict(const std::set<Mistake>* known) {
  StageGrade grade{.stage = stage_};
  std::vector<Match> matches;
  const Closeness& close = compared_.close();
  if (find_right(matches)) {
    settle(Verdict::right, compared_.right().rest, grade);
    if (close.blur == 0 || stage_ == 1) return finish(grade);
    bool sign = false;
    const std::vector<Match> hidden = hidden_besides({}, compared_.picture_of({}), sign);
    if (hidden.empty()) {
      if (sign) grade.verdict = Verdict::unknown;
      return finish(grade);
    }
    if (left_where_changed(hidden.front().candidate->by) == Left::more) {
      grade.verdict = Verdict::unknown;
      return finish(grade);
    }
    settle(Verdict::mistaken, hidden.front().rest, grade);
    for (const Match& match : hidden) grade.mistakes.push_back(match.candidate->by.first);
    return finish(grade);
  }
  // What hardly differs shows no mistake for sure.
  settle(Verdict::unknown, compared_.right().rest, grade);
  if (compared_.right().rest.share < kHardly && close.blur > 0) return finish(grade);
  lie_on_nearest(matches);
  compared_.look_closely(matches);
  std::erase_if(matches, [&, best = matches.empty() ? 0 : matches.front().distance](
                             const Match& match) {
    return match.distance <= kFarFromBest * best && !compared_.has_its_powers(match.candidate->by);
  });
  const std::vector<Match> likely = as_likely(matches);
  if (!likely.empty() && compared_.shows(likely.front().candidate->by) &&
      !leaves_a_shape(likely.front())) {
    const Left left = left_where_changed(likely.front().candidate->by);
    if (left == Left::more) return finish(grade);
    settle(left == Left::noise ? Verdict::mistaken : Verdict::probable, likely.front().rest, grade);
    for (const Match& match : likely) grade.mistakes.push_back(match.candidate->by.first);
    if (likely.size() == 1 && known != nullptr && left == Left::noise)
      name_second(likely.front(), grade);
    return finish(grade);
  }
  if (matches.empty()) return finish(grade);
  // What is as far from them as a plain picture shows none.
  if (!compared_.is_near({}, kNear) && !compared_.is_near(matches.front().candidate->by, kNear))
    return finish(grade);
  if (known != nullptr && name_two(matches, *known, grade)) return finish(grade);
  if (compared_.shows(matches.front().candidate->by)) name_probable(matches, grade);
  return finish(grade);
}

}  // namespace zraka
