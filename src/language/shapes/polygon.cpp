// SPDX-License-Identifier: Apache-2.0
// The polygon, which becomes triangles.
#include "scene/polygon.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <optional>

#include "language/shapes.hpp"

namespace zraka::language {
namespace {

/// Cutting a polygon into triangles takes time that grows with the square of its corners.
constexpr std::size_t kMostCorners = 20000;

struct Polygon {
  Points points;
  std::optional<Transform> texture_transform;
};

constexpr Field kPolygonFields[] = {
    field<&Polygon::points>("points", {.text = "its corners in turn, in a plane",
                                       .unit = Unit::point,
                                       .required = true,
                                       .fewest = 3,
                                       .most = kMostCorners}),
    texture_transform_field<Polygon>(),
};

/// How far the points are from their plane, over how far they reach; none where they have no plane:
/// all on a line, or their edges cross so that one half turns back what the other turns.
std::optional<double> out_of_plane(const Points& points) {
  Vec3 normal, middle;
  double reach = 0;
  const auto count = static_cast<double>(points.size());
  for (const Vec3& p : points)
    middle = {middle.x + p.x / count, middle.y + p.y / count, middle.z + p.z / count};
  for (std::size_t i = 0; i < points.size();
       ++i) {  // Newell's, which concave corners do not mislead
    const Vec3 &a = points[i], &b = points[(i + 1) % points.size()];
    normal.x += (a.y - b.y) * ((a.z - middle.z) + (b.z - middle.z));
    normal.y += (a.z - b.z) * ((a.x - middle.x) + (b.x - middle.x));
    normal.z += (a.x - b.x) * ((a.y - middle.y) + (b.y - middle.y));
    reach = std::max(
        {reach, std::fabs(a.x - middle.x), std::fabs(a.y - middle.y), std::fabs(a.z - middle.z)});
  }
  const double length = std::sqrt(normal.x * normal.x + normal.y * normal.y + normal.z * normal.z);
  if (!(length > 0)) return std::nullopt;
  double farthest = 0;
  for (const Vec3& p : points)
    farthest =
        std::max(farthest, std::fabs((p.x - middle.x) * normal.x + (p.y - middle.y) * normal.y +
                                     (p.z - middle.z) * normal.z));
  return farthest / length / reach;
}

void put(Polygon& polygon, Item& item) {
  constexpr double kFlat = 1e-5;  // coordinates of five digits are not in a plane more exactly
  const std::optional<double> out = out_of_plane(polygon.points);
  if (!out)
    return item.complain("points",
                         "points of polygon are all on one line, or its edges cross: corners are "
                         "named in turn, round the polygon");
  if (!(*out <= kFlat))
    return item.complain(
        "points", fmt::format("points of polygon are in no plane: one is out of it by {:.2g} "
                              "of the polygon's reach",
                              *out));
  for (const auto& [a, b, c] : triangulate(polygon.points))
    add_shape(item, Triangle{polygon.points[a], polygon.points[b], polygon.points[c]},
              polygon.texture_transform);
}

}  // namespace

constexpr Kind shape::polygon =
    kind_of<Polygon, put>("polygon", "polygon", "A polygon, which may be concave.", kPolygonFields);

}  // namespace zraka::language
