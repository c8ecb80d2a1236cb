// SPDX-License-Identifier: Apache-2.0
// Where the engine's frame lies in the world: floats go to what the camera sees.
#include "math/frame.hpp"

#include <algorithm>
#include <cmath>
#include <mutex>
#include <optional>
#include <vector>

#include "core/in_parallel.hpp"
#include "scene/freeze.hpp"
#include "scene/view_axes.hpp"
#include "scene/view_cone.hpp"

namespace zraka {
namespace {

/// Nearer and smaller, what is seen has squares of squares that floats cannot hold.
constexpr double kLeastSeen = 0x1p-22;

/// What there is, and what of it the camera sees.
struct Survey {
  Bounds bounds;
  double nearest = Bounds::kInfinity;   ///< distance of the nearest shape seen
  double smallest = Bounds::kInfinity;  ///< least size or, if that is more, distance of a shape seen
};

/// Calls function(box) for some shapes, evenly over all.
template <class Function>
void each_sample(const ShapeLists& shapes, const Whereabouts& where, const Function& function) {
  constexpr std::uint64_t kSamples = 65536;
  const std::uint64_t step = shapes.shape_count() / kSamples + 1;
  std::uint64_t index = 0;  // over all kinds
#define ZRAKA_LOOK(Type, plural)                                     \
  for (; index < shapes.plural.size(); index += step)                \
    if (const Bounds box = where.bounds(shapes.plural[index]); has_bounds<Type>(box)) function(box); \
  index -= shapes.plural.size();
  ZRAKA_SHAPES(ZRAKA_LOOK)
#undef ZRAKA_LOOK
}

/// What `more` makes of all objects, from `none` on; `join` puts two parts' results together.
template <class T, class Shape, class More, class Join>
T reduced(const std::vector<Object<Shape>>& objects, const T& none, const More& more,
          const Join& join) {
  T all = none;
  std::mutex joining;
  in_parallel(
      objects.size(),
      [&](std::size_t begin, std::size_t end) {
        T sum = none;
        for (std::size_t i = begin; i < end; ++i) more(sum, objects[i]);
        const std::lock_guard lock(joining);
        all = join(all, sum);
      },
      65536);
  return all;
}

Survey survey(const Scene& scene, const Whereabouts& where, const ViewCone& view) {
  Survey all;
  const auto join = [](Survey a, const Survey& b) {
    a.bounds.include(b.bounds);
    a.nearest = std::min(a.nearest, b.nearest);
    a.smallest = std::min(a.smallest, b.smallest);
    return a;
  };
  const auto include = [&]<class Shape>(const std::vector<Object<Shape>>& objects) {
    const auto more = [&](Survey& sum, const Object<Shape>& object) {
      const Bounds box = where.bounds(object);
      if (has_bounds<Shape>(box)) sum.bounds.include(box);
      // Mostly one coordinate is enough to see that it is farther off.
      const double gap =
          std::max({box.lower.x - view.eye.x, view.eye.x - box.upper.x, box.lower.y - view.eye.y,
                    view.eye.y - box.upper.y, box.lower.z - view.eye.z, view.eye.z - box.upper.z});
      if (gap >= std::max(sum.nearest, sum.smallest)) return;
      const double distance = where.distance(object, view.eye);
      const double size = std::max(distance, box.reach());
      if ((distance < sum.nearest || size < sum.smallest) && view.may_see(box)) {
        sum.nearest = std::min(sum.nearest, distance);
        if (size > 0) sum.smallest = std::min(sum.smallest, size);
      }
    };
    all = join(all, reduced(objects, Survey(), more, join));
  };
#define ZRAKA_INCLUDE(Type, plural) include(scene.plural);
  ZRAKA_SHAPES(ZRAKA_INCLUDE)
#undef ZRAKA_INCLUDE
  return all;
}

double median(std::vector<double>& values) {
  const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
  std::nth_element(values.begin(), middle, values.end());
  return *middle;
}

/// None where nothing has bounds.
std::optional<Vec3> median_of(const Scene& scene, const Whereabouts& where) {
  std::vector<double> x, y, z;
  each_sample(scene, where, [&](const Bounds& box) {
    x.push_back(box.lower.x / 2 + box.upper.x / 2);
    y.push_back(box.lower.y / 2 + box.upper.y / 2);
    z.push_back(box.lower.z / 2 + box.upper.z / 2);
  });
  if (x.empty()) return std::nullopt;
  return Vec3{median(x), median(y), median(z)};
}

}  // namespace

Frame frame_of(const Scene& scene) {
  if (scene.shape_count() == 0) return {};
  const ViewCone view(scene.camera, scene.resolution);
  const Whereabouts where(scene);
  Survey all = survey(scene, where, view);
  const Vec3 middle = median_of(scene, where).value_or(view.point_at(all.nearest));
  if (all.bounds.empty() && all.nearest < Bounds::kInfinity) {
    // Planes alone: as much around what is seen of them as it is away.
    const double d = all.nearest;
    all.bounds = {{middle.x - d, middle.y - d, middle.z - d},
                  {middle.x + d, middle.y + d, middle.z + d}};
  }
  if (!(all.nearest < Bounds::kInfinity)) return Frame::around(middle, all.bounds);

  const Vec3 seen = view.point_at(all.nearest);
  const bool good =
      length_of(vector_between(seen, middle)) <= kMostWidths * view.width_at(all.nearest);
  Frame frame = Frame::around(good ? middle : seen, all.bounds);
  if (frame.length(all.smallest) < kLeastSeen) {
    int exponent = 0;
    std::frexp(all.smallest, &exponent);
    const double larger = std::ldexp(kLeastSeen, std::min(1 - exponent, 1000));
    frame.reach = larger / frame.scale;
    frame.scale = larger;
  }
  // Which side of a surface an eye on it is on would be rounding's choice: what lies before it is
  // seen.
  if (all.smallest < Bounds::kInfinity && all.nearest <= 0x1p-40 * all.smallest)
    frame.eye_shift = 0x1p-18 * all.smallest;
  frame.width_seen = view.width_at(std::max(all.nearest, frame.eye_shift));
  return frame;
}

bool has_ground_sphere(const ShapeLists& shapes, const Whereabouts& where, const Frame& frame) {
  const double largest = frame.length(reduced(
      shapes.spheres, 0.0,
      [](double& most, const Object<Sphere>& s) { most = std::max(most, s.shape.radius); },
      [](double a, double b) { return std::max(a, b); }));
  if (largest > kMostWidths * frame.length(frame.width_seen)) return true;
  std::vector<double> reaches;
  each_sample(shapes, where, [&](const Bounds& box) {
    const Vec3 lower = frame.point(box.lower), upper = frame.point(box.upper);
    reaches.push_back(std::max({std::fabs(lower.x), std::fabs(lower.y), std::fabs(lower.z),
                                std::fabs(upper.x), std::fabs(upper.y), std::fabs(upper.z)}));
  });
  return !reaches.empty() && largest > 4 * median(reaches);
}

}  // namespace zraka
