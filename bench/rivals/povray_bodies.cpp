// SPDX-License-Identifier: Apache-2.0
#include "povray_bodies.hpp"

#include <cmath>
#include <type_traits>

namespace zraka::rivals {
namespace {

std::string vector(const Vec3& v) {
  return fmt::format("<{:.12g},{:.12g},{:.12g}>", v.x, v.y, v.z);
}

std::string matrix(const Transform& t) {
  return fmt::format("matrix <{:.12g},{:.12g},{:.12g}, {:.12g},{:.12g},{:.12g}, "
                     "{:.12g},{:.12g},{:.12g}, {:.12g},{:.12g},{:.12g}>",
                     t.along_x.x, t.along_x.y, t.along_x.z, t.along_y.x, t.along_y.y, t.along_y.z,
                     t.along_z.x, t.along_z.y, t.along_z.z, t.origin.x, t.origin.y, t.origin.z);
}

/// An object while it is written: what stands between its numbers and the closing brace.
struct Ending {
  const Scene& scene;
  TextureOf texture;
  std::uint32_t material, transform;

  std::string str() const {
    std::string text;
    if (material != kMaterialOfWhole) text += texture(material);
    if (transform != 0) text += ' ', text += matrix(scene.transforms[transform - 1]);
    return text + " }\n";
  }
};

void write(const Ellipsoid& s, const Ending& end, Text& out) {
  out.add("sphere {{ 0, 1 scale {} translate {} {}", vector(s.radii), vector(s.center), end.str());
}
void write(const Box& s, const Ending& end, Text& out) {
  if (!(s.radius > 0)) return out.add("box {{ {}, {} {}", vector(s.min), vector(s.max), end.str());
  const Vec3 r{s.radius, s.radius, s.radius}, a = s.min + r, b = s.max - r;
  out.add("merge {{\n");
  for (int axis = 0; axis < 3; ++axis) {
    Vec3 low = a, high = b;
    (axis == 0 ? low.x : axis == 1 ? low.y : low.z) -= s.radius;
    (axis == 0 ? high.x : axis == 1 ? high.y : high.z) += s.radius;
    out.add("box {{ {}, {} }}\n", vector(low), vector(high));
    for (int corner = 0; corner < 4; ++corner) {
      const bool one = (corner & 1) != 0, two = (corner & 2) != 0;
      Vec3 from = axis == 0   ? Vec3{a.x, one ? b.y : a.y, two ? b.z : a.z}
                  : axis == 1 ? Vec3{one ? b.x : a.x, a.y, two ? b.z : a.z}
                              : Vec3{one ? b.x : a.x, two ? b.y : a.y, a.z};
      Vec3 to = from;
      (axis == 0 ? to.x : axis == 1 ? to.y : to.z) = axis == 0 ? b.x : axis == 1 ? b.y : b.z;
      out.add("cylinder {{ {}, {}, {:.12g} }}\n", vector(from), vector(to), s.radius);
      if (axis == 0)
        out.add("sphere {{ {}, {:.12g} }} sphere {{ {}, {:.12g} }}\n", vector(from), s.radius,
                vector(to), s.radius);
    }
  }
  out.add("{}", end.str());
}
void write(const Plane& s, const Ending& end, Text& out) {
  out.add("plane {{ {}, 0 translate {} {}", vector(s.normal), vector(s.point), end.str());
}
void write(const Parallelogram& s, const Ending& end, Text& out) {
  const Vec3 b = s.corner + s.edge_u, c = b + s.edge_v, d = s.corner + s.edge_v;
  out.add("polygon {{ 5, {}, {}, {}, {}, {} {}", vector(s.corner), vector(b), vector(c), vector(d),
          vector(s.corner), end.str());
}
void write(const Disc& s, const Ending& end, Text& out) {
  out.add("disc {{ {}, {}, {:.12g}, {:.12g} {}", vector(s.center), vector(s.normal), s.radius,
          s.inner_radius, end.str());
}
void write(const Frustum& s, const Ending& end, Text& out) {
  out.add("cone {{ {}, {:.12g}, {}, {:.12g} {} {}", vector(s.base), s.base_radius, vector(s.top),
          s.top_radius, s.caps ? "" : "open", end.str());
}
void write(const Capsule& s, const Ending& end, Text& out) {
  out.add("merge {{ cylinder {{ {}, {}, {:.12g} }} sphere {{ {}, {:.12g} }} sphere {{ {}, {:.12g} }} {}",
          vector(s.base), vector(s.top), s.radius, vector(s.base), s.radius, vector(s.top), s.radius,
          end.str());
}
void write(const Torus& s, const Ending& end, Text& out) {
  // POV-Ray's torus lies round y: turned like any frame whose y is the axis.
  const Vec3 n = s.normal * (1 / std::sqrt(dot(s.normal, s.normal)));
  Vec3 x = std::fabs(n.y) < 0.9 ? cross(Vec3{0, 1, 0}, n) : cross(Vec3{0, 0, 1}, n);
  x = x * (1 / std::sqrt(dot(x, x)));
  const Transform turn{x, n, cross(x, n), s.center};
  out.add("torus {{ {:.12g}, {:.12g} sturm {} {}", s.radius, s.tube_radius, matrix(turn), end.str());
}
void write(const Quadric& s, const Ending& end, Text& out) {
  const auto& c = s.coefficients;
  out.add("quadric {{ <{:.12g},{:.12g},{:.12g}>, <{:.12g},{:.12g},{:.12g}>, "
          "<{:.12g},{:.12g},{:.12g}>, {:.12g} clipped_by {{ box {{ {}, {} }} }} {}",
          c[0], c[1], c[2], c[3], c[4], c[5], c[6], c[7], c[8], c[9], vector(s.min), vector(s.max),
          end.str());
}
void write(const Superellipsoid& s, const Ending& end, Text& out) {
  out.add("superellipsoid {{ <{:.12g},{:.12g}> scale {} translate {} {}", s.e, s.n, vector(s.radii),
          vector(s.center), end.str());
}
void write(const Csg& s, const Ending& end, Text& out) {
  out.add("{} {{\n", s.operation == CsgOperation::unite       ? "merge"
                     : s.operation == CsgOperation::intersect ? "intersection"
                                                              : "difference");
  for (const CsgMember& member : s.of)
    std::visit(
        [&]<class Shape>(const Shape& shape) {
          if constexpr (!std::is_same_v<Shape, std::monostate>)
            write(shape, Ending{end.scene, end.texture, member.material, member.transform}, out);
        },
        member.body);
  out.add("{}", end.str());
}
void write(const Instance& s, const Ending& end, Text& out) {
  out.add("object {{ Group{} {}", s.group, end.str());
}

void write(const Sphere& s, const Ending& end, Text& out) {
  out.add("sphere {{ {}, {:.12g} {}", vector(s.center), s.radius, end.str());
}
void write(const Cone& s, const Ending& end, Text& out) {
  out.add("cone {{ {}, {:.12g}, {}, {:.12g} open {}", vector(s.base), s.base_radius, vector(s.apex),
          s.apex_radius, end.str());
}
void write(const Triangle& s, const Ending& end, Text& out) {
  out.add("triangle {{ {}, {}, {} {}", vector(s.a), vector(s.b), vector(s.c), end.str());
}
void write(const SmoothTriangle& s, const Ending& end, Text& out) {
  out.add("smooth_triangle {{ {}, {}, {}, {}, {}, {} {}", vector(s.a), vector(s.normal_a),
          vector(s.b), vector(s.normal_b), vector(s.c), vector(s.normal_c), end.str());
}

void add_all(const Scene& scene, const ShapeLists& shapes, TextureOf texture, bool with_primitives,
             Text& out) {
  if (with_primitives) {
    // Primitives are in the world already, whatever their transform.
#define ZRAKA_WRITE(Type, plural)           \
  for (const auto& object : shapes.plural) \
    write(object.shape, Ending{scene, texture, object.material, 0}, out);
    ZRAKA_PRIMITIVES(ZRAKA_WRITE)
#undef ZRAKA_WRITE
  }
#define ZRAKA_WRITE(Type, plural)           \
  for (const auto& object : shapes.plural) \
    write(object.shape, Ending{scene, texture, object.material, object.transform}, out);
  ZRAKA_BODIES(ZRAKA_WRITE)
#undef ZRAKA_WRITE
}

}  // namespace

void add_bodies(const Scene& scene, TextureOf texture, Text& out) {
  // Groups before those that have instances of them: as often as there are groups is enough.
  std::vector<bool> done(scene.groups.size());
  for (std::size_t round = 0; round < scene.groups.size(); ++round)
    for (std::size_t i = 0; i < scene.groups.size(); ++i) {
      bool ready = !done[i];
      for (const Object<Instance>& inner : scene.groups[i].instances)
        ready = ready && done[inner.shape.group];
      if (!ready) continue;
      done[i] = true;
      out.add("#declare Group{} = union {{\n", i);
      add_all(scene, scene.groups[i], texture, true, out);
      out.add("}}\n");
    }
  add_all(scene, scene, texture, false, out);
}

}  // namespace zraka::rivals
