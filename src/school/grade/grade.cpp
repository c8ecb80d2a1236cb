// SPDX-License-Identifier: Apache-2.0
// The cause of a wrong picture is the mistake whose own picture is nearest to it: noise of a JPEG
// or of a scaled screenshot adds the same distance to all of them.
#include <fmt/format.h>
#include <tbb/task_arena.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <mutex>
#include <zraka/school/grade.hpp>

#include "core/phrase.hpp"
#include "core/text.hpp"
#include "image/alter.hpp"
#include "image/packed.hpp"
#include "render/prepare.hpp"
#include "school/grade/align.hpp"
#include "school/grade/rubric.hpp"
#include "school/grade/submission.hpp"

namespace zraka {
namespace {

/// Pictures are first compared at about this size.
constexpr std::uint32_t kCoarseSide = 100;

/// A mistake is named if it takes away this much of the squared difference to the right picture.
constexpr double kExplained = 0.5;
/// The same for pictures that lost something on their way.
constexpr double kExplainedWithLoss = 0.2;
/// A picture farther than this from every mistake's shows none of them, whatever it explains.
constexpr double kNamed = 0.1;
/// What JPEG and scaling may add, as a root mean square of values of 0…1.
constexpr double kLoss = 0.04;
/// Pixels that may be left over where a mistake is named, and those of an edge that was blurred.
constexpr double kRestOfMistake = 0.05, kEdges = 0.02;

struct Candidate {
  Mistake mistake = Mistake::none;
  Image coarse;
  PackedImage picture;  ///< a scene has hundreds of these
};

/// A stage's right picture in small, and the pictures of its mistakes.
struct StagePictures {
  std::once_flag once;
  Image coarse;
  std::vector<Candidate> visible;
};

struct Match {
  const Candidate* candidate = nullptr;  ///< nullptr: the right picture
  std::size_t way = 0;
  double distance = std::numeric_limits<double>::infinity();
};

}  // namespace

struct Grader::Impl {
  const Scene& scene;
  RenderOptions options;
  Rubric rubric;
  std::array<Image, 7> right;
  mutable std::array<StagePictures, 7> stages;

