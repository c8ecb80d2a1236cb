// SPDX-License-Identifier: Apache-2.0
// A whole comparison: common ground for the two pictures, then all measures.
#include <fmt/format.h>

#include <algorithm>
#include <zraka/compare.hpp>

#include "image/alter.hpp"

namespace zraka {
namespace {

/// k/255 as a float is off by rounding; no step of 16 bits is as small as this.
constexpr double kRounding = 1e-6;

/// Integers keep their values, but for the steps that the coarser picture does not have; floats
/// become the integers that a file would hold.
Image on_steps(const ReadImage& read, Transfer transfer, int bits) {
  return as_stored(read.image, read.floats ? transfer : Transfer::linear, bits);
}

Transfer other(Transfer transfer) {
  return transfer == Transfer::srgb ? Transfer::linear : Transfer::srgb;
}

}  // namespace

Image as_shown(const Image& image, bool linear_light) {
  return encoded(image, linear_light ? Transfer::srgb : Transfer::linear);
}

Result<Comparison> compare(ReadImage a, ReadImage b, const CompareOptions& options) {
  if (a.image.width != b.image.width || a.image.height != b.image.height)
    return failure("", fmt::format("the pictures have different sizes: {}×{} and {}×{}",
                                   a.image.width, a.image.height, b.image.width, b.image.height));
  Comparison c;
  c.options = options;
  c.floats = a.floats && b.floats;
  c.threshold = options.tolerance / 255 + (c.floats ? 0 : kRounding);
  if (c.floats) {
    c.bits = std::max(a.bits, b.bits);
  } else {
    c.bits = a.floats ? b.bits : b.floats ? a.bits : std::min(a.bits, b.bits);
    const Image light = a.floats != b.floats ? (a.floats ? a : b).image : Image();
    a.image = on_steps(a, options.transfer, c.bits);
    b.image = on_steps(b, options.transfer, c.bits);
    if (a.floats != b.floats) {
      const double now = measure_errors(a.image, b.image).root_mean_square();
      const double then = measure_errors(as_stored(light, other(options.transfer), c.bits),
                                         (a.floats ? b : a).image)
                              .root_mean_square();
      if (then < now / 2) c.better_by_other_transfer = then;
    }
  }
  c.a = std::move(a);
  c.b = std::move(b);

  c.errors = measure_errors(c.a.image, c.b.image, c.threshold);
  c.within = static_cast<double>(c.errors.over) <=
             options.allow * static_cast<double>(c.errors.pixels) * (1 + 1e-12);
  c.first = first_pixels(c.a.image, c.b.image, c.threshold, options.places);
  c.worst = worst_pixels(c.a.image, c.b.image, c.threshold, options.places);
  const auto see = [&](const Image& shown_a, const Image& shown_b) {
    c.similarity = structural_similarity(shown_a, shown_b);
    c.flip = flip_error(shown_a, shown_b);
  };
  if (!options.perception) return c;
  if (c.floats)
    see(as_shown(c.a.image, true), as_shown(c.b.image, true));
  else
    see(c.a.image, c.b.image);
  return c;
}

}  // namespace zraka
