// SPDX-License-Identifier: Apache-2.0
// How particles look: what they become as shapes, and which colours they have.
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <zraka/formats.hpp>

#include "particles/color_map.hpp"
#include "particles/particles.hpp"

namespace zraka {

/// In the order of kParticleLookNames.
enum class ParticleLook : std::uint8_t { van_der_waals, ball_and_stick, sticks, points };
inline constexpr std::string_view kParticleLookNames[] = {"van_der_waals", "ball_and_stick",
                                                          "sticks", "points"};

struct ParticleStyle {
  ParticleLook look = ParticleLook::van_der_waals;
  double scale = 1;                ///< of all radii but `radius`
  std::optional<double> radius{};  ///< points: of all; ball_and_stick and sticks: of bonds
  /// "": the file's own colours, else by element; "element"; else a column, whose numbers are then
  /// in Particles::values.
  std::string color_by{};
  ColorMap color_map = ColorMap::viridis;
  std::optional<std::array<double, 2>> range{};  ///< of the numbers; else from least to most
  bool solid = false;                            ///< bonds are closed, so that cuts have caps there
  bool cell = false;                             ///< whether the edges of the cell are drawn
  bool one_material = false;  ///< whatever the file says: all are of the material given
};

/// What particles have of a material besides their colour where nobody says it.
Material particle_material();

/// Whether a style colours by a column.
inline bool has_column(const ParticleStyle& style) {
  return !style.color_by.empty() && style.color_by != "element";
}

/// What there is to say of particles that have been added.
struct AddedParticles {
  Diagnostics notes;
  std::optional<ColorLegend> legend;  ///< where a column colours them
};

/// Adds the particles to `shapes` of the scene: spheres, cones for bonds, ellipsoids. Of their
/// colours materials are made, like `base` in all else; 10 000 000 colours become at most 65 536,
/// by rounding. Problems and notes are of the file `name`.
Result<AddedParticles> add_particles(Particles&& particles, const ParticleStyle& style,
                                     const Material& base, std::uint32_t base_index,
                                     const std::string& name, Scene& scene, ShapeLists& shapes);

/// sRGB as 0xRRGGBB, in linear light.
Color linear_color(std::uint32_t rgb);

}  // namespace zraka
