// SPDX-License-Identifier: Apache-2.0
// Pictures, over a surface or through space.
#include <algorithm>
#include <cmath>

#include "math/elementary.hpp"
#include "textures/kinds.hpp"

namespace zraka {
namespace {

/// A level of the pyramid, and how it goes on beyond its edges.
struct Sheet {
  const Image& image;
  TextureWrap wrap_u, wrap_v;
};

/// Into 0 to 1.
double folded(double x, TextureWrap wrap) {
  if (wrap == TextureWrap::repeat) return x - std::floor(x);
  if (wrap == TextureWrap::clamp) return std::clamp(x, 0.0, 1.0);
  x -= 2 * std::floor(x / 2);
  return x > 1 ? 2 - x : x;
}

/// A number of a row or column, where it may be one too small or too large.
std::uint32_t neighbor(double i, std::uint32_t count, TextureWrap wrap) {
  if (i < 0) return wrap == TextureWrap::repeat ? count - 1 : 0;
  if (i >= count) return wrap == TextureWrap::repeat ? 0 : count - 1;
  return static_cast<std::uint32_t>(i);
}

/// A colour of which two numbers are computed at a time, which every processor of 64 bits can.
struct Rgb {
  __extension__ typedef double Two __attribute__((vector_size(16)));
  Two rg;
  double b;

