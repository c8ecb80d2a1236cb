// SPDX-License-Identifier: Apache-2.0
#include "render/corners.hpp"

#include <algorithm>
#include <utility>
#include <vector>

#include "core/in_parallel.hpp"

namespace zraka {
namespace {

/// Rows of pixels that are made together.
constexpr std::size_t kBand = 64;

/// Corners that the band below writes over before they may have been read: those from row `first`
/// on, to the band's last.
struct Kept {
  std::size_t first;
  std::vector<float> rows;
};

}  // namespace

Image means_of_corners(Image corners, const DoAll& do_all) {
  const std::size_t height = corners.height - 1;
  const std::size_t row = std::size_t{3} * corners.width, row_after = row - 3;
  float* const pixels = corners.pixels.data();

  // A row of pixels begins before its corners do, by as much as all rows above have become shorter.
  // Where that is most of a band, as in a picture of few columns, most would have to be kept: there
  // is one band only.
  const std::size_t shift_in_rows = 3 * height / row + 2;
  const std::size_t band = shift_in_rows < kBand / 2 ? kBand : height;
  const std::size_t bands = (height + band - 1) / band;
  std::vector<Kept> kept;
  for (std::size_t end = band; end < height; end += band) {
    const std::size_t first = end * row_after / row;
    kept.push_back({first, {pixels + first * row, pixels + (end + 1) * row}});
  }

  do_all(bands, [&](std::size_t index) {
    const std::size_t begin = index * band, end = std::min(begin + band, height);
    const auto corner_row = [&](std::size_t y) -> const float* {
      if (index < kept.size() && y >= kept[index].first)
        return kept[index].rows.data() + (y - kept[index].first) * row;
      return pixels + y * row;
    };
    std::vector<float> means(row_after);
    for (std::size_t y = begin; y < end; ++y) {
      const float *above = corner_row(y), *below = corner_row(y + 1);
      for (std::size_t i = 0; i < row_after; ++i)
        means[i] = mean_of_corners(above[i], above[i + 3], below[i], below[i + 3]);
      std::copy(means.begin(), means.end(), pixels + y * row_after);
    }
  });

  corners.width -= 1;
  corners.height -= 1;
  corners.pixels.resize(row_after * height);
  return corners;
}

Image means_of_corners(Image corners) {
  return means_of_corners(std::move(corners), [](std::size_t count, const auto& work) {
    const auto some = [&](std::size_t begin, std::size_t end) {
      for (std::size_t index = begin; index < end; ++index) work(index);
    };
    in_parallel(count, some, 1);
  });
}

}  // namespace zraka
