// SPDX-License-Identifier: Apache-2.0
#include "school/grade/drawn_size.hpp"

#include <algorithm>
#include <cmath>

#include "image/alter.hpp"
#include "school/grade/stage_pictures.hpp"

namespace zraka {
namespace {

/// The largest picture that is rendered anew, if the scene's own is not larger, and how many pixels
/// all of them may have.
constexpr std::uint64_t kMostOfOne = std::uint64_t{1} << 20, kMostOfAll = std::uint64_t{4} << 20;
/// Smaller ones show too little.
constexpr std::uint32_t kLeastSide = 48;

}  // namespace

SizedPictures::SizedPictures(const StagePictures& own) : own_(own) {}
SizedPictures::~SizedPictures() = default;

const StagePictures* SizedPictures::of(std::uint32_t width, std::uint32_t height) const {
  const auto [own_width, own_height] = own_.scene().resolution;
  if (width == own_width && height == own_height) return &own_;
  const double shape = static_cast<double>(width) * own_height / (static_cast<double>(height) * own_width);
  const std::uint64_t pixels = std::uint64_t{width} * height;
  if (std::min(width, height) < kLeastSide || std::fabs(shape - 1) > 0.005) return nullptr;
  if (pixels > std::max(kMostOfOne, std::uint64_t{own_width} * own_height)) return nullptr;
  const std::lock_guard lock(mutex_);
  const auto found = others_.find({width, height});
  if (found != others_.end()) return found->second.get();
  if (pixels_ + pixels > kMostOfAll) return nullptr;
  pixels_ += pixels;
  return (others_[{width, height}] = StagePictures::in_size(own_, width, height)).get();
}

void add_drawn_sizes(const Image& submitted, const SizedPictures& sizes,
                     std::vector<Fitted>& fitted) {
  std::vector<Fitted> all;
  for (Fitted& one : fitted) {
    const GridPlacement at = one.placement;
    const Alignment& alignment = one.alignment;
    if (alignment.scaled && !alignment.unpainted && std::fabs(at.across / at.down - 1) < 0.02) {
      const double width = at.across * one.image.width, height = at.down * one.image.height;
      auto w = static_cast<std::uint32_t>(std::lround(width)),
           h = static_cast<std::uint32_t>(std::lround(height));
      if (one.image.width == one.image.height)
        w = h = static_cast<std::uint32_t>(std::lround((width + height) / 2));
      if (const StagePictures* pictures = sizes.of(w, h); pictures != nullptr) {
        // The middle tells best where it lies.
        const Position position{alignment.transposed, alignment.flipped,
                                {std::round(at.left + (width - w) / 2),
                                 std::round(at.top + (height - h) / 2), 1, 1},
                                one.likeness};
        all.push_back(fitted_at(position, submitted, false, w, h));
        all.back().pictures = pictures;
      }
    }
    all.push_back(std::move(one));
  }
  fitted = std::move(all);
}

}  // namespace zraka
