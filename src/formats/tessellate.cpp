// SPDX-License-Identifier: Apache-2.0
#include "formats/tessellate.hpp"

#include <array>
#include <cmath>

#include "formats/vectors.hpp"
#include "math/elementary.hpp"

namespace zraka {
namespace {

constexpr double kPi = 3.14159265358979323846;
constexpr int kAround = 64, kAlong = 32;

struct Corner {
  Vec3 point, normal;
};

void add(const Corner& a, const Corner& b, const Corner& c, std::vector<SmoothTriangle>& out) {
  constexpr double kFlat = 1e-20;  // at a pole a side has no length but rounding's
  const Vec3 ab = b.point - a.point, ac = c.point - a.point, bc = c.point - b.point;
  const Vec3 across = cross(ab, ac);
  const double longest = std::fmax(dot(ab, ab), std::fmax(dot(ac, ac), dot(bc, bc)));
  if (!(dot(across, across) > kFlat * longest * longest)) return;
  out.push_back({a.point, b.point, c.point, a.normal, b.normal, c.normal});
}

/// A net of corners: `at(u, v)` with u and v from 0 to 1.
template <class At>
std::vector<SmoothTriangle> net(int columns, int rows, const At& at) {
  std::vector<SmoothTriangle> out;
  std::vector<Corner> before, row(static_cast<std::size_t>(columns) + 1);
  for (int j = 0; j <= rows; ++j) {
    for (int i = 0; i <= columns; ++i)
      row[static_cast<std::size_t>(i)] =
          at(static_cast<double>(i % columns) / columns, static_cast<double>(j) / rows);
    for (std::size_t i = 0; j > 0 && i < static_cast<std::size_t>(columns); ++i) {
      add(before[i], before[i + 1], row[i + 1], out);
      add(before[i], row[i + 1], row[i], out);
    }
    before = row;
  }
  return out;
}

void append(std::vector<SmoothTriangle>& all, const std::vector<SmoothTriangle>& more) {
  all.insert(all.end(), more.begin(), more.end());
}

/// Two directions that make a right-handed frame with an axis.
struct Frame {
  Vec3 x, y, axis;
  explicit Frame(const Vec3& along) : x(any_across(along)), y(), axis(unit(along)) {
    y = cross(axis, x);
  }
  Vec3 round(double turns) const {
    const double angle = 2 * kPi * turns;
    return x * elementary::cos(angle) + y * elementary::sin(angle);
  }
};

std::vector<SmoothTriangle> ring(const Vec3& center, const Vec3& normal, double inner,
                                 double outer) {
  const Frame frame(normal);
  return net(kAround, 1, [&](double u, double v) {
    return Corner{center + frame.round(u) * (inner + (outer - inner) * v), frame.axis};
  });
}

std::vector<SmoothTriangle> side(const Vec3& base, double base_radius, const Vec3& top,
                                 double top_radius) {
  const Vec3 along = top - base;
  const Frame frame(along);
  const double slope = (base_radius - top_radius) / length(along);
  return net(kAround, 1, [&](double u, double v) {
    const Vec3 out = frame.round(u);
    return Corner{base + along * v + out * (base_radius + (top_radius - base_radius) * v),
                  out + frame.axis * slope};
  });
}

/// A ball's zone between two heights, 0 at the lower pole and 1 at the upper one.
std::vector<SmoothTriangle> zone(const Vec3& center, const Frame& frame, double radius, double low,
                                 double high) {
  return net(kAround, kAlong, [&](double u, double v) {
    const double angle = kPi * (low + (high - low) * v - 0.5);
    const Vec3 n = frame.round(u) * elementary::cos(angle) + frame.axis * elementary::sin(angle);
    return Corner{center + n * radius, n};
  });
}

/// |x|^power with the sign of x.
double signed_power(double x, double power) {
  return std::copysign(elementary::pow(std::fabs(x), power), x);
}

struct Tessellate {
  using Triangles = std::vector<SmoothTriangle>;

