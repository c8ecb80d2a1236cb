// SPDX-License-Identifier: Apache-2.0
// Pictures made of other pictures: turned, cut, resampled, with another curve. What a grader tries
// to bring a picture into line with its own.
#pragma once

#include <cstdint>
#include <zraka/image.hpp>

namespace zraka {

/// Top and bottom are swapped.
Image flipped_vertically(const Image& image);
/// Left and right are swapped.
Image flipped_horizontally(const Image& image);
Image with_red_and_blue_swapped(const Image& image);

/// The part of width × height pixels from column `left` and row `top` on; it has to lie within the
/// picture.
Image cropped(const Image& image, std::uint32_t left, std::uint32_t top, std::uint32_t width,
              std::uint32_t height);

/// What was at (x, y) comes to (x + right, y + down), in pixels, between pixels by bilinear
/// interpolation; what comes in from outside is the nearest pixel of the edge.
Image shifted(const Image& image, double right, double down);

/// Each new pixel is the mean over the area that it covers of the old picture, exact also where the
/// ratio of the sizes is no whole number. To make pictures smaller; for larger ones it repeats
/// pixels. Sizes are at least 1.
Image scaled_by_area(const Image& image, std::uint32_t width, std::uint32_t height);

/// By scaled_by_area() to at most `side` pixels wide and high, if it is not that small already.
Image reduced(const Image& image, std::uint32_t side);

/// Bilinear interpolation between the centres of the old pixels, as screens and most programs
/// enlarge; the edges repeat. Sizes are at least 1.
Image scaled_bilinearly(const Image& image, std::uint32_t width, std::uint32_t height);

/// The values that a file of `bits` (8 or 16) a channel would hold, divided by their maximum:
/// exactly what read_image() gives for what write_png() wrote.
Image as_stored(const Image& image, Transfer transfer, int bits);

/// Linear light clamped to 0…1, through the curve; NaN becomes 0.
Image encoded(const Image& image, Transfer transfer);
/// The linear light of values of 0…1 that went through the curve.
Image decoded(const Image& image, Transfer transfer);
/// Each value of 0…1 to the power `exponent`: 1/2.2 is the gamma of programs that know no curve.
Image with_power(const Image& image, double exponent);

}  // namespace zraka
