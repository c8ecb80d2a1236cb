// SPDX-License-Identifier: Apache-2.0
#include "scene/polygon.hpp"

#include <algorithm>
#include <array>
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

/// Corners by where they lie, to be asked for those near a triangle.
class CornerGrid {
 public:
  CornerGrid() = default;
  CornerGrid(const std::vector<Point>& points, const std::vector<std::uint32_t>& corners)
      : count_(corners.size()), held_(points.size()) {
    if (corners.empty()) return;
    Point upper = lower_ = points[corners.front()];
    for (const std::uint32_t i : corners) {
      lower_ = {std::min(lower_.x, points[i].x), std::min(lower_.y, points[i].y)};
      upper = {std::max(upper.x, points[i].x), std::max(upper.y, points[i].y)};
      held_[i] = true;
    }
    side_ = static_cast<std::size_t>(std::sqrt(static_cast<double>(corners.size()))) + 1;
    const auto cells = static_cast<double>(side_);
    // Where all lie on a line the other axis has no extent, and one cell.
    per_x_ = upper.x > lower_.x ? cells / (upper.x - lower_.x) : 0;
    per_y_ = upper.y > lower_.y ? cells / (upper.y - lower_.y) : 0;
    first_.resize(side_ * side_ + 1);
    for (const std::uint32_t i : corners) ++first_[cell_of(points[i]) + 1];
    for (std::size_t i = 1; i < first_.size(); ++i) first_[i] += first_[i - 1];
    items_.resize(corners.size());
    std::vector<std::size_t> next(first_.begin(), first_.end() - 1);
    for (const std::uint32_t i : corners) items_[next[cell_of(points[i])]++] = i;
  }

  std::size_t count() const { return count_; }
  void remove(std::uint32_t corner) {
    if (held_[corner]) --count_;
    held_[corner] = false;
  }
  /// Does the predicate hold for any corner in the cells that the triangle reaches into? Each cell
  /// and corner is taken off `looks`.
  template <class Predicate>
  bool any_near(const std::array<Point, 3>& triangle, std::int64_t& looks,
                const Predicate& predicate) const {
    if (count_ == 0) return false;
    const auto [x, x_end] = std::minmax({triangle[0].x, triangle[1].x, triangle[2].x});
    const auto [y, y_end] = std::minmax({triangle[0].y, triangle[1].y, triangle[2].y});
    for (std::size_t row = row_of(y); row <= row_of(y_end); ++row) {
      const std::size_t end = first_[row * side_ + column_of(x_end) + 1];
      for (std::size_t i = first_[row * side_ + column_of(x)]; i < end; ++i, --looks)
        if (held_[items_[i]] && predicate(items_[i])) return true;
      --looks;
    }
    return false;
  }

 private:
  std::size_t index(double place) const {
    return static_cast<std::size_t>(std::clamp(place, 0.0, static_cast<double>(side_ - 1)));
  }
  std::size_t column_of(double x) const { return index((x - lower_.x) * per_x_); }
  std::size_t row_of(double y) const { return index((y - lower_.y) * per_y_); }
  std::size_t cell_of(const Point& p) const { return row_of(p.y) * side_ + column_of(p.x); }

  std::size_t count_ = 0, side_ = 0;
  Point lower_{};
  double per_x_ = 0, per_y_ = 0;
  std::vector<bool> held_;
  std::vector<std::size_t> first_;    // of each cell, in items_
  std::vector<std::uint32_t> items_;  // corners, cell by cell
};

/// Cuts ears off a polygon (Meisters 1975): corners that turn left and have no other corner in
/// their triangle. Of these the one comes first whose cut is shortest: what is round is halved
/// again and again, where corners taken as they come would make a fan of triangles that reach all
/// over it, and be hit by every ray that comes near.
class EarCutter {
 public:
  explicit EarCutter(const std::vector<Vec3>& corners)
      : corners_(corners), flat_(flattened(corners)), links_(corners.size()) {
    const auto n = static_cast<std::uint32_t>(corners.size());
    looks_left_ = std::min(8 * std::int64_t{n} * n + 1000, kMostLooks);
    for (std::uint32_t i = 0; i < n; ++i) links_[i] = {(i + n - 1) % n, (i + 1) % n};
  }

