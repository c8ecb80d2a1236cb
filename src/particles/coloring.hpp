// SPDX-License-Identifier: Apache-2.0
// Materials for the colours of particles.
#pragma once

#include <functional>

#include "particles/look.hpp"

namespace zraka {

/// The index in Scene::materials of a particle, which still knows its species.
using MaterialOf = std::function<std::uint32_t(std::size_t index, std::uint32_t species)>;

/// Adds what materials are needed to the scene, and says what the colours of a column mean. Fails
/// where colours or numbers are none.
Result<MaterialOf> color_particles(const Particles& particles, const ParticleStyle& style,
                                   const Material& base, std::uint32_t base_index,
                                   const std::string& name, Scene& scene,
                                   std::optional<ColorLegend>& legend);

}  // namespace zraka
