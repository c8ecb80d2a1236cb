// SPDX-License-Identifier: Apache-2.0
// The general engine's steps that are the same at all hits of a batch, as one instruction set has
// them (engine/hit_lanes.cpp).
#pragma once

#include "engine/engine.hpp"

namespace zraka {

/// What the rays of a batch's hits bring back: the hits' colours, and what media and fog leave of
/// them, a number a hit; nullptr: all.
template <class R>
struct BroughtBack {
  const R *r, *g, *b;
  const R* transmittance[3];
  const R* clear;
  V3<R> fog;
};

/// Light is that of lights with one sample.
template <class R>
struct HitServices {
  /// The origins of the shadow rays of n hits, whose normals no texture bends.
  void (*start_shadow_rays)(std::size_t n, Scratch<R>& scratch);
  /// level.hits.r, g and b: the ambient term, or white for a silhouette.
  void (*start_light)(const FrozenScene<R>& scene, const Terms& terms, Level<R>& level,
                      const Scratch<R>& scratch);
  /// Of what arrives, scratch.strength and scratch.sdistance by hit, 0 where a hit faces away from
  /// it; and highlights of hits that may have some. Whether some are kUnknownHighlight.
  bool (*find_shines)(const Terms& terms, std::size_t n, Scratch<R>& scratch,
                      const ArrivingLight& arriving);
  /// Which hits light adds something to, if it arrives: scratch.lit, and a list of these in
  /// scratch.shadow_ray_hit. Returns how many.
  std::size_t (*list_facing)(const V3<R>& color, const Terms& terms, std::size_t n,
                             Scratch<R>& scratch, const ArrivingLight& arriving);
  /// Adds a light's terms to hits that are lit.
  void (*add_arriving)(const V3<R>& color, const Terms& terms, Level<R>& level,
                       const Scratch<R>& scratch, const ArrivingLight& arriving);
  /// e^x of n numbers, to elementary::exp()'s bits; -1 where that has to be asked for by itself.
  /// Whether it has anywhere.
  bool (*find_exponentials)(std::size_t n, const double* x, double* powers);
  /// The colours of the rays of all hits.
  void (*bring_back)(const BroughtBack<R>& brings, bool clamps, Level<R>& level);
};

#define ZRAKA_HITS(isa, R)                  \
  namespace isa {                           \
  extern const HitServices<R> kHitServices; \
  }
ZRAKA_HITS(isa_avx512, float)
ZRAKA_HITS(isa_avx2, float)
ZRAKA_HITS(isa_portable, float)
ZRAKA_HITS(isa_oracle, double)
#undef ZRAKA_HITS

}  // namespace zraka
