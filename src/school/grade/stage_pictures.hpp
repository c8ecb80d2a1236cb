// SPDX-License-Identifier: Apache-2.0
// The pictures that submissions of a scene are compared with: right ones, and those of mistakes.
#pragma once

#include <map>
#include <memory>
#include <mutex>
#include <tuple>
#include <zraka/school/grade.hpp>

#include "image/packed.hpp"
#include "school/grade/registration.hpp"

namespace zraka {

/// Pictures are first compared at about this size, those of two mistakes at about half of it.
inline constexpr std::uint32_t kCoarseSide = 100;

struct Candidate {
  MistakenBy by;
  Image coarse;
  PackedImage picture;  ///< a scene has hundreds of these
};

class StagePictures {
 public:
  static Result<std::unique_ptr<StagePictures>> create(const Scene& scene,
                                                       const RenderOptions& options,
                                                       const Rubric& rubric);

  /// The same scene's pictures in another size.
  static std::unique_ptr<StagePictures> in_size(const StagePictures& other, std::uint32_t width,
                                                std::uint32_t height);

  const Scene& scene() const { return scene_; }
  const Rubric& rubric() const { return rubric_; }
  RenderOptions options_of(int stage) const;
  const Image& right(int stage) const;
  const Image& coarse(int stage) const { return coarse_[index(stage)]; }
  const Template& outlines() const { return outlines_; }
  const Template& mirrored_outlines() const { return mirrored_outlines_; }

  /// The mistakes that this scene can show in the stage; made when they are first asked for.
  const std::vector<Candidate>& mistaken(int stage) const;
  /// The same on top of a mistake, of every stride()-th pixel only, as `coarse`.
  const std::vector<Candidate>& mistaken_besides(int stage, Mistake mistake) const;
  std::uint32_t stride() const;
  /// A picture as an 8 bit file has it.
  Image picture(int stage, const MistakenBy& by) const;

 private:
  StagePictures(const Scene& scene, const RenderOptions& options, const Rubric& rubric)
      : scene_(scene), options_(options), rubric_(rubric) {}
  StagePictures(std::unique_ptr<const Scene> scene, const RenderOptions& options,
                const Rubric& rubric)
      : own_scene_(std::move(scene)), scene_(*own_scene_), options_(options), rubric_(rubric) {}
  static std::size_t index(int stage) { return static_cast<std::size_t>(stage - 1); }
  Result<Image> render(int stage, const MistakenBy& by, std::uint32_t stride = 1) const;
  std::vector<Candidate> render_all(int stage) const;
  std::vector<Candidate> render_besides(int stage, Mistake mistake) const;

  struct Made {
    std::once_flag once;
    std::vector<Candidate> pictures;
  };
  std::unique_ptr<const Scene> own_scene_;  ///< where it is none of the caller's
  const Scene& scene_;
  RenderOptions options_;
  Rubric rubric_;
  mutable std::array<Image, 7> right_;
  mutable std::array<std::once_flag, 7> right_once_;
  std::array<Image, 7> coarse_;
  Template outlines_, mirrored_outlines_;
  mutable std::array<Made, 7> mistaken_;
  mutable std::mutex mutex_;
  mutable std::map<std::pair<int, Mistake>, Made> besides_;
  /// Of mistakes in another size than the scene's.
  mutable std::map<std::tuple<int, Mistake, Mistake>, PackedImage> kept_;
};

/// The pixels of a picture that a smaller one of the same scene has, or the nearest to them.
Image sampled(const Image& image, std::uint32_t width, std::uint32_t height);

}  // namespace zraka