  const Image& right_of(int stage) const { return right[static_cast<std::size_t>(stage - 1)]; }
  RenderOptions options_of(int stage) const {
    RenderOptions asked = options;
    asked.terms = terms_of(static_cast<Stage>(stage));
    return asked;
  }
  Result<Image> render_stage(int stage, Mistake mistake) const {
    const Result<Rendering> rendering = render_mistaken(scene, options_of(stage), mistake);
    if (!rendering) return tl::make_unexpected(rendering.error());
    const Image image = as_stored(rendering->image, options.profile.transfer, 8);
    return stage == 1 ? as_silhouette(image) : image;
  }
  static Image coarse_of(const Image& image) { return reduced(image, kCoarseSide); }
  const StagePictures& pictures(int stage) const;
  PictureKind kind() const;
  StageGrade judge(int stage, const SubmittedPicture& submitted) const;
  StageGrade judge(int stage, const std::string& file, const Result<ReadImage>& submitted) const;
  Match best_match(int stage, const Fitted& fitted, const std::vector<Alignment>& ways) const;
  int nearest_stage(const Image& image) const;
  StageGrade judge_alone(const SubmittedPicture& picture, const Result<ReadImage>& image) const;
  std::vector<StageGrade> judge_all(const std::vector<SubmittedPicture>& pictures) const;
};

const StagePictures& Grader::Impl::pictures(int stage) const {
  StagePictures& found = stages[static_cast<std::size_t>(stage - 1)];
  const auto render_all = [&] {
    found.coarse = coarse_of(right_of(stage));
    // Mistakes are those of the lab's rules.
    const bool none = needs_general_engine(scene, options);
    for (const MistakeEntry& entry : all_mistakes()) {
      if (none || entry.first_stage > stage) continue;
      // What render() refuses was refused by create().
      const Image picture = render_stage(stage, entry.mistake).value();
      // A picture that would pass for right is no picture of a mistake.
      if (measure_errors(picture, right_of(stage), (rubric.tolerance + 0.5) / 255).share() <=
          rubric.share)
        continue;
      found.visible.push_back({entry.mistake, coarse_of(picture), PackedImage(picture)});
    }
  };
  // While it waits for its tiles, a thread must not be given another submission to mark: that one
  // would wait here for the thread itself.
  std::call_once(found.once, [&] { tbb::this_task_arena::isolate(render_all); });
  return found;
}

/// The candidate and the alignment that come nearest.
Match Grader::Impl::best_match(int stage, const Fitted& fitted,
                               const std::vector<Alignment>& ways) const {
  const StagePictures& all = pictures(stage);
  const Image& whole = fitted.image;
  const Image less = coarse_of(whole);
  const auto scaled = [](std::uint32_t n, std::uint32_t from, std::uint32_t to) {
    return static_cast<std::uint32_t>(std::uint64_t{n} * to / from);
  };
  const Region part{scaled(fitted.region.left, whole.width, less.width),
                    scaled(fitted.region.top, whole.height, less.height),
                    scaled(fitted.region.right, whole.width, less.width),
                    scaled(fitted.region.bottom, whole.height, less.height)};
  std::vector<Match> coarse;
  for (std::size_t w = 0; w < ways.size(); ++w) {
    const Image small = aligned(less, ways[w]);
    coarse.push_back({nullptr, w, mean_square(small, all.coarse, part)});
    for (const Candidate& candidate : all.visible)
      coarse.push_back({&candidate, w, mean_square(small, candidate.coarse, part)});
  }
  // As it was handed in, unless another way fits much better.
  double as_is = std::numeric_limits<double>::infinity(), best = as_is;
  std::size_t way = 0;
  for (const Match& match : coarse) {
    if (match.way == 0) as_is = std::min(as_is, match.distance);
    if (match.distance < best) best = match.distance, way = match.way;
  }
  if (best > 0.5 * as_is) way = 0;

  Match nearest;
  const auto look = [&](std::size_t w) {
    const Image image = aligned(whole, ways[w]);
    const auto consider = [&](const Candidate* candidate, const Image& picture) {
      const double d = mean_square(image, through_scaling(picture, fitted), fitted.region);
      if (d < nearest.distance) nearest = {candidate, w, d};
    };
    consider(nullptr, right_of(stage));
    for (const Candidate& candidate : all.visible) consider(&candidate, candidate.picture.image());
  };
  look(0);
  if (way != 0) look(way);
  return nearest;
}

PictureKind Grader::Impl::kind() const {
  return {right_of(7).width, right_of(7).height, options.profile.transfer};
}

StageGrade Grader::Impl::judge(int stage, const SubmittedPicture& submitted) const {
  return judge(stage, submitted.file, read_picture(submitted, kind()));
}

StageGrade Grader::Impl::judge(int stage, const std::string& file,
                               const Result<ReadImage>& submitted) const {
  StageGrade grade{.stage = stage, .file = file};
  if (!submitted) {
    grade.verdict = Verdict::unreadable;
    grade.problems = submitted.error();
    return grade;
  }
  const Image& wanted = right_of(stage);
  Image handed_in = submitted->image;
  if (stage == 1) handed_in = as_silhouette(handed_in);
  Fitted fitted = fit(handed_in, wanted);
  if (stage == 1) fitted.image = as_silhouette(fitted.image);  // scaling has left greys
  const bool loss = submitted->format == "JPEG" || fitted.alignment.scaled;
  const double threshold = (rubric.tolerance + 0.5) / 255;
  const auto share_over = [&](const Image& a, const Image& b) {
    const auto cut = [&](const Image& image) {
      const Region& r = fitted.region;
      return fitted.alignment.cut
                 ? cropped(image, r.left, r.top, r.right - r.left, r.bottom - r.top)
                 : image;
    };
    return measure_errors(cut(a), cut(b), threshold).share();
  };
  const auto settle = [&](const Image& image, const Alignment& way, Verdict verdict) {
    grade.verdict = verdict;
    grade.alignment = fitted.alignment;
    grade.alignment.flipped = way.flipped;
    grade.alignment.swapped = way.swapped;
    grade.alignment.curve = way.curve;
    grade.aligned = image;
    grade.share_wrong = share_over(image, wanted);
  };

  grade.share_wrong = share_over(fitted.image, wanted);
  if (!loss && grade.share_wrong <= rubric.share && shows(fitted.image, wanted, fitted.region)) {
    settle(fitted.image, {}, Verdict::right);
    grade.share_left = grade.share_wrong;
    return grade;
  }

  std::vector<Alignment> kinds = ways_to_align();
  if (fitted.alignment.cut) std::erase_if(kinds, [](const Alignment& way) { return way.flipped; });
  if (stage == 1)
    std::erase_if(kinds, [](const Alignment& way) {
      return way.swapped || way.curve != Alignment::Curve::none;
    });
  const Match match = best_match(stage, fitted, kinds);
  const Image image = aligned(fitted.image, kinds[match.way]);
  const double to_right = mean_square(image, through_scaling(wanted, fitted), fitted.region);
  const Image named = match.candidate == nullptr ? wanted : match.candidate->picture.image();
  grade.share_left = share_over(image, named);

  const double few = match.candidate == nullptr ? rubric.share : kRestOfMistake;
  // Silhouettes are black and white, so that a pixel on the edge counts as much as any.
  const bool close = !loss        ? grade.share_left <= few
                     : stage == 1 ? grade.share_left <= std::max(few, kEdges)
                                  : std::sqrt(match.distance) <= kLoss;
  const double explained = to_right > 0 ? 1 - match.distance / to_right : 1;
  if (!shows(image, through_scaling(named, fitted), fitted.region)) {
    settle(image, kinds[match.way], Verdict::differs);
  } else if (match.candidate == nullptr) {
    settle(image, kinds[match.way], close ? Verdict::right : Verdict::differs);
  } else if ((explained >= (loss ? kExplainedWithLoss : kExplained) &&
              std::sqrt(match.distance) <= kNamed) ||
             (close && explained > 0)) {
    settle(image, kinds[match.way], Verdict::mistaken);
    // Several where the scene cannot tell them apart.
    const Region whole{0, 0, wanted.width, wanted.height};
    for (const Candidate& other : pictures(stage).visible)
      if (mean_square(other.picture.image(), named, whole) < kSame)
        grade.mistakes.push_back(other.mistake);
  } else {
    settle(image, kinds[match.way], Verdict::differs);
  }
  if (grade.verdict != Verdict::right) {
    Image there = wanted;  // what was cut off differs nowhere
    const Region& r = fitted.region;
    for (std::uint32_t y = r.top; y < r.bottom; ++y)
      std::copy(image.row(y) + std::size_t{3} * r.left, image.row(y) + std::size_t{3} * r.right,
                there.row(y) + std::size_t{3} * r.left);
    grade.pixels = worst_pixels(there, wanted, threshold, 3);
    grade.aligned = std::move(there);
  }
  return grade;
}

int Grader::Impl::nearest_stage(const Image& image) const {
  int nearest = 7;
  double least = std::numeric_limits<double>::infinity();
  // Any picture of the scene has its silhouette.
  for (int stage = 7; stage >= (is_flat(image) ? 1 : 2); --stage) {
    const Image& wanted = right_of(stage);
    const Fitted fitted = fit(stage == 1 ? as_silhouette(image) : image, wanted);
    const double d = mean_square(fitted.image, wanted, fitted.region);
    if (d < least) least = d, nearest = stage;
  }
  return nearest;
}

/// A picture whose name says nothing is of the nearest stage; or of the last one, if that makes
/// more of it.
StageGrade Grader::Impl::judge_alone(const SubmittedPicture& picture,
                                     const Result<ReadImage>& image) const {
  if (picture.stage != 0) return judge(picture.stage, picture.file, image);
  StageGrade nearest = judge(nearest_stage(image->image), picture.file, image);
  if (nearest.verdict != Verdict::differs) return nearest;
  StageGrade last = judge(7, picture.file, image);
  return last.verdict == Verdict::differs ? nearest : last;
}

/// Of two pictures for one stage the first that can be read counts. One whose name says nothing is
/// of the nearest stage that no other picture is named after; one that cannot be read either is
/// told of at a stage that has none.
std::vector<StageGrade> Grader::Impl::judge_all(
    const std::vector<SubmittedPicture>& pictures) const {
  std::array<std::vector<const SubmittedPicture*>, 8> of_stage;
  std::vector<StageGrade> unreadable;
  for (const SubmittedPicture& picture : pictures)
    if (picture.stage >= 1 && picture.stage <= 7)
      of_stage[static_cast<std::size_t>(picture.stage)].push_back(&picture);
  for (const SubmittedPicture& picture : pictures) {
    if (picture.stage != 0) continue;
    const Result<ReadImage> image = read_picture(picture, kind());
    if (image)
      of_stage[static_cast<std::size_t>(nearest_stage(image->image))].push_back(&picture);
    else
      unreadable.push_back(judge(7, picture.file, image));
  }
  std::vector<StageGrade> grades;
  for (int stage = 1; stage <= 7; ++stage) {
    StageGrade first{.stage = stage};
    for (const SubmittedPicture* picture : of_stage[static_cast<std::size_t>(stage)]) {
      StageGrade grade = judge(stage, *picture);
      const bool counts = grade.verdict != Verdict::unreadable;
      if (counts || first.verdict == Verdict::missing) first = std::move(grade);
      if (counts) break;
    }
    grades.push_back(std::move(first));
  }
  for (auto grade = grades.rbegin(); grade != grades.rend() && !unreadable.empty(); ++grade) {
    if (grade->verdict != Verdict::missing) continue;
    unreadable.front().stage = grade->stage;
    *grade = std::move(unreadable.front());
    unreadable.erase(unreadable.begin());
  }
  return grades;
}

Grader::Grader(std::unique_ptr<Impl> impl) : impl_(std::move(impl)) {}
Grader::Grader(Grader&&) noexcept = default;
Grader::~Grader() = default;

Result<Grader> Grader::create(const Scene& scene, const RenderOptions& options,
                              const Rubric& rubric) {
  std::unique_ptr<Impl> impl(new Impl{scene, options, rubric, {}, {}});
  impl->options.isa.reset();  // all have the same bits, and the oracle makes no mistakes
  for (int stage = 1; stage <= 7; ++stage) {
    Result<Image> picture = impl->render_stage(stage, Mistake::none);
    if (!picture) return tl::make_unexpected(picture.error());
    impl->right[static_cast<std::size_t>(stage - 1)] = std::move(*picture);
  }
  return Grader(std::move(impl));
}

const Rubric& Grader::rubric() const {
  return impl_->rubric;
}

Image Grader::picture(int stage, Mistake mistake) const {
  if (mistake != Mistake::none)
    for (const Candidate& candidate : impl_->pictures(stage).visible)
      if (candidate.mistake == mistake) return candidate.picture.image();
  return impl_->right_of(stage);
}

Grade Grader::grade(const std::string& path, Links links) const {
  Grade grade{.name = path, .stages = {}, .problems = {}};
  for (const double marks : impl_->rubric.marks) grade.of += marks;
  try {
    Result<std::vector<SubmittedPicture>> pictures = read_submission(path, links);
    if (!pictures) {
      grade.problems = pictures.error();
      return grade;
    }
    const bool alone = pictures->front().alone;
    if (alone && pictures->front().stage == kNoStage) {
      grade.problems = {problem(Severity::error, path,
                                phrase(Word::grade_no_stage, shown(pictures->front().file)),
                                phrase(Word::grade_call_it))};
      return grade;
    }
    if (alone) {
      const Result<ReadImage> image = read_picture(pictures->front(), impl_->kind());
      if (!image) {
        grade.problems = image.error();
        return grade;
      }
      grade.stages = {impl_->judge_alone(pictures->front(), image)};
    } else {
      grade.stages = impl_->judge_all(*pictures);
    }
    mark(impl_->rubric, grade.stages);
    if (alone) grade.of = 0;
    for (const StageGrade& stage : grade.stages) {
      grade.marks += stage.marks;
      if (alone) grade.of += stage.of;
    }
  } catch (const std::bad_alloc&) {
    grade.stages.clear();
    grade.problems = {problem(Severity::error, path, phrase(Word::grade_memory))};
  }
  return grade;
}

std::optional<ToldApart> Grader::told_apart(const StageGrade& stage) const {
  if (stage.mistakes.empty()) return std::nullopt;
  const Mistake mistake = stage.mistakes.front();
  const std::vector<PixelPair> worst =
      worst_pixels(picture(stage.stage, mistake), picture(stage.stage), 0, 1);
  if (worst.empty()) return std::nullopt;
  const auto explained = [&](Mistake made) {
    return explain_mistaken(impl_->scene, impl_->options_of(stage.stage), made, worst.front().x,
                            worst.front().y);
  };
  Result<Explanation> right = explained(Mistake::none), mistaken = explained(mistake);
  if (!right || !mistaken) return std::nullopt;  // a tree too large to be explained
  return ToldApart{std::move(*right), std::move(*mistaken)};
}

}  // namespace zraka
