// SPDX-License-Identifier: Apache-2.0
#include "school/grade/by_mistakes.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include "school/grade/verdict.hpp"

namespace zraka {
namespace {

/// TurnedOutlines that are less alike than this are other ones: they may lie anywhere.
constexpr double kOtherOutlines = 0.6;
/// Where the right picture's outlines are that much alike, it lies about there.
constexpr double kLiesThere = 0.65;
/// So many places are refined with few pixels, near to what was found or anywhere, and the best of
/// them with more, and judged.
constexpr std::size_t kNearOnes = 6, kAnywhere = 10, kJudged = 3;
/// TurnedOutlines less alike than this tell nothing.
constexpr double kLeastLike = 0.55;
/// The whole is meant where its outlines are less alike by no more than this.
constexpr double kAboutAsGood = 0.05;
/// What is only probable is so where outlines say it, too: by so much more than for the right one.
constexpr double kMoreAlike = 0.15;
/// The area around the right picture, in areas of that, that tells whether more is seen.
constexpr double kAround = 0.3;
/// A strip around the middle is seen where it has this part of it, and is the picture's where it
/// leaves no more than this of what a plain one does.
constexpr double kGoesOnAround = 0.2;

/// A place where a mistake's picture may lie.
struct Place {
  const Sought* sought = nullptr;
  std::size_t turn = 0;
  GridPlacement at{};  ///< of the whole picture in the whole submission
  double likeness = -1;
  bool whole = false;  ///< the submission is all of it
};

/// Are they about the same?
bool is_near(const Place& a, const Place& b) {
  constexpr double kPixels = 0.5, kScales = 0.005;
  const auto near = [](double x, double y, double most) { return std::fabs(x - y) < most; };
  return a.sought == b.sought && a.turn == b.turn && near(a.at.left, b.at.left, kPixels) &&
         near(a.at.top, b.at.top, kPixels) && near(a.at.across, b.at.across, kScales) &&
         near(a.at.down, b.at.down, kScales);
}

/// A submission's outlines, turned in all ways.
class TurnedOutlines {
 public:
  TurnedOutlines(const Image& painted, std::uint32_t width, std::uint32_t height)
      : width_(width), height_(height) {
    const Grid drawn = outlines(painted);
    for (std::size_t i = 0; i < turned_.size(); ++i) {
      const Turn& turn = kTurns[i];
      Grid plane = turn.flipped_first ? upside_down(drawn) : drawn;
      if (turn.transposed) plane = transposed(plane);
      turned_[i] = turn.flipped ? upside_down(plane) : std::move(plane);
    }
  }
  const Grid& turned(std::size_t turn) const { return turned_[turn]; }
  std::size_t turns() const { return turned_.size(); }

  /// The submission with about as few pixels as a picture of width × height has that lies there.
  struct Few {
    Grid grid;
    double across = 1, down = 1;  ///< its size by the submission's
  };
  Few few(const Place& place, const Grid& size) const {
    const Grid& whole = turned_[place.turn];
    const auto pixels = [](std::uint32_t n, double by) {
      return static_cast<std::uint32_t>(std::max(4.0, std::round(n / by)));
    };
    const std::uint32_t w = pixels(whole.width,
                                   std::max(1.0, place.at.across * width_ / size.width)),
                        h = pixels(whole.height,
                                   std::max(1.0, place.at.down * height_ / size.height));
    const double across = static_cast<double>(w) / whole.width,
                 down = static_cast<double>(h) / whole.height;
    return {resampled(whole, {0, 0, 1 / across, 1 / down}, w, h), across, down};
  }
  GridPlacement in_few(const GridPlacement& at, const Grid& size, const Few& few) const {
    return rescaled(at, size.width / width_, size.height / height_, few.across, few.down);
  }
  GridPlacement in_whole(const GridPlacement& at, const Grid& size, const Few& few) const {
    return rescaled(at, width_ / size.width, height_ / size.height, 1 / few.across, 1 / few.down);
  }
  void refine(Place& place, const Searched& searched, double first, double last) const {
    const Few small = few(place, searched.grid);
    GridPlacement at = in_few(place.at, searched.grid, small);
    place.likeness = SearchLevel(searched, small.grid).refine(at, first, last);
    place.at = in_whole(at, searched.grid, small);
  }

