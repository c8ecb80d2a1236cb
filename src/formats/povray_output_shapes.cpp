// SPDX-License-Identifier: Apache-2.0
// Shapes, CSG and instances in POV-Ray's language.
#include <map>
#include <type_traits>
#include <vector>

#include "formats/povray_output.hpp"
#include "formats/vectors.hpp"
#include "shapes/shapes.hpp"

namespace zraka {

std::string PovrayWriter::words(const Transform& t) {
  return fmt::format("matrix <{},{},{}, {},{},{}, {},{},{}, {},{},{}>", t.along_x.x, t.along_x.y,
                     t.along_x.z, t.along_y.x, t.along_y.y, t.along_y.z, t.along_z.x, t.along_z.y,
                     t.along_z.z, t.origin.x, t.origin.y, t.origin.z);
}

std::string PovrayWriter::ending(std::uint32_t material, std::uint32_t transform) const {
  std::string text;
  if (material != kMaterialOfWhole) text += fmt::format("M{}()", material);
  if (transform != 0) text += ' ' + words(scene_.transforms[transform - 1]);
  return text + " }\n";
}

void PovrayWriter::write(const Sphere& s, const std::string& end) {
  put("sphere {{ {}, {} {}", words(s.center), s.radius, end);
}

void PovrayWriter::write(const Cone& s, const std::string& end) {
  put("cone {{ {}, {}, {}, {} open {}", words(s.base), s.base_radius, words(s.apex), s.apex_radius,
      end);
}

void PovrayWriter::write(const Triangle& s, const std::string& end) {
  put("triangle {{ {}, {}, {} {}", words(s.a), words(s.b), words(s.c), end);
}

void PovrayWriter::write(const SmoothTriangle& s, const std::string& end) {
  put("smooth_triangle {{ {}, {}, {}, {}, {}, {} {}", words(s.a), words(s.normal_a), words(s.b),
      words(s.normal_b), words(s.c), words(s.normal_c), end);
}

void PovrayWriter::write(const Ellipsoid& s, const std::string& end) {
  put("sphere {{ 0, 1 scale {} translate {} {}", words(s.radii), words(s.center), end);
}

void PovrayWriter::write(const Box& s, const std::string& end) {
  if (!(s.radius > 0)) return put("box {{ {}, {} {}", words(s.min), words(s.max), end);
  const Vec3 r{s.radius, s.radius, s.radius}, a = s.min + r, b = s.max - r;
  put("merge {{\n");
  for (int axis = 0; axis < 3; ++axis) {
    Vec3 low = a, high = b;
    (axis == 0 ? low.x : axis == 1 ? low.y : low.z) -= s.radius;
    (axis == 0 ? high.x : axis == 1 ? high.y : high.z) += s.radius;
    put("box {{ {}, {} }}\n", words(low), words(high));
    for (int corner = 0; corner < 4; ++corner) {
      const bool one = (corner & 1) != 0, two = (corner & 2) != 0;
      const Vec3 from = axis == 0   ? Vec3{a.x, one ? b.y : a.y, two ? b.z : a.z}
                        : axis == 1 ? Vec3{one ? b.x : a.x, a.y, two ? b.z : a.z}
                                    : Vec3{one ? b.x : a.x, two ? b.y : a.y, a.z};
      Vec3 to = from;
      (axis == 0 ? to.x : axis == 1 ? to.y : to.z) = axis == 0 ? b.x : axis == 1 ? b.y : b.z;
      // A length of 0 is an error there.
      if (from != to) put("cylinder {{ {}, {}, {} }}\n", words(from), words(to), s.radius);
      if (axis == 0)
        put("sphere {{ {}, {} }} sphere {{ {}, {} }}\n", words(from), s.radius, words(to),
            s.radius);
    }
  }
  put("{}", end);
}

void PovrayWriter::write(const Plane& s, const std::string& end) {
  put("plane {{ {}, 0 translate {} {}", words(s.normal), words(s.point), end);
}

void PovrayWriter::write(const Parallelogram& s, const std::string& end) {
  const Vec3 b = s.corner + s.edge_u, c = b + s.edge_v, d = s.corner + s.edge_v;
  put("polygon {{ 5, {}, {}, {}, {}, {} {}", words(s.corner), words(b), words(c), words(d),
      words(s.corner), end);
}

void PovrayWriter::write(const Disc& s, const std::string& end) {
  put("disc {{ {}, {}, {}, {} {}", words(s.center), words(s.normal), s.radius, s.inner_radius, end);
}

void PovrayWriter::write(const Frustum& s, const std::string& end) {
  put("cone {{ {}, {}, {}, {} {} {}", words(s.base), s.base_radius, words(s.top), s.top_radius,
      s.caps ? "" : "open", end);
}

void PovrayWriter::write(const Capsule& s, const std::string& end) {
  put("merge {{ cylinder {{ {}, {}, {} }} sphere {{ {}, {} }} sphere {{ {}, {} }} {}",
      words(s.base), words(s.top), s.radius, words(s.base), s.radius, words(s.top), s.radius, end);
}

void PovrayWriter::write(const Torus& s, const std::string& end) {
  // POV-Ray's torus lies round y: turned like any frame whose y is the axis.
  const Vec3 axis = unit(s.normal), x = any_across(axis);
  const Transform turn{x, axis, cross(x, axis), s.center};
  put("torus {{ {}, {} sturm {} {}", s.radius, s.tube_radius, words(turn), end);
}

void PovrayWriter::write(const Quadric& s, const std::string& end) {
  const auto& c = s.coefficients;
  put("quadric {{ <{},{},{}>, <{},{},{}>, <{},{},{}>, {} clipped_by {{ box {{ {}, {} }} }} {}",
      c[0], c[1], c[2], c[3], c[4], c[5], c[6], c[7], c[8], c[9], words(s.min), words(s.max), end);
}

void PovrayWriter::write(const Superellipsoid& s, const std::string& end) {
  put("superellipsoid {{ <{},{}> scale {} translate {} {}", s.e, s.n, words(s.radii),
      words(s.center), end);
}

void PovrayWriter::write(const Csg& s, const std::string& end) {
  put("{} {{\n", s.operation == CsgOperation::unite       ? "merge"
                 : s.operation == CsgOperation::intersect ? "intersection"
                                                          : "difference");
  for (const CsgMember& member : s.of)
    std::visit(
        [&]<class Shape>(const Shape& shape) {
          if constexpr (!std::is_same_v<Shape, std::monostate>)
            write(shape, ending(member.material, member.transform));
        },
        member.body);
  put("{}", end);
}

void PovrayWriter::write(const Instance& s, const std::string& end) {
  put("object {{ Group{} {}", s.group, end);
}

template <class Shape>
void PovrayWriter::write_all(const std::vector<Object<Shape>>& objects) {
  // Primitives are in the world already, whatever their transform.
  for (const Object<Shape>& object : objects)
    write(object.shape, ending(object.material, is_body<Shape> ? object.transform : 0));
}

/// The triangles of each material as a mesh, which has a bounding hierarchy of its own, and an
/// inside that rays come into and out of.
void PovrayWriter::write_meshes(const ShapeLists& shapes) {
  struct Faces {
    std::vector<const Triangle*> flat;
    std::vector<const SmoothTriangle*> smooth;
  };
  std::map<std::uint32_t, Faces> of;
  for (const Object<Triangle>& object : shapes.triangles)
    of[object.material].flat.push_back(&object.shape);
  for (const Object<SmoothTriangle>& object : shapes.smooth_triangles)
    of[object.material].smooth.push_back(&object.shape);
  for (const auto& [material, mesh] : of) {
    put("mesh {{\n");
    for (const Triangle* triangle : mesh.flat) write(*triangle, "}\n");
    for (const SmoothTriangle* triangle : mesh.smooth) write(*triangle, "}\n");
    put("{}", ending(material, 0));
  }
}

void PovrayWriter::write_shapes(const ShapeLists& shapes) {
  write_all(shapes.spheres);
  write_all(shapes.cones);
  write_meshes(shapes);
#define ZRAKA_WRITE(Type, plural) write_all(shapes.plural);
  ZRAKA_BODIES(ZRAKA_WRITE)
#undef ZRAKA_WRITE
}

void PovrayWriter::write_groups() {
  // Groups before those that have instances of them: as often as there are groups is enough.
  std::vector<bool> done(scene_.groups.size());
  for (std::size_t round = 0; round < scene_.groups.size(); ++round) {
    bool is_done = true;
    for (std::size_t i = 0; i < scene_.groups.size(); ++i) {
      bool is_ready = !done[i];
      for (const Object<Instance>& inner : scene_.groups[i].instances)
        is_ready = is_ready && done[inner.shape.group];
      is_done = is_done && done[i];
      if (!is_ready) continue;
      done[i] = true;
      put("#declare Group{} = union {{\n", i);
      write_shapes(scene_.groups[i]);
      put("}}\n");
    }
    if (is_done) break;
  }
}

}  // namespace zraka