  static Rgb at(const float* t) { return {Two{t[0], t[1]}, t[2]}; }
  friend Rgb operator+(const Rgb& x, const Rgb& y) { return {x.rg + y.rg, x.b + y.b}; }
  friend Rgb operator*(const Rgb& x, double s) { return {x.rg * Two{s, s}, x.b * s}; }
  operator V3<double>() const { return {rg[0], rg[1], b}; }
};

V3<double> texel(const Image& image, std::uint32_t column, std::uint32_t row_from_below) {
  const float* t = image.row(image.height - 1 - row_from_below) + std::size_t{3} * column;
  return {t[0], t[1], t[2]};
}

V3<double> nearest(const Sheet& sheet, double u, double v) {
  const Image& image = sheet.image;
  const double x = std::floor(folded(u, sheet.wrap_u) * image.width);
  const double y = std::floor(folded(v, sheet.wrap_v) * image.height);
  return texel(image, std::min(static_cast<std::uint32_t>(x), image.width - 1),
               std::min(static_cast<std::uint32_t>(y), image.height - 1));
}

/// Between the middles of the four texels around, at what is folded of u and v.
Rgb between_four(const Sheet& sheet, double u, double v) {
  const Image& image = sheet.image;
  const double x = u * image.width - 0.5, y = v * image.height - 0.5;
  const double i = std::floor(x), j = std::floor(y), right = x - i, above = y - j;
  const std::uint32_t i0 = neighbor(i, image.width, sheet.wrap_u);
  const std::uint32_t i1 = neighbor(i + 1, image.width, sheet.wrap_u);
  const std::uint32_t j0 = neighbor(j, image.height, sheet.wrap_v);
  const std::uint32_t j1 = neighbor(j + 1, image.height, sheet.wrap_v);
  const float *lower = image.row(image.height - 1 - j0), *upper = image.row(image.height - 1 - j1);
  const std::size_t left_at = std::size_t{3} * i0, right_at = std::size_t{3} * i1;
  const double left = 1 - right;
  const Rgb low = Rgb::at(lower + left_at) * left + Rgb::at(lower + right_at) * right;
  const Rgb high = Rgb::at(upper + left_at) * left + Rgb::at(upper + right_at) * right;
  return low * (1 - above) + high * above;
}

V3<double> bilinear(const Sheet& sheet, double u, double v) {
  return between_four(sheet, folded(u, sheet.wrap_u), folded(v, sheet.wrap_v));
}

/// How wide an ellipse is, in texels, and its longer half axis.
struct Ellipse {
  double wide = 0, narrow = 0;
  double x = 0, y = 0;
};

/// Of two half axes that a map may have turned towards each other: by the eigenvalues and an
/// eigenvector of a matrix of two by two.
Ellipse ellipse(const TexturePlace& at, const Image& image) {
  const double ax = at.axes[0].x * image.width, ay = at.axes[0].y * image.height;
  const double bx = at.axes[1].x * image.width, by = at.axes[1].y * image.height;
  const double xx = ax * ax + bx * bx, yy = ay * ay + by * by, xy = ax * ay + bx * by;
  const double half = (xx - yy) / 2, root = std::sqrt(half * half + xy * xy);
  const double long_axis = std::sqrt((xx + yy) / 2 + root);
  if (!(long_axis > 0)) return {};
  // Of the two ways to write the eigenvector, the one that vanishes for circles alone.
  double x = half >= 0 ? half + root : xy, y = half >= 0 ? xy : root - half;
  if (x == 0 && y == 0) x = 1;
  const double scale = long_axis / std::sqrt(x * x + y * y);
  return {2 * long_axis, 2 * std::fabs(ax * by - ay * bx) / long_axis, x * scale, y * scale};
}

/// The wraps of a texture at a place; a sphere's north pole is next to no south pole.
Sheet sheet_of(const PreparedTexture& t, const TexturePlace& at, std::size_t level) {
  return {t.pyramid->level(level), t.wrap, at.v_ends ? TextureWrap::clamp : t.wrap};
}

/// The mean over what a footprint sees: probes in a row along its longer axis, each as wide as the
/// shorter, from the two levels whose texels are about as large.
V3<double> filtered(const PreparedTexture& t, const TexturePlace& at) {
  constexpr double kMostProbes = 16, kPerLn2 = 1.4426950408889634;
  const Image& image = t.pyramid->level(0);
  const Ellipse seen = ellipse(at, image);
  const double width = std::max({seen.narrow, seen.wide / kMostProbes, 1.0});
  const auto last = static_cast<double>(t.pyramid->levels() - 1);
  const double level = width > 1 ? std::min(elementary::log(width) * kPerLn2, last) : 0;
  const auto fine = static_cast<std::size_t>(level);
  const double coarser = level - std::floor(level);

  const Sheet sheet = sheet_of(t, at, fine),
              coarse = sheet_of(t, at, coarser > 0 ? fine + 1 : fine);
  const double probes = std::clamp(std::ceil(seen.wide / width), 1.0, kMostProbes);
  const double along_u = 2 * seen.x / image.width, along_v = 2 * seen.y / image.height;
  Rgb sum{};
  for (double i = 0.5; i < probes; ++i) {
    const double share = i / probes - 0.5;
    const double u = folded(at.point.x + share * along_u, sheet.wrap_u);
    const double v = folded(at.point.y + share * along_v, sheet.wrap_v);
    Rgb probe = between_four(sheet, u, v);
    if (coarser > 0) probe = probe * (1 - coarser) + between_four(coarse, u, v) * coarser;
    sum = sum + probe;
  }
  return sum * (1 / probes);
}

/// The four texels around a place, from 0 to 1 in both directions, where the first and the last
/// stand at 0 and 1.
void find_four(const ImageLevel& image, std::size_t level, double u, double v,
               ImageTaps::Four& four) {
  const double x = u * (image.columns - 1), y = v * (image.rows - 1);
  const auto i = static_cast<std::ptrdiff_t>(x), j = static_cast<std::ptrdiff_t>(y);
  const std::ptrdiff_t above = 3 * (j * image.width + i);
  const std::ptrdiff_t right = i + 1 < image.width ? 3 : 0;
  const std::ptrdiff_t below = above + (j + 1 < image.height ? 3 * image.width : 0);
  four.level = level;
  four.at[0] = above, four.at[1] = above + right;
  four.at[2] = below, four.at[3] = below + right;
  four.right = x - static_cast<double>(i), four.below = y - static_cast<double>(j);
}

Rgb mixed_of(const ImageLevel& image, const ImageTaps::Four& four) {
  const auto at = [&](int i) { return Rgb::at(image.pixels + four.at[i]); };
  const double left = 1 - four.right;
  const Rgb upper = at(0) * left + at(1) * four.right;
  const Rgb lower = at(2) * left + at(3) * four.right;
  return upper * (1 - four.below) + lower * four.below;
}

TextureValue image_value(const PreparedTexture& t, const TexturePlace& at) {
  if (t.pyramid == nullptr) return {};
  if (t.filter == TextureFilter::nearest)
    return nearest(sheet_of(t, at, 0), at.point.x, at.point.y);
  if (t.filter == TextureFilter::bilinear)
    return bilinear(sheet_of(t, at, 0), at.point.x, at.point.y);
  if (t.filter == TextureFilter::distance) {
    ImageTaps taps;
    find_taps(t, at, taps);
    return value_of_taps(t, taps);
  }
  return filtered(t, at);
}

void prepare_image(const Texture& described, PreparedTexture& texture) {
  const std::shared_ptr<const Image>& image = described.image;
  if (image == nullptr || image->width == 0 || image->height == 0) return;
  texture.pyramid =
      std::make_shared<Pyramid>(texture.filter == TextureFilter::distance
                                    ? Pyramid::of_bytes(image)
                                    : Pyramid(image, texture.filter == TextureFilter::mip));
  texture.finest = {0.5 / image->width, 0.5 / image->height, 1};
  for (std::size_t i = 0; i < texture.pyramid->levels(); ++i) {
    const Image& level = texture.pyramid->level(i);
    texture.levels.push_back({level.pixels.data(), static_cast<std::ptrdiff_t>(level.width),
                              static_cast<std::ptrdiff_t>(level.height),
                              static_cast<double>(level.width),
                              static_cast<double>(level.height)});
  }
}

}  // namespace

/// As Tachyon has it: from the two levels that the way from the eye is between, of the last but one
/// from the last; it begins anew with the first row.
void find_taps(const PreparedTexture& t, const TexturePlace& at, ImageTaps& taps) {
  const double share = std::clamp(at.distance / (t.reach * at.away), 0.0, 1.0);
  const std::size_t levels = t.levels.size();
  const double level = share * (static_cast<double>(levels) - 0.9999);
  const auto fine = static_cast<std::size_t>(level);
  const double u = folded(at.point.x, TextureWrap::repeat);
  const double v = folded(1 - at.point.y, TextureWrap::repeat);
  if (fine + 2 >= levels) {
    taps.coarser = -1;
    return find_four(t.levels.back(), levels - 1, u, v, taps.fine);
  }
  taps.coarser = level - static_cast<double>(fine);
  find_four(t.levels[fine], fine, u, v, taps.fine);
  find_four(t.levels[fine + 1], fine + 1, u, v, taps.coarse);
}

TextureValue value_of_taps(const PreparedTexture& t, const ImageTaps& taps) {
  Rgb value = mixed_of(t.levels[taps.fine.level], taps.fine);
  if (taps.coarser >= 0)
    value = value * (1 - taps.coarser) +
            mixed_of(t.levels[taps.coarse.level], taps.coarse) * taps.coarser;
  return V3<double>(value);
}

const TextureCode texture_kinds::image = {image_value, prepare_image, {"image", "slika"}};

}  // namespace zraka
