// SPDX-License-Identifier: Apache-2.0
#include "school/grade/drawn_size.hpp"

#include <algorithm>
#include <array>
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
/// What is no farther from the background has its colour.
constexpr float kSameColor = 0.03F;
constexpr std::size_t kLeastOutline = 40;
/// So much of an outline's pixels are on their sides of it where a program has drawn them.
constexpr double kOfAll = 0.85, kOfJpeg = 0.7;

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

namespace {

/// The pixels on both sides of a silhouette's outline.
struct Outline {
  std::vector<std::pair<std::uint32_t, std::uint32_t>> inside, outside;
};

Outline outline_of(const Image& silhouette) {
  Outline outline;
  const auto lit = [&](std::uint32_t x, std::uint32_t y) {
    return silhouette.row(y)[std::size_t{3} * x] > 0.5F;
  };
  for (std::uint32_t y = 1; y + 1 < silhouette.height; ++y)
    for (std::uint32_t x = 1; x + 1 < silhouette.width; ++x) {
      const bool here = lit(x, y);
      if (lit(x - 1, y) != here || lit(x + 1, y) != here || lit(x, y - 1) != here ||
          lit(x, y + 1) != here)
        (here ? outline.inside : outline.outside).emplace_back(x, y);
    }
  return outline;
}

/// The share of an outline's pixels that are on their sides of it: all where a program has drawn
/// them, few where a screen has scaled them.
double on_their_sides(const Outline& outline, const Image& picture, std::int64_t left,
                      std::int64_t top, const std::array<float, 3>& background) {
  std::size_t right = 0, all = 0;
  const auto count = [&](const auto& pixels, bool is_background) {
    for (const auto& [x, y] : pixels) {
      const std::int64_t u = left + x, v = top + y;
      if (u < 0 || v < 0 || u >= picture.width || v >= picture.height) continue;
      const float* p = picture.row(static_cast<std::uint32_t>(v)) + 3 * u;
      float most = 0;
      for (std::size_t c = 0; c < 3; ++c) most = std::max(most, std::fabs(p[c] - background[c]));
      ++all;
      right += (most < kSameColor) == is_background;
    }
  };
  count(outline.inside, false);
  count(outline.outside, true);
  return all < kLeastOutline ? 0 : static_cast<double>(right) / static_cast<double>(all);
}

}  // namespace

std::vector<Fitted> drawn_as_whole(const Image& submitted, bool jpeg, const SizedPictures& sizes) {
  std::vector<Fitted> all;
  for (const Turn& turn : kTurns) {
    const std::uint32_t width = turn.transposed ? submitted.height : submitted.width,
                        height = turn.transposed ? submitted.width : submitted.height;
    const StagePictures* pictures = sizes.of(width, height);
    if (pictures == nullptr) continue;
    const bool own = sizes.is_own(*pictures);
    const bool as_it_is = own && !turn.flipped_first && !turn.transposed && !turn.flipped;
    if (!as_it_is && on_their_sides(outline_of(pictures->right(1)), turned_by(submitted, turn), 0,
                                    0, pictures->background()) < (jpeg ? kOfJpeg : kOfAll))
      continue;
    all.push_back(fitted_at({turn, {}, 1}, submitted, false, width, height));
    if (!own) all.back().pictures = pictures;
  }
  return all;
}

void add_drawn_sizes(const Image& submitted, bool jpeg, const SizedPictures& sizes,
                     std::vector<Fitted>& fitted) {
  std::vector<Fitted> all;
  for (Fitted& one : fitted) {
    const GridPlacement at = one.placement;
    const double width = at.across * one.image.width, height = at.down * one.image.height;
    const bool may_be = one.alignment.scaled && !one.alignment.unpainted &&
                        std::fabs(at.across / at.down - 1) < 0.02;
    double most = jpeg ? kOfJpeg : kOfAll;
    Position best{};
    const StagePictures* found = nullptr;
    const Image turned = may_be ? turned_by(submitted, one.turn) : Image();
    for (int more = -1; more <= 1 && may_be; ++more) {
      auto w = static_cast<std::uint32_t>(std::lround(width) + more),
           h = static_cast<std::uint32_t>(std::lround(height) + more);
      if (one.image.width == one.image.height)
        w = h = static_cast<std::uint32_t>(std::lround((width + height) / 2) + more);
      // A whole one is as large as it is.
      if (!one.alignment.cut && (w != turned.width || h != turned.height)) continue;
      const StagePictures* pictures = sizes.of(w, h);
      if (pictures == nullptr) continue;
      const Outline outline = outline_of(pictures->right(1));
      // The middle tells best where it lies.
      const auto left = std::lround(at.left + (width - w) / 2),
                 top = std::lround(at.top + (height - h) / 2);
      const int reach = one.alignment.cut ? 2 : 0;
      for (int y = -reach; y <= reach; ++y)
        for (int x = -reach; x <= reach; ++x) {
          const double share =
              on_their_sides(outline, turned, left + x, top + y, pictures->background());
          if (share <= most) continue;
          most = share;
          found = pictures;
          best = {one.turn,
                  {static_cast<double>(left + x), static_cast<double>(top + y), 1, 1},
                  one.likeness};
        }
    }
    if (found != nullptr) {
      all.push_back(
          fitted_at(best, submitted, false, found->right(1).width, found->right(1).height));
      all.back().pictures = found;
    }
    all.push_back(std::move(one));
  }
  fitted = std::move(all);
}

}  // namespace zraka
