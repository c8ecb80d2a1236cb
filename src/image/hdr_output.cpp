// SPDX-License-Identifier: Apache-2.0
// Radiance's pictures: three bytes and an exponent that they share (Ward, "Real pixels", Graphics
// Gems II, 1991), with runs of equal bytes where lines have the length for it.
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

#include "image/writers.hpp"

namespace zraka {
namespace {

using Rgbe = std::array<unsigned char, 4>;

/// Rounded to the nearest; what is no light is black, and what is brighter than can be stored is as
/// bright as can be.
Rgbe rgbe_of(const float* color) {
  constexpr float kLargest = 0x1.FEp+126f;  // 255·2^119
  float v[3];
  for (int c = 0; c < 3; ++c) v[c] = color[c] > 0 ? std::min(color[c], kLargest) : 0.0f;
  const float most = std::max({v[0], v[1], v[2]});
  if (most < 0x1p-127f) return {};
  int exponent = 0;
  std::frexp(most, &exponent);
  if (std::floor(std::ldexp(most, 8 - exponent) + 0.5f) > 255) ++exponent;
  Rgbe stored;
  for (std::size_t c = 0; c < 3; ++c)
    stored[c] = static_cast<unsigned char>(std::floor(std::ldexp(v[c], 8 - exponent) + 0.5f));
  stored[3] = static_cast<unsigned char>(exponent + 128);
  return stored;
}

/// Runs of at least 4 equal bytes, each as 128 and its length and the byte; what lies between them
/// as its length and the bytes.
void put_channel(const std::vector<Rgbe>& line, std::size_t channel,
                 std::vector<unsigned char>& out) {
  constexpr std::size_t kLeastRun = 4, kLongestRun = 127, kMostOthers = 128;
  const auto run_at = [&](std::size_t at) {
    std::size_t end = at + 1;
    while (end < line.size() && end - at < kLongestRun && line[end][channel] == line[at][channel])
      ++end;
    return end - at;
  };
  for (std::size_t at = 0; at < line.size();) {
    const std::size_t run = run_at(at);
    if (run >= kLeastRun) {
      out.push_back(static_cast<unsigned char>(128 + run));
      out.push_back(line[at][channel]);
      at += run;
      continue;
    }
    std::size_t end = at;
    while (end < line.size() && end - at < kMostOthers && run_at(end) < kLeastRun) ++end;
    out.push_back(static_cast<unsigned char>(end - at));
    for (; at < end; ++at) out.push_back(line[at][channel]);
  }
}

}  // namespace

std::string put_hdr(std::FILE* stream, const PictureToWrite& picture, const WriteOptions&) {
  const Image& image = picture.image;
  ByteStream out(stream);
  out.put(fmt::format("#?RADIANCE\nFORMAT=32-bit_rle_rgbe\n\n-Y {} +X {}\n", image.height,
                      image.width));
  const bool runs = image.width >= 8 && image.width < 0x8000;
  std::vector<Rgbe> line(image.width);
  std::vector<unsigned char> bytes;
  for (std::uint32_t y = 0; y < image.height; ++y) {
    for (std::uint32_t x = 0; x < image.width; ++x)
      line[x] = rgbe_of(image.row(y) + std::size_t{3} * x);
    bytes.clear();
    if (runs) {
      bytes = {2, 2, static_cast<unsigned char>(image.width >> 8),
               static_cast<unsigned char>(image.width & 0xFF)};
      for (std::size_t channel = 0; channel < 4; ++channel) put_channel(line, channel, bytes);
    } else {
      for (const Rgbe& pixel : line) bytes.insert(bytes.end(), pixel.begin(), pixel.end());
    }
    if (!out.put(bytes.data(), bytes.size())) break;
  }
  return out.problem();
}

}  // namespace zraka