 private:
  std::array<Grid, std::size(kTurns)> turned_;
  double width_, height_;  ///< of the right picture
};

bool more_alike(const Place& a, const Place& b) {
  return a.likeness > b.likeness;
}

/// Near to where the right picture was found, and as the whole.
std::vector<Place> places_near(const std::vector<Sought>& all, const TurnedOutlines& drawn,
                               const Registered& submitted, const Image& right) {
  std::vector<Place> starts;
  for (std::size_t i = 0; i < drawn.turns(); ++i) {
    const double across = drawn.turned(i).width / static_cast<double>(right.width),
                 down = drawn.turned(i).height / static_cast<double>(right.height);
    if (std::fabs(across / down - 1) <= kAxesApart)
      starts.push_back({nullptr, i, {0, 0, across, down}, -1, true});
  }
  for (const Fitted& fitted : submitted.fitted()) {
    GridPlacement at = fitted.placement;
    at.across *= static_cast<double>(fitted.image.width) / right.width;
    at.down *= static_cast<double>(fitted.image.height) / right.height;
    const auto turn = std::find(std::begin(kTurns), std::end(kTurns), fitted.turn);
    starts.push_back({nullptr, static_cast<std::size_t>(turn - std::begin(kTurns)), at});
  }
  std::vector<Place> places;
  for (Place place : starts) {
    const Grid& size = all.front().middle.grid;
    const TurnedOutlines::Few small = drawn.few(place, size);
    const GridPlacement at = drawn.in_few(place.at, size, small);
    for (const Sought& sought : all) {
      place.sought = &sought;
      place.likeness = SearchLevel(sought.middle, small.grid).likeness(at);
      places.push_back(place);
    }
  }
  std::sort(places.begin(), places.end(), more_alike);
  places.resize(std::min(places.size(), kNearOnes));
  std::vector<Place> refined;
  for (Place place : places) {
    const Place as_whole = place;
    place.whole = false;
    drawn.refine(place, place.sought->middle, 1, 0.25);
    // As a whole, where that is about as good: colours tell.
    if (as_whole.whole && as_whole.likeness > place.likeness - kAboutAsGood)
      refined.push_back(as_whole);
    refined.push_back(place);
  }
  return refined;
}

/// Anywhere, in any size: those whose outlines are not the right picture's.
std::vector<Place> places_anywhere(const std::vector<Sought>& all, const TurnedOutlines& drawn) {
  std::vector<Place> places;
  const Grid& size = all.front().coarse.grid;
  for (std::size_t i = 0; i < drawn.turns(); ++i)
    for (double scale = kSmallestScale; scale <= kLargestScale; scale *= kScaleStep) {
      const Place any{nullptr, i, {0, 0, scale, scale}};
      const TurnedOutlines::Few small = drawn.few(any, size);
      if (small.grid.width < size.width * 3 / 5 || small.grid.height < size.height * 3 / 5) break;
      for (const Sought& sought : all) {
        if (sought.like_right > kOtherOutlines) continue;
        Place best{&sought, i};
        slide(sought.coarse, small.grid, 0.2,
              [&](std::int32_t left, std::int32_t top, double like) {
                if (like <= best.likeness) return;
                best.likeness = like;
                best.at = drawn.in_whole(
                    {static_cast<double>(left), static_cast<double>(top), 1, 1}, size, small);
              });
        if (best.likeness > 0) places.push_back(best);
      }
    }
  std::sort(places.begin(), places.end(), more_alike);
  places.resize(std::min(places.size(), kAnywhere));
  for (Place& place : places) drawn.refine(place, place.sought->middle, 2, 0.25);
  return places;
}

/// Twice as wide and high, about the same middle.
GridPlacement doubled(const GridPlacement& at, double width, double height) {
  return {at.left - at.across * width / 2, at.top - at.down * height / 2, 2 * at.across,
          2 * at.down};
}

/// Does a picture go on around its middle, which is surely there? Windows' frames do not.
bool goes_on_around(const Fitted& doubled, const Image& picture) {
  const auto clipped = [&](std::uint32_t by) {
    const std::uint32_t x = picture.width / by, y = picture.height / by;
    const Region& r = doubled.region;
    return Region{std::max(r.left, x), std::max(r.top, y), std::min(r.right, picture.width - x),
                  std::min(r.bottom, picture.height - y)};
  };
  const Region middle = clipped(4), more = clipped(5);
  if (middle.left >= middle.right || middle.top >= middle.bottom) return false;
  const double around = more.pixels() - middle.pixels();
  const double left = more.pixels() * mean_square(doubled.image, picture, more) -
                      middle.pixels() * mean_square(doubled.image, picture, middle);
  return around >= kGoesOnAround * middle.pixels() &&
         left <= kGoesOnAround * around * spread(picture, more);
}

/// The best ones, none of them twice.
std::vector<Place> most_alike(std::vector<Place> places, std::size_t most) {
  std::sort(places.begin(), places.end(), more_alike);
  std::vector<Place> best;
  for (const Place& place : places)
    if (best.size() < most && std::none_of(best.begin(), best.end(), [&](const Place& other) {
          return is_near(place, other);
        }))
      best.push_back(place);
  return best;
}

}  // namespace

std::optional<StageGrade> judge_by_mistakes(const StagePictures& pictures, int stage,
                                            const Registered& submitted) {
  const std::vector<Sought>& all = pictures.sought(stage);
  if (all.empty()) return std::nullopt;
  Image painted = submitted.handed_in();
  const bool unpainted = fill_unpainted(painted, submitted.jpeg());
  const Image& right = pictures.right(stage);
  const TurnedOutlines drawn(painted, right.width, right.height);
  std::vector<Place> places = places_near(all, drawn, submitted, right);
  double seen = 0;
  for (const Fitted& fitted : submitted.fitted()) seen = std::max(seen, fitted.likeness);
  if (seen < kLiesThere) {
    const std::vector<Place> others = places_anywhere(all, drawn);
    places.insert(places.end(), others.begin(), others.end());
  }
  for (const Place& place : most_alike(std::move(places), kJudged)) {
    if (place.likeness < kLeastLike) break;
    const MistakenBy& by = place.sought->by;
    Place there = place;
    if (!place.whole)
      drawn.refine(there,
                   Searched(reduced_to(outlines(pictures.picture(stage, by)), kFineOutlines)), 1,
                   0.06);
    const Fitted fitted = fitted_at({kTurns[there.turn], there.at, there.likeness}, painted,
                                    unpainted, right.width, right.height);
    // The picture of a window that is too small is the right one's middle, which may go on around.
    if (by == MistakenBy(Mistake::view_narrow) &&
        goes_on_around(
            fitted_at({kTurns[there.turn], doubled(there.at, right.width, right.height), 0},
                      painted, unpainted, right.width, right.height),
            right))
      continue;
    StageGrade grade = Judge(pictures, stage, fitted, submitted.compression(), by).verdict(nullptr);
    const bool sure = grade.verdict == Verdict::mistaken ||
                      (grade.verdict == Verdict::probable && place.likeness > seen + kMoreAlike);
    if (sure && !is_the_whole(pictures, stage, submitted, fitted, grade) &&
        std::find(grade.mistakes.begin(), grade.mistakes.end(), by.first) != grade.mistakes.end())
      return grade;
  }
  return std::nullopt;
}

std::optional<StageGrade> judge_as_wide(const StagePictures& pictures, int stage,
                                        const Registered& submitted, const Fitted& right) {
  if (right.source == nullptr) return std::nullopt;
  const Image& whole = pictures.right(stage);
  GridPlacement wide = doubled(right.placement, right.image.width, right.image.height);
  wide.across *= static_cast<double>(right.image.width) / whole.width;
  wide.down *= static_cast<double>(right.image.height) / whole.height;
  const Fitted fitted = fitted_at({right.turn, wide, right.likeness}, submitted.handed_in(), false,
                                  whole.width, whole.height);
  const MistakenBy by = Mistake::view_wide;
  const double middle = 0.25 * whole.width * whole.height;
  if (fitted.region.pixels() < (1 + kAround) * middle ||
      !shows(fitted.image, pictures.picture(stage, by), fitted.region))
    return std::nullopt;
  StageGrade grade = Judge(pictures, stage, fitted, submitted.compression(), by).verdict(nullptr);
  if (grade.verdict == Verdict::mistaken && grade.mistakes.front() == Mistake::view_wide)
    return grade;
  return std::nullopt;
}

}  // namespace zraka
