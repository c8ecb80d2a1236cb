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

/// X(kind): every kind of texture; what it does stands in src/textures/KIND.cpp.
#define ZRAKA_TEXTURES(X) \
  X(checker)              \
  X(stripes)              \
  X(gradient)             \
  X(rings)                \
  X(marble)               \
  X(wood)                 \
  X(noise)                \
  X(image)

namespace zraka {

/// u and v of three corners.
using CornerUvs = std::array<std::array<float, 2>, 3>;

#define ZRAKA_ENUMERATE(kind) kind,
enum class TextureKind : std::uint8_t { ZRAKA_TEXTURES(ZRAKA_ENUMERATE) };
#undef ZRAKA_ENUMERATE

/// Where a texture is looked up: at the point in space, or at the surface's u and v. Of an image in
/// space x and y are taken for u and v, of others over a surface u and v for x and y. Or rolled
/// round the y axis of the texture's space, whatever the shape: u goes once round from 0 at x = 0 to
/// 1, and v is the height y, or, round a sphere, the angle from straight down over half a turn.
enum class TextureMapping : std::uint8_t { solid, uv, cylinder, sphere };
/// What is beyond the end of an image or a gradient: it once more, its edge, or its mirror image.
enum class TextureWrap : std::uint8_t { repeat, clamp, mirror };
/// How an image is looked up: the texel, what lies between the four around, the mean over what a
/// pixel sees, from the image in smaller and smaller sizes; or as Tachyon does, from smaller ones
/// the farther the way from the eye is.
enum class TextureFilter : std::uint8_t { nearest, bilinear, mip, distance };

/// One texture; each kind uses what it needs of it. Colours of one kind take turns from the first
/// on, a checker has the first two.
struct Texture {
  TextureKind kind = TextureKind::checker;
  TextureMapping mapping = TextureMapping::solid;
  /// From the texture's space to that of the shape, or to u and v.
  Transform transform;
  std::vector<Color> colors{{1, 1, 1}, {0, 0, 0}};  ///< of all kinds but image; two or more
  /// Greater than 0: a checker's side, the width of a stripe or a ring, also of marble and wood,
  /// the length of a gradient, the grain of noise.
  double size = 1;
  /// Of any length but 0: across stripes and marble, along a gradient, the axis of rings and wood.
  Vec3 direction{1, 0, 0};
  double turbulence = 0;   ///< how far noise bends marble, wood and rings, in sizes
  int octaves = 4;         ///< of noise and turbulence, 1 or more: each has half the grain before
  std::uint32_t seed = 0;  ///< of noise and turbulence
  /// cylinder, sphere: how often it goes round, from how far on, and the same for v.
  double repeat_u = 1, repeat_v = 1, offset_u = 0, offset_v = 0;
  std::string file;        ///< of an image, as it was written
  /// Linear light; the first row is at v = 1, the left edge at u = 0. None: black.
  std::shared_ptr<const Image> image;
  /// How light became the numbers of an image of 8 or 16 bits; linear for a map of normals.
  Transfer transfer = Transfer::srgb;
  TextureWrap wrap = TextureWrap::repeat;     ///< of images and gradients
  TextureFilter filter = TextureFilter::mip;  ///< of images
  /// filter distance: from where on an image is a single pixel; of cylinder and sphere in units of
  /// a point's distance from the texture's origin. Greater than 0.
  double reach = 20;
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
