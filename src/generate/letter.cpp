// SPDX-License-Identifier: Apache-2.0
#include "generate/letter.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "generate/distance.hpp"

namespace zraka {
namespace {

constexpr int kGlyphPixels = 300;

/// A place where a sphere may stand, in pixels of the drawn text, y downwards.
struct Spot {
  float x, y;
  float room;                                          ///< largest radius inside the glyph
  float gap = std::numeric_limits<float>::infinity();  ///< to the nearest sphere's surface
};

struct Disc {
  float x, y, radius;
};

/// All places inside the glyphs, or those in the middle of strokes only: where the slope of the
/// distance to the edge is small, for it is 1 anywhere else and 0.7 on the way into a right-angled
/// corner.
std::vector<Spot> find_spots(const Coverage& ink, const std::vector<float>& distance,
                             Packing packing) {
  const auto at = [&](int x, int y) {
    if (x < 0 || y < 0 || x >= ink.width || y >= ink.height) return 0.0f;
    return distance[static_cast<std::size_t>(y) * static_cast<std::size_t>(ink.width) +
                    static_cast<std::size_t>(x)];
  };
  std::vector<Spot> spots;
  for (int y = 0; y < ink.height; ++y)
    for (int x = 0; x < ink.width; ++x) {
      const float room = at(x, y);
      if (room <= 0) continue;
      if (packing == Packing::strokes) {
        const float dx = (at(x + 1, y) - at(x - 1, y)) / 2, dy = (at(x, y + 1) - at(x, y - 1)) / 2;
        if (dx * dx + dy * dy > 0.4f) continue;
      }
      spots.push_back({static_cast<float>(x), static_cast<float>(y), room});
    }
  return spots;
}

/// Puts discs of at most `largest` one after the other where they touch those already there
/// (strokes), or where the largest one fits (fill), until none of at least `smallest` fits.
std::vector<Disc> pack(std::vector<Spot> spots, Packing packing, float largest, float smallest) {
  std::vector<Disc> discs;
  for (;;) {
    const Spot* best = nullptr;
    float best_rank = 0, best_radius = 0;
    for (const Spot& spot : spots) {
      const bool chain = packing == Packing::strokes;
      // In a chain spheres are as wide as the stroke; in a filled glyph they take what is left.
      const float radius = std::min({spot.room, largest, chain ? spot.room : spot.gap});
      if (radius < smallest || spot.gap < radius) continue;
      const float gap = std::isinf(spot.gap) ? 0 : spot.gap - radius;
      const float rank = chain ? radius - gap : radius * 1000 - gap;
      if (best == nullptr || rank > best_rank) best = &spot, best_rank = rank, best_radius = radius;
    }
    if (best == nullptr) return discs;
    const Disc disc{best->x, best->y, best_radius};
    discs.push_back(disc);
    std::erase_if(spots, [&](Spot& spot) {
      spot.gap = std::min(spot.gap, std::hypot(spot.x - disc.x, spot.y - disc.y) - disc.radius);
      return spot.gap < smallest;
    });
  }
}

/// Packs with the largest radius that gives at least `wanted` discs, or the strokes' own for 0.
std::vector<Disc> pack_about(const std::vector<Spot>& spots, Packing packing, std::size_t wanted) {
  float widest = 0;
  for (const Spot& spot : spots) widest = std::max(widest, spot.room);
  const auto with = [&](float largest) {
    return pack(spots, packing, largest,
                packing == Packing::strokes ? 0.6f * largest : 0.3f * largest);
  };
  if (wanted == 0) return with(packing == Packing::strokes ? widest : 0.5f * widest);
  float low = 1.5f, high = widest;
  std::vector<Disc> best = with(high);
  for (int step = 0; step < 12 && best.size() != wanted; ++step) {
    const float middle = (low + high) / 2;
    std::vector<Disc> discs = with(middle);
    const auto off = [&](const std::vector<Disc>& d) {
      return d.size() > wanted ? d.size() - wanted : wanted - d.size();
    };
    (discs.size() > wanted ? low : high) = middle;
    if (off(discs) < off(best)) best = std::move(discs);
  }
  return best;
}

/// Matt, shiny, mirror and glass by turns, with hues that go round.
Material material_of(std::size_t i, std::uint32_t seed) {
  const double turn =
      0.61803398875 * (static_cast<double>(i) + seed);  // golden section: no two alike
  const double hue = 6 * (turn - std::floor(turn));
  const auto channel = [&](double shift) {
    const double h = std::fmod(hue + shift, 6.0);
    return std::round(100 * (0.25 + 0.65 * std::clamp(std::fabs(h - 3) - 1, 0.0, 1.0))) / 100;
  };
  const Color tint{channel(0), channel(4), channel(2)};
  const auto scaled = [](const Color& c, double s) {
    const auto two_digits = [&](double v) { return std::round(v * s * 100) / 100; };
    return Color{two_digits(c.r), two_digits(c.g), two_digits(c.b)};
  };
  const Color grey{1, 1, 1};
  switch ((i + seed) % 4) {
    case 0:  // mirror
      return {scaled(tint, 0.15), scaled(tint, 0.35), scaled(grey, 0.8), 80, 0.6, 0, 1.5};
    case 1:  // plastic
      return {scaled(tint, 0.3), scaled(tint, 0.8), scaled(grey, 0.5), 30, 0.1, 0, 1.5};
    case 2:  // glass: the lab's ni is n1/n2, and air to glass is 1/1.5
      return {scaled(tint, 0.1), scaled(tint, 0.25), scaled(grey, 0.9), 120, 0.15, 0.7, 0.67};
    default:  // matt
      return {scaled(tint, 0.35), scaled(tint, 0.9), scaled(grey, 0.1), 5, 0, 0, 1.5};
  }
}

double rounded(double v) {
  return std::round(v * 10000) / 10000;
}

}  // namespace

Result<Scene> generate_letter(const std::string& text, const LetterOptions& options) {
  const Result<Font> font = Font::open(options.font);
  if (!font) return tl::make_unexpected(font.error());
  const Result<Coverage> ink = font->draw(text, kGlyphPixels);
  if (!ink) return tl::make_unexpected(ink.error());
  if (ink->width == 0) return failure("", "the text has no visible letter");

  const std::vector<float> distance = distance_inside(*ink);
  const auto letters = static_cast<std::size_t>(std::count_if(
      text.begin(), text.end(), [](char c) { return (c & 0xC0) != 0x80 && c != ' '; }));
  const std::vector<Disc> discs =
      pack_about(find_spots(*ink, distance, options.packing), options.packing,
                 static_cast<std::size_t>(std::max(options.spheres, 0)) * letters);
  if (discs.empty()) return failure("", "the text has no room for a sphere");

  // From the drawn text to a plane behind the lab's window, where the eye sees it fill nine tenths
  // of it.
  constexpr double kEye = 2, kPlane = -2, kFilled = 0.9;
  Scene scene;
  scene.camera.eye = {0, 0, kEye};
  scene.resolution = {options.resolution, options.resolution};
  scene.default_profile = ProfileName::lab;
  scene.lights = {{{-2, 3, 3}, {1, 1, 1}}};
  const double half = kFilled * (kEye - kPlane) / kEye * scene.camera.window_right.x / 2;
  const double scale = 2 * half / std::max(ink->width, ink->height);
  for (const Disc& disc : discs) {
    const auto i = scene.spheres.size();
    scene.spheres.push_back({{{rounded((disc.x + 0.5 - ink->width / 2.0) * scale),
                               rounded((ink->height / 2.0 - disc.y - 0.5) * scale), kPlane},
                              rounded(disc.radius * scale * 0.98)},
                             static_cast<std::uint32_t>(i)});
    scene.materials.push_back(material_of(i, options.seed));
  }
  return scene;
}

}  // namespace zraka
