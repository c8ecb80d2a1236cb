// SPDX-License-Identifier: Apache-2.0
// Tachyon's shapes.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "formats/tachyon_reader.hpp"
#include "formats/vectors.hpp"

namespace zraka {

void TachyonReader::add_sphere(const Vec3& center, double radius, std::uint32_t material,
                               const char* at) {
  if (radius == 0) return warn(at, "a radius of 0 has nothing to draw");
  scene_.spheres.push_back({{center, std::fabs(radius)}, material});
}

void TachyonReader::add_cylinder(const Vec3& base, const Vec3& apex, double radius,
                                 std::uint32_t material, const char* at) {
  if (radius == 0) return warn(at, "a radius of 0 has nothing to draw");
  if (base == apex) return warn(at, "a cylinder of length 0 has nothing to draw");
  radius = std::fabs(radius);
  scene_.cones.push_back({{base, radius, apex, radius}, material});
}

bool TachyonReader::read_sphere() {
  Vec3 center;
  double radius = 0;
  std::uint32_t material = 0;
  const char* const at = in_->place();
  if (!vector_of("CENTER", center) || !number_of("RAD", radius) || !surface(material)) return false;
  add_sphere(center, radius, material, at);
  return true;
}

bool TachyonReader::read_plane() {
  Plane plane;
  std::uint32_t material = 0;
  const char* const at = in_->place();
  if (!vector_of("CENTER", plane.point) || !vector_of("NORMAL", plane.normal)) return false;
  if (is_zero(plane.normal)) return fail(at, "NORMAL of PLANE is 0 0 0");
  if (!surface(material)) return false;
  scene_.planes.push_back({plane, material});
  return true;
}

bool TachyonReader::read_cylinder() {
  InfiniteCylinder cylinder;
  const char* const at = in_->place();
  if (!vector_of("CENTER", cylinder.center) || !vector_of("AXIS", cylinder.axis) ||
      !number_of("RAD", cylinder.radius))
    return false;
  if (is_zero(cylinder.axis)) return fail(at, "AXIS of CYLINDER is 0 0 0");
  if (!surface(cylinder.material)) return false;
  if (cylinder.radius == 0) return warn(at, "a radius of 0 has nothing to draw"), true;
  cylinder.radius = std::fabs(cylinder.radius);
  warn(at, "an infinite CYLINDER ends where it is thin as a hair");
  cylinders_.push_back(cylinder);
  return true;
}

/// As long as a thousand times what it is away or thick.
void TachyonReader::add_infinite_cylinders() {
  for (const InfiniteCylinder& c : cylinders_) {
    const Vec3 way{c.center.x - center_.x, c.center.y - center_.y, c.center.z - center_.z};
    const double away = std::sqrt(way.x * way.x + way.y * way.y + way.z * way.z);
    const double axis = std::sqrt(c.axis.x * c.axis.x + c.axis.y * c.axis.y + c.axis.z * c.axis.z);
    const double reach = 1000 * std::fmax(away, c.radius) / axis;
    const auto end = [&](double s) {
      return Vec3{c.center.x + s * c.axis.x, c.center.y + s * c.axis.y, c.center.z + s * c.axis.z};
    };
    scene_.cones.push_back({{end(-reach), c.radius, end(reach), c.radius}, c.material});
  }
}

bool TachyonReader::read_fcylinder() {
  Vec3 base, apex;
  double radius = 0;
  std::uint32_t material = 0;
  const char* const at = in_->place();
  if (!vector_of("BASE", base) || !vector_of("APEX", apex) || !number_of("RAD", radius) ||
      !surface(material))
    return false;
  add_cylinder(base, apex, radius, material, at);
  return true;
}

bool TachyonReader::read_polycylinder() {
  const char* const at = in_->place();
  std::size_t n = 0;
  if (!expect("POINTS") || !count(n, "POINTS", 6, 1e9)) return false;
  std::vector<Vec3> points(n);
  for (Vec3& point : points)
    if (!vector(point, "a point")) return false;
  double radius = 0;
  std::uint32_t material = 0;
  if (!number_of("RAD", radius) || !surface(material)) return false;
  for (std::size_t i = 0; i < n; ++i) {
    add_sphere(points[i], radius, material, at);
    if (i > 0 && points[i - 1] != points[i])
      add_cylinder(points[i - 1], points[i], radius, material, at);
  }
  return true;
}

bool TachyonReader::read_ring() {
  Disc disc;
  std::uint32_t material = 0;
  const char* const at = in_->place();
  if (!vector_of("CENTER", disc.center) || !vector_of("NORMAL", disc.normal) ||
      !number_of("INNER", disc.inner_radius) || !number_of("OUTER", disc.radius))
    return false;
  if (is_zero(disc.normal)) return fail(at, "NORMAL of RING is 0 0 0");
  if (!surface(material)) return false;
  disc.inner_radius = std::fmax(disc.inner_radius, 0.0);
  if (!(disc.radius > disc.inner_radius))
    return warn(at, "a RING without width has nothing to draw"), true;
  scene_.discs.push_back({disc, material});
  return true;
}

bool TachyonReader::read_box() {
  Box box;
  std::uint32_t material = 0;
  const char* const at = in_->place();
  if (!vector_of("MIN", box.min) || !vector_of("MAX", box.max) || !surface(material)) return false;
  if (!(box.min.x < box.max.x && box.min.y < box.max.y && box.min.z < box.max.z))
    return fail(at, "MIN of BOX is not below MAX in x, y and z");
  scene_.boxes.push_back({box, material});
  return true;
}

bool TachyonReader::read_triangle() {
  Triangle t;
  std::uint32_t material = 0;
  if (!vector_of("V0", t.a) || !vector_of("V1", t.b) || !vector_of("V2", t.c) || !surface(material))
    return false;
  scene_.triangles.push_back({t, material});
  return true;
}

void TachyonReader::add_smooth(const std::array<Vec3, 6>& c, std::uint32_t material) {
  // Without a normal in each corner it is flat.
  if (is_zero(c[3]) || is_zero(c[4]) || is_zero(c[5]))
    scene_.triangles.push_back({{c[0], c[1], c[2]}, material});
  else
    scene_.smooth_triangles.push_back({{c[0], c[1], c[2], c[3], c[4], c[5]}, material});
}

bool TachyonReader::read_smooth_triangle() {
  std::array<Vec3, 6> c;
  std::uint32_t material = 0;
  if (!vector_of("V0", c[0]) || !vector_of("V1", c[1]) || !vector_of("V2", c[2]) ||
      !vector_of("N0", c[3]) || !vector_of("N1", c[4]) || !vector_of("N2", c[5]) ||
      !surface(material))
    return false;
  add_smooth(c, material);
  return true;
}

bool TachyonReader::read_painted_triangle() {
  std::array<Vec3, 6> c;
  std::array<Color, 3> colors;
  TachyonSurface body;
  if (!vector_of("V0", c[0]) || !vector_of("V1", c[1]) || !vector_of("V2", c[2]) ||
      !vector_of("N0", c[3]) || !vector_of("N1", c[4]) || !vector_of("N2", c[5]) ||
      !color_of("C0", colors[0]) || !color_of("C1", colors[1]) || !color_of("C2", colors[2]) ||
      !surface_body(body, true))
    return false;
  add_painted(c, colors, body);
  return true;
}

/// Colours are laid out as textures once all are known; a triangle without normals gets its own.
void TachyonReader::add_painted(const std::array<Vec3, 6>& c, const std::array<Color, 3>& colors,
                                const TachyonSurface& surface) {
  auto found = std::find_if(painted_.begin(), painted_.end(),
                            [&](const Painted& p) { return p.surface == surface; });
  if (found == painted_.end()) {
    const auto material = static_cast<std::uint32_t>(surfaces_.size());
    surfaces_.push_back(surface);
    painted_.push_back({surface, material, {}, {}});
    found = painted_.end() - 1;
  }
  std::array<Vec3, 6> n = c;
  if (is_zero(c[3]) || is_zero(c[4]) || is_zero(c[5])) {
    const auto minus = [](const Vec3& a, const Vec3& b) {
      return Vec3{a.x - b.x, a.y - b.y, a.z - b.z};
    };
    const Vec3 u = minus(c[1], c[0]), v = minus(c[2], c[0]);
    n[3] = n[4] = n[5] = {u.y * v.z - u.z * v.y, u.z * v.x - u.x * v.z, u.x * v.y - u.y * v.x};
  }
  found->triangles.push_back(scene_.smooth_triangles.size());
  for (const Color& color : colors)
    for (const double value : {color.r, color.g, color.b})
      found->colors.push_back(static_cast<float>(value));
  scene_.smooth_triangles.push_back({{n[0], n[1], n[2], n[3], n[4], n[5]}, found->material});
}

bool TachyonReader::read_vertex_array() {
  std::size_t n = 0;
  if (!expect("NUMVERTS") || !count(n, "NUMVERTS", 12, 1e9)) return false;
  std::vector<Vec3> points(n), normals(n);
  std::vector<Color> colors;
  if (!expect("COORDS")) return false;
  for (Vec3& point : points)
    if (!vector(point, "a corner")) return false;
  if (!expect("NORMALS")) return false;
  for (Vec3& normal : normals)
    if (!vector(normal, "a normal")) return false;
  TachyonSurface body;
  std::uint32_t material = 0;
  bool has_material = false;
  const auto add = [&](const std::array<std::size_t, 3>& i) {
    const std::array<Vec3, 6> corners{points[i[0]],  points[i[1]],  points[i[2]],
                                      normals[i[0]], normals[i[1]], normals[i[2]]};
    if (!colors.empty())
      return add_painted(corners, {colors[i[0]], colors[i[1]], colors[i[2]]}, body);
    if (!has_material) material = material_of(body);
    has_material = true;
    add_smooth(corners, material);
  };
  const auto index = [&](std::size_t& i) {
    const char* const at = in_->place();
    double value = 0;
    if (!number(value, "a corner's index")) return false;
    if (value < 0 || value != std::floor(value) || !(value < static_cast<double>(n)))
      return fail(at,
                  fmt::format("the index {} is none of VERTEXARRAY: expected a whole number, less "
                              "than {}",
                              value, n));
    i = static_cast<std::size_t>(value);
    return true;
  };
  for (;;) {
    if (in_->take_keyword("END_VERTEXARRAY")) return true;
    std::size_t facets = 0;
    std::array<std::size_t, 3> i{};
    if (in_->take_keyword("COLORS")) {
      colors.resize(n);
      for (Color& c : colors)
        if (!color(c, "a colour")) return false;
    } else if (in_->take_keyword("TEXTURE")) {
      body = {};
      if (!surface_body(body, false)) return false;
      has_material = false;
    } else if (in_->take_keyword("TRISTRIP")) {
      if (!count(facets, "TRISTRIP", 2, 1e9)) return false;
      for (std::size_t k = 0; k < facets; ++k) {
        std::size_t next = 0;
        if (!index(next)) return false;
        i = {i[1], i[2], next};
        if (k >= 2) add(k % 2 == 0 ? i : std::array<std::size_t, 3>{i[1], i[0], i[2]});
      }
    } else if (in_->take_keyword("TRIMESH")) {
      if (!count(facets, "TRIMESH", 6, 1e9)) return false;
      for (std::size_t k = 0; k < facets; ++k) {
        if (!index(i[0]) || !index(i[1]) || !index(i[2])) return false;
        add(i);
      }
    } else {
      return expect("END_VERTEXARRAY");
    }
  }
}

bool TachyonReader::read_scape() {
  const char* const at = in_->place();
  Vec3 center;
  double number_read = 0;
  std::uint32_t material = 0;
  if (!expect("RES") || !number(number_read, "RES") || !number(number_read, "RES") ||
      !expect("SCALE") || !number(number_read, "SCALE") || !number(number_read, "SCALE") ||
      !vector_of("CENTER", center) || !surface(material))
    return false;
  warn(at, "SCAPE is left out: there is no fractal terrain");
  return true;
}

bool TachyonReader::read_volume() {
  const char* const at = in_->place();
  Vec3 corner;
  std::string name;
  std::uint32_t material = 0;
  if (!vector_of("MIN", corner) || !vector_of("MAX", corner) || !vector_of("DIM", corner) ||
      !expect("FILE") || !file_name("FILE", name) || !surface(material))
    return false;
  warn(at, "SCALARVOL is left out: there is no rendering of volumes");
  return true;
}

bool TachyonReader::read_mgf() {
  const char* const at = in_->place();
  std::string name;
  if (!file_name("a file's name", name)) return false;
  warn(at, "MGFFILE is left out: MGF is not read");
  return true;
}

/// Triangles from a file of their own: scaled, turned about x, y and z, then moved.
bool TachyonReader::read_polygon_file() {
  constexpr double kDegree = 3.14159265358979323846 / 180;
  Vec3 scale, turn, center;
  std::string name;
  std::uint32_t material = 0;
  if (!vector_of("SCALE", scale) || !vector_of("ROT", turn) || !vector_of("CENTER", center) ||
      !expect("FILE"))
    return false;
  const char* const at = in_->place();
  if (!file_name("FILE", name) || !surface(material)) return false;
  const std::optional<std::string> text = read_named(at, name);
  if (!text) return true;  // all is read of the statement
  const double sx = std::sin(turn.x * kDegree), cx = std::cos(turn.x * kDegree);
  const double sy = std::sin(turn.y * kDegree), cy = std::cos(turn.y * kDegree);
  const double sz = std::sin(turn.z * kDegree), cz = std::cos(turn.z * kDegree);
  const auto moved = [&](Vec3 v) {
    v = {v.x * scale.x, v.y * scale.y, v.z * scale.z};
    return Vec3{
        v.x * cy * cz + v.y * (sx * sy * cz - cx * sz) + v.z * (sx * sz + cx * cz * sy) + center.x,
        v.x * cy * sz + v.y * (cx * cz + sx * sy * sz) + v.z * (cx * sy * sz - sx * cz) + center.y,
        v.x * sy + v.y * sx * cy + v.z * cx * cy + center.z};
  };
  TachyonText polygons(*text, name);
  TachyonText* const outer = in_;
  in_ = &polygons;
  double corners = 0;
  bool good = true;
  while (good && in_->take_number(corners) && corners == 3) {
    Vec3 a, b, c;
    good = vector(a, "a corner") && vector(b, "a corner") && vector(c, "a corner");
    if (good) scene_.triangles.push_back({{moved(b), moved(a), moved(c)}, material});
  }
  in_ = outer;
  return true;
}

}  // namespace zraka
