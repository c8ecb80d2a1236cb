// SPDX-License-Identifier: Apache-2.0
// The scene in the sizes that students' programs draw in: their pictures are then compared pixel by
// pixel, as those in the scene's own size are.
#pragma once

#include <array>
#include <cstdint>
#include <map>
#include <memory>
#include <mutex>
#include <tuple>
#include <utility>
#include <vector>

#include "school/grade/align.hpp"

namespace zraka {

class StagePictures;

/// The pixels on both sides of a silhouette's outline.
struct Outline {
  std::vector<std::pair<std::uint32_t, std::uint32_t>> inside, outside;
};

/// The scene's pictures in other sizes, made when they are first asked for.
class SizedPictures {
 public:
  explicit SizedPictures(const StagePictures& own);
  ~SizedPictures();
  SizedPictures(const SizedPictures&) = delete;
  SizedPictures& operator=(const SizedPictures&) = delete;

  /// The scene's own ones where it is its size; nullptr where the size is none of its shape, or
  /// larger than what is kept, or where there are too many already.
  const StagePictures* of(std::uint32_t width, std::uint32_t height) const;
  /// Of the silhouettes in a size, right or with a mistake; empty where of() has none. Sizes that
  /// are only tried take little memory.
  Outline outline(std::uint32_t width, std::uint32_t height, Mistake mistake = Mistake::none) const;
  std::pair<std::uint32_t, std::uint32_t> own_size() const;

  std::array<float, 3> background() const;

 private:
  bool may_be(std::uint32_t width, std::uint32_t height) const;

  const StagePictures& own_;
  mutable std::mutex mutex_;
  mutable std::map<std::pair<std::uint32_t, std::uint32_t>, std::unique_ptr<StagePictures>> others_;
  mutable std::uint64_t pixels_ = 0;  ///< of all sizes
  mutable std::map<std::tuple<std::uint32_t, std::uint32_t, Mistake>, Outline> outlines_;
};

/// A submission as a whole, turned or not, in the size that a program may have drawn it in: as it
/// is where that is the scene's own, else where it keeps to the scene's outlines.
std::vector<Fitted> drawn_as_whole(const Image& submitted, bool jpeg, const SizedPictures& sizes);

/// Puts before each scaled fit of a submission the one in the size that a program may have drawn it
/// in, which leaves its pixels as they are. Where one that does so keeps to the scene's outlines,
/// all that do not are left out.
void add_drawn_sizes(const Image& submitted, bool jpeg, const SizedPictures& sizes,
                     std::vector<Fitted>& fitted);

}  // namespace zraka
