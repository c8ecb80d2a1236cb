// SPDX-License-Identifier: Apache-2.0
#include "compare/words.hpp"

#include <fmt/format.h>

#include <cmath>

#include "core/text.hpp"

namespace zraka {
namespace {

/// "0.77 %", and never "0 %" or "100 %" for what is not quite that.
std::string percent(double share) {
  const double p = 100 * share;
  if (p > 0 && p < 0.01) return "under 0.01 %";
  if (p < 100 && p > 99.99) return "over 99.99 %";
  return fmt::format("{:.4g} %", p);
}

std::string place_of(const PixelPair& pair, const Comparison& c) {
  return fmt::format("({}, {}): {} against {}", pair.x, pair.y, values_of(pair.a, c.bits, c.floats),
                     values_of(pair.b, c.bits, c.floats));
}

std::string compared_values(const Comparison& c) {
  if (c.floats) return "linear light, as it is stored";
  std::string text = fmt::format("stored values, {} bits", c.bits);
  if (c.a.floats != c.b.floats)
    text += fmt::format("; {}'s light {}", c.a.floats ? "A" : "B",
                        c.options.transfer == Transfer::srgb ? "went through the sRGB curve"
                                                             : "was taken as it is");
  return text;
}

}  // namespace

double steps_of(double difference) {
  const double steps = 255 * difference, whole = std::round(steps);
  return std::fabs(steps - whole) < 1e-4 ? whole : steps;
}

std::string values_of(const std::array<float, 3>& pixel, int bits, bool floats) {
  if (floats) return fmt::format("({:.6g}, {:.6g}, {:.6g})", pixel[0], pixel[1], pixel[2]);
  const auto stored = [&](float v) { return quantize(v, Transfer::linear, bits); };
  return fmt::format("({}, {}, {})", stored(pixel[0]), stored(pixel[1]), stored(pixel[2]));
}

std::string describe(const ReadImage& picture) {
  return fmt::format("{} × {} pixels, {} with {} bits{}{}", picture.image.width,
                     picture.image.height, picture.format, picture.bits,
                     picture.floats ? " of float" : "",
                     picture.alpha ? ", transparent pixels over black" : "");
}

std::string verdict_on(const Comparison& c) {
  const Errors& e = c.errors;
  if (e.largest == 0) return "The pictures are equal.";
  const std::string by = c.options.tolerance > 0
                             ? fmt::format(" by more than {:.6g} of 255", c.options.tolerance)
                             : "";
  if (e.over == 0)
    return fmt::format(
        "The pictures differ by at most {:.4g} of 255, within the tolerance of {:.6g}.",
        steps_of(e.largest), c.options.tolerance);
  const std::string allowed =
      c.options.allow > 0 ? fmt::format("; {} are allowed", percent(c.options.allow)) : "";
  return fmt::format("{} of {} pixels ({}) differ{}{}.", grouped(e.over), grouped(e.pixels),
                     percent(e.share()), by, allowed);
}

Lines measure_lines(const Comparison& c, const std::string& a_name, const std::string& b_name) {
  const Errors& e = c.errors;
  Lines lines = {{"A", fmt::format("{}: {}", a_name, describe(c.a))},
                 {"B", fmt::format("{}: {}", b_name, describe(c.b))},
                 {"compared", compared_values(c)}};
  if (e.largest == 0) return lines;
  if (e.over > 0)
    lines.push_back({"where", fmt::format("columns {} to {}, rows {} to {}", e.box.left,
                                          e.box.right, e.box.top, e.box.bottom)});
  lines.push_back({"largest", fmt::format("{:.4g} of 255", steps_of(e.largest))});
  lines.push_back({"mean", fmt::format("{:.4g} of 255", 255 * e.mean)});
  lines.push_back({"RMSE", fmt::format("{:.4g} of 255", 255 * e.root_mean_square())});
  lines.push_back({"PSNR", fmt::format("{:.2f} dB", e.peak_signal_to_noise())});
  lines.push_back({"SSIM", c.similarity ? fmt::format("{:.6f}", *c.similarity)
                                        : "none: a side has fewer than 11 pixels"});
  lines.push_back(
      {"FLIP", fmt::format("{:.6f} mean, {:.6f} largest", c.flip.mean, c.flip.largest)});
  return lines;
}

Lines pixel_lines(const Comparison& c) {
  Lines lines;
  for (std::size_t i = 0; i < c.first.size(); ++i)
    lines.push_back({i == 0 ? "first" : "", place_of(c.first[i], c)});
  for (std::size_t i = 0; i < c.worst.size(); ++i)
    lines.push_back({i == 0 ? "worst" : "", place_of(c.worst[i], c)});
  return lines;
}

}  // namespace zraka
