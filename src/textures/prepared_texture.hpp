// SPDX-License-Identifier: Apache-2.0
// A texture as its kind's functions look it up: in its own space, with what they made ready.
#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <vector>
#include <zraka/textures.hpp>

#include "textures/pyramid.hpp"
#include "textures/ramp.hpp"
#include "textures/texture_point.hpp"

namespace zraka {

/// A map into a texture's space.
struct IntoTexture {
  V3<double> x{1, 0, 0}, y{0, 1, 0}, z{0, 0, 1};  ///< a matrix, row by row
  V3<double> origin{};                            ///< where the origin goes
  V3<double> direction(const V3<double>& d) const { return {dot(x, d), dot(y, d), dot(z, d)}; }
  V3<double> point(const V3<double>& p) const { return direction(p) + origin; }
};

/// A level of a pyramid as it is looked up.
struct ImageLevel {
  const float* pixels;
  std::ptrdiff_t width, height;
  double columns, rows;  ///< the same
};

/// Coordinates and axes that are as large count as none, or as so large.
inline constexpr double kHugeNumber = 1e30;

struct PreparedTexture {
  TextureKind kind = TextureKind::checker;
  TextureMapping mapping = TextureMapping::solid;
  IntoTexture into;
  double repeat_u = 1, repeat_v = 1, offset_u = 0, offset_v = 0;  ///< cylinder, sphere
  std::vector<V3<double>> colors;  ///< two or more
  double size = 1;
  V3<double> direction{1, 0, 0};  ///< of length 1
  double turbulence = 0;
  int octaves = 1;
  std::uint32_t seed = 0;
  TextureWrap wrap = TextureWrap::repeat;
  TextureFilter filter = TextureFilter::mip;
  double reach = 1;

  V3<double> first_colors[2]{};
  double per_size = 0;  ///< 1/size where that is exact, as it is of powers of two; else 0

  // What a kind's prepare() makes.
  Ramp ramp;
  std::shared_ptr<const Pyramid> pyramid;
  std::vector<ImageLevel> levels;  ///< the pyramid's
  /// How far to either side, along each axis, a slope looks at least; a part of the size.
  V3<double> finest{};

  V3<double> least_step{};  ///< the same along the axes of what the texture lies in
  double error_scale = 0;   ///< how much the map lengthens a point's error
  bool keeps_v = false;     ///< the texture's v is the surface's
  bool sees_footprint = true;

  static constexpr std::uint32_t kNone = 0xffffffff;
  /// The first texture of its set that lies as it does, so that one place serves them all.
  std::uint32_t placed_like = kNone;
  /// And of images that are looked up by distance, the first that takes the same texels; else kNone.
  std::uint32_t sampled_like = kNone;

  /// An image that is looked up in smaller sizes of it.
  bool has_mips() const {
    return kind == TextureKind::image && filter == TextureFilter::mip && pyramid != nullptr;
  }
};

/// A place in a texture's space, and the footprint there.
struct TexturePlace {
  V3<double> point{};
  V3<double> axes[2]{};
  double error = 0;
  double distance = 0;  ///< from the eye, in the scene's unit
  /// Of what is rolled: of the point from the texture's origin, in its unit; else 1.
  double away = 1;
  bool v_ends = false;  ///< v goes from 0 to 1 and no further, for the texture as well
};

/// Between which texels of an image a value lies: four of one level of its pyramid, or of two.
struct ImageTaps {
  struct Four {
    std::size_t level;
    std::ptrdiff_t at[4];  ///< floats from the level's first on: above, then below, from left to right
    double right, below;
  };
  Four fine, coarse;
  double coarser;  ///< the share of the coarse level; below 0 there is none
};

/// What has been found out of a point for a texture, and serves the next ones, too: coefficients of
/// a material often have the same picture, each in its own strength.
struct TextureLookup {
  std::uint32_t texture = PreparedTexture::kNone;  ///< of which `value` is
  std::uint32_t placed = PreparedTexture::kNone, sampled = PreparedTexture::kNone;
  TextureValue value;
  TexturePlace place;
  ImageTaps taps;
  /// Another point, of which nothing is known.
  void start() { texture = placed = PreparedTexture::kNone; }
};

/// Of an image that is looked up by distance.
void find_taps(const PreparedTexture& texture, const TexturePlace& at, ImageTaps& taps);
TextureValue value_of_taps(const PreparedTexture& texture, const ImageTaps& taps);

/// What is rolled round the y axis (TextureMapping): from a place in the texture's space.
void roll(const PreparedTexture& texture, TexturePlace& place);

/// The colour at a place in its space.
TextureValue value_at(const PreparedTexture& texture, const TexturePlace& at);

/// The width of a footprint along a direction of length 1, and where it is widest.
double width_along(const TexturePlace& at, const V3<double>& direction);
double greatest_width(const TexturePlace& at);

/// How far below a border between two cells still counts to the cell above, in cells: what rounding
/// may have done, and a little more, so that a surface in a border has one colour.
inline constexpr double kLeastTolerance = 0x1p-20, kMostTolerance = 0.25;
double tolerance(const PreparedTexture& texture, const TexturePlace& at);

}  // namespace zraka
