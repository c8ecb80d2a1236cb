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

/// Pictures are first compared at no less than this size, those of two mistakes at half of it.
inline constexpr std::uint32_t kCoarseSide = 100;

struct Candidate {
  MistakenBy by;
  Image coarse;
};

/// A mistake's picture that submissions are searched for.
struct Sought {
  Sought(const MistakenBy& made_by, const Grid& outlines)
      : by(made_by),
        coarse(reduced_to(outlines, kCoarseOutlines)),
        middle(reduced_to(outlines, kMiddleOutlines)) {}
  MistakenBy by;
  Searched coarse, middle;  ///< its outlines
  double like_right = 1;    ///< how alike they are to the right picture's
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
  /// As picture(), where all highlights have `factor` times the power; nothing of it is kept.
  Image with_power_times(double factor, int stage, const MistakenBy& by) const;
  const Image& right(int stage) const;
  /// As an 8 bit file has it.
  std::array<float, 3> background() const;
  const Image& coarse(int stage) const { return coarse_[index(stage)]; }
  const Template& outlines() const { return outlines_; }

  /// The mistakes that this scene can show in the stage, of every stride()-th pixel, as `coarse`;
  /// made when they are first asked for.
  const std::vector<Candidate>& mistaken(int stage) const;
  /// Those of mistaken() that lie elsewhere than the right picture would, or have other outlines.
  const std::vector<Sought>& sought(int stage) const;
  /// Products of what any two of them change, one row for each.
  const std::vector<double>& products(int stage) const;
  /// The same on top of a mistake, with fewer pixels.
  const std::vector<Candidate>& mistaken_besides(int stage, Mistake mistake) const;
  /// One with two mistakes, with as few pixels.
  Image besides(int stage, const MistakenBy& by) const;
  /// A picture as an 8 bit file has it.
  Image picture(int stage, const MistakenBy& by) const;

 private:
  StagePictures(const Scene& scene, const RenderOptions& options, const Rubric& rubric)
      : scene_(scene), options_(options), rubric_(rubric) {}
  StagePictures(std::unique_ptr<const Scene> scene, const RenderOptions& options,
                const Rubric& rubric)
      : own_scene_(std::move(scene)), scene_(*own_scene_), options_(options), rubric_(rubric) {}
  static std::size_t index(int stage) { return static_cast<std::size_t>(stage - 1); }
  std::uint32_t stride(std::uint32_t side) const;
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
  Template outlines_;
  mutable std::array<Made, 7> mistaken_;
  struct Outlined {
    std::once_flag once;
    std::vector<Sought> pictures;
  };
  mutable std::array<Outlined, 7> sought_;
  mutable std::mutex mutex_;
  mutable std::map<std::pair<int, Mistake>, Made> besides_;
  /// With mistakes, as they were asked for; a scene has hundreds of these.
  mutable std::map<std::tuple<int, Mistake, Mistake>, PackedImage> kept_;
  struct Products {
    std::once_flag once;
    std::vector<double> values;
  };
  mutable std::array<Products, 7> products_;
};

/// The pixels of a picture that a smaller one of the same scene has, or the nearest to them.
Image sampled(const Image& image, std::uint32_t width, std::uint32_t height);

}  // namespace zraka
