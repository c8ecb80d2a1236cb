// SPDX-License-Identifier: Apache-2.0
#include "sampling_options.hpp"

#include <algorithm>
#include <array>
#include <charconv>
#include <string_view>
#include <vector>

namespace zraka::app {
namespace {

/// A whole number, and nothing else.
template <class Number>
std::optional<Number> number_in(std::string_view word) {
  Number number{};
  const auto [end, error] = std::from_chars(word.data(), word.data() + word.size(), number);
  if (word.empty() || error != std::errc() || end != word.data() + word.size()) return std::nullopt;
  return number;
}

std::vector<std::string_view> split(std::string_view list) {
  std::vector<std::string_view> words;
  for (std::size_t begin = 0;;) {
    const std::size_t comma = list.find(',', begin);
    words.push_back(list.substr(begin, comma - begin));
    if (comma == std::string_view::npos) return words;
    begin = comma + 1;
  }
}

std::optional<PixelRect> rect_in(const std::string& list) {
  const std::vector<std::string_view> words = split(list);
  if (words.size() != 4) return std::nullopt;
  std::array<std::uint32_t, 4> numbers{};
  for (std::size_t i = 0; i < 4; ++i) {
    const auto number = number_in<std::uint32_t>(words[i]);
    if (!number) return std::nullopt;
    numbers[i] = *number;
  }
  return PixelRect{numbers[0], numbers[1], numbers[2], numbers[3]};
}

std::optional<Sampling> adaptive_in(const std::string& list) {
  const std::vector<std::string_view> words = split(list);
  if (words.size() != 2 && words.size() != 3) return std::nullopt;
  const auto least = number_in<int>(words[0]), most = number_in<int>(words[1]);
  const auto contrast =
      words.size() == 3 ? number_in<double>(words[2]) : std::optional(Sampling().contrast);
  if (!least || !most || !contrast || *least < 1 || *most < *least || *most > kMaxSamples ||
      !(*contrast >= 0 && *contrast <= 1))
    return std::nullopt;
  Sampling sampling;
  sampling.kind = Sampling::Kind::adaptive;
  sampling.count = *least;
  sampling.most = *most;
  sampling.contrast = *contrast;
  return sampling;
}

std::optional<PixelFilter> filter_named(std::string_view name) {
  if (name == "box") return PixelFilter::box;
  if (name == "tent") return PixelFilter::tent;
  if (name == "gauss") return PixelFilter::gauss;
  if (name == "mitchell") return PixelFilter::mitchell;
  return std::nullopt;
}

std::optional<Shadows> shadows_named(std::string_view name) {
  if (name == "opaque") return Shadows::opaque;
  if (name == "transparent") return Shadows::transparent;
  if (name == "off") return Shadows::off;
  return std::nullopt;
}

/// Takes how many and where from one, filter and seed from the other.
Sampling with_places(const Sampling& places, Sampling sampling) {
  sampling.kind = places.kind;
  sampling.count = places.count;
  sampling.most = places.most;
  sampling.contrast = places.contrast;
  return sampling;
}

/// docs/sampling.md has this table.
void apply_quality(const std::string& quality, RenderDefaults& defaults) {
  constexpr int kDraftDepth = 2;
  Sampling& sampling = defaults.sampling;
  if (quality == "draft") {
    sampling = with_places({}, sampling);
    sampling.filter = PixelFilter::box;
    defaults.max_depth = std::min(defaults.max_depth, kDraftDepth);
  } else if (quality == "good") {
    sampling = with_places({.kind = Sampling::Kind::adaptive, .count = 4, .most = 16}, sampling);
  } else if (quality == "final") {
    sampling = with_places({.count = 64}, sampling);
    sampling.filter = PixelFilter::gauss;
  }
}

}  // namespace

void SamplingArguments::add_to(Command& command) {
  command
      .add("--quality", &quality,
           "draft (one ray a pixel, at most 2 levels), good (4 rays a pixel, 16 where they differ) "
           "or final (64, smoothed by a Gaussian); other options say more")
      .one_of({"draft", "good", "final"});
  command.add("--samples", &samples, "rays a pixel, spread evenly; one goes through its middle")
      .range(1, kMaxSamples);
  command.add("--grid", &grid, "N by N rays a pixel, in the middles of equal squares")
      .range(1, kMaxGrid);
  command
      .add(
          "--adaptive", &adaptive,
          "MIN,MAX[,CONTRAST]: so many rays a pixel, and up to MAX where they or neighbours differ "
          "by more than CONTRAST (0.02)")
      .check("MIN,MAX or MIN,MAX,CONTRAST: 1 or more, MIN or more, 0 to 1",
             [](const std::string& list) { return adaptive_in(list).has_value(); });
  command
      .add("--filter", &filter, "how rays become a pixel: box, tent, gauss or mitchell (sharpest)")
      .one_of({"box", "tent", "gauss", "mitchell"});
  command.add("--seed", &seed, "another number draws other random numbers")
      .check("a whole number from 0 to 4294967295",
             [](const std::string& word) { return number_in<std::uint32_t>(word).has_value(); });
  command
      .add("--shadows", &shadows,
           "opaque, transparent (glass lets light through) or off (there are none)")
      .one_of({"opaque", "transparent", "off"});
  command
      .add("--min-contribution", &min_contribution,
           "leave out reflected and refracted rays that can bring a pixel less than this; 0 traces "
           "all")
      .range(0, 1e30);
  command
      .add("--wavelengths", &wavelengths,
           "into how many a ray splits that a dispersive body refracts")
      .range(1, kMaxWavelengths);
  command.check([this] { return problem(); });
}

void SamplingArguments::add_crop_to(Command& command) {
  command
      .add("--crop", &crop,
           "X,Y,WIDTH,HEIGHT: only this part, in pixels from the upper left; its pixels are the "
           "whole picture's")
      .check("X,Y,WIDTH,HEIGHT in whole pixels",
             [](const std::string& list) { return rect_in(list).has_value(); });
}

std::string SamplingArguments::problem() const {
  const int given = (samples > 0) + (grid > 0) + !adaptive.empty();
  return given > 1 ? "--samples, --grid and --adaptive exclude each other: give one of them" : "";
}

void SamplingArguments::apply_to(RenderDefaults& defaults) const {
  apply_quality(quality, defaults);
  Sampling& sampling = defaults.sampling;
  if (samples > 0) sampling = with_places({.count = samples}, sampling);
  if (grid > 0) sampling = with_places({.kind = Sampling::Kind::grid, .count = grid}, sampling);
  if (!adaptive.empty()) sampling = with_places(adaptive_in(adaptive).value(), sampling);
  sampling.filter = filter_named(filter).value_or(sampling.filter);
  sampling.seed = number_in<std::uint32_t>(seed).value_or(sampling.seed);
  defaults.shadows = shadows_named(shadows).value_or(defaults.shadows);
  if (min_contribution >= 0) defaults.min_contribution = min_contribution;
  if (wavelengths > 0) defaults.wavelengths = wavelengths;
}

std::optional<PixelRect> SamplingArguments::crop_rect() const {
  return rect_in(crop);
}

}  // namespace zraka::app
