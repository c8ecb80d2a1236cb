// SPDX-License-Identifier: Apache-2.0
#include "textures/pyramid.hpp"

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstdint>
#include <utility>
#include <vector>

#include "core/in_parallel.hpp"

namespace zraka {
namespace {

/// One pixel of a line that is made shorter: the pixels that it covers, of which the first and the
/// last may be parts.
struct Cover {
  std::uint32_t begin, end;
  double first, last;
};

/// Pixel `i` of `to`, where there are `from`: it covers from·i/to to from·(i + 1)/to.
Cover cover(std::uint32_t i, std::uint32_t from, std::uint32_t to) {
  const std::uint64_t begin = std::uint64_t{from} * i, end = begin + from;
  const auto first = static_cast<std::uint32_t>(begin / to);
  const auto last = static_cast<std::uint32_t>((end + to - 1) / to);
  const double size = to;
  return {first, last, 1 - static_cast<double>(begin % to) / size,
          end % to == 0 ? 1 : static_cast<double>(end % to) / size};
}

double weight(const Cover& c, std::uint32_t i) {
  if (i == c.begin) return c.first;
  return i + 1 == c.end ? c.last : 1;
}

void halve_row(const Image& image, std::uint32_t y, Image& half) {
  const Cover rows = cover(y, image.height, half.height);
  const double size = (static_cast<double>(image.width) / half.width) *
                      (static_cast<double>(image.height) / half.height);
  float* out = half.row(y);
  for (std::uint32_t x = 0; x < half.width; ++x, out += 3) {
    const Cover columns = cover(x, image.width, half.width);
    double sum[3] = {};
    for (std::uint32_t j = rows.begin; j < rows.end; ++j)
      for (std::uint32_t i = columns.begin; i < columns.end; ++i)
        for (std::size_t c = 0; c < 3; ++c)
          sum[c] += weight(rows, j) * weight(columns, i) *
                    static_cast<double>(image.row(j)[std::size_t{3} * i + c]);
    for (std::size_t c = 0; c < 3; ++c) out[c] = static_cast<float>(sum[c] / size);
  }
}

}  // namespace

Image halved(const Image& image) {
  Image half(std::max(image.width / 2, 1u), std::max(image.height / 2, 1u));
  const auto rows = [&](std::size_t begin, std::size_t end) {
    for (std::size_t y = begin; y < end; ++y) halve_row(image, static_cast<std::uint32_t>(y), half);
  };
  in_parallel(half.height, rows, 1 + (1 << 16) / half.width);
  return half;
}

namespace {

/// std::lround(), which is a call: of what is no larger, the sum with a half is exact.
long rounded(double x) {
  if (!(x >= 0 && x < 0x1p31)) return std::lround(x);
  return static_cast<long>(x + 0.5);
}

/// Whether the sum of four numbers is small as whole 255ths.
bool is_plain(const std::vector<float>& from) {
  // Without branches, so that the compiler makes lanes of it. As integers, numbers from 0 on are in
  // the same order, and all others are larger.
  std::uint32_t most = 0;
  for (const float value : from) most = std::max(most, std::bit_cast<std::uint32_t>(value));
  return most < std::bit_cast<std::uint32_t>(0x1p20f);
}

/// Numbers as whole 255ths.
void find_bytes(const float* from, std::vector<std::int32_t>& to) {
  for (std::size_t i = 0; i < to.size(); ++i)
    to[i] = static_cast<std::int32_t>(static_cast<double>(from[i]) * 255 + 0.5);
}
void find_bytes(const float* from, std::vector<long>& to) {
  for (std::size_t i = 0; i < to.size(); ++i)
    to[i] = rounded(static_cast<double>(from[i]) * 255);
}

template <class Whole>
Image halved_bytes(const Image& image) {
  Image half(std::max(image.width / 2, 1u), std::max(image.height / 2, 1u));
  const std::uint32_t below = image.height > 1 ? 1 : 0;
  const std::size_t step = image.width > 1 ? 6 : 3, right = step - 3;
  const auto rows = [&](std::size_t begin, std::size_t end) {
    std::vector<Whole> upper(std::size_t{3} * image.width), lower(upper.size());
    for (auto y = static_cast<std::uint32_t>(begin); y < end; ++y) {
      find_bytes(image.row((1 + below) * y), upper);
      find_bytes(image.row((1 + below) * y + below), lower);
      float* out = half.row(y);
      for (std::size_t x = 0; x < half.width; ++x)
        for (std::size_t c = 0; c < 3; ++c) {
          const std::size_t i = step * x + c;
          const Whole sum = upper[i] + upper[i + right] + lower[i] + lower[i + right];
          *out++ = static_cast<float>(sum / 4) / 255.0f;
        }
    }
  };
  in_parallel(half.height, rows, 1 + (1 << 16) / half.width);
  return half;
}

}  // namespace

Pyramid Pyramid::of_bytes(std::shared_ptr<const Image> image) {
  Pyramid pyramid(std::move(image), false);
  for (;;) {
    const Image& last = pyramid.level(pyramid.levels() - 1);
    if (last.width <= 1 && last.height <= 1) return pyramid;
    pyramid.smaller_.push_back(is_plain(last.pixels) ? halved_bytes<std::int32_t>(last)
                                                     : halved_bytes<long>(last));
  }
}

Pyramid::Pyramid(std::shared_ptr<const Image> image, bool smaller) : image_(std::move(image)) {
  while (smaller) {
    const Image& last = level(levels() - 1);
    if (last.width <= 1 && last.height <= 1) return;
    smaller_.push_back(halved(last));
  }
}

}  // namespace zraka
