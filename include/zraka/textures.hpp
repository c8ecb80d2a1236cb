// SPDX-License-Identifier: Apache-2.0
// Textures: colours, or numbers, that change over a surface or through space.
#pragma once

#include <array>
#include <cstdint>
#include <memory>
#include <string>
#include <vector>
#include <zraka/bodies.hpp>
#include <zraka/image.hpp>
#include <zraka/values.hpp>

namespace zraka {

enum class TextureKind : std::uint8_t {
  checker,
  stripes,
  gradient,
  rings,
  marble,
  wood,
  noise,
  image
};

/// Where a texture is looked up: at the point in space, or at the surface's u and v.
enum class TextureMapping : std::uint8_t { solid, uv };
enum class TextureWrap : std::uint8_t { repeat, clamp, mirror };
enum class TextureFilter : std::uint8_t { nearest, bilinear, mip };

/// One texture; each kind uses what it needs of it.
struct Texture {
  TextureKind kind = TextureKind::checker;
  TextureMapping mapping = TextureMapping::solid;
  /// From the texture's space to that of the shape, or to u and v.
  Transform transform;
  std::vector<Color> colors{{1, 1, 1}, {0, 0, 0}};  ///< two or more; evenly along a gradient
  double size = 1;          ///< a checker's side, a stripe's width, a ring's, a noise's grain
  Vec3 direction{1, 0, 0};  ///< across stripes, along a gradient, a log's axis
  double turbulence = 0;    ///< how much noise bends marble, wood and rings, in sizes
  int octaves = 4;          ///< of noise
  std::uint32_t seed = 0;   ///< of noise
  std::string file;         ///< of an image, as it was written
  std::shared_ptr<const Image> image;  ///< linear
  TextureWrap wrap = TextureWrap::repeat;
  TextureFilter filter = TextureFilter::mip;
};

/// A quantity of a material that a texture may give.
enum class Coefficient : std::uint8_t {
  ambient,
  diffuse,
  specular,
  shininess,
  reflection,
  refraction
};

/// A material's coefficient comes from a texture, as its index in Scene::textures.
struct TextureUse {
  Coefficient coefficient = Coefficient::diffuse;
  std::uint32_t texture = 0;
  friend bool operator==(const TextureUse&, const TextureUse&) = default;
};

/// Normals bent by a texture: by the slope of a height, or to those of a map.
struct NormalUse {
  enum class Kind : std::uint8_t { none, bump, normal_map } kind = Kind::none;
  std::uint32_t texture = 0;
  double height = 0.1;  ///< bump: how high 1 is, in units of the shape's space
  friend bool operator==(const NormalUse&, const NormalUse&) = default;
};

}  // namespace zraka
