// SPDX-License-Identifier: Apache-2.0
#include "image/alter.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>
#include <vector>

#include "image/quantize.hpp"
#include "image/transfer.hpp"

namespace zraka {
namespace {

/// NaN becomes 0.
float clamped(float v) {
  return v > 0 ? std::min(v, 1.0f) : 0.0f;
}

template <class Curve>
Image mapped(const Image& image, Curve curve) {
  Image out(image.width, image.height);
  for (std::size_t i = 0; i < image.pixels.size(); ++i) out.pixels[i] = curve(image.pixels[i]);
  return out;
}

/// Old pixels that make one new pixel, along one axis: `count` of them from `first` on, whose
/// weights begin at `weights` in a list that all pixels share.
struct Taps {
  std::uint32_t first = 0, count = 0;
  std::size_t weights = 0;
};

struct Axis {
  std::vector<Taps> taps;
  std::vector<float> weights;

  void add(std::uint32_t first, const std::vector<float>& its_weights) {
    taps.push_back({first, static_cast<std::uint32_t>(its_weights.size()), weights.size()});
    weights.insert(weights.end(), its_weights.begin(), its_weights.end());
  }
};

/// New pixel i of n covers old pixels from i·old/n to (i + 1)·old/n; in whole numbers, so that
/// shares are exact.
Axis axis_by_area(std::uint32_t old, std::uint32_t n) {
  Axis axis;
  for (std::uint64_t i = 0; i < n; ++i) {
    const std::uint64_t begin = i * old, end = begin + old;  // in n-ths of an old pixel
    std::vector<float> weights;
    for (std::uint64_t p = begin / n; p * n < end; ++p) {
      const std::uint64_t covered = std::min((p + 1) * n, end) - std::max(p * n, begin);
      weights.push_back(static_cast<float>(static_cast<double>(covered) / old));
    }
    axis.add(static_cast<std::uint32_t>(begin / n), weights);
  }
  return axis;
}

/// The two old pixels whose centres lie around each of the positions (in old pixels, 0 being the
/// first centre), beyond the edges the one that is nearest.
template <class Position>
Axis axis_between(std::uint32_t old, std::uint32_t n, Position position) {
  Axis axis;
  for (std::uint32_t i = 0; i < n; ++i) {
    const double at = std::clamp(position(i), 0.0, old - 1.0);
    const auto first = static_cast<std::uint32_t>(at);
    const double part = at - first;
    if (part == 0)
      axis.add(first, {1.0f});
    else
      axis.add(first, {static_cast<float>(1 - part), static_cast<float>(part)});
  }
  return axis;
}

/// Along rows, then along columns.
Image resampled(const Image& image, const Axis& across, const Axis& down) {
  const auto width = static_cast<std::uint32_t>(across.taps.size());
  Image narrow(width, image.height);
  for (std::uint32_t y = 0; y < image.height; ++y) {
    const float* in = image.row(y);
    float* out = narrow.row(y);
    for (const Taps& taps : across.taps) {
      std::array<float, 3> sum{};
      const float* pixel = in + std::size_t{3} * taps.first;
      for (std::size_t k = 0; k < taps.count; ++k, pixel += 3)
        for (std::size_t c = 0; c < 3; ++c) sum[c] += across.weights[taps.weights + k] * pixel[c];
      out = std::copy(sum.begin(), sum.end(), out);
    }
  }
  Image out(width, static_cast<std::uint32_t>(down.taps.size()));
  for (std::uint32_t y = 0; y < out.height; ++y) {
    const Taps& taps = down.taps[y];
    float* row = out.row(y);
    for (std::uint32_t k = 0; k < taps.count; ++k) {
      const float* in = narrow.row(taps.first + k);
      const float weight = down.weights[taps.weights + k];
      for (std::size_t i = 0; i < std::size_t{3} * width; ++i) row[i] += weight * in[i];
    }
  }
  return out;
}

}  // namespace

Image flipped_vertically(const Image& image) {
  Image out(image.width, image.height);
  for (std::uint32_t y = 0; y < image.height; ++y)
    std::copy_n(image.row(y), std::size_t{3} * image.width, out.row(image.height - 1 - y));
  return out;
}

Image flipped_horizontally(const Image& image) {
  Image out(image.width, image.height);
  for (std::uint32_t y = 0; y < image.height; ++y) {
    const float* in = image.row(y);
    float* end = out.row(y) + std::size_t{3} * image.width;
    for (std::uint32_t x = 0; x < image.width; ++x, in += 3) std::copy_n(in, 3, end -= 3);
  }
  return out;
}

Image with_red_and_blue_swapped(const Image& image) {
  Image out = image;
  for (std::size_t i = 0; i < out.pixels.size(); i += 3)
    std::swap(out.pixels[i], out.pixels[i + 2]);
  return out;
}

Image cropped(const Image& image, std::uint32_t left, std::uint32_t top, std::uint32_t width,
              std::uint32_t height) {
  Image out(width, height);
  for (std::uint32_t y = 0; y < height; ++y)
    std::copy_n(image.row(top + y) + std::size_t{3} * left, std::size_t{3} * width, out.row(y));
  return out;
}

Image shifted(const Image& image, double right, double down) {
  return resampled(
      image, axis_between(image.width, image.width, [&](std::uint32_t x) { return x - right; }),
      axis_between(image.height, image.height, [&](std::uint32_t y) { return y - down; }));
}

Image scaled_by_area(const Image& image, std::uint32_t width, std::uint32_t height) {
  return resampled(image, axis_by_area(image.width, width), axis_by_area(image.height, height));
}

Image reduced(const Image& image, std::uint32_t side) {
  const std::uint32_t longest = std::max(image.width, image.height);
  if (longest <= side) return image;
  const auto less = [&](std::uint32_t n) {
    return std::max(1u, static_cast<std::uint32_t>(std::uint64_t{n} * side / longest));
  };
  return scaled_by_area(image, less(image.width), less(image.height));
}

Image scaled_bilinearly(const Image& image, std::uint32_t width, std::uint32_t height) {
  const auto axis = [](std::uint32_t old, std::uint32_t n) {
    return axis_between(old, n, [&](std::uint32_t i) { return (i + 0.5) * old / n - 0.5; });
  };
  return resampled(image, axis(image.width, width), axis(image.height, height));
}

Image as_stored(const Image& image, Transfer transfer, int bits) {
  const float most = bits == 16 ? 65535.0f : 255.0f;
  Image out(image.width, image.height);
  if (bits == 16)
    return mapped(image,
                  [&](float v) { return static_cast<float>(quantize(v, transfer, 16)) / most; });
  const RowQuantizer quantizer(transfer, bits);
  std::vector<unsigned char> row(std::size_t{3} * image.width);
  for (std::uint32_t y = 0; y < image.height; ++y) {
    quantizer.row(image.row(y), row.size(), row.data());
    std::transform(row.begin(), row.end(), out.row(y),
                   [&](unsigned char v) { return static_cast<float>(v) / most; });
  }
  return out;
}

Image encoded(const Image& image, Transfer transfer) {
  if (transfer == Transfer::linear) return mapped(image, clamped);
  return mapped(image, [](float v) { return static_cast<float>(encode_srgb(clamped(v))); });
}

Image decoded(const Image& image, Transfer transfer) {
  if (transfer == Transfer::linear) return image;
  return mapped(image, [](float v) { return static_cast<float>(decode_srgb(clamped(v))); });
}

Image with_power(const Image& image, double exponent) {
  return mapped(image,
                [&](float v) { return static_cast<float>(plain_power(clamped(v), exponent)); });
}

}  // namespace zraka
