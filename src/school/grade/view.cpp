// SPDX-License-Identifier: Apache-2.0
#include "school/grade/view.hpp"

#include <algorithm>
#include <cmath>

namespace zraka {
namespace {

/// Sizes that differ by more are different ones.
constexpr double kOtherSize = 0.03;
/// Axes may be scaled that far apart.
constexpr double kShapesApart = 0.07;
/// Colours that are no farther apart are one.
constexpr float kOneColor = 0.06F;
constexpr float kShaded = 0.15F;  ///< of one surface
/// A pixel inside the edge, in distances of those beside it.
constexpr double kDeep = 6;
constexpr int kLeastPixels = 12;
constexpr double kGoesOn = 0.6;

/// A pixel of a submission, if there is one.
const float* pixel_at(const Image& image, double x, double y) {
  const double u = std::floor(x), v = std::floor(y);
  if (u < 0 || v < 0 || u >= image.width || v >= image.height) return nullptr;
  return image.row(static_cast<std::uint32_t>(v)) + std::size_t{3} * static_cast<std::uint32_t>(u);
}

bool is_one_color(const float* a, const float* b, float far = kOneColor) {
  for (std::size_t c = 0; c < 3; ++c)
    if (std::fabs(a[c] - b[c]) > far) return false;
  return true;
}

/// Shapes that the right picture's edge cuts off go on behind it.
bool goes_on(const Fitted& fitted, const Image& silhouette) {
  const Image& image = *fitted.source;
  const GridPlacement& at = fitted.placement;
  const double w = silhouette.width, h = silhouette.height;
  int all = 0, same = 0;
  // A pixel inside, and one as far outside. What was cut has the frame's colour for both.
  const auto look = [&](double x, double y, double to_x, double to_y) {
    const auto u = static_cast<std::uint32_t>(x), v = static_cast<std::uint32_t>(y);
    if (silhouette.row(v)[std::size_t{3} * u] < 0.5F) return;
    const float *here = pixel_at(image, at.left + at.across * x, at.top + at.down * y),
                *there = pixel_at(image, at.left + at.across * to_x, at.top + at.down * to_y),
                *deep = pixel_at(image, at.left + at.across * (x + kDeep * (x - to_x)),
                                 at.top + at.down * (y + kDeep * (y - to_y)));
    if (here == nullptr || there == nullptr || deep == nullptr) return;
    ++all;
    same += is_one_color(here, there) && is_one_color(here, deep, kShaded);
  };
  constexpr double kInside = 1.5;
  for (double x = 0.5; x < w; ++x) {
    look(x, kInside, x, -kInside);
    look(x, h - kInside, x, h + kInside);
  }
  for (double y = 0.5; y < h; ++y) {
    look(kInside, y, -kInside, y);
    look(w - kInside, y, w + kInside, y);
  }
  return all >= kLeastPixels && same > kGoesOn * all;
}

/// Has all around the right picture the background's colour?
bool lies_in_background(const Fitted& fitted, const float* background) {
  const Image& image = *fitted.source;
  const GridPlacement& at = fitted.placement;
  const double right = at.left + at.across * fitted.image.width,
               bottom = at.top + at.down * fitted.image.height;
  for (std::uint32_t y = 0; y < image.height; ++y)
    for (std::uint32_t x = 0; x < image.width; ++x) {
      const bool inside = x + 1 > at.left && x < right && y + 1 > at.top && y < bottom;
      if (!inside && !is_one_color(image.row(y) + std::size_t{3} * x, background)) return false;
    }
  return true;
}

bool is_of_another_view(const Fitted& fitted, const Image& silhouette, const float* background) {
  if (fitted.source == nullptr) return false;
  const Image& image = *fitted.source;
  const double w = silhouette.width, h = silhouette.height;
  const double across = fitted.placement.across * fitted.image.width / image.width,
               down = fitted.placement.down * fitted.image.height / image.height;
  const auto is_one = [](double scale) { return std::fabs(scale - 1) <= kOtherSize; };
  if (is_one(across) && is_one(down)) return false;
  // A program's own picture in the scene's size.
  if (image.width == silhouette.width && image.height == silhouette.height) return true;
  if (across > 1 && down > 1) return false;
  const bool alike = std::fabs(image.width * h / (image.height * w) - 1) <= kShapesApart;
  return goes_on(fitted, silhouette) || (alike && lies_in_background(fitted, background));
}

}  // namespace

void leave_out_other_views(std::vector<Fitted>& fitted, const Image& silhouette,
                           const std::array<float, 3>& background) {
  const Fitted last = fitted.back();
  std::erase_if(fitted, [&](const Fitted& one) {
    return is_of_another_view(one, silhouette, background.data());
  });
  if (!fitted.empty()) return;
  const Image& image = *last.source;
  fitted = {placed_at(last, {0, 0, static_cast<double>(image.width) / silhouette.width,
                             static_cast<double>(image.height) / silhouette.height})};
}

}  // namespace zraka
