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

/// Light that goes into bodies: n entries, each with a hit and one wavelength or all.
struct Bends {
  const std::int32_t* hit;  ///< kArrayPadding more are read
  const double *n1, *n2;    ///< in front of the surface and behind it
  const double* by;         ///< who says what is reflected: a value of Fresnel
  double* ratio;            ///< n1/n2
  double* quarter_d;        ///< a quarter of Snell's discriminant: below 0, all is reflected
  double* fresnel;          ///< the share that is reflected
};

/// What goes on from hits: reflected where quarter_d is below 0, else bent as Bends says.
struct GoingOn {
  const std::int32_t* hit;  ///< kArrayPadding more are read
  const double *ratio, *quarter_d;
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
  /// How n entries bend.
  void (*find_bends)(std::size_t n, const Scratch<R>& scratch, const Bends& bends);
  /// Rays of n children, the first of them in the place `first`; up to kArrayPadding behind the
  /// last have any values then.
  void (*aim_children)(std::size_t n, const Scratch<R>& scratch, const GoingOn& children,
                       std::size_t first, RayArrays<R>& rays);
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
