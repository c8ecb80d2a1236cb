// SPDX-License-Identifier: Apache-2.0
// A submission brought into line with the pictures it is compared with.
#pragma once

#include <vector>
#include <zraka/school/grade.hpp>

namespace zraka {

/// A rectangle of pixels that can be compared.
struct Region {
  std::uint32_t left = 0, top = 0, right = 0, bottom = 0;  ///< right and bottom are outside
};

/// A submission in the right picture's size.
struct Fitted {
  Image image;
  Region region;  ///< what of it was handed in
  Alignment alignment;
  std::uint32_t width = 0, height = 0;  ///< as it was handed in
};

/// Scales a picture of the same shape; looks for the right picture's position in one of another
/// shape, which is a window with its frame, or cut off.
Fitted fit(const Image& submitted, const Image& right);

/// What may have become of a right picture: upside down or not, colours swapped or not, each with
/// every curve. The first is as it was handed in.
std::vector<Alignment> ways_to_align();
Image aligned(const Image& image, const Alignment& way);

/// A picture of a right size as it comes out of the scaling that a submission went through.
Image through_scaling(const Image& image, const Fitted& fitted);

/// Pictures that differ by less than this in their mean squares are the same.
inline constexpr double kSame = 1e-9;

/// Mean squared difference of all channels in a region.
double mean_square(const Image& a, const Image& b, const Region& region);

/// Mean squared difference of all channels from their means in a region: what the plain picture
/// that is nearest differs by.
double spread(const Image& image, const Region& region);
/// Is the one picture nearer to the other than a plain one could be?
bool shows(const Image& picture, const Image& other, const Region& region);

/// Every pixel that is not nearly black in white: silhouettes may have any colour.
Image as_silhouette(const Image& image);
/// Has all that is not nearly black one colour, as silhouettes have?
bool is_flat(const Image& image);

}  // namespace zraka
