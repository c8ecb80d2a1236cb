// SPDX-License-Identifier: Apache-2.0
#include "render/outlines.hpp"

#include <algorithm>
#include <cstdint>

#include "scene/reals.hpp"

namespace zraka {
namespace {

/// The cosine of the angle between normals where an edge begins, and of that between the way to
/// the next pixel's point and the normal where a gap does: 45°.
constexpr float kEdge = 0.70710678f;

/// What the rays through a part's pixels hit.
class FirstHits {
 public:
  FirstHits(const Layers& layers, const TileRect& part, std::uint32_t first_triangle,
            std::uint32_t triangles)
      : part_(part), first_triangle_(first_triangle), triangles_(triangles) {
    for (const Channel& channel : layers.channels) {
      if (const auto* ids = std::get_if<std::vector<std::uint32_t>>(&channel.values))
        object_ = ids->data();
      for (int c = 0; c < 3; ++c) {
        const auto* floats = std::get_if<std::vector<float>>(&channel.values);
        if (floats == nullptr) continue;
        const char axis = static_cast<char>('X' + c);
        if (channel.name == std::string("position.") + axis) position_[c] = floats->data();
        if (channel.name == std::string("normal.") + axis) normal_[c] = floats->data();
      }
    }
  }

  /// Whether a line goes between two pixels of the part.
  bool differ(std::int32_t x, std::int32_t y, std::int32_t next_x, std::int32_t next_y) const {
    const std::size_t a = index(x, y), b = index(next_x, next_y);
    const std::uint32_t one = object(a), other = object(b);
    if (one != other) return true;
    if (one == 0) return false;
    float cosine = 0, way = 0, along_a = 0, along_b = 0;
    for (int c = 0; c < 3; ++c) {
      const float d = position_[c][b] - position_[c][a];
      cosine += normal_[c][a] * normal_[c][b];
      way += d * d;
      along_a += d * normal_[c][a];
      along_b += d * normal_[c][b];
    }
    const float gap = kEdge * kEdge * way;
    return cosine < kEdge || (along_a * along_a > gap && along_b * along_b > gap);
  }

 private:
  std::size_t index(std::int32_t x, std::int32_t y) const {
    return static_cast<std::size_t>(y - part_.y) * static_cast<std::size_t>(part_.width) +
           static_cast<std::size_t>(x - part_.x);
  }
  std::uint32_t object(std::size_t i) const {
    const std::uint32_t id = object_[i];
    return id > first_triangle_ && id - first_triangle_ <= triangles_ ? first_triangle_ + 1 : id;
  }

  TileRect part_;
  std::uint32_t first_triangle_, triangles_;
  const std::uint32_t* object_ = nullptr;
  const float *position_[3] = {}, *normal_[3] = {};
};

/// A rectangle with more on each side, as far as the picture goes.
TileRect widened(const TileRect& part, std::int32_t before, std::int32_t after,
                 const Resolution& picture) {
  const auto side = [&](std::int32_t start, std::int32_t size, std::uint32_t all) {
    const std::int32_t first = std::max(start - before, 0);
    const auto end =
        static_cast<std::int32_t>(std::min<std::int64_t>(std::int64_t{start} + size + after, all));
    return std::pair(first, end - first);
  };
  const auto [x, width] = side(part.x, part.width, picture.width);
  const auto [y, height] = side(part.y, part.height, picture.height);
  return {x, y, width, height};
}

}  // namespace

template <class R>
bool find_outlines(const LayerPass<R>& pass, const TileRect& part, std::vector<bool>& lines) {
  const int width = pass.job.options.outlines;
  const std::int32_t before = (width - 1) / 2, after = width / 2;
  RenderOptions options = pass.job.options;
  options.layers = {};
  for (const Layer layer : {Layer::position, Layer::normal, Layer::object_id})
    options.layers.add(layer);
  // The lines that reach into the part begin so far around it.
  const TileRect around = widened(part, after, before + 1, pass.job.resolution);
  const PictureJob<R> job{pass.job.scene, pass.job.kernel,     pass.job.settings,
                          options,        pass.job.resolution, around,
                          pass.job.tile,  pass.job.threads};
  Layers layers;
  if (!make_layers<R>({pass.scene, pass.prepared, job}, layers)) return false;
  const FrozenScene<R>& scene = pass.job.scene;
  const auto first = static_cast<std::uint32_t>(scene.triangles.first_id);
  const FirstHits hits(layers, around, first,
                       static_cast<std::uint32_t>(scene.triangles.count) +
                           static_cast<std::uint32_t>(scene.smooth_triangles.count));
  lines.assign(area_of(part), false);
  const auto mark = [&](std::int32_t x, std::int32_t y) {
    for (std::int32_t to_y = std::max(y - before, part.y);
         to_y <= std::min(y + after, part.y + part.height - 1); ++to_y)
      for (std::int32_t to_x = std::max(x - before, part.x);
           to_x <= std::min(x + after, part.x + part.width - 1); ++to_x)
        lines[static_cast<std::size_t>(to_y - part.y) * static_cast<std::size_t>(part.width) +
              static_cast<std::size_t>(to_x - part.x)] = true;
  };
  for (std::int32_t y = around.y; y < around.y + around.height; ++y)
    for (std::int32_t x = around.x; x < around.x + around.width; ++x)
      if ((x + 1 < around.x + around.width && hits.differ(x, y, x + 1, y)) ||
          (y + 1 < around.y + around.height && hits.differ(x, y, x, y + 1)))
        mark(x, y);
  return true;
}

#define ZRAKA_FOR(R) \
  template bool find_outlines<R>(const LayerPass<R>&, const TileRect&, std::vector<bool>&);
ZRAKA_FOR_REALS(ZRAKA_FOR)
#undef ZRAKA_FOR

}  // namespace zraka
