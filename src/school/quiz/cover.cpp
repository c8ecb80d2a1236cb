// SPDX-License-Identifier: Apache-2.0
#include "school/quiz/cover.hpp"

#include <algorithm>
#include <array>
#include <cstdlib>

namespace zraka {
namespace {

constexpr std::array<float, 3> kDark = {0.3F, 0.3F, 0.3F}, kLight = {0.45F, 0.45F, 0.45F},
                               kFrame = {1, 1, 1}, kCross = {1, 0.15F, 0.1F};

}  // namespace

Image covered(const Image& stored, std::uint32_t x, std::uint32_t y) {
  Image image = stored;
  const auto side = static_cast<int>(std::max(image.width, image.height));
  const int reach = std::max(4, side / 28), arm = std::max(2, reach / 2), width = side / 800;
  for (int dy = -reach; dy <= reach; ++dy)
    for (int dx = -reach; dx <= reach; ++dx) {
      const std::int64_t px = std::int64_t{x} + dx, py = std::int64_t{y} + dy;
      if (px < 0 || py < 0 || px >= image.width || py >= image.height) continue;
      const bool cross = (std::abs(dx) <= width && std::abs(dy) <= arm) ||
                         (std::abs(dy) <= width && std::abs(dx) <= arm);
      const bool frame = std::max(std::abs(dx), std::abs(dy)) >= reach - width;
      const auto& color = cross ? kCross : frame ? kFrame : ((dx + dy) & 2) != 0 ? kDark : kLight;
      std::copy(color.begin(), color.end(),
                image.row(static_cast<std::uint32_t>(py)) + 3 * static_cast<std::size_t>(px));
    }
  return image;
}

}  // namespace zraka
