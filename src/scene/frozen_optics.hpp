// SPDX-License-Identifier: Apache-2.0
// What the general engine needs of a scene besides what the lab's has: plain numbers in the
// engine's frame.
#pragma once

#include <cstdint>
#include <zraka/lights.hpp>
#include <zraka/optics.hpp>

#include "math/vec.hpp"

namespace zraka {

struct OpticalMaterial {
  V3<double> k1, k2;      ///< shares per channel
  V3<double> absorption;  ///< per unit of the engine's frame
  double ior;
  Dispersion dispersion;
  Highlight highlight;
  Fresnel fresnel;
  int priority;
  /// Textures give these coefficients, for all channels alike.
  bool textured_k1, textured_k2;
  bool has_children;  ///< rays leave its surface: some k1 or k2 is not 0, or a texture's
  bool casts_shadow;
  std::uint32_t cut_group;
  bool absorbs() const { return absorption.x > 0 || absorption.y > 0 || absorption.z > 0; }
  bool is_dispersive() const { return dispersion.kind != Dispersion::Kind::none; }
};

struct OpticalLight {
  LightKind kind;
  V3<double> position;   ///< of a rectangle, its corner
  V3<double> direction;  ///< unit length, of travel: directional and spot
  double constant, linear, quadratic;  ///< attenuation by distance in the engine's frame
  double cos_inner, cos_outer;         ///< spot
  double inner, outer;                 ///< spot: the same in radians, where its edge is linear
  bool linear_edge;
  V3<double> edge_u, edge_v;           ///< rectangle; disc: two radii at right angles
  double radius;                       ///< sphere
  int samples;                         ///< 1 for those that are no surfaces
  bool linear_edge_counts() const { return linear_edge && outer > inner; }
};

struct OpticalSky {
  Sky::Kind kind;
  V3<double> bottom, top;
  V3<double> up;         ///< unit length
  double low, high;      ///< gradient
  V3<double> middle;     ///< image: unit length, horizontal, where its middle is
  V3<double> right;      ///< image: a quarter of the way round to the right of it
  std::uint32_t texture;
};

struct OpticalFog {
  Fog::Kind kind;
  double start, end, density;  ///< by lengths of the engine's frame
  V3<double> color;
  bool planar;
  V3<double> ahead;  ///< planar: unit length, along the view
};

struct OpticalCut {
  V3<double> normal;  ///< unit length; what is more than `distance` along it is taken away
  double distance;
  bool caps, eye_only;
  std::uint32_t group;
};

struct FrozenOptics {
  const OpticalMaterial* materials;
  const OpticalLight* lights;  ///< as many as FrozenScene::lights, which has their colours
  OpticalSky sky;
  OpticalFog fog;
  const OpticalCut* cuts;
  int cut_count;
  bool has_caps;  ///< of some cut
  /// Where cuts have caps, how large bodies can be that are closed by them, and how large each
  /// is that is no sphere, by its id from the first on: the diagonals of their boxes.
  double largest_body;
  const float* body_sizes;
  int occlusion_samples;      ///< 0: none
  double occlusion_distance;  ///< infinite: the whole scene
  V3<double> occlusion_color;
  bool nested;     ///< some material has a priority: bodies know what they stand in
  bool absorbing;  ///< some material absorbs
  bool dispersive;
  bool shadowless;   ///< some material casts no shadow
  bool transparent;  ///< some material has a k2
  /// Textures say of some material what it lets through, or bend its normals: shadow rays have to
  /// ask them, too.
  bool textured_passing;
  bool index_is_ratio;
  /// The most that a surface sends by itself, the sky's most, and the largest sum of the shares of
  /// a hit's children: what bounds any ray's radiance follows from them.
  double most_local, most_sky, most_shares;
};

/// Whether rays know what they are inside of.
inline bool has_media(const FrozenOptics& optics) {
  return optics.nested || optics.absorbing;
}

}  // namespace zraka
