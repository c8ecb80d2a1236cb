// SPDX-License-Identifier: Apache-2.0
// Which stages the pictures of a submission are of, and what is found out about each.
#include <fmt/format.h>

#include <algorithm>
#include <tuple>
#include <zraka/school/grade.hpp>

#include "core/phrase.hpp"
#include "core/text.hpp"
#include "school/grade/drawn_size.hpp"
#include "school/grade/judge.hpp"
#include "school/grade/rubric.hpp"
#include "school/grade/submission.hpp"

namespace zraka {

struct Grader::Impl {
  std::unique_ptr<StagePictures> pictures;
  SizedPictures sizes{*pictures};

  /// In the size that a picture was compared in.
  const StagePictures& pictures_of(const StageGrade& judged) const {
    const Alignment& alignment = judged.alignment;
    const StagePictures* sized = alignment.drawn_width == 0
                                     ? nullptr
                                     : sizes.of(alignment.drawn_width, alignment.drawn_height);
    return sized != nullptr ? *sized : *pictures;
  }

  PictureKind kind() const {
    const Image& right = pictures->right(7);
    return {right.width, right.height, pictures->options_of(7).profile.transfer};
  }
  Registered registered(const DecodedPicture& read) const { return {read, *pictures, sizes}; }
  static StageGrade unreadable(int stage, const std::string& file, const Diagnostics& problems);
  StageGrade judge_one(const SubmittedPicture& picture, const DecodedPicture& image,
                       const std::set<Mistake>& known = {}) const;
  std::vector<StageGrade> judge_all(const std::vector<SubmittedPicture>& submitted) const;
};

StageGrade Grader::Impl::unreadable(int stage, const std::string& file,
                                    const Diagnostics& problems) {
  return {.stage = stage, .file = file, .verdict = Verdict::unreadable, .problems = problems};
}

/// What is another stage's right picture shows nothing that its own adds, whatever the cause: many
/// a mistake hides it all, and those that the catalogue has are no likelier than others.
void say_right_as(int stage, StageGrade& grade) {
  if (stage == 0 || stage == grade.stage) return;
  grade.right_as = stage;
  grade.verdict = Verdict::unknown;
}

/// A word in the name tells the stage. A number is only a hint: where the picture is right as
/// another stage, or a mistake explains it as the one that it is nearest to, that is the one.
StageGrade Grader::Impl::judge_one(const SubmittedPicture& picture, const DecodedPicture& image,
                                   const std::set<Mistake>& known) const {
  const Registered found = registered(image);
  const auto judged = [&](int stage) {
    StageGrade grade = judge(*pictures, stage, found, known);
    grade.file = picture.file;
    return grade;
  };
  int stage = picture.stage;
  if (stage == 0) stage = right_stage(*pictures, found, 0);
  const bool shown = picture.stage == 0 && stage != 0;
  if (stage == 0) stage = nearest_stage(*pictures, found).stage;
  StageGrade grade = judged(stage);
  if (shown || grade.verdict == Verdict::right) return grade;
  if (picture.stage_is_sure) {
    say_right_as(right_stage(*pictures, found, 0), grade);
    return grade;
  }
  if (picture.stage != 0)
    if (const int right = right_stage(*pictures, found, 0); right != 0) return judged(right);
  if (grade.verdict != Verdict::unknown) return grade;
  const NearestStage nearest = nearest_stage(*pictures, found);
  if (!nearest.near) return grade;
  for (const int other : {nearest.stage, 7}) {
    if (other == stage) continue;
    StageGrade better = judged(other);
    if (better.verdict == Verdict::mistaken) return better;
  }
  return grade;
}

/// Of two pictures for one stage a right one counts, else the first that can be read. One whose
/// name says nothing is of the stage that it shows; one that cannot be read either is told of at a
/// stage that has none.
std::vector<StageGrade> Grader::Impl::judge_all(
    const std::vector<SubmittedPicture>& submitted) const {
  std::vector<StageGrade> grades, lost;
  for (int stage = 1; stage <= 7; ++stage) grades.push_back({.stage = stage});
  std::vector<const SubmittedPicture*> in_order;
  for (const SubmittedPicture& picture : submitted)
    if (picture.stage != kNoStage) in_order.push_back(&picture);
  // Mistakes of earlier stages are known when later ones are judged; what has no name comes last.
  const auto rank = [](const SubmittedPicture* picture) {
    return std::tuple(picture->stage == 0 ? 8 : picture->stage, !picture->stage_is_sure, picture);
  };
  std::sort(in_order.begin(), in_order.end(),
            [&](const auto* a, const auto* b) { return rank(a) < rank(b); });
  std::set<Mistake> known;
  for (const SubmittedPicture* picture : in_order) {
    const auto judged_at = [&](int stage) -> StageGrade& {
      return grades[static_cast<std::size_t>(stage - 1)];
    };
    if (picture->stage != 0 && picture->stage_is_sure &&
        judged_at(picture->stage).verdict == Verdict::right)
      continue;
    const Result<DecodedPicture> image = read_picture(*picture, kind());
    if (!image) {
      const int stage = picture->stage;
      StageGrade told = unreadable(stage == 0 ? 7 : stage, picture->file, image.error());
      if (stage != 0 && judged_at(stage).verdict == Verdict::missing)
        judged_at(stage) = std::move(told);
      else if (stage == 0)
        lost.push_back(std::move(told));
      continue;
    }
    StageGrade grade = judge_one(*picture, *image, known);
    if (grade.verdict == Verdict::mistaken && grade.mistakes.size() == (grade.both ? 2 : 1))
      known.insert(grade.mistakes.begin(), grade.mistakes.end());
    // A number is a hint, but the stage that it shows has its picture, and the number's has none.
    if (picture->stage != 0 && grade.stage != picture->stage &&
        judged_at(grade.stage).verdict == Verdict::right &&
        judged_at(picture->stage).verdict == Verdict::missing) {
      SubmittedPicture as_named = *picture;
      as_named.stage_is_sure = true;
      grade = judge_one(as_named, *image, known);
    }
    StageGrade& there = judged_at(grade.stage);
    if (there.verdict == Verdict::missing || there.verdict == Verdict::unreadable ||
        (grade.verdict == Verdict::right && there.verdict != Verdict::right))
      there = std::move(grade);
  }
  for (auto grade = grades.rbegin(); grade != grades.rend() && !lost.empty(); ++grade) {
    if (grade->verdict != Verdict::missing) continue;
    lost.front().stage = grade->stage;
    *grade = std::move(lost.front());
    lost.erase(lost.begin());
  }
  return grades;
}

Grader::Grader(std::unique_ptr<Impl> impl) : impl_(std::move(impl)) {}
Grader::Grader(Grader&&) noexcept = default;
Grader::~Grader() = default;

Result<Grader> Grader::create(const Scene& scene, const RenderOptions& options,
                              const Rubric& rubric) {
  Result<std::unique_ptr<StagePictures>> pictures = StagePictures::create(scene, options, rubric);
  if (!pictures) return tl::make_unexpected(pictures.error());
  return Grader(std::unique_ptr<Impl>(new Impl{.pictures = std::move(*pictures)}));
}

const Rubric& Grader::rubric() const {
  return impl_->pictures->rubric();
}

Image Grader::picture(int stage, const MistakenBy& by) const {
  return impl_->pictures->picture(stage, by);
}

Image Grader::picture(const StageGrade& judged, const MistakenBy& by) const {
  return impl_->pictures_of(judged).picture(judged.stage, by);
}

Grade Grader::grade(const std::string& path, Links links, int of) const {
  Grade grade{.name = path, .stages = {}, .problems = {}};
  for (const double marks : impl_->pictures->rubric().marks) grade.of += marks;
  try {
    Result<std::vector<SubmittedPicture>> pictures = read_submission(path, links);
    if (!pictures) {
      grade.problems = pictures.error();
      return grade;
    }
    if (of != 0)
      for (SubmittedPicture& picture : *pictures) {
        picture.stage = of;
        picture.stage_is_sure = true;
      }
    const bool alone = pictures->front().alone;
    if (alone && pictures->front().stage == kNoStage) {
      grade.problems = {problem(Severity::error, path,
                                phrase(Word::grade_no_stage, shown(pictures->front().file)),
                                phrase(Word::grade_call_it))};
      return grade;
    }
    if (alone) {
      const Result<DecodedPicture> image = read_picture(pictures->front(), impl_->kind());
      if (!image) {
        grade.problems = image.error();
        return grade;
      }
      grade.stages = {impl_->judge_one(pictures->front(), *image)};
    } else {
      grade.stages = impl_->judge_all(*pictures);
    }
    mark(impl_->pictures->rubric(), grade.stages);
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
  if (stage.mistakes.empty() || stage.pixels.empty()) return std::nullopt;
  const StagePictures& pictures = impl_->pictures_of(stage);
  const PixelPair& pixel = stage.pixels.front();
  const auto explained = [&](const MistakenBy& by) {
    return explain_mistaken(pictures.scene(), pictures.options_of(stage.stage), by, pixel.x,
                            pixel.y);
  };
  Result<Explanation> right = explained(Mistake::none), mistaken = explained(stage.named());
  if (!right || !mistaken) return std::nullopt;  // a tree too large to be explained
  return ToldApart{std::move(*right), std::move(*mistaken)};
}

}  // namespace zraka
