// SPDX-License-Identifier: Apache-2.0
// A submission brought into line with the pictures it is compared with, and how near two are.
#pragma once

#include <limits>
#include <memory>
#include <vector>
#include <zraka/school/grade.hpp>

#include "school/grade/registration.hpp"

namespace zraka {

class StagePictures;

/// A rectangle of pixels that can be compared.
struct Region {
  std::uint32_t left = 0, top = 0, right = 0, bottom = 0;  ///< right and bottom are outside
  double pixels() const { return (right - left) * static_cast<double>(bottom - top); }
};

/// The part of a submission that shows the picture, in its pixels: no frame, no clear edges.
struct Shown {
  double left = 0, top = 0, right = std::numeric_limits<double>::infinity(), bottom = right;
  friend bool operator==(const Shown&, const Shown&) = default;
};

/// A submission in the right picture's size.
struct Fitted {
  Image image;
  Region region;  ///< what of it was handed in
  Alignment alignment;
  bool exact = true;      ///< pixel by pixel as it was handed in
  bool sure = false;      ///< so much so that it lies nowhere else
  bool softened = false;  ///< by its scaling, and once more where that was undone
  bool repeated = false;  ///< it was scaled by repeating pixels
  double smallest = 1;    ///< its scale: below 1, details are lost
  double likeness = 0;    ///< of outlines
  Turn turn{};
  GridPlacement placement{};
  Shown shown{};
  std::uint32_t width = 0, height = 0;    ///< as it was handed in, turned
  std::shared_ptr<const Image> source{};  ///< which is that; nullptr: image, exactly
  /// Of the size that it was drawn in; nullptr where that is the scene's own.
  const StagePictures* pictures = nullptr;
};

/// Finds a right picture of width × height in a submission: where it may be, the plainest first.
std::vector<Fitted> fit(const Image& submitted, bool jpeg, const Template& searched,
                        std::uint32_t width, std::uint32_t height);

Image turned_by(const Image& submitted, const Turn& turn);

/// What lies at a position in a submission, whose unpainted lines were filled or not.
Fitted fitted_at(const Position& position, const Image& painted, bool unpainted,
                 std::uint32_t width, std::uint32_t height);
/// An inexact one that lies elsewhere, of which the same is shown.
Fitted placed_at(const Fitted& fitted, const GridPlacement& placement);
/// An exact one that may lie about there by fractions of a pixel.
Fitted between_pixels(const Fitted& fitted);

/// What may have become of a right picture's colours: red and blue exchanged or not, each with
/// every curve. The first is as it was handed in.
std::vector<Alignment> ways_to_align();
Image aligned(const Image& image, const Alignment& way);

/// A picture of a right size in a submission of width × height, as that was scaled.
Image scaled_into(const Image& image, const Fitted& fitted, std::uint32_t width,
                  std::uint32_t height);

/// A picture of a right size as it comes out of the scaling that a submission went through, where
/// that has lost something.
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

/// What an alteration makes of pixels that are right.
struct Closeness {
  unsigned blur = 0;     ///< both pictures are smoothed that often by the mean of 3×3 pixels
  bool reach = false;    ///< values between those of pixels next to it are right
  float tolerance = 0;   ///< and those this far outside
  double share = 0.005;  ///< of the pixels that are farther outside
  double biased = 1;     ///< and of the blocks that are lighter or darker as a whole
  bool grey = false;     ///< blocks may have other colours: JPEGs keep few
};
Closeness closeness_of(const Fitted& fitted, bool jpeg, const Rubric& rubric);

/// Means over 3×3 pixels, `times` one after the other.
Image smoothed(const Image& image, unsigned times);

/// How far a picture is from another one.
struct Rest {
  double share = 0;   ///< pixels that differ by more than what is close
  double energy = 0;  ///< mean of the squares of what is beyond
  double biased = 0;  ///< blocks of 8×8 pixels whose means differ: alterations leave these
  int solid = 0;      ///< blocks of 3×3 pixels that all differ: rounding makes dots and lines
};
/// `picture` has been smoothed.
Rest rest_of(const Image& picture, const Image& other, const Region& region,
             const Closeness& close);

/// Every pixel that is not nearly black in white: silhouettes may have any colour.
Image as_silhouette(const Image& image);
/// Has all that is not nearly black one colour, as silhouettes have?
bool is_flat(const Image& image, const Region& region);

}  // namespace zraka
