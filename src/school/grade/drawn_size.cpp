// SPDX-License-Identifier: Apache-2.0
#include "school/grade/drawn_size.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>

#include "image/alter.hpp"
#include "school/grade/stage_pictures.hpp"

namespace zraka {
namespace {

/// The largest picture that is rendered anew, if the scene's own is not larger, and how many pixels
/// all of them may have.
constexpr std::uint64_t kMostOfOne = std::uint64_t{1} << 20, kMostOfAll = std::uint64_t{4} << 20;
/// Smaller ones show too little.
constexpr std::uint32_t kLeastSide = 48;
constexpr std::size_t kMostOutlines = 200;
/// What is no farther from the background has its colour.
constexpr float kSameColor = 0.008F, kSameInJpeg = 0.04F;
constexpr std::size_t kLeastOutline = 40;
/// So much of an outline's pixels are on their sides of it where a program has drawn them.
constexpr double kRepeated = 0.99;  ///< of the outlines, where pixels were repeated
constexpr double kOfAll = 0.85, kOfJpeg = 0.7, kSure = 0.97, kSureOfJpeg = 0.9;

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

}  // namespace

SizedPictures::SizedPictures(const StagePictures& own) : own_(own) {}
SizedPictures::~SizedPictures() = default;

std::array<float, 3> SizedPictures::background() const {
  return own_.background();
}

std::pair<std::uint32_t, std::uint32_t> SizedPictures::own_size() const {
  const Resolution& size = own_.scene().resolution;
  return {size.width, size.height};
}

/// A size that its pictures may be asked for in.
bool SizedPictures::may_be(std::uint32_t width, std::uint32_t height) const {
  const auto [own_width, own_height] = own_size();
  const double shape = static_cast<double>(width) * own_height / height / own_width;
  return std::min(width, height) >= kLeastSide && std::fabs(shape - 1) <= 0.005 &&
         std::uint64_t{width} * height <=
             std::max(kMostOfOne, std::uint64_t{own_width} * own_height);
}

Outline SizedPictures::outline(std::uint32_t width, std::uint32_t height, Mistake mistake) const {
  if (!may_be(width, height)) return {};
  const std::tuple key(width, height, mistake);
  {
    const std::lock_guard lock(mutex_);
    if (const auto found = outlines_.find(key); found != outlines_.end()) return found->second;
  }
  const bool own = std::pair(width, height) == own_size();
  const Outline made =
      outline_of(own ? own_.picture(1, mistake)
                     : StagePictures::in_size(own_, width, height)->picture(1, mistake));
  const std::lock_guard lock(mutex_);
  if (outlines_.size() < kMostOutlines) outlines_.try_emplace(key, made);
  return made;
}

const StagePictures* SizedPictures::of(std::uint32_t width, std::uint32_t height) const {
  if (width == 0 || height == 0) return nullptr;
  if (std::pair(width, height) == own_size()) return &own_;
  if (!may_be(width, height)) return nullptr;
  const std::uint64_t pixels = std::uint64_t{width} * height;
  const std::lock_guard lock(mutex_);
  const auto found = others_.find({width, height});
  if (found != others_.end()) return found->second.get();
  if (pixels_ + pixels > kMostOfAll) return nullptr;
  pixels_ += pixels;
  return (others_[{width, height}] = StagePictures::in_size(own_, width, height)).get();
}

namespace {

/// A picture as it is turned, with nothing moved.
class TurnedPixels {
 public:
  TurnedPixels(const Image& image, const Turn& turn)
      : width(turn.transposed ? image.height : image.width),
        height(turn.transposed ? image.width : image.height) {
    const auto at = [&](std::int64_t x, std::int64_t y) {
      if (turn.flipped) y = height - 1 - y;
      if (turn.transposed) std::swap(x, y);
      if (turn.flipped_first) y = image.height - 1 - y;
      return 3 * (y * image.width + x);
    };
    first_ = image.pixels.data() + at(0, 0);
    right_ = at(1, 0) - at(0, 0);
    down_ = at(0, 1) - at(0, 0);
  }
  const float* pixel(std::int64_t x, std::int64_t y) const {
    return first_ + x * right_ + y * down_;
  }

  std::uint32_t width, height;

