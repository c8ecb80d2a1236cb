// SPDX-License-Identifier: Apache-2.0
// How far two pictures are apart, and where.
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>
#include <zraka/api.hpp>
#include <zraka/diagnostic.hpp>
#include <zraka/image.hpp>

namespace zraka {

// The measures. They want two pictures of the same size and touch no file.

/// A rectangle of pixels: columns left…right and rows top…bottom, both ends among them.
struct PixelBox {
  std::uint32_t left = 0, top = 0, right = 0, bottom = 0;
  friend bool operator==(const PixelBox&, const PixelBox&) = default;
};

/// Differences channel by channel, in the pictures' own unit. Two values of which one is NaN or
/// infinite differ by 1 unless they are the same.
struct Errors {
  double largest = 0;
  double mean = 0;           ///< of the absolute differences
  double mean_square = 0;    ///< MSE
  std::uint64_t pixels = 0;  ///< in all
  std::uint64_t over = 0;    ///< pixels with a channel that differs by more than the threshold
  PixelBox box;              ///< around those; of no meaning where there are none

  ZRAKA_API double root_mean_square() const;
  /// 10·log10(1/MSE) in dB, for a range of values of 1; infinite where nothing differs.
  ZRAKA_API double peak_signal_to_noise() const;
  /// Share of the pixels that are over the threshold.
  ZRAKA_API double share() const;
};

/// One pass over both, about a millisecond for 400×400 pixels. The sums do not depend on the
/// instruction set.
ZRAKA_API Errors measure_errors(const Image& a, const Image& b, double threshold = 0);

/// A pixel of which both pictures' values are given; x counts from the left, y from the top, from
/// 0.
struct PixelPair {
  std::uint32_t x = 0, y = 0;
  std::array<float, 3> a{}, b{};
  double difference = 0;  ///< of the channel where it is largest
};

/// The first pixels over the threshold, row by row from the top; at most `count`.
ZRAKA_API std::vector<PixelPair> first_pixels(const Image& a, const Image& b, double threshold,
                                              std::size_t count);
/// The pixels over the threshold that differ most, those that differ equally row by row.
ZRAKA_API std::vector<PixelPair> worst_pixels(const Image& a, const Image& b, double threshold,
                                              std::size_t count);

/// Structural similarity (Wang, Bovik, Sheikh, Simoncelli, "Image quality assessment: from error
/// visibility to structural similarity", IEEE Transactions on Image Processing 13(4), 2004): the
/// mean of their equation 13 over all positions where their window of 11×11 pixels, a Gaussian with
/// a standard deviation of 1.5, fits into the picture; K1 = 0.01, K2 = 0.03, a range of 1. It is
/// computed from 0.299 R + 0.587 G + 0.114 B of values as a screen is given them, as the authors'
/// program does. 1 where the pictures are equal; none where one side is shorter than 11 pixels.
ZRAKA_API std::optional<double> structural_similarity(const Image& a, const Image& b);

/// What flip_error() finds.
struct FlipErrors {
  double mean = 0;
  float largest = 0;
  std::vector<float> map;  ///< 0…1 for each pixel, row by row from the top
};

/// Pixels of a degree of the visual field: a screen of 3840 pixels on 0.7 m, seen from 0.7 m, which
/// the FLIP paper takes unless something else is known.
inline constexpr double kFlipPixelsPerDegree = 67.0206;

/// LDR-FLIP (Andersson, Nilsson, Akenine-Möller, Oskarsson, Åström, Fairchild, "FLIP: A Difference
/// Evaluator for Alternating Images", HPG 2020): what somebody sees who switches between the two
/// pictures. Values are taken as a screen is given them, 0…1 by the sRGB curve.
ZRAKA_API FlipErrors flip_error(const Image& a, const Image& b,
                                double pixels_per_degree = kFlipPixelsPerDegree);

// A whole comparison of two pictures that were read.

struct CompareOptions {
  double tolerance = 0;  ///< what a channel may differ by, in steps of 1/255
  double allow = 0;      ///< the share of the pixels, 0…1, that may differ by more
  /// What made integers of the light, where floats are compared with integers.
  Transfer transfer = Transfer::srgb;
  std::size_t places = 5;  ///< how many of the first and of the worst pixels to give
  bool perception = true;  ///< SSIM and FLIP too, which take most of the time
};

struct Comparison {
  /// The pictures as they were read, but for their `image`, which holds what was compared
  /// (docs/compare.md): stored values of 0…1, or linear light where both are floats.
  ReadImage a, b;
  int bits = 8;         ///< of the values that were compared
  bool floats = false;  ///< both pictures hold linear light
  CompareOptions options;
  double threshold = 0;  ///< the tolerance in the unit of the values
  Errors errors;
  bool within = false;  ///< at most the share that is allowed is over the tolerance
  std::vector<PixelPair> first, worst;
  std::optional<double> similarity;  ///< SSIM
  FlipErrors flip;
  /// Floats and integers would agree much better by the other curve; then that one's RMSE.
  std::optional<double> better_by_other_transfer;
};

/// Fails where the sizes differ.
ZRAKA_API Result<Comparison> compare(ReadImage a, ReadImage b, const CompareOptions& options = {});

/// As a screen shows it: linear light through the sRGB curve, stored values as they are; clamped.
ZRAKA_API Image as_shown(const Image& image, bool linear_light);

/// The largest difference of each pixel's channels, row by row from the top.
ZRAKA_API std::vector<float> difference_map(const Image& a, const Image& b);

/// What the brightest colour of a picture of differences should stand for: the largest that occurs,
/// but at least 1/16, so that rounding does not look like a difference.
ZRAKA_API double brightest_difference(const std::vector<float>& map);

/// A map of width × height values in colours: black for 0, white for `brightest` and more.
/// To be stored as it is, with Transfer::linear.
ZRAKA_API Image heat_picture(const std::vector<float>& map, std::uint32_t width,
                             std::uint32_t height, double brightest = 1);

/// The colours of heat pictures, 0…1 for a screen, from the darkest to the brightest. Their
/// lightness grows in equal steps from black to white and their hue goes from violet through red to
/// yellow, in Oklab (Björn Ottosson, "A perceptual color space for image processing", 2020).
ZRAKA_API const std::array<std::array<float, 3>, 256>& heat_colors();

/// A page that shows both pictures under a slider, beside each other, in turns and as heat maps,
/// with the numbers and a loupe; all that it needs is in it.
ZRAKA_API Result<std::string> comparison_page(const Comparison& comparison,
                                              const std::string& a_name, const std::string& b_name);

}  // namespace zraka
