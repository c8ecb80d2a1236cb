// SPDX-License-Identifier: Apache-2.0
#include "school/grade/judge.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>

#include "school/grade/by_mistakes.hpp"
#include "school/grade/verdict.hpp"
#include "school/grade/view.hpp"

namespace zraka {
namespace {

/// Outlines that are less alike than this tell nothing.
constexpr double kLike = 0.5;
constexpr double kPlain = 1e-6;
/// It is as it was handed in, pixel by pixel, unless it is so many times nearer elsewhere.
constexpr double kNearerElsewhere = 2;
/// It lies between pixels where that leaves no more than this of what it leaves by whole ones.
constexpr double kNearerBetween = 0.25;
/// Elsewhere is no farther than this, in pixels, at any corner.
constexpr double kAboutThere = 2;
/// More pixels tell where they lie.
constexpr double kFewPixels = 96 * 96;

bool is_turn(Mistake mistake) {
  return mistake == Mistake::y_down || mistake == Mistake::transposed;
}

/// A submission of the right picture's shape, turned, that is near to some mistake's picture as a
/// whole: one of another view has no outlines that tell, nor has one that is full of noise.
std::optional<StageGrade> judge_as_whole(const StagePictures& pictures, int stage,
                                         const Registered& submitted) {
  const Image &image = submitted.handed_in(), &right = pictures.right(stage);
  const Image& coarse = pictures.coarse(stage);
  for (const Turn& turn : kTurns) {
    const double width = turn.transposed ? image.height : image.width,
                 height = turn.transposed ? image.width : image.height;
    const double across = width / right.width, down = height / right.height;
    if (std::fabs(across / down - 1) > 0.02) return std::nullopt;
    const Fitted fitted =
        fitted_at({turn, {0, 0, across, down}, 0}, image, false, right.width, right.height);
    const Image few = sampled(stage == 1 ? as_silhouette(fitted.image) : fitted.image, coarse.width,
                              coarse.height);
    const Region all{0, 0, coarse.width, coarse.height};
    const double near = 0.1 * spread(few, all);
    const std::vector<Candidate>& mistaken = pictures.mistaken(stage);
    if (std::none_of(mistaken.begin(), mistaken.end(), [&](const Candidate& candidate) {
          return mean_square(few, candidate.coarse, all) < near;
        }))
      continue;
    StageGrade grade = Judge(pictures, stage, fitted, submitted.compression()).verdict(nullptr);
    if (grade.verdict == Verdict::mistaken &&
        std::none_of(grade.mistakes.begin(), grade.mistakes.end(), is_turn))
      return grade;
  }
  return std::nullopt;
}

/// The whole, turned, if that is right.
std::optional<StageGrade> right_if_turned(const StagePictures& pictures, int stage,
                                          const Registered& submitted) {
  const Image &image = submitted.handed_in(), &right = pictures.right(stage);
  for (const Turn& turn : kTurns) {
    const double width = turn.transposed ? image.height : image.width,
                 height = turn.transposed ? image.width : image.height;
    const Position whole{turn, {0, 0, width / right.width, height / right.height}, 0};
    const Fitted fitted = fitted_at(whole, image, false, right.width, right.height);
    StageGrade grade = Judge(pictures, stage, fitted, submitted.compression()).verdict(nullptr);
    if (grade.verdict == Verdict::right) return grade;
  }
  return std::nullopt;
}

/// Mirrored and turned may be only turned another way.
StageGrade turned_without_mirror(const StagePictures& pictures, int stage,
                                 const Registered& submitted, StageGrade grade) {
  const bool mirrored = grade.verdict == Verdict::mistaken &&
                        grade.mistakes.front() == Mistake::x_mirrored &&
                        (grade.alignment.transposed || grade.alignment.flipped);
  if (!mirrored) return grade;
  return right_if_turned(pictures, stage, submitted).value_or(std::move(grade));
}

/// Outlines may be alike by whole pixels where colours tell that it lies between them: then it is
/// so much nearer that no mistake can be what else is left.
std::optional<StageGrade> right_between_pixels(const StagePictures& pictures, int stage,
                                               const Registered& submitted, const Fitted& fitted) {
  const auto judged = [&](const Fitted& there) {
    return Judge(pictures, stage, there, submitted.compression());
  };
  const Fitted there = between_pixels(fitted);
  if (judged(there).distance({}) > kNearerBetween * judged(fitted).distance({}))
    return std::nullopt;
  StageGrade grade = judged(there).verdict(nullptr);
  if (grade.verdict != Verdict::right) return std::nullopt;
  return grade;
}

bool is_settled(const StageGrade& grade) {
  return grade.verdict == Verdict::right || grade.verdict == Verdict::mistaken;
}

}  // namespace

const std::vector<Fitted>& Registered::plain() const {
  if (!looked_) plain_ = drawn_as_whole(handed_in(), jpeg(), sizes_);
  looked_ = true;
  return plain_;
}

const std::vector<Fitted>& Registered::fitted() const {
  if (!fitted_.empty()) return fitted_;
  for (const Fitted& fitted : plain())
    if (fitted.sure) fitted_.push_back(fitted);
  if (!fitted_.empty()) return fitted_;
  const Image& right = pictures_.right(7);
  // A plain one lies anywhere.
  if (spread(handed_in(), {0, 0, handed_in().width, handed_in().height}) < kPlain) {
    const GridPlacement whole{0, 0, static_cast<double>(handed_in().width) / right.width,
                              static_cast<double>(handed_in().height) / right.height};
    fitted_ = {fitted_at({{}, whole, 0}, handed_in(), false, right.width, right.height)};
    return fitted_;
  }
  fitted_ = fit(handed_in(), jpeg(), pictures_.outlines(), right.width, right.height);
  add_drawn_sizes(handed_in(), jpeg(), sizes_, fitted_);
  leave_out_other_views(fitted_, pictures_.right(1), pictures_.background());
  return fitted_;
}

bool is_the_whole(const StagePictures& pictures, int stage, const Registered& submitted,
                  const Fitted& fitted, const StageGrade& grade) {
  if (grade.mistakes.empty() || grade.alignment.swapped ||
      grade.alignment.curve != Alignment::Curve::none || fitted.exact ||
      fitted.region.pixels() > kFewPixels)
    return false;
  const GridPlacement& at = fitted.placement;
  const double right = at.left + at.across * fitted.image.width,
               bottom = at.top + at.down * fitted.image.height;
  const auto about = [](double a, double b) { return std::fabs(a - b) <= kAboutThere; };
  for (const Fitted& whole : submitted.plain()) {
    // That it was drawn in another size is only likely.
    if (whole.pictures != nullptr || whole.turn != fitted.turn || !whole.exact ||
        !about(at.left, 0) || !about(at.top, 0) || !about(right, whole.width) ||
        !about(bottom, whole.height))
      continue;
    const auto distance = [&](const Fitted& there) {
      return Judge(pictures, stage, there, submitted.compression()).distance(grade.named());
    };
    if (distance(whole) <= kNearerElsewhere * distance(fitted)) return true;
  }
  return false;
}

namespace {

StageGrade judge_where_it_lies(const StagePictures& pictures, int stage,
                               const Registered& submitted, const std::set<Mistake>& known) {
  // What turning undoes is no mistake, if that leaves nothing.
  std::optional<StageGrade> unturned;
  bool differs_turned = false;
  std::optional<StageGrade> as_whole;
  for (const Fitted& fitted : submitted.plain()) {
    StageGrade grade = Judge(pictures, stage, fitted, submitted.compression()).verdict(&known);
    if (!is_settled(grade)) {
      differs_turned = differs_turned || unturned;
      if (!as_whole) as_whole = std::move(grade);
      continue;
    }
    if (std::none_of(grade.mistakes.begin(), grade.mistakes.end(), is_turn)) return grade;
    if (!unturned) unturned = std::move(grade);
  }
  if (unturned && unturned->share_left <= pictures.rubric().share) {
    // Turned back, something was seen to be left.
    if (differs_turned) unturned->verdict = Verdict::probable;
    // A JPEG's outlines may be too coarse for that to have been tried.
    if (!differs_turned && submitted.jpeg())
      return right_if_turned(pictures, stage, submitted).value_or(*unturned);
    return *unturned;
  }
  const bool sure = std::any_of(submitted.plain().begin(), submitted.plain().end(),
                                [](const Fitted& fitted) { return fitted.sure; });
  const bool whole =
      !sure && std::none_of(submitted.fitted().begin(), submitted.fitted().end(),
                            [](const Fitted& fitted) { return fitted.alignment.cut; });
  if (!whole && !sure)
    if (std::optional<StageGrade> grade = judge_as_whole(pictures, stage, submitted)) return *grade;
  const Fitted* best = nullptr;
  StageGrade of_best;
  for (const Fitted& fitted : submitted.fitted()) {
    // A second mistake is easily lost in what an inexact fit allows.
    StageGrade grade = Judge(pictures, stage, fitted, submitted.compression())
                           .verdict(fitted.exact ? &known : nullptr);
    if (is_settled(grade) && as_whole && is_the_whole(pictures, stage, submitted, fitted, grade))
      return *as_whole;
    if (is_settled(grade)) {
      if (std::optional<StageGrade> wide = judge_as_wide(pictures, stage, submitted, fitted))
        return *wide;
      return grade;
    }
    // A picture that may lie anywhere is rather where its outlines say.
    if (best != nullptr && fitted.likeness <= std::max(best->likeness, kLike)) continue;
    best = &fitted;
    of_best = std::move(grade);
  }
  if (whole)
    if (std::optional<StageGrade> grade = judge_as_whole(pictures, stage, submitted)) return *grade;
  if (best->exact && stage > 1)
    if (std::optional<StageGrade> grade = right_between_pixels(pictures, stage, submitted, *best))
      return *grade;
  StageGrade grade = best->exact
                         ? std::move(of_best)
                         : Judge(pictures, stage, *best, submitted.compression()).verdict(&known);
  if (is_settled(grade) && as_whole && is_the_whole(pictures, stage, submitted, *best, grade))
    return *as_whole;
  if (stage == 1 || grade.verdict != Verdict::unknown) return grade;
  if (std::optional<StageGrade> mistaken = judge_by_mistakes(pictures, stage, submitted))
    return *mistaken;
  return grade;
}

}  // namespace

StageGrade judge(const StagePictures& pictures, int stage, const Registered& submitted,
                 const std::set<Mistake>& known) {
  return turned_without_mirror(pictures, stage, submitted,
                               judge_where_it_lies(pictures, stage, submitted, known));
}

int right_stage(const StagePictures& pictures, const Registered& submitted, int named) {
  // Stages may look alike: the nearest is meant.
  const auto distance = [&](int stage, const std::vector<Fitted>& all) {
    double least = std::numeric_limits<double>::infinity();
    for (const Fitted& fitted : all)
      if (stage != 1 || is_flat(fitted.image, fitted.region))
        least = std::min(
            least, Judge(pictures, stage, fitted, submitted.compression()).distance_if_right());
    return least;
  };
  const auto right_one = [&](const std::vector<Fitted>& all) {
    if (named != 0 && std::isfinite(distance(named, all))) return named;
    int nearest = 0;
    double least = std::numeric_limits<double>::infinity();
    for (int stage = 7; stage >= 1; --stage)
      if (const double d = distance(stage, all); stage != named && d < least)
        least = d, nearest = stage;
    return nearest;
  };
  if (const int stage = right_one(submitted.plain()); stage != 0) return stage;
  return right_one(submitted.fitted());
}

NearestStage nearest_stage(const StagePictures& pictures, const Registered& submitted) {
  const Fitted& fitted = submitted.fitted().back();
  NearestStage nearest;
  double least = std::numeric_limits<double>::infinity();
  // Any picture of the scene has its silhouette.
  for (int stage = 7; stage >= (is_flat(fitted.image, fitted.region) ? 1 : 2); --stage) {
    const Image& wanted = pictures.right(stage);
    const double d =
        mean_square(stage == 1 ? as_silhouette(fitted.image) : fitted.image, wanted, fitted.region);
    if (d < least) least = d, nearest = {stage, d <= kNear * spread(wanted, fitted.region)};
  }
  return nearest;
}

}  // namespace zraka
