// SPDX-License-Identifier: Apache-2.0
// What a stage of a scene's picture consists of, counted: pixels that changed, rays and what became
// of them, shapes that throw shadows or reflect totally.
#pragma once

#include <array>
#include <functional>
#include <vector>
#include <zraka/compare.hpp>
#include <zraka/explain.hpp>

namespace zraka {

/// Pixels that have to do with a shape.
struct ShapePixels {
  NamedShape shape;
  Material material;
  std::uint64_t pixels = 0;
};

/// The pixels of a picture as a file of 8 bits a channel holds it, against the picture before.
struct Change {
  std::uint64_t pixels = 0;         ///< with a channel that differs
  std::uint64_t brighter = 0;       ///< of these, with a larger sum of their channels
  std::uint64_t darker = 0;         ///< with a smaller sum
  int largest = 0;                  ///< difference of a channel, in steps of 255
  std::uint64_t full = 0;           ///< pixels of the picture with a channel of 255
  std::uint64_t colors = 0;         ///< different ones in the picture of the ambient stage
  std::vector<ShapePixels> on;      ///< changed pixels by the shape that is seen there
  std::uint64_t on_background = 0;  ///< changed pixels that show no shape
};

/// One light at the points that rays from the eye hit.
struct LightFacts {
  std::uint64_t facing = 0;   ///< points on a surface that faces it
  std::uint64_t away = 0;     ///< L·N < 0
  std::uint64_t blocked = 0;  ///< facing, but the shadow ray hits a shape; of a surface, all do
  std::uint64_t dark = 0;     ///< facing, but outside of the spot's cone
  std::uint64_t partly = 0;   ///< some of a surface's shadow rays reach it, some do not
  std::uint64_t dimmed = 0;   ///< reached through transparent bodies
};

/// A shape that shadow rays from points that the eye sees hit first.
struct ShadowFacts {
  ShapePixels by;         ///< pixels with such a shadow ray
  ShapePixels mostly_on;  ///< the shape where most of these pixels have it
};

/// Total internal reflection.
struct TotalFacts {
  std::uint64_t entering = 0, leaving = 0;  ///< how often, from outside and from inside
  std::uint64_t pixels = 0;                 ///< with such a point in their trees
  PixelBox box;                             ///< around these
  std::vector<ShapePixels> on;              ///< the most pixels first
};

struct StageFacts {
  RayCounts rays;
  double build_seconds = 0, render_seconds = 0;
  Change change;                   ///< of the first stage: against nothing, `pixels` is 0
  std::uint64_t points = 0;        ///< that rays from the eye hit
  std::uint64_t later_points = 0;  ///< that reflected and refracted rays hit
  std::vector<LightFacts> lights;  ///< where the stage has diffuse or specular terms
  std::uint64_t unlit = 0;         ///< points that no light reaches, as far as the stage checks it
  std::vector<ShadowFacts> shadows;
  std::uint64_t shadowed = 0;             ///< pixels with a shadow ray that hits a shape
  std::vector<ShapePixels> mirrored;      ///< shapes by the pixels where a reflected ray hits them
  std::vector<ShapePixels> seen_through;  ///< the same for refracted rays; no glass from inside
  std::uint64_t entering = 0, leaving = 0;  ///< refracted rays into shapes and out of them
  TotalFacts total;
  /// Points at the greatest depth whose shares ask for a reflected or refracted ray.
  std::uint64_t ended_reflected = 0, ended_refracted = 0;
  int deepest = 0;  ///< level of rays that occurs
  /// Hits of all rays: after a way through what absorbs; where Fresnel's share moves from
  /// refraction to reflection; where light is split into wavelengths.
  std::uint64_t absorbed = 0, fresnel = 0, split = 0;
};

/// A scene's seven stages.
struct SceneFacts {
  Resolution resolution;
  Profile profile;
  int max_depth = 0;
  int threads = 0;
  Isa isa = Isa::portable;
  std::uint64_t shapes = 0;       ///< in the scene
  std::size_t lights = 0;         ///< in the scene
  bool dark = false;              ///< no ambient light
  bool general = false;           ///< more than the lab's optics
  double min_contribution = 0;    ///< rays of less are not traced
  int wavelengths = 0;            ///< into which light is split
  std::uint64_t covered = 0;      ///< pixels that show a shape, if only in a corner
  std::vector<ShapePixels> seen;  ///< shapes that rays from the eye hit
  std::array<StageFacts, 7> stages;
};

/// A picture of a stage and of what it changed, as files; values as they are stored.
struct StagePictures {
  Image picture, changes;  ///< in 0…1; the changes are empty for the first stage
  double brightest = 0;    ///< difference that is white in the changes
};

/// Renders the stages one after the other, and listens to the renderer's steps. `take` gets each
/// stage's pictures when they are there; what it returns ends all if it is a failure. Fails as
/// render() does; and for Isa::oracle, whose numbers are none of a picture's.
Result<SceneFacts> measure_stages(
    const Scene& scene, RenderOptions options,
    const std::function<Result<void>(Stage, const StagePictures&)>& take);

}  // namespace zraka
