// SPDX-License-Identifier: Apache-2.0
#include "school/grade/stage_pictures.hpp"

#include <algorithm>

#include "core/threads.hpp"
#include "image/alter.hpp"
#include "render/prepare.hpp"
#include "school/grade/align.hpp"

namespace zraka {
namespace {

/// Bytes of mistakes' pictures that are kept, in the scene's size and in each other one.
constexpr std::size_t kMostKept = std::size_t{192} << 20, kMostOfSize = std::size_t{48} << 20;

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
    const std::uint32_t stride = made->stride(kCoarseSide);
    made->coarse_[index(stage)] =
        sampled(*picture, picture->width / stride, picture->height / stride);
    made->right_[index(stage)] = std::move(*picture);
  }
  // Silhouettes are in all pictures; light and mirrors add to them.
  made->outlines_ = Template(
      {&made->right(1), &made->right(1), &made->right(2), &made->right(3), &made->right(7)});
  return made;
}

std::unique_ptr<StagePictures> StagePictures::in_size(const StagePictures& other,
                                                      std::uint32_t width, std::uint32_t height) {
  auto scene = std::make_unique<Scene>(other.scene_);
  scene->resolution = {width, height};
  return std::unique_ptr<StagePictures>(
      new StagePictures(std::move(scene), other.options_, other.rubric_));
}

Image StagePictures::with_power_times(double factor, int stage, const MistakenBy& by) const {
  Scene other = scene_;
  for (Material& material : other.materials) material.shininess *= factor;
  Image made;
  undisturbed([&] {
    made = as_stored(render_mistaken(other, options_of(stage), by).value().image,
                     options_.profile.transfer, 8);
  });
  return made;
}

std::array<float, 3> StagePictures::background() const {
  Image one(1, 1);
  const Color& color = scene_.background;
  one.pixels = {static_cast<float>(color.r), static_cast<float>(color.g),
                static_cast<float>(color.b)};
  const Image stored = as_stored(one, options_.profile.transfer, 8);
  return {stored.pixels[0], stored.pixels[1], stored.pixels[2]};
}

const Image& StagePictures::right(int stage) const {
  const std::size_t i = index(stage);
  std::call_once(right_once_[i], [&] {
    if (!right_[i].pixels.empty()) return;
    // What one size can show another can.
    undisturbed([&] { right_[i] = render(stage, Mistake::none).value(); });
  });
  return right_[i];
}

std::vector<Candidate> StagePictures::render_all(int stage) const {
  std::vector<Candidate> all;
  // Mistakes are those of the lab's rules.
  if (is_beyond_the_lab(scene_, options_)) return all;
  const std::uint32_t by = stride(kCoarseSide);
  const Image& right = coarse_[index(stage)];
  for (const MistakeEntry& entry : lab_mistakes()) {
    if (entry.first_stage > stage) continue;
    // What render() refuses was refused by create(). Part of a pixel is so in its own size only.
    const bool of_pixels =
        entry.mistake == Mistake::pixel_center || entry.mistake == Mistake::shifted;
    Image made = of_pixels
                     ? sampled(render(stage, entry.mistake).value(), right.width, right.height)
                     : render(stage, entry.mistake, by).value();
    // A plain picture shows nothing, and one that would pass for right is no picture of a mistake.
    if (spread(made, {0, 0, made.width, made.height}) < 1e-4) continue;
    if (measure_errors(made, right, (rubric_.tolerance + 0.5) / 255).share() <= rubric_.share)
      continue;
    all.push_back({entry.mistake, std::move(made)});
  }
  return all;
}

/// The largest that leaves a picture at least `side` pixels, all of which are the whole one's.
std::uint32_t StagePictures::stride(std::uint32_t side) const {
  const std::uint32_t width = scene_.resolution.width, height = scene_.resolution.height;
  std::uint32_t best = 1;
  for (std::uint32_t by = 2; std::max(width, height) / by >= side; ++by)
    if (width % (2 * by) == 0 && height % (2 * by) == 0) best = by;
  return best;
}

std::vector<Candidate> StagePictures::render_besides(int stage, Mistake mistake) const {
  std::vector<Candidate> all;
  for (const Candidate& other : mistaken(stage)) {
    if (other.by.first == mistake) continue;
    const MistakenBy by(mistake, other.by.first);
    all.push_back({by, besides(stage, by)});
  }
  return all;
}

