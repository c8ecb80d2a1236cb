// SPDX-License-Identifier: Apache-2.0
// Where textures come in: after surfaces, before light. In double, the same for all instruction
// sets: one hit at a time, and solid textures in lanes; scenes without textures do not come here.
#pragma once

#include "engine/engine.hpp"

namespace zraka {

/// Finds out where on their shapes those hits are that need it, gives every hit a row of
/// coefficients of its own, and bends normals. `color_hits` may be none.
template <class R>
void find_coefficients(const FrozenScene<R>& scene, const Level<R>& level, Scratch<R>& scratch,
                       ColorHits<R>* color_hits);

/// Says where light finds the coefficients of the hits whose surfaces are known.
template <class R>
void take_coefficients(const FrozenScene<R>& scene, const Level<R>& level, Scratch<R>& scratch,
                       ColorHits<R>* color_hits = nullptr) {
  const bool textured = scene.textures != nullptr;
  if (textured) find_coefficients(scene, level, scratch, color_hits);
  scratch.coefficients = textured ? scratch.own_rows : scene.materials;
  scratch.row = textured ? scratch.own_row : scratch.material;
}

/// Gives the children of a level's hits their cones.
template <class R>
void spread_cones(const Level<R>& level, const Scratch<R>& scratch, Level<R>& next);

/// Cones of camera rays: as wide as a pixel.
template <class R>
void start_cones(const FrozenCamera<R>& camera, Level<R>& level);

#ifdef ZRAKA_ISA
namespace ZRAKA_ISA {

/// A ColorHits, in engine/texturing.cpp.
template <class L>
void color_hits(const HitsOfMaterial& hits, const Level<typename L::Real>& level,
                Scratch<typename L::Real>& scratch);

}  // namespace ZRAKA_ISA
#endif

}  // namespace zraka
