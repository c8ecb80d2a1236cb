// SPDX-License-Identifier: Apache-2.0
// What light comes from.
#pragma once

#include <cstdint>
#include <zraka/values.hpp>

namespace zraka {

enum class LightKind : std::uint8_t {
  point,
  directional,  ///< from so far that all its rays are parallel
  spot,         ///< a point that shines into a cone
  rectangle,    ///< these three are surfaces, and throw soft shadows: each sends rays from points of it
  disc,
  sphere
};

/// A light of any kind; what a kind does not name, it does not look at.
struct Light {
  Vec3 position;           ///< of point and spot; a rectangle's corner, a disc's or sphere's centre
  Color color{1, 1, 1};    ///< Ii
  LightKind kind = LightKind::point;
  Vec3 attenuation{1, 0, 0};  ///< c, l, q: 1/(c + l·d + q·d²) at the distance d; not of directional
  Vec3 direction{0, -1, 0};   ///< directional: of travel. spot: from its position to its target
  double inner_deg = 30;      ///< spot: half angle within which it is full
  double outer_deg = 45;      ///< spot: half angle beyond which it is dark; smooth between
  bool linear_edge = false;   ///< spot: falls off in proportion to the angle instead
  Vec3 edge_u{1, 0, 0}, edge_v{0, 0, 1};  ///< rectangle
  Vec3 normal{0, -1, 0};                  ///< disc
  double radius = 1;                      ///< disc, sphere
  int samples = 16;                       ///< rectangle, disc, sphere: shadow rays from each point
  bool is_surface() const { return kind >= LightKind::rectangle; }
  friend bool operator==(const Light&, const Light&) = default;
};

/// How much of the ambient light reaches a point: of so many rays over the hemisphere, by the
/// cosine, the share that meets nothing within the distance.
struct AmbientOcclusion {
  int samples = 0;      ///< 0: all of it does
  double distance = 0;  ///< 0: the whole scene
  Color color{1, 1, 1};
  friend bool operator==(const AmbientOcclusion&, const AmbientOcclusion&) = default;
};

/// What rays see that hit nothing.
struct Sky {
  enum class Kind : std::uint8_t {
    flat,      ///< Scene::background
    gradient,  ///< from `bottom` to `top` by the height of the direction, from `low` to `high`
    image      ///< a panorama (equirectangular), upright along `up`, its middle towards -z
  };
  Kind kind = Kind::flat;
  Color bottom{}, top{};
  Vec3 up{0, 1, 0};
  double low = -1, high = 1;  ///< gradient: sines of heights, -1 straight down and 1 straight up
  std::uint32_t texture = 0;  ///< image: index in Scene::textures
  friend bool operator==(const Sky&, const Sky&) = default;
};

/// What distance puts over the light of a ray: of its colour the share f is left, 1 - f is the
/// fog's; after the length r of the ray, or, for rays from the eye, the depth along the view.
struct Fog {
  enum class Kind : std::uint8_t {
    none,
    linear,      ///< f = (end - r)/(end - start)
    exponential, ///< f = exp(-density·(r - start))
    squared      ///< f = exp(-(density·(r - start))²), 1 before start
  };
  Kind kind = Kind::none;
  double start = 0, end = 1, density = 1;
  Color color{};
  bool planar = false;  ///< by depth from the eye, and not over what is behind everything
  friend bool operator==(const Fog&, const Fog&) = default;
};

}  // namespace zraka
