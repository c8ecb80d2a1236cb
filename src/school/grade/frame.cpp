// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <array>
#include <cmath>

#include "school/grade/comparison.hpp"

namespace zraka {

namespace {

/// What is no farther from a line's middle colour has that one, and what is farther from the right
/// picture's is another one: in a JPEG, clear edges ring. As they are read, they are black.
constexpr float kPlainLine = 0.05F, kOtherLine = 0.06F, kRinging = 0.12F, kClear = 0.06F;

}  // namespace

void trim_frame(Fitted& fitted, const Image& wanted, bool jpeg) {
  Region& r = fitted.region;
  const std::uint32_t most_clear = std::max(3U, wanted.width / 50);
  const auto foreign = [&](std::uint32_t trimmed, std::uint32_t x0, std::uint32_t x1,
                           std::uint32_t y0, std::uint32_t y1) {
    std::array<std::vector<float>, 3> channels;
    for (std::uint32_t y = y0; y < y1; ++y)
      for (std::uint32_t x = x0; x < x1; ++x)
        for (std::size_t c = 0; c < 3; ++c)
          channels[c].push_back(fitted.image.row(y)[std::size_t{3} * x + c]);
    std::array<float, 3> middle{};
    for (std::size_t c = 0; c < 3; ++c) {
      std::vector<float> sorted = channels[c];
      const auto half = sorted.begin() + static_cast<std::ptrdiff_t>(sorted.size() / 2);
      std::nth_element(sorted.begin(), half, sorted.end());
      middle[c] = *half;
    }
    const bool rings = jpeg && std::all_of(middle.begin(), middle.end(),
                                           [](float value) { return value < kClear; });
    const float same_color = rings ? kRinging : kPlainLine,
                other_color = rings ? kRinging : kOtherLine;
    std::size_t count = 0, same = 0, others = 0, i = 0;
    for (std::uint32_t y = y0; y < y1; ++y)
      for (std::uint32_t x = x0; x < x1; ++x, ++i) {
        bool plain = true, other = false;
        for (std::size_t c = 0; c < 3; ++c) {
          plain = plain && std::fabs(channels[c][i] - middle[c]) < same_color;
          other = other ||
                  std::fabs(channels[c][i] - wanted.row(y)[std::size_t{3} * x + c]) > other_color;
        }
        count += plain && other;
        same += plain;
        others += other;
      }
    // A line that is all of one colour may be a part of the background, if there are many.
    return count * 10 > i * 6 || (same * 100 >= 97 * i && others > 0 && trimmed < most_clear);
  };
  // The outermost that are scaled are mixed with what lies outside, and are looked at only.
  const std::uint32_t mixed = fitted.exact ? 0 : 1;
  r.left -= std::min(r.left, mixed);
  r.top -= std::min(r.top, mixed);
  r.right = std::min(r.right + mixed, wanted.width);
  r.bottom = std::min(r.bottom + mixed, wanted.height);
  const Region whole = r;
  // A picture that was handed in as a whole has clear edges at most.
  const auto limit = [&](std::uint32_t size) {
    return fitted.alignment.cut ? size / 7 : std::max(most_clear, size / 40);
  };
  const std::uint32_t across = limit(r.right - r.left), down = limit(r.bottom - r.top);
  // What was cut off may have a window's frame in its place, and a screen behind that.
  if (fitted.alignment.cut) {
    const auto is_frame = [&](std::uint32_t x0, std::uint32_t x1, std::uint32_t y0,
                              std::uint32_t y1) { return foreign(most_clear, x0, x1, y0, y1); };
    for (std::uint32_t i = down; i > 0 && r.top == whole.top; --i)
      if (is_frame(r.left, r.right, r.top + i - 1, r.top + i)) r.top += i;
    for (std::uint32_t i = down; i > 0 && r.bottom == whole.bottom; --i)
      if (is_frame(r.left, r.right, r.bottom - i, r.bottom - i + 1)) r.bottom -= i;
    for (std::uint32_t i = across; i > 0 && r.left == whole.left; --i)
      if (is_frame(r.left + i - 1, r.left + i, r.top, r.bottom)) r.left += i;
    for (std::uint32_t i = across; i > 0 && r.right == whole.right; --i)
      if (is_frame(r.right - i, r.right - i + 1, r.top, r.bottom)) r.right -= i;
  }
  while (r.top < whole.top + down && foreign(r.top - whole.top, r.left, r.right, r.top, r.top + 1))
    ++r.top;
  while (r.bottom > whole.bottom - down &&
         foreign(whole.bottom - r.bottom, r.left, r.right, r.bottom - 1, r.bottom))
    --r.bottom;
  while (r.left < whole.left + across &&
         foreign(r.left - whole.left, r.left, r.left + 1, r.top, r.bottom))
    ++r.left;
  while (r.right > whole.right - across &&
         foreign(whole.right - r.right, r.right - 1, r.right, r.top, r.bottom))
    --r.right;
  if (r.right - r.left < 8 || r.bottom - r.top < 8) return;
  // A frame's colour is in the means of the pixels beside it, too.
  r.left += mixed + (r.left > whole.left);
  r.top += mixed + (r.top > whole.top);
  r.right -= mixed + (r.right < whole.right);
  r.bottom -= mixed + (r.bottom < whole.bottom);
}

}  // namespace zraka