 private:
  const float* first_;
  std::ptrdiff_t right_, down_;
};

/// Which of `in` pixels of a row one of `of` pixels has: those at centres, or at corners.
std::vector<std::uint32_t> repeated(std::uint32_t of, std::uint32_t in, bool centers) {
  std::vector<std::uint32_t> kept(of);
  // The first of those that were made of one.
  const std::uint64_t up = of < in ? of - 1 : 0;
  for (std::uint32_t i = 0; i < of; ++i)
    kept[i] =
        centers
            ? static_cast<std::uint32_t>((2 * std::uint64_t{i} + 1) * in / (2 * std::uint64_t{of}))
            : std::min(in - 1, static_cast<std::uint32_t>((std::uint64_t{i} * in + up) / of));
  return kept;
}

/// The share of an outline's pixels that are on their sides of it: all where a program has drawn
/// them, few where a screen has scaled them.
double on_their_sides(const Outline& outline, const TurnedPixels& picture, bool jpeg,
                      std::int64_t left, std::int64_t top, const std::array<float, 3>& background) {
  const float same = jpeg ? kSameInJpeg : kSameColor;
  std::size_t right = 0, all = 0;
  const auto count = [&](const auto& pixels, bool is_background) {
    for (const auto& [x, y] : pixels) {
      const std::int64_t u = left + x, v = top + y;
      if (u < 0 || v < 0 || u >= picture.width || v >= picture.height) continue;
      const float* p = picture.pixel(u, v);
      float most = 0;
      for (std::size_t c = 0; c < 3; ++c) most = std::max(most, std::fabs(p[c] - background[c]));
      ++all;
      right += (most < same) == is_background;
    }
  };
  count(outline.inside, false);
  count(outline.outside, true);
  return all < kLeastOutline ? 0 : static_cast<double>(right) / static_cast<double>(all);
}

/// Pixels that repeat those of a smaller picture: where nothing changes, nothing tells, nor do
/// those that a picture which is hardly larger has once.
bool are_repeated(const TurnedPixels& image, const std::vector<std::uint32_t>& columns,
                  const std::vector<std::uint32_t>& rows) {
  const double most = 3.0 * image.width * image.height;
  std::size_t other = 0, all = 0;
  for (std::uint32_t y = 1; y < image.height; ++y) {
    for (std::uint32_t x = 1; x < image.width; ++x) {
      if (columns[x] == x && rows[y] == y) continue;
      const float *here = image.pixel(x, y), *before = image.pixel(x - 1, y),
                  *above = image.pixel(x, y - 1), *again = image.pixel(columns[x], rows[y]);
      for (std::size_t c = 0; c < 3; ++c) {
        if (std::fabs(here[c] - before[c]) <= kSameColor &&
            std::fabs(here[c] - above[c]) <= kSameColor)
          continue;
        ++all;
        other += !(std::fabs(here[c] - again[c]) < kSameColor);
      }
    }
    if (static_cast<double>(other) > (1 - kRepeated) * most) return false;
  }
  return all >= kLeastOutline &&
         static_cast<double>(all - other) >= kRepeated * static_cast<double>(all);
}

/// A picture whose pixels were repeated until it had another size, as before; none where they were
/// not.
std::optional<Image> unrepeated(const TurnedPixels& image, std::uint32_t width,
                                std::uint32_t height) {
  for (const bool centers : {true, false}) {
    const std::vector<std::uint32_t> columns = repeated(width, image.width, centers),
                                     rows = repeated(height, image.height, centers);
    const auto again = [&](std::uint32_t size, const std::vector<std::uint32_t>& kept) {
      std::vector<std::uint32_t> twice =
          repeated(size, static_cast<std::uint32_t>(kept.size()), centers);
      for (std::uint32_t& i : twice) i = kept[i];
      return twice;
    };
    if (!are_repeated(image, again(image.width, columns), again(image.height, rows))) continue;
    Image out(width, height);
    for (std::uint32_t y = 0; y < height; ++y)
      for (std::uint32_t x = 0; x < width; ++x)
        std::copy_n(image.pixel(columns[x], rows[y]), 3, out.row(y) + std::size_t{3} * x);
    return out;
  }
  return std::nullopt;
}

}  // namespace

std::vector<Fitted> drawn_as_whole(const Image& submitted, bool jpeg, const SizedPictures& sizes) {
  std::vector<Fitted> all;
  std::optional<bool> unpainted;
  const auto is_unpainted = [&] {
    if (!unpainted) {
      Image painted = submitted;
      unpainted = fill_unpainted(painted, jpeg);
    }
    return *unpainted;
  };
  const auto add_unrepeated = [&](const Turn& turn, const TurnedPixels& turned) {
    const auto [own_width, own_height] = sizes.own_size();
    const double across = static_cast<double>(turned.width) / own_width,
                 down = static_cast<double>(turned.height) / own_height;
    if (jpeg || across <= 1 || down <= 1 || std::fabs(across / down - 1) > 0.02 || is_unpainted())
      return;
    const std::optional<Image> out = unrepeated(turned, own_width, own_height);
    if (!out) return;
    all.push_back(fitted_at({{}, {}, 1}, *out, false, own_width, own_height));
    all.back().sure = true;
    Alignment& alignment = all.back().alignment;
    alignment.transposed = turn.transposed;
    alignment.flipped = turn.flipped != turn.flipped_first;
    alignment.scaled = true;
    alignment.across = across;
    alignment.down = down;
  };
  for (const Turn& turn : kTurns) {
    const TurnedPixels turned(submitted, turn);
    const std::uint32_t width = turned.width, height = turned.height;
    add_unrepeated(turn, turned);
    const bool own = std::pair(width, height) == sizes.own_size();
    const bool as_it_is = own && !turn.flipped_first && !turn.transposed && !turn.flipped;
    // What moves the outline by a pixel at most is found out later.
    double share =
        on_their_sides(sizes.outline(width, height), turned, jpeg, 0, 0, sizes.background());
    const bool sure = share >= (jpeg ? kSureOfJpeg : kSure);
    for (const Mistake moved : {Mistake::pixel_center, Mistake::shifted, Mistake::y_down})
      if (share < (jpeg ? kOfJpeg : kOfAll) && !own)
        share = std::max(share, on_their_sides(sizes.outline(width, height, moved), turned, jpeg, 0,
                                               0, sizes.background()));
    if (!as_it_is && share < (jpeg ? kOfJpeg : kOfAll)) continue;
    const StagePictures* pictures = sizes.of(width, height);
    if (pictures == nullptr) continue;
    all.push_back(fitted_at({turn, {}, 1}, submitted, false, width, height));
    all.back().sure = sure;
    if (!own) all.back().pictures = pictures;
  }
  return all;
}

namespace {

/// Widths that a picture may have been drawn in which was found about so wide: people like round
/// ones.
std::vector<std::uint32_t> likely_widths(double width) {
  std::vector<std::uint32_t> widths;
  const auto add = [&](double w) {
    const auto whole = static_cast<std::uint32_t>(std::lround(w));
    if (std::find(widths.begin(), widths.end(), whole) == widths.end()) widths.push_back(whole);
  };
  for (const double round : {50.0, 32.0})
    if (const double w = std::round(width / round) * round; std::fabs(w - width) < 0.012 * width)
      add(w);
  for (const int more : {0, 1, -1}) add(std::round(width) + more);
  return widths;
}

}  // namespace

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
    std::pair<std::uint32_t, std::uint32_t> found;
    const TurnedPixels turned(submitted, one.turn);
    for (const std::uint32_t w : may_be ? likely_widths(width) : std::vector<std::uint32_t>()) {
      const auto h = static_cast<std::uint32_t>(
          std::lround(static_cast<double>(w) * one.image.height / one.image.width));
      // A whole one is as large as it is.
      if (!one.alignment.cut && (w != turned.width || h != turned.height)) continue;
      if (std::pair(w, h) == sizes.own_size()) continue;
      const Outline outline = sizes.outline(w, h);
      // The middle tells best where it lies.
      const auto left = std::lround(at.left + (width - w) / 2),
                 top = std::lround(at.top + (height - h) / 2);
      const int reach = one.alignment.cut ? 3 : 0;
      for (int y = -reach; y <= reach && most < kSure; ++y)
        for (int x = -reach; x <= reach && most < kSure; ++x) {
          const double share =
              on_their_sides(outline, turned, jpeg, left + x, top + y, sizes.background());
          if (share <= most) continue;
          most = share;
          found = {w, h};
          best = {one.turn,
                  {static_cast<double>(left + x), static_cast<double>(top + y), 1, 1},
                  one.likeness};
        }
    }
    if (const StagePictures* pictures = sizes.of(found.first, found.second); pictures != nullptr) {
      all.push_back(fitted_at(best, submitted, false, found.first, found.second));
      all.back().pictures = pictures;
    }
    all.push_back(std::move(one));
  }
  const auto is_sure = [&](const Fitted& one) {
    if (!one.exact) return false;
    return on_their_sides(sizes.outline(one.image.width, one.image.height), {one.image, {}}, jpeg,
                          0, 0, sizes.background()) >= (jpeg ? kSureOfJpeg : kSure);
  };
  if (std::any_of(all.begin(), all.end(), is_sure))
    std::erase_if(all, [](const Fitted& one) { return !one.exact; });
  fitted = std::move(all);
}

}  // namespace zraka
