// SPDX-License-Identifier: Apache-2.0
#include "school/generate/letter.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "core/phrase.hpp"
#include "school/generate/distance.hpp"

namespace zraka {
namespace {

constexpr int kGlyphPixels = 300;

/// A place where a sphere may stand, in pixels of the drawn text, y downwards.
struct Spot {
  float x, y;
  float room;                                          ///< largest radius inside the glyph
  float gap = std::numeric_limits<float>::infinity();  ///< to the nearest sphere's surface
};

struct Circle {
  float x, y, radius;
};

/// A text's picture, as pieces that hang together: a letter's body, its caron, a dot.
class Pieces {
 public:
  explicit Pieces(const Coverage& ink) : ink_(ink), distance_(distance_inside(ink)) {}

  /// All places inside each piece, or those in the middle of its strokes only: where the slope of
  /// the distance to the edge is small, for it is 1 anywhere else and 0.7 on the way into a
  /// right-angled corner.
  std::vector<std::vector<Spot>> spots(Packing packing) const;

 private:
  float at(int x, int y) const {
    if (x < 0 || y < 0 || x >= ink_.width || y >= ink_.height) return 0;
    return distance_[index(x, y)];
  }
  std::size_t index(int x, int y) const {
    return static_cast<std::size_t>(y) * static_cast<std::size_t>(ink_.width) +
           static_cast<std::size_t>(x);
  }
  const Coverage& ink_;
  std::vector<float> distance_;
};

std::vector<std::vector<Spot>> Pieces::spots(Packing packing) const {
  std::vector<std::vector<Spot>> pieces;
  std::vector<bool> seen(distance_.size(), false);
  std::vector<std::pair<int, int>> open;
  const auto visit = [&](int x, int y) {
    if (at(x, y) <= 0 || seen[index(x, y)]) return;
    seen[index(x, y)] = true;
    open.push_back({x, y});
  };
  for (int start_y = 0; start_y < ink_.height; ++start_y)
    for (int start_x = 0; start_x < ink_.width; ++start_x) {
      visit(start_x, start_y);
      if (open.empty()) continue;
      std::vector<Spot>& spots = pieces.emplace_back();
      while (!open.empty()) {
        const auto [x, y] = open.back();
        open.pop_back();
        for (const auto& [dx, dy] : {std::pair{1, 0}, {-1, 0}, {0, 1}, {0, -1}})
          visit(x + dx, y + dy);
        const float sx = (at(x + 1, y) - at(x - 1, y)) / 2, sy = (at(x, y + 1) - at(x, y - 1)) / 2;
        if (packing == Packing::strokes && sx * sx + sy * sy > 0.4f) continue;
        spots.push_back({static_cast<float>(x), static_cast<float>(y), at(x, y)});
      }
      if (spots.empty()) pieces.pop_back();
    }
  return pieces;
}

/// Puts circles of at most `largest` one after the other where they touch those already there
/// (strokes), or where the largest one fits (fill), until none of at least `smallest` fits.
std::vector<Circle> pack(std::vector<Spot> spots, Packing packing, float largest, float smallest) {
  const bool chain = packing == Packing::strokes;
  // A chain starts at the spot farthest from the middle: the end of a stroke.
  float middle_x = 0, middle_y = 0;
  for (const Spot& spot : spots) middle_x += spot.x, middle_y += spot.y;
  middle_x /= static_cast<float>(spots.size()), middle_y /= static_cast<float>(spots.size());

  std::vector<Circle> circles;
  for (;;) {
    const Spot* best = nullptr;
    float best_rank = 0, best_radius = 0;
    for (const Spot& spot : spots) {
      // In a chain spheres are as wide as the stroke; in a filled glyph they take what is left.
      const float radius = std::min({spot.room, largest, chain ? spot.room : spot.gap});
      if (radius < smallest || spot.gap < radius) continue;
      float rank = chain ? radius - (spot.gap - radius) : radius * 1000 - spot.gap;
      if (circles.empty()) rank = chain ? std::hypot(spot.x - middle_x, spot.y - middle_y) : radius;
      if (best == nullptr || rank > best_rank) best = &spot, best_rank = rank, best_radius = radius;
    }
    if (best == nullptr) return circles;
    const Circle disc{best->x, best->y, best_radius};
    circles.push_back(disc);
    std::erase_if(spots, [&](Spot& spot) {
      spot.gap = std::min(spot.gap, std::hypot(spot.x - disc.x, spot.y - disc.y) - disc.radius);
      return spot.gap < smallest;
    });
  }
}

/// How much of the strokes' middle is farther than a disc's radius from every disc's edge, 0…1.
float uncovered(const std::vector<Spot>& spots, const std::vector<Circle>& circles) {
  std::size_t bare = 0;
  for (const Spot& spot : spots)
    bare += std::none_of(circles.begin(), circles.end(), [&](const Circle& d) {
      return std::hypot(spot.x - d.x, spot.y - d.y) < 1.1f * d.radius;
    });
  return static_cast<float>(bare) / static_cast<float>(spots.size());
}

/// A chain along the strokes of a piece: of the radii between `low` and `high` parts of the usual
/// room the one whose chain leaves least uncovered.
std::vector<Circle> pack_chain(const std::vector<Spot>& spots, float low, float high) {
  std::vector<float> rooms;
  for (const Spot& spot : spots) rooms.push_back(spot.room);
  const auto middle = rooms.begin() + static_cast<std::ptrdiff_t>(rooms.size() / 2);
  std::nth_element(rooms.begin(), middle, rooms.end());
  constexpr int kTries = 10;
  std::vector<Circle> best;
  float best_bare = 2;
  for (int i = 0; i <= kTries; ++i) {
    const float radius = *middle * (high + (low - high) * static_cast<float>(i) / kTries);
    std::vector<Circle> circles = pack(spots, Packing::strokes, radius, 0.35f * radius);
    const float bare = uncovered(spots, circles);
    if (bare < best_bare) best_bare = bare, best = std::move(circles);
  }
  return best;
}

/// All pieces with circles whose radius is `size` of what is usual: 1 is as wide as the strokes.
std::vector<Circle> pack_all(const std::vector<std::vector<Spot>>& pieces, Packing packing,
                           float size) {
  std::vector<Circle> all;
  for (const std::vector<Spot>& spots : pieces) {
    float widest = 0;
    for (const Spot& spot : spots) widest = std::max(widest, spot.room);
    const std::vector<Circle> circles =
        packing == Packing::strokes
            ? pack_chain(spots, 0.8f * size, 1.1f * size)
            : pack(spots, packing, 0.6f * size * widest, 0.18f * size * widest);
    all.insert(all.end(), circles.begin(), circles.end());
  }
  return all;
}

/// With 0 wanted the usual size; else the size that gives the number nearest to it.
std::vector<Circle> pack_about(const std::vector<std::vector<Spot>>& pieces, Packing packing,
                             std::size_t wanted) {
  std::vector<Circle> best = pack_all(pieces, packing, 1);
  if (wanted == 0) return best;
  const auto off = [&](const std::vector<Circle>& d) {
    return d.size() > wanted ? d.size() - wanted : wanted - d.size();
  };
  // The number falls with the size, but by leaps and not always.
  for (float size = 1.2f; size > 0.04f && off(best) > 0; size *= 0.97f) {
    std::vector<Circle> circles = pack_all(pieces, packing, size);
    if (circles.size() > 2 * wanted + 10) break;
    if (off(circles) < off(best)) best = std::move(circles);
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
  if (ink->width == 0) return failure("", phrase(Word::letter_unseen));

  const auto letters = static_cast<std::size_t>(std::count_if(
      text.begin(), text.end(), [](char c) { return (c & 0xC0) != 0x80 && c != ' '; }));
  const std::vector<Circle> circles =
      pack_about(Pieces(*ink).spots(options.packing), options.packing,
                 static_cast<std::size_t>(std::max(options.spheres, 0)) * letters);
  if (circles.empty()) return failure("", phrase(Word::letter_no_room));

  // From the drawn text to a plane behind the lab's window, where the eye sees it fill nine tenths
  // of it.
  constexpr double kEye = 2, kPlane = -2, kFilled = 0.9;
  Scene scene;
  scene.camera.eye = {0, 0, kEye};
  scene.resolution = {options.resolution, options.resolution};
  scene.defaults.profile = ProfileName::lab;
  scene.lights = {{{-2, 3, 3}, {1, 1, 1}}};
  const double half = kFilled * (kEye - kPlane) / kEye * scene.camera.window_right.x / 2;
  float left = circles[0].x, right = left, top = circles[0].y, bottom = top;
  for (const Circle& disc : circles) {
    left = std::min(left, disc.x - disc.radius), right = std::max(right, disc.x + disc.radius);
    top = std::min(top, disc.y - disc.radius), bottom = std::max(bottom, disc.y + disc.radius);
  }
  const double scale = 2 * half / static_cast<double>(std::max(right - left, bottom - top));
  const float middle_x = (left + right) / 2, middle_y = (top + bottom) / 2;
  for (const Circle& disc : circles) {
    const auto i = scene.spheres.size();
    scene.spheres.push_back({{{rounded(static_cast<double>(disc.x - middle_x) * scale),
                               rounded(static_cast<double>(middle_y - disc.y) * scale), kPlane},
                              rounded(static_cast<double>(disc.radius) * scale * 0.98)},
                             static_cast<std::uint32_t>(i)});
    scene.materials.push_back(material_of(i, options.seed));
  }
  return scene;
}

}  // namespace zraka
