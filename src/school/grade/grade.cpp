// SPDX-License-Identifier: Apache-2.0
// Which stages the pictures of a submission are of, and what is found out about each.
#include <fmt/format.h>

#include <algorithm>
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
  Registered registered(const ReadImage& read) const { return {read, *pictures, sizes}; }
  StageGrade judge_one(int stage, const std::string& file, const Result<ReadImage>& submitted,
                       const std::set<Mistake>& known = {}) const;
  int stage_of(const SubmittedPicture& picture, const Registered& found) const;
  StageGrade judge_alone(const SubmittedPicture& picture, const Result<ReadImage>& image) const;
  std::vector<StageGrade> judge_all(const std::vector<SubmittedPicture>& submitted) const;
};

StageGrade Grader::Impl::judge_one(int stage, const std::string& file,
                                   const Result<ReadImage>& submitted,
                                   const std::set<Mistake>& known) const {
  if (!submitted)
    return {.stage = stage,
            .file = file,
            .verdict = Verdict::unreadable,
            .problems = submitted.error()};
  StageGrade grade = judge(*pictures, stage, registered(*submitted), known);
  grade.file = file;
  return grade;
}

/// A word in the name tells the stage; a number does so where the picture is right in no other one.
int Grader::Impl::stage_of(const SubmittedPicture& picture, const Registered& found) const {
  if (picture.stage != 0 && picture.stage_is_sure) return picture.stage;
  if (const int stage = right_stage(*pictures, found, picture.stage); stage != 0) return stage;
  return picture.stage != 0 ? picture.stage : nearest_stage(*pictures, found);
}

/// A picture whose name says nothing is of the nearest stage; or of the last one, if that makes
/// more of it.
StageGrade Grader::Impl::judge_alone(const SubmittedPicture& picture,
                                     const Result<ReadImage>& image) const {
  const Registered found = registered(*image);
  const auto judged = [&](int stage) { return judge(*pictures, stage, found); };
  StageGrade nearest = judged(stage_of(picture, found));
  if (picture.stage == 0 && nearest.verdict == Verdict::unknown && nearest.stage != 7) {
    StageGrade last = judged(7);
    if (last.verdict != Verdict::unknown) nearest = std::move(last);
  }
  nearest.file = picture.file;
  return nearest;
}

/// Of two pictures for one stage the first that can be read counts. One whose name says nothing is
/// of the nearest stage that no other picture is named after; one that cannot be read either is
/// told of at a stage that has none.
std::vector<StageGrade> Grader::Impl::judge_all(
    const std::vector<SubmittedPicture>& submitted) const {
  std::array<std::vector<const SubmittedPicture*>, 8> of_stage;
  std::vector<StageGrade> unreadable;
  for (const SubmittedPicture& picture : submitted)
    if (picture.stage >= 1 && picture.stage <= 7 && picture.stage_is_sure)
      of_stage[static_cast<std::size_t>(picture.stage)].push_back(&picture);
  for (const SubmittedPicture& picture : submitted) {
    if (picture.stage == kNoStage || (picture.stage != 0 && picture.stage_is_sure)) continue;
    const Result<ReadImage> image = read_picture(picture, kind());
    if (image)
      of_stage[static_cast<std::size_t>(stage_of(picture, registered(*image)))].push_back(&picture);
    else if (picture.stage != 0)
      of_stage[static_cast<std::size_t>(picture.stage)].push_back(&picture);
    else
      unreadable.push_back(judge_one(7, picture.file, image));
  }
  std::vector<StageGrade> grades;
  std::set<Mistake> known;
  for (int stage = 1; stage <= 7; ++stage) {
    StageGrade first{.stage = stage};
    for (const SubmittedPicture* picture : of_stage[static_cast<std::size_t>(stage)]) {
      StageGrade grade = judge_one(stage, picture->file, read_picture(*picture, kind()), known);
      const bool counts = grade.verdict != Verdict::unreadable;
      if (counts || first.verdict == Verdict::missing) first = std::move(grade);
      if (counts) break;
    }
    if (first.verdict == Verdict::mistaken && (first.both || first.mistakes.size() == 1))
      known.insert(first.mistakes.begin(), first.mistakes.end());
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
      const Result<ReadImage> image = read_picture(pictures->front(), impl_->kind());
      if (!image) {
        grade.problems = image.error();
        return grade;
      }
      grade.stages = {impl_->judge_alone(pictures->front(), image)};
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
