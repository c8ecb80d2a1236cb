// SPDX-License-Identifier: Apache-2.0
// Shapes as Tachyon has them: all in the world, each with a material of its own, and what it does
// not know as triangles.
#include <algorithm>
#include <cmath>
#include <type_traits>

#include "formats/tachyon_output.hpp"
#include "formats/tessellate.hpp"
#include "formats/vectors.hpp"
#include "language/bake.hpp"
#include "scene/bounds_of.hpp"
#include "shapes/bodies.hpp"
#include "shapes/shapes.hpp"

namespace zraka {
namespace {

/// By which a map that keeps balls round stretches.
double stretch_of(const Transform& t) {
  return length(t.along_x);
}

bool is_upright(const Transform& t) {
  const auto alone = [](double own, double a, double b) { return own > 0 && a == 0 && b == 0; };
  return alone(t.along_x.x, t.along_x.y, t.along_x.z) &&
         alone(t.along_y.y, t.along_y.x, t.along_y.z) &&
         alone(t.along_z.z, t.along_z.x, t.along_z.y);
}

Vec3 normal_under(const Vec3& normal, const Transform& t) {
  const SmoothTriangle corner{{}, {}, {}, normal, normal, normal};
  return unit(language::baked(corner, t).normal_a);
}

Frustum solid(const Cone& s) {
  return {s.base, s.base_radius, s.apex, s.apex_radius, false};
}

}  // namespace

std::vector<const Cut*> TachyonWriter::planes_of(const Material& material) const {
  std::vector<const Cut*> planes;
  for (const Cut& cut : scene_.cuts)
    if (cut.group == 0 || cut.group == material.cut_group) planes.push_back(&cut);
  return planes;
}

/// What follows is clipped by these planes.
void TachyonWriter::clip(std::vector<const Cut*> planes) {
  if (planes == clipped_) return;
  if (!clipped_.empty()) put("END_CLIPGROUP\n");
  clipped_ = std::move(planes);
  if (clipped_.empty()) return;
  put("START_CLIPGROUP NUMPLANES {}", clipped_.size());
  for (const Cut* const cut : clipped_)
    put(" {} {} {} {}", cut->normal.x, cut->normal.y, cut->normal.z, dot(cut->normal, cut->point));
  put("\n");
}

void TachyonWriter::write_triangles(const AnyBody& body, const Place& place) {
  for (const SmoothTriangle& t : tessellated(body)) write(t, place);
}

void TachyonWriter::write_cylinder(const Vec3& base, const Vec3& top, double radius,
                                   const Place& place) {
  put("FCYLINDER ");
  put_value("BASE", moved(base, place.transform));
  put_value("APEX", moved(top, place.transform));
  put("RAD {} ", radius * stretch_of(place.transform));
  end(place);
}

void TachyonWriter::write_ring(const Vec3& center, const Vec3& normal, double inner, double outer,
                               const Place& place) {
  const double stretch = stretch_of(place.transform);
  put("RING ");
  put_value("CENTER", moved(center, place.transform));
  put_value("NORMAL",
            place.transform == Transform{} ? normal : normal_under(normal, place.transform));
  put("INNER {} OUTER {} ", inner * stretch, outer * stretch);
  end(place);
}

void TachyonWriter::write(const Sphere& s, const Place& place) {
  if (!keeps_balls(place.transform)) {
    losses_.count("shapes: squashed spheres, for which there are triangles", 1);
    return write_triangles(Ellipsoid{s.center, {s.radius, s.radius, s.radius}}, place);
  }
  put("SPHERE ");
  put_value("CENTER", moved(s.center, place.transform));
  put("RAD {} ", s.radius * stretch_of(place.transform));
  end(place);
}

void TachyonWriter::write(const Triangle& s, const Place& place) {
  put("TRI ");
  put_value("V0", moved(s.a, place.transform));
  put_value("V1", moved(s.b, place.transform));
  put_value("V2", moved(s.c, place.transform));
  end(place);
}

void TachyonWriter::write(const SmoothTriangle& given, const Place& place) {
  const SmoothTriangle s =
      place.transform == Transform{} ? given : language::baked(given, place.transform);
  put("STRI ");
  put_value("V0", s.a);
  put_value("V1", s.b);
  put_value("V2", s.c);
  put_value("N0", s.normal_a);
  put_value("N1", s.normal_b);
  put_value("N2", s.normal_c);
  end(place);
}

void TachyonWriter::write(const Cone& s, const Place& place) {
  if (s.base_radius == s.apex_radius && keeps_balls(place.transform))
    return write_cylinder(s.base, s.apex, s.base_radius, place);
  losses_.count("shapes: cones, for which there are triangles", 1);
  write_triangles(solid(s), place);
}

void TachyonWriter::write(const Plane& s, const Place& place) {
  put("PLANE ");
  put_value("CENTER", moved(s.point, place.transform));
  put_value("NORMAL",
            place.transform == Transform{} ? s.normal : normal_under(s.normal, place.transform));
  end(place);
}

void TachyonWriter::write(const Box& s, const Place& place) {
  losses_.count("shapes: the round edges of boxes", s.radius > 0);
  if (!is_upright(place.transform)) return write_triangles(s, place);
  put("BOX ");
  put_value("MIN", moved(s.min, place.transform));
  put_value("MAX", moved(s.max, place.transform));
  end(place);
}

void TachyonWriter::write(const Frustum& s, const Place& place) {
  if (s.base_radius != s.top_radius || !keeps_balls(place.transform)) {
    losses_.count("shapes: cones, for which there are triangles", 1);
    return write_triangles(s, place);
  }
  write_cylinder(s.base, s.top, s.base_radius, place);
  if (!s.caps) return;
  write_ring(s.base, s.base - s.top, 0, s.base_radius, place);
  write_ring(s.top, s.top - s.base, 0, s.top_radius, place);
}

void TachyonWriter::write(const Disc& s, const Place& place) {
  if (keeps_balls(place.transform))
    return write_ring(s.center, s.normal, s.inner_radius, s.radius, place);
  losses_.count("shapes: squashed discs, for which there are triangles", 1);
  write_triangles(s, place);
}

void TachyonWriter::write(const Parallelogram& s, const Place& place) {
  const Vec3 b = s.corner + s.edge_u, d = s.corner + s.edge_v, c = b + s.edge_v;
  write(Triangle{s.corner, b, c}, place);
  write(Triangle{s.corner, c, d}, place);
}

void TachyonWriter::write(const Capsule& s, const Place& place) {
  const bool is_clear = scene_.materials[place.material].refraction.most() > 0;
  if (is_clear || !keeps_balls(place.transform)) {
    losses_.count("shapes: capsules, for which there are triangles", 1);
    return write_triangles(s, place);
  }
  write_cylinder(s.base, s.top, s.radius, place);
  write(Sphere{s.base, s.radius}, place);
  write(Sphere{s.top, s.radius}, place);
}

void TachyonWriter::write(const Instance& s, const Place& place) {
  write_shapes(scene_.groups[s.group], place);
}

template <class Body>
void TachyonWriter::write(const Body& body, const Place& place) {
  const AnyBody any(body);
  const char* const name = ShapeTraits<Body>::kName;
  if (tessellated(any).empty()) return losses_.count(fmt::format("shapes: {}", name), 1);
  losses_.count(fmt::format("shapes: {}, for which there are triangles", name), 1);
  write_triangles(any, place);
}

template <class Shape>
void TachyonWriter::write_all(const std::vector<Object<Shape>>& objects, const Place& place) {
  for (const Object<Shape>& object : objects) {
    Place own = place;
    if (object.material != kMaterialOfWhole) own.material = object.material;
    // Primitives are moved already.
    if (is_body<Shape> && object.transform != 0)
      own.transform = then(scene_.transforms[object.transform - 1], place.transform);
    if (!scene_.cuts.empty()) clip(planes_of(scene_.materials[own.material]));
    write(object.shape, own);
  }
}

double TachyonWriter::count_shapes(const ShapeLists& shapes) {
  double all = static_cast<double>(shapes.shape_count());
  for (const Object<Instance>& instance : shapes.instances) {
    double& own = group_shapes_[instance.shape.group];
    if (own < 0) own = 0, own = count_shapes(scene_.groups[instance.shape.group]);
    all += own;
  }
  return all;
}

void TachyonWriter::write_shapes(const ShapeLists& shapes, const Place& place) {
  // Lights have spheres of their own.
  if (&shapes == &scene_ && std::find(shines_.begin(), shines_.end(), true) != shines_.end()) {
    for (const Object<Sphere>& object : shapes.spheres) {
      const auto is_its = [&](const Light& light) {
        return !light.is_surface() && light.kind != LightKind::directional &&
               light.position == object.shape.center && seen_radius(light) == object.shape.radius;
      };
      if (shines_[object.material] &&
          std::any_of(scene_.lights.begin(), scene_.lights.end(), is_its))
        continue;
      Place own = place;
      own.material = object.material;
      if (!scene_.cuts.empty()) clip(planes_of(scene_.materials[own.material]));
      write(object.shape, own);
    }
  } else {
    write_all(shapes.spheres, place);
  }
  write_all(shapes.triangles, place);
  write_all(shapes.smooth_triangles, place);
  write_all(shapes.cones, place);
#define ZRAKA_WRITE(Type, plural) write_all(shapes.plural, place);
  ZRAKA_BODIES(ZRAKA_WRITE)
#undef ZRAKA_WRITE
}

}  // namespace zraka
