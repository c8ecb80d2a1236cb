// SPDX-License-Identifier: Apache-2.0
#include "scene/polygon.hpp"

#include <cmath>

namespace zraka {
namespace {

struct Point {
  double x, y;
};

/// Twice the signed area; positive where a, b, c turn left.
double turn(const Point& a, const Point& b, const Point& c) {
  return (b.x - a.x) * (c.y - a.y) - (b.y - a.y) * (c.x - a.x);
}

bool inside(const Point& p, const Point& a, const Point& b, const Point& c) {
  return turn(a, b, p) >= 0 && turn(b, c, p) >= 0 && turn(c, a, p) >= 0;
}

/// The polygon in the coordinate plane that it faces most, going round to the left.
std::vector<Point> flattened(const std::vector<Vec3>& corners) {
  Vec3 normal;  // Newell's, which concave corners do not mislead
  for (std::size_t i = 0; i < corners.size(); ++i) {
    const Vec3 &a = corners[i], &b = corners[(i + 1) % corners.size()];
    normal.x += (a.y - b.y) * (a.z + b.z);
    normal.y += (a.z - b.z) * (a.x + b.x);
    normal.z += (a.x - b.x) * (a.y + b.y);
  }
  const double x = std::fabs(normal.x), y = std::fabs(normal.y), z = std::fabs(normal.z);
  std::vector<Point> flat;
  for (const Vec3& c : corners) {
    Point p = z >= x && z >= y ? Point{c.x, c.y} : x >= y ? Point{c.y, c.z} : Point{c.z, c.x};
    const double facing = z >= x && z >= y ? normal.z : x >= y ? normal.x : normal.y;
    if (facing < 0) p.x = -p.x;
    flat.push_back(p);
  }
  return flat;
}

}  // namespace

std::vector<std::array<std::uint32_t, 3>> triangulate(const std::vector<Vec3>& corners) {
  std::vector<std::array<std::uint32_t, 3>> triangles;
  if (corners.size() < 3) return triangles;
  const std::vector<Point> flat = flattened(corners);
  std::vector<std::uint32_t> left(corners.size());
  for (std::uint32_t i = 0; i < left.size(); ++i) left[i] = i;

  // Ears are cut off one by one (Meisters 1975): corners that turn left and have no other corner in
  // their triangle. Only corners that turn right can be in the way, and there are none in a convex
  // polygon.
  // A polygon that crosses itself may have no ears; then looking for one at every corner again and
  // again must end.
  std::size_t looks = 0;
  const std::size_t most_looks = 8 * corners.size() * corners.size() + 1000;
  std::size_t at = 0, tried = 0;
  while (left.size() > 3) {
    const std::size_t n = left.size();
    const std::size_t before = (at + n - 1) % n, after = (at + 1) % n;
    const Point &a = flat[left[before]], &b = flat[left[at]], &c = flat[left[after]];
    bool ear = turn(a, b, c) > 0;
    for (std::size_t i = 0; ear && i < n; ++i) {
      ++looks;
      if (i == before || i == at || i == after) continue;
      const Point& p = flat[left[i]];
      if (turn(flat[left[(i + n - 1) % n]], p, flat[left[(i + 1) % n]]) < 0 && inside(p, a, b, c))
        ear = false;
    }
    if (!ear && tried < n && looks < most_looks) {
      ++tried;
      at = after;
      continue;
    }
    if (ear)
      triangles.push_back(
          {left[before], left[at], left[after]});  // else a corner on a line is dropped
    left.erase(left.begin() + static_cast<std::ptrdiff_t>(at));
    at = at < left.size() ? at : 0;
    tried = 0;
  }
  triangles.push_back({left[0], left[1], left[2]});
  return triangles;
}

}  // namespace zraka