  std::vector<std::array<std::uint32_t, 3>> cut() {
    std::uint32_t last = 0;
    look_at_all(last);
    for (std::size_t left = corners_.size(); left > 3; --left) {
      std::optional<std::uint32_t> ear = next_ear();
      // Where corners lie on one another, as at bridges to holes, one may have become an ear
      // without being a neighbour of what was cut; not so where none turns right.
      if (!ear && looks_left_ > 0 && right_.count() > 0) {
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
    std::vector<std::uint32_t> right;
    each_left(first, [&](std::uint32_t i) {
      if (turns_right(i)) right.push_back(i);
      return true;
    });
    right_ = CornerGrid(flat_, right);
    straight_.clear();
    looks_left_ -= static_cast<std::int64_t>(right.size());
    each_left(first, [&](std::uint32_t i) {
      look_at(i);
      return true;
    });
  }

  /// Of a polygon without ears the corner that goes without a triangle: one on a line, or on its
  /// neighbour, if there is any; else the polygon crosses itself.
  std::uint32_t needless_corner(std::uint32_t from) {
    while (!straight_.empty()) {
      const std::uint32_t corner = straight_.back();
      straight_.pop_back();
      if (links_[corner].there && turn_at(corner) == 0) return corner;
    }
    return links_[from].after;
  }

  /// Returns the one before.
  std::uint32_t take_out(std::uint32_t corner) {
    const auto [before, after] = std::pair(links_[corner].before, links_[corner].after);
    links_[before].after = after;
    links_[after].before = before;
    links_[corner].there = false;
    right_.remove(corner);
    for (const std::uint32_t i : {before, after})
      if (!turns_right(i)) right_.remove(i);
    look_at(before);
    look_at(after);
    return before;
  }

  bool is_ear(std::uint32_t corner) {
    const Link& link = links_[corner];
    const Point &a = flat_[link.before], &b = flat_[corner], &c = flat_[link.after];
    if (!(turn(a, b, c) > 0)) return false;
    // Only corners that turn right can be in the way, and there are none in a convex polygon.
    return !right_.any_near({a, b, c}, looks_left_, [&](std::uint32_t i) {
      return i != link.before && i != link.after && inside(flat_[i], a, b, c);
    });
  }

  void look_at(std::uint32_t corner) {
    Link& link = links_[corner];
    ++link.looks;
    --looks_left_;
    if (turn_at(corner) == 0) straight_.push_back(corner);
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
  CornerGrid right_;                     ///< corners that turn right
  std::vector<std::uint32_t> straight_;  ///< corners that turned neither way when last looked at
  static constexpr std::int64_t kMostLooks = std::int64_t{1} << 25;
  /// A polygon that crosses itself may have no ears; then looking for one at every corner again and
  /// again must end.
  std::int64_t looks_left_ = 0;
  std::priority_queue<Ear, std::vector<Ear>, std::greater<>> ears_;
  std::vector<std::array<std::uint32_t, 3>> triangles_;
};

}  // namespace

std::vector<std::array<std::uint32_t, 3>> triangulate(const std::vector<Vec3>& corners) {
  // Corners on the one before them make no triangle.
  std::vector<std::uint32_t> kept;
  for (std::uint32_t i = 0; i < corners.size(); ++i)
    if (i == 0 || !(corners[i] == corners[kept.back()])) kept.push_back(i);
  while (kept.size() > 1 && corners[kept.back()] == corners[kept.front()]) kept.pop_back();
  if (kept.size() < 3) return {};
  if (kept.size() == corners.size()) return EarCutter(corners).cut();
  std::vector<Vec3> different;
  for (const std::uint32_t i : kept) different.push_back(corners[i]);
  std::vector<std::array<std::uint32_t, 3>> triangles = EarCutter(different).cut();
  for (auto& triangle : triangles)
    for (std::uint32_t& corner : triangle) corner = kept[corner];
  return triangles;
}

}  // namespace zraka
