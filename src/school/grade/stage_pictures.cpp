// SPDX-License-Identifier: Apache-2.0
#include "school/grade/stage_pictures.hpp"

#include <tbb/task_arena.h>

#include <algorithm>

#include "image/alter.hpp"
#include "render/prepare.hpp"
#include "school/grade/align.hpp"

namespace zraka {
namespace {

/// Bytes of mistakes' pictures in another size than the scene's.
constexpr std::size_t kMostKept = std::size_t{64} << 20;

}  // namespace

RenderOptions StagePictures::options_of(int stage) const {
  RenderOptions asked = options_;
  asked.terms = terms_of(static_cast<Stage>(stage));
  return asked;
}

Result<Image> StagePictures::render(int stage, const MistakenBy& by, std::uint32_t stride) const {
  Scene smaller;
  if (stride > 1) {
    // The lab's rays go through the corners of pixels, so that these are the whole picture's.
    smaller = scene_;
    smaller.resolution = {scene_.resolution.width / stride, scene_.resolution.height / stride};
  }
  const Result<Rendering> rendering =
      render_mistaken(stride > 1 ? smaller : scene_, options_of(stage), by);
  if (!rendering) return tl::make_unexpected(rendering.error());
  const Image image = as_stored(rendering->image, options_.profile.transfer, 8);
  return stage == 1 ? as_silhouette(image) : image;
}

Result<std::unique_ptr<StagePictures>> StagePictures::create(const Scene& scene,
                                                             const RenderOptions& options,
                                                             const Rubric& rubric) {
  std::unique_ptr<StagePictures> made(new StagePictures(scene, options, rubric));
  made->options_.isa.reset();  // all have the same bits, and the oracle makes no mistakes
  for (int stage = 1; stage <= 7; ++stage) {
    Result<Image> picture = made->render(stage, Mistake::none);
    if (!picture) return tl::make_unexpected(picture.error());
    made->coarse_[index(stage)] = reduced(*picture, kCoarseSide);
    made->right_[index(stage)] = std::move(*picture);
  }
  // Silhouettes are in all pictures; light and mirrors add to them.
  made->outlines_ = Template({&made->right(1), &made->right(1), &made->right(2), &made->right(3),
                              &made->right(7)});
  made->mirrored_outlines_ = made->outlines_.mirrored();
  return made;
}

std::unique_ptr<StagePictures> StagePictures::in_size(const StagePictures& other,
                                                      std::uint32_t width, std::uint32_t height) {
  auto scene = std::make_unique<Scene>(other.scene_);
  scene->resolution = {width, height};
  return std::unique_ptr<StagePictures>(
      new StagePictures(std::move(scene), other.options_, other.rubric_));
}

const Image& StagePictures::right(int stage) const {
  const std::size_t i = index(stage);
  std::call_once(right_once_[i], [&] {
    if (!right_[i].pixels.empty()) return;
    // What one size can show another can.
    tbb::this_task_arena::isolate([&] { right_[i] = render(stage, Mistake::none).value(); });
  });
  return right_[i];
}

std::vector<Candidate> StagePictures::render_all(int stage) const {
  std::vector<Candidate> all;
  // Mistakes are those of the lab's rules.
  if (needs_general_engine(scene_, options_)) return all;
  for (const MistakeEntry& entry : all_mistakes()) {
    if (entry.first_stage > stage) continue;
    // What render() refuses was refused by create().
    const Image made = render(stage, entry.mistake).value();
    // A plain picture shows nothing, and one that would pass for right is no picture of a mistake.
    if (spread(made, {0, 0, made.width, made.height}) < 1e-4) continue;
    if (measure_errors(made, right(stage), (rubric_.tolerance + 0.5) / 255).share() <=
        rubric_.share)
      continue;
    all.push_back({entry.mistake, reduced(made, kCoarseSide), PackedImage(made)});
  }
  return all;
}

std::uint32_t StagePictures::stride() const {
  const std::uint32_t width = scene_.resolution.width, height = scene_.resolution.height;
  std::uint32_t best = 1;
  for (std::uint32_t by = 2; std::max(width, height) / by >= kCoarseSide / 2; ++by)
    if (width % (2 * by) == 0 && height % (2 * by) == 0) best = by;
  return best;
}

std::vector<Candidate> StagePictures::render_besides(int stage, Mistake mistake) const {
  std::vector<Candidate> all;
  for (const Candidate& other : mistaken(stage)) {
    if (other.by.first == mistake) continue;
    const MistakenBy by(mistake, other.by.first);
    all.push_back({by, render(stage, by, stride()).value(), {}});
  }
  return all;
}

const std::vector<Candidate>& StagePictures::mistaken(int stage) const {
  Made& kept = mistaken_[index(stage)];
  // While it waits for its tiles, a thread must not be given another submission to mark: that one
  // would wait here for the thread itself.
  std::call_once(kept.once, [&] {
    tbb::this_task_arena::isolate([&] { kept.pictures = render_all(stage); });
  });
  return kept.pictures;
}

const std::vector<Candidate>& StagePictures::mistaken_besides(int stage, Mistake mistake) const {
  Made* kept = nullptr;
  {
    const std::lock_guard lock(mutex_);
    kept = &besides_[{stage, mistake}];
  }
  std::call_once(kept->once, [&] {
    tbb::this_task_arena::isolate([&] { kept->pictures = render_besides(stage, mistake); });
  });
  return kept->pictures;
}

Image StagePictures::picture(int stage, const MistakenBy& by) const {
  if (by == MistakenBy{}) return right(stage);
  if (own_scene_ == nullptr && by.second == Mistake::none)
    for (const Candidate& candidate : mistaken(stage))
      if (candidate.by == by) return candidate.picture.image();
  if (own_scene_ == nullptr) return render(stage, by).value();
  const std::tuple key(stage, by.first, by.second);
  {
    const std::lock_guard lock(mutex_);
    if (const auto found = kept_.find(key); found != kept_.end()) return found->second.image();
  }
  Image made;
  tbb::this_task_arena::isolate([&] { made = render(stage, by).value(); });
  const std::lock_guard lock(mutex_);
  const std::size_t bytes = made.pixels.size();
  if (kept_.size() * bytes < kMostKept) kept_.try_emplace(key, made);
  return made;
}

Image sampled(const Image& image, std::uint32_t width, std::uint32_t height) {
  Image out(width, height);
  // The lab's rays go through the corners of pixels.
  const auto nearest = [](std::uint32_t i, std::uint32_t of, std::uint32_t in) {
    return std::min(in - 1, static_cast<std::uint32_t>((2 * std::uint64_t{i} * in + of) / (2 * of)));
  };
  for (std::uint32_t y = 0; y < height; ++y)
    for (std::uint32_t x = 0; x < width; ++x)
      std::copy_n(image.row(nearest(y, height, image.height)) +
                      std::size_t{3} * nearest(x, width, image.width),
                  3, out.row(y) + std::size_t{3} * x);
  return out;
}

}  // namespace zraka
