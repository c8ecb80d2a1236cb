// SPDX-License-Identifier: Apache-2.0
#include "scene/polygon.hpp"

#include <algorithm>
#include <cmath>
#include <functional>
#include <optional>
#include <queue>
#include <utility>

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

double squared_distance(const Vec3& a, const Vec3& b) {
  const Vec3 d{a.x - b.x, a.y - b.y, a.z - b.z};
  return d.x * d.x + d.y * d.y + d.z * d.z;
}

/// Cuts ears off a polygon (Meisters 1975): corners that turn left and have no other corner in
/// their triangle. Of these the one comes first whose cut is shortest: what is round is halved
/// again and again, where corners taken as they come would make a fan of triangles that reach all
/// over it, and be hit by every ray that comes near.
class EarCutter {
 public:
  explicit EarCutter(const std::vector<Vec3>& corners)
      : corners_(corners), flat_(flattened(corners)), links_(corners.size()) {
    const auto n = static_cast<std::uint32_t>(corners.size());
    looks_left_ = 8 * std::int64_t{n} * n + 1000;
    for (std::uint32_t i = 0; i < n; ++i) links_[i] = {(i + n - 1) % n, (i + 1) % n};
  }

  std::vector<std::array<std::uint32_t, 3>> cut() {
    std::uint32_t last = 0;
    look_at_all(last);
    for (std::size_t left = corners_.size(); left > 3; --left) {
      std::optional<std::uint32_t> ear = next_ear();
      // Where corners lie on one another, as at bridges to holes, one may have become an ear
      // without being a neighbour of what was cut.
      if (!ear && looks_left_ > 0) {
        look_at_all(last);
        ear = next_ear();
      }
      if (ear) triangles_.push_back({links_[*ear].before, *ear, links_[*ear].after});
      last = take_out(ear ? *ear : needless_corner(last));
    }
    std::array<std::uint32_t, 3> rest = {links_[last].before, last, links_[last].after};
    std::rotate(rest.begin(), std::min_element(rest.begin(), rest.end()), rest.end());
    triangles_.push_back(rest);
    return triangles_;
  }

 private:
  struct Link {
    std::uint32_t before, after;
    std::uint32_t looks = 0;  ///< what was found before the last of them counts no more
    bool there = true;
  };
  struct Ear {
    double length;
    std::uint32_t corner, look;
    bool operator>(const Ear& other) const {
      return length != other.length ? length > other.length : corner > other.corner;
    }
  };

  double turn_at(std::uint32_t i) const {
    return turn(flat_[links_[i].before], flat_[i], flat_[links_[i].after]);
  }
  bool turns_right(std::uint32_t i) const { return turn_at(i) < 0; }

  /// Calls function(corner) for all that are left, from this one on, until it returns false.
  template <class Function>
  void each_left(std::uint32_t first, const Function& function) const {
    std::uint32_t corner = first;
    do {
      if (!function(corner)) return;
      corner = links_[corner].after;
    } while (corner != first);
  }

  void look_at_all(std::uint32_t first) {
    right_.clear();
    each_left(first, [&](std::uint32_t i) {
      if (turns_right(i)) right_.push_back(i);
      return true;
    });
    each_left(first, [&](std::uint32_t i) {
      look_at(i);
      return true;
    });
  }

  /// Of a polygon without ears the corner that goes without a triangle: one on a line, or on its
  /// neighbour, if there is any; else the polygon crosses itself.
  std::uint32_t needless_corner(std::uint32_t from) const {
    std::uint32_t found = links_[from].after;
    each_left(found, [&](std::uint32_t i) {
      if (turn_at(i) != 0) return true;
      found = i;
      return false;
    });
    return found;
  }

  /// Returns the one before.
  std::uint32_t take_out(std::uint32_t corner) {
    const auto [before, after] = std::pair(links_[corner].before, links_[corner].after);
    links_[before].after = after;
    links_[after].before = before;
    links_[corner].there = false;
    std::erase_if(right_, [&](std::uint32_t i) {
      return i == corner || ((i == before || i == after) && !turns_right(i));
    });
    look_at(before);
    look_at(after);
    return before;
  }

  bool is_ear(std::uint32_t corner) const {
    const Link& link = links_[corner];
    const Point &a = flat_[link.before], &b = flat_[corner], &c = flat_[link.after];
    if (!(turn(a, b, c) > 0)) return false;
    // Only corners that turn right can be in the way, and there are none in a convex polygon.
    return std::none_of(right_.begin(), right_.end(), [&](std::uint32_t i) {
      return i != link.before && i != link.after && inside(flat_[i], a, b, c);
    });
  }

  void look_at(std::uint32_t corner) {
    Link& link = links_[corner];
    ++link.looks;
    looks_left_ -= static_cast<std::int64_t>(1 + right_.size());
    if (is_ear(corner))
      ears_.push(
          {squared_distance(corners_[link.before], corners_[link.after]), corner, link.looks});
  }

  std::optional<std::uint32_t> next_ear() {
    while (!ears_.empty()) {
      const Ear ear = ears_.top();
      ears_.pop();
      if (links_[ear.corner].there && links_[ear.corner].looks == ear.look) return ear.corner;
    }
    return {};
  }

  const std::vector<Vec3>& corners_;
  std::vector<Point> flat_;
  std::vector<Link> links_;
  std::vector<std::uint32_t> right_;  ///< corners that turn right
  /// A polygon that crosses itself may have no ears; then looking for one at every corner again and
  /// again must end.
  std::int64_t looks_left_ = 0;
  std::priority_queue<Ear, std::vector<Ear>, std::greater<>> ears_;
  std::vector<std::array<std::uint32_t, 3>> triangles_;
};

}  // namespace

std::vector<std::array<std::uint32_t, 3>> triangulate(const std::vector<Vec3>& corners) {
  if (corners.size() < 3) return {};
  return EarCutter(corners).cut();
}

}  // namespace zraka
