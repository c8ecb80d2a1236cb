// SPDX-License-Identifier: Apache-2.0
// Listens to the renderer's steps on tile after tile, and counts what becomes of rays.
#pragma once

#include <map>
#include <tuple>
#include <vector>

#include "explain/general_recording.hpp"

namespace zraka {

/// What a pixel can have to do with a shape.
enum class Tie : std::uint8_t {
  seen,          ///< a ray from the eye hits it; noted for silhouettes only
  shadow_by,     ///< a shadow ray from a point that the eye sees hits it first
  shadow_on,     ///< the same, with the shape that the point is on
  mirrored,      ///< a reflected ray hits it
  seen_through,  ///< a refracted ray, or one that comes from it, hits it; not glass from inside
  total          ///< a ray is reflected totally at it
};

/// What the rays of a picture came to. Points are hits of rays from the eye.
struct RayTally {
  struct Light {
    std::uint64_t facing = 0, away = 0, blocked = 0;
    std::uint64_t dark = 0;             ///< facing, but outside of the spot's cone
    std::uint64_t partly = 0;           ///< some, but not all of a surface is seen
    std::uint64_t dimmed = 0;           ///< reached through transparent bodies
  };
  std::uint64_t points = 0, later_points = 0, unlit = 0;
  std::vector<Light> lights;
  std::uint64_t entering = 0, leaving = 0, total_entering = 0, total_leaving = 0;
  std::uint64_t ended_reflected = 0, ended_refracted = 0;
  /// Hits of all rays: that have come through what absorbs, where Fresnel moves light from
  /// refraction to reflection, where light is split into wavelengths.
  std::uint64_t absorbed = 0, fresnel = 0, split = 0;
  std::size_t deepest = 0;
  /// Pixels by what they have to do with a slot, and for shadows the slot that they fall on; with
  /// slot kAnyShape pixels that have it to do with any.
  std::map<std::tuple<Tie, std::int32_t, std::int32_t>, std::uint64_t> pixels;
  /// Columns and rows around the pixels with total reflection: left, top, right, bottom.
  std::int32_t total_box[4] = {INT32_MAX, INT32_MAX, -1, -1};

  void add(const RayTally& more);
};

inline constexpr std::int32_t kAnyShape = -1;
inline constexpr std::int32_t kNothingSeen = -1, kSeveralSeen = -2;

/// One thread's listener.
class StageListener {
 public:
  /// For a picture of `width` pixels; with `corners` a pixel has rays through its four corners.
  StageListener(const FrozenScene<float>& scene, const TraceSettings& settings, bool corners,
                std::int32_t width, std::int32_t height, std::int32_t batch);
  StageListener(const StageListener&) = delete;
  StageListener& operator=(const StageListener&) = delete;

  /// Traces a tile of pixels, and stores by pixel of the picture the slot that the eye sees there:
  /// kNothingSeen, or kSeveralSeen where corners see different ones.
  void read(const TileRect& tile, std::vector<std::int32_t>& seen);

  const RayTally& tally() const { return tally_; }

  void at_hits(const Level<float>& level, const Scratch<float>& s);
  void at_light(std::int32_t light, std::size_t shadow_rays, const Level<float>& level,
                const Scratch<float>& s);
  void at_children(const Level<float>& level, const Level<float>& next);
  void at_fold(const Level<float>&) {}

 private:
  std::size_t depth_of(const Level<float>& level) {
    return static_cast<std::size_t>(&level - recorder_.workspace().levels);
  }
  /// Which ray from the eye the hit comes from.
  std::size_t root(std::size_t depth, const Level<float>& level, std::size_t hit) const;
  void count_light(RayTally::Light& facts, std::size_t h) const;
  float material(const Scratch<float>& s, std::size_t hit, MaterialColumn column) const;
  void note(Tie tie, std::int32_t slot, std::int32_t on, std::size_t root);
  void leave_each_once();

  const FrozenScene<float>& scene_;
  const TraceSettings& settings_;
  std::int32_t more_;  ///< rays of a row, and of a column, that are more than pixels
  std::int32_t width_, height_;
  TileRecorder recorder_;
  TileRect tile_{};
  std::vector<TileRect> places_;  ///< by ray from the eye: its pixels, in the tile
  std::vector<bool> counts_;      ///< by ray from the eye: false if it is another tile's, too
  std::vector<std::int32_t> first_slot_;           ///< by ray from the eye: what it hits
  std::vector<std::vector<std::uint32_t>> roots_;  ///< by level and ray
  std::vector<std::vector<bool>> refracted_;       ///< by level and ray: was it, or its parents?
  std::vector<bool> reached_;                      ///< by point: does a light reach it?
  std::vector<std::tuple<Tie, std::int32_t, std::int32_t, std::uint32_t>> notes_;
  RayTally tally_;
};

}  // namespace zraka