Image StagePictures::besides(int stage, const MistakenBy& by) const {
  return render(stage, by, stride(kCoarseSide / 2)).value();
}

const std::vector<double>& StagePictures::products(int stage) const {
  Products& kept = products_[index(stage)];
  const std::vector<Candidate>& all = mistaken(stage);
  std::call_once(kept.once, [&] {
    const Image& right = coarse_[index(stage)];
    std::vector<std::vector<float>> changes;
    for (const Candidate& candidate : all) {
      changes.push_back(candidate.coarse.pixels);
      for (std::size_t i = 0; i < right.pixels.size(); ++i) changes.back()[i] -= right.pixels[i];
    }
    kept.values.resize(all.size() * all.size());
    for (std::size_t i = 0; i < all.size(); ++i)
      for (std::size_t j = 0; j <= i; ++j) {
        // A thousand at a time, so that floats are enough.
        double sum = 0;
        for (std::size_t from = 0; from < right.pixels.size(); from += 1000) {
          float part = 0;
          for (std::size_t k = from; k < std::min(from + 1000, right.pixels.size()); ++k)
            part += changes[i][k] * changes[j][k];
          sum += static_cast<double>(part);
        }
        kept.values[i * all.size() + j] = kept.values[j * all.size() + i] = sum;
      }
  });
  return kept.values;
}

const std::vector<Candidate>& StagePictures::mistaken(int stage) const {
  Made& kept = mistaken_[index(stage)];
  // While it waits for its tiles, a thread must not be given another submission to mark: that one
  // would wait here for the thread itself.
  std::call_once(kept.once, [&] {
    undisturbed([&] { kept.pictures = render_all(stage); });
  });
  return kept.pictures;
}

const std::vector<Sought>& StagePictures::sought(int stage) const {
  Outlined& kept = sought_[index(stage)];
  const std::vector<Candidate>& all = mistaken(stage);
  std::call_once(kept.once, [&] {
    const Searched right(reduced_to(zraka::outlines(coarse(stage)), kMiddleOutlines));
    for (const Candidate& candidate : all) {
      switch (candidate.by.first) {
        // The search itself turns and shifts.
        case Mistake::y_down:
        case Mistake::transposed:
        case Mistake::pixel_center:
        case Mistake::shifted:
          continue;
        default:
          break;
      }
      Sought& one = kept.pictures.emplace_back(candidate.by, zraka::outlines(candidate.coarse));
      one.like_right = SearchLevel(right, one.middle.grid).likeness({});
    }
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
    undisturbed([&] { kept->pictures = render_besides(stage, mistake); });
  });
  return kept->pictures;
}

Image StagePictures::picture(int stage, const MistakenBy& by) const {
  if (by == MistakenBy{}) return right(stage);
  if (own_scene_ == nullptr && by.second == Mistake::none && stride(kCoarseSide) == 1)
    for (const Candidate& candidate : mistaken(stage))
      if (candidate.by == by) return candidate.coarse;
  const std::tuple key(stage, by.first, by.second);
  {
    const std::lock_guard lock(mutex_);
    if (const auto found = kept_.find(key); found != kept_.end()) return found->second.image();
  }
  Image made;
  undisturbed([&] { made = render(stage, by).value(); });
  const std::lock_guard lock(mutex_);
  if (kept_.size() * made.pixels.size() < (own_scene_ == nullptr ? kMostKept : kMostOfSize))
    kept_.try_emplace(key, made);
  return made;
}

Image sampled(const Image& image, std::uint32_t width, std::uint32_t height) {
  Image out(width, height);
  // The lab's rays go through the corners of pixels.
  const auto nearest = [](std::uint32_t i, std::uint32_t of, std::uint32_t in) {
    return std::min(in - 1,
                    static_cast<std::uint32_t>((2 * std::uint64_t{i} * in + of) / (2 * of)));
  };
  for (std::uint32_t y = 0; y < height; ++y)
    for (std::uint32_t x = 0; x < width; ++x)
      std::copy_n(image.row(nearest(y, height, image.height)) +
                      std::size_t{3} * nearest(x, width, image.width),
                  3, out.row(y) + std::size_t{3} * x);
  return out;
}

}  // namespace zraka
