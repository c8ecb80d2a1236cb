// SPDX-License-Identifier: Apache-2.0
// Whitted's ray trees of a tile, level by level, over Embree's traversal.
#pragma once

#include <cstdint>
#include <vector>

#include "world.hpp"

namespace zraka::embree {

/// How rays are handed to Embree: sixteen at a time, or one by one.
enum class Mode { packets, single };

struct Counts {
  std::uint64_t camera = 0, shadow = 0, reflected = 0, refracted = 0;
};

/// Rays of one level with what they are worth: a share of a pixel.
class RayList {
 public:
  int size() const { return size_; }
  void clear() { size_ = 0; }
  /// Room for whole packets past the end, too.
  void reserve(int rays) {
    for (auto* column : {&ox, &oy, &oz, &dx, &dy, &dz, &weight})
      column->resize(static_cast<std::size_t>(rays + 2 * kWide));
    pixel.resize(static_cast<std::size_t>(rays + 2 * kWide));
  }
  void add(unsigned lanes, Three<Float16> origin, Three<Float16> direction, Float16 share,
           Int16 of_pixel) {
    pack(origin.x, lanes, &ox[at()]), pack(origin.y, lanes, &oy[at()]);
    pack(origin.z, lanes, &oz[at()]), pack(direction.x, lanes, &dx[at()]);
    pack(direction.y, lanes, &dy[at()]), pack(direction.z, lanes, &dz[at()]);
    pack(share, lanes, &weight[at()]);
    pack(of_pixel, lanes, &pixel[at()]);
    size_ += __builtin_popcount(lanes);
  }

  std::vector<float> ox, oy, oz, dx, dy, dz, weight;
  std::vector<int> pixel;

 private:
  std::size_t at() const { return static_cast<std::size_t>(size_); }
  int size_ = 0;
};

/// One thread's memory and its work.
class Tracer {
 public:
  static constexpr int kTile = 16;

  Tracer(const World& world, Mode mode, int max_depth);

  /// Traces the rays through corners [x, x + kTile) × [y, y + kTile), as far as there are any, and
  /// writes their colours into a picture of corners.
  void trace_tile(std::uint32_t x, std::uint32_t y, float* corners);

  const Counts& counts() const { return counts_; }

 private:
  struct Packet;
  void make_camera_rays(std::uint32_t x, std::uint32_t y);
  void trace_packet(const RayList& rays, int first, int level);
  Going going_of(Three<Float16> directions, unsigned lanes) const;
  void find_nearest(Packet& packet, int level) const;
  Int16 find_lit(const Packet& packet, Int16 wanted, Three<Float16> way, Float16 distance) const;
  void find_surface(Packet& packet) const;
  Three<Float16> light(const Packet& packet);
  void spawn(const Packet& packet, int level);
  void add_to_pixels(Int16 pixel, unsigned lanes, Three<Float16> color);

  const World& world_;
  Mode mode_;
  int max_depth_;
  /// Of each level, reflected and refracted rays apart, for each kind keeps together best.
  std::vector<RayList> reflected_, refracted_;
  float pixels_[3][kTile * kTile];
  Counts counts_;
};

}  // namespace zraka::embree
