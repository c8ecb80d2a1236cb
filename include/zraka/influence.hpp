// SPDX-License-Identifier: Apache-2.0
// Which pixels a shape has a part in, and by which kinds of ways.
#pragma once

#include <cstdint>
#include <string>
#include <vector>
#include <zraka/api.hpp>
#include <zraka/explain.hpp>

namespace zraka {

/// How a shape can reach a pixel; bits of Influence::pixels.
enum InfluenceBit : std::uint8_t {
  kSeen = 1,          ///< a ray from the eye hits it
  kMirrored = 2,      ///< a ray that has been reflected, and not refracted, hits it
  kThroughGlass = 4,  ///< a ray that has been refracted, and not reflected, hits it
  kBothWays = 8,      ///< a ray that has been reflected and refracted hits it
  kShadow = 16        ///< a shadow ray hits it first: it shadows what some ray of the pixel hits
};

/// Rays of one kind of way: those that were reflected and refracted in this order.
struct InfluenceWay {
  std::vector<RayKind> path;  ///< without the ray from the eye; at most kInfluencePath of them
  bool longer = false;        ///< the path stands for all that begin like this and go on
  bool shadow = false;        ///< it is the shape's shadow that is hit
  std::uint64_t pixels = 0;   ///< that are reached this way
};

inline constexpr std::size_t kInfluencePath = 6;

struct Influence {
  std::uint32_t width = 0, height = 0;
  std::vector<std::uint8_t> pixels;  ///< bits of each pixel, row by row from the top
  std::vector<InfluenceWay> ways;    ///< the most pixels first
  /// Number of pixels with any of these bits.
  ZRAKA_API std::uint64_t count(unsigned bits) const;
};

/// A shape of the scene, or one of a group: then in all its instances.
struct ShapeInScene {
  ShapeId id;
  std::int32_t group = -1;  ///< index in Scene::groups; -1: the scene itself

  ShapeInScene() = default;
  ShapeInScene(const ShapeId& shape, std::int32_t of_group = -1) : id(shape), group(of_group) {}
  ShapeInScene(std::int32_t kind, std::uint32_t index) : id{kind, index} {}
  friend bool operator==(const ShapeInScene&, const ShapeInScene&) = default;
};

/// Traces the whole picture. Fails as render() does, and for a shape that the scene does not have.
ZRAKA_API Result<Influence> influence(const Scene& scene, const RenderOptions& options,
                                      const ShapeInScene& shape);

/// The shape that a text names: the name that its file gives it, or "sphere 3" as messages call it
/// (counted from 1, in any case); "chair/leg" or "chair/box 1" is in the group called chair, whose
/// name may be left out where no other shape is called leg. The name of a CSG shape's member is the
/// whole's. Fails with names that it could have been.
ZRAKA_API Result<ShapeInScene> find_shape(const Scene& scene, const std::string& name);

}  // namespace zraka