  Triangles operator()(const Ellipsoid& s) const {
    Triangles out = zone({}, Frame({0, 1, 0}), 1, 0, 1);
    for (SmoothTriangle& t : out) {
      for (Vec3* p : {&t.a, &t.b, &t.c})
        *p = s.center + Vec3{p->x * s.radii.x, p->y * s.radii.y, p->z * s.radii.z};
      for (Vec3* n : {&t.normal_a, &t.normal_b, &t.normal_c})
        *n = unit({n->x / s.radii.x, n->y / s.radii.y, n->z / s.radii.z});
    }
    return out;
  }
  Triangles operator()(const Frustum& s) const {
    Triangles out = side(s.base, s.base_radius, s.top, s.top_radius);
    if (!s.caps) return out;
    const Vec3 along = s.top - s.base;
    append(out, ring(s.base, along * -1, 0, s.base_radius));
    append(out, ring(s.top, along, 0, s.top_radius));
    return out;
  }
  Triangles operator()(const Disc& s) const {
    return ring(s.center, s.normal, s.inner_radius, s.radius);
  }
  Triangles operator()(const Torus& s) const {
    const Frame frame(s.normal);
    return net(kAround + kAlong, kAlong, [&](double u, double v) {
      const double angle = 2 * kPi * v;
      const Vec3 out = frame.round(u);
      const Vec3 n = out * elementary::cos(angle) + frame.axis * elementary::sin(angle);
      return Corner{s.center + out * s.radius + n * s.tube_radius, n};
    });
  }
  Triangles operator()(const Capsule& s) const {
    const Frame frame(s.top - s.base);
    Triangles out = side(s.base, s.radius, s.top, s.radius);
    append(out, zone(s.base, frame, s.radius, 0, 0.5));
    append(out, zone(s.top, frame, s.radius, 0.5, 1));
    return out;
  }
  Triangles operator()(const Superellipsoid& s) const {
    // Barr 1981, with z for the axis.
    return net(kAround + kAlong, kAlong + kAlong, [&](double u, double v) {
      const double around = 2 * kPi * u, up = kPi * (v - 0.5);
      const double cu = elementary::cos(around), su = elementary::sin(around);
      const double cv = v == 0 || v == 1 ? 0 : elementary::cos(up), sv = elementary::sin(up);
      const auto at = [&](double e, double n) {
        const double wide = signed_power(cv, n);
        return Vec3{wide * signed_power(cu, e), wide * signed_power(su, e), signed_power(sv, n)};
      };
      const Vec3 p = at(s.e, s.n), n = at(2 - s.e, 2 - s.n);
      const Vec3 normal = unit({n.x / s.radii.x, n.y / s.radii.y, n.z / s.radii.z});
      const bool is_good = std::isfinite(normal.x) && std::isfinite(normal.y) &&
                           std::isfinite(normal.z) && normal != Vec3{};
      return Corner{s.center + Vec3{p.x * s.radii.x, p.y * s.radii.y, p.z * s.radii.z},
                    is_good ? normal : unit(p)};
    });
  }
  Triangles operator()(const Box& s) const {
    Triangles out;
    for (int axis = 0; axis < 3; ++axis)
      for (const bool high : {false, true}) {
        const auto corner = [&](int which) {
          std::array<bool, 3> is_high{};
          is_high[static_cast<std::size_t>(axis)] = high;
          is_high[static_cast<std::size_t>((axis + 1) % 3)] = (which & 1) != 0;
          is_high[static_cast<std::size_t>((axis + 2) % 3)] = (which & 2) != 0;
          return Vec3{is_high[0] ? s.max.x : s.min.x, is_high[1] ? s.max.y : s.min.y,
                      is_high[2] ? s.max.z : s.min.z};
        };
        const double way = high ? 1 : -1;
        const Vec3 normal{axis == 0 ? way : 0, axis == 1 ? way : 0, axis == 2 ? way : 0};
        const Corner a{corner(0), normal}, b{corner(1), normal}, c{corner(3), normal},
            d{corner(2), normal};
        add(a, b, c, out);
        add(a, c, d, out);
      }
    return out;
  }
  template <class Other>
  Triangles operator()(const Other&) const {
    return {};
  }
};

}  // namespace

std::vector<SmoothTriangle> tessellated(const AnyBody& body) {
  return std::visit(Tessellate{}, body);
}

}  // namespace zraka
