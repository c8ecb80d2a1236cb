// SPDX-License-Identifier: Apache-2.0
#include "engine/coefficients.hpp"

#include <algorithm>
#include <cmath>
#include <cstring>

#include "accel/body_surface.hpp"
#include "engine/shape_spaces.hpp"
#include "engine/waiting_hits.hpp"
#include "scene/bounds_of.hpp"
#include "scene/reals.hpp"
#include "shapes/primitive_uv.hpp"
#include "textures/texture_set.hpp"

namespace zraka {
namespace {

constexpr double kEpsilon = 0x1p-23;  ///< what points in float err by, of their size, and a little

double length(const V3<double>& v) {
  return std::sqrt(dot(v, v));
}

template <class R>
V3<double> three(const R* x, const R* y, const R* z, std::size_t i) {
  return {static_cast<double>(x[i]), static_cast<double>(y[i]), static_cast<double>(z[i])};
}

/// What is known of a hit besides what light needs: in the frame of the group that its shape
/// stands in.
struct Found {
  BodySurface surface{};  ///< its tangents in that frame
  V3<double> point{};     ///< in that frame
};

/// What of it somebody wants to know, beside the transform.
struct Wanted {
  bool surface, curvature, footprint, unit;
};

/// The tables of one kind of primitive: where in it a slot is, and what it is there.
template <class R, class Shape>
bool find_primitive(const FrozenScene<R>& scene, const FrozenTextures& textures,
                    const FrozenShapes<R, Shape>& shapes, std::int32_t slot, std::int32_t transform,
                    Found& found) {
  const std::int32_t at = slot - shapes.first_slot;
  if (at < 0 || at >= shapes.count) return false;
  const std::int32_t index = shapes.id[at] - shapes.first_id;
  const FrozenMapping& mapping = shapes.mapping;
  double numbers[ShapeTraits<Shape>::kReals];
  for (int k = 0; k < ShapeTraits<Shape>::kReals; ++k)
    numbers[k] = static_cast<double>(shapes.column[k][at]);
  UvContext context;
  if (transform != 0) {
    const Transform& t = textures.to_shape[transform - 1];
    const double scale = 1 / scene.frame_scale;
    context.x = vector_of(t.along_x) * scale;
    context.y = vector_of(t.along_y) * scale;
    context.z = vector_of(t.along_z) * scale;
  }
  if (mapping.uvs != nullptr) context.uvs = mapping.uvs + index;
  const WholeTriangle* const end = mapping.wholes + mapping.whole_count;
  const WholeTriangle* const whole =
      std::lower_bound(mapping.wholes, end, index,
                       [](const WholeTriangle& t, std::int32_t i) { return t.index < i; });
  if (whole != end && whole->index == index) context.whole_corners = whole->corners;
  found.surface = uv_of(static_cast<const Shape*>(nullptr), numbers, found.point, context);
  return true;
}

template <class R>
void find_on_shape(const FrozenScene<R>& scene, const FrozenTextures& textures, const HitPath& path,
                   std::int32_t transform, Found& found) {
#define ZRAKA_FIND(Type, plural) \
  if (find_primitive(scene, textures, scene.plural, path.slot, transform, found)) return;
  ZRAKA_INLINED_KINDS(ZRAKA_FIND)
#undef ZRAKA_FIND
  found.surface = isa_oracle::on_body(scene.bodies, path.body, found.point);
}

/// One hit: where it is for textures, and how its normal may be bent.
struct Seen {
  TexturePoint& at;
  /// From the shape's space to the engine's frame: gradients there as they are here.
  const Transform& to_shape;
  V3<double> along_u{}, along_v{};  ///< in the engine's frame
  double unit = 1;                  ///< of the shape's space, in the engine's frame
};

/// The gradients of u and v over a surface, from its tangents and its normal.
struct UvGradients {
  V3<double> u, v;
  UvGradients(const V3<double>& along_u, const V3<double>& along_v, const V3<double>& n) {
    const V3<double> un = cross(along_v, n), vn = cross(n, along_u);
    const double det = dot(cross(along_u, along_v), n);
    const double scale = det != 0 ? 1 / det : 0;
    u = un * scale, v = vn * scale;
  }
};

/// A cone cuts the surface in an ellipse: as wide as it is across, longer where it comes flat.
void find_footprint(const Seen& seen, const V3<double>& normal, const V3<double>& view,
                    double width, TexturePoint& to) {
  const double facing = std::fmax(std::fabs(dot(view, normal)), 1e-6);
  const V3<double> slide = view - normal * dot(view, normal);
  const double slope = length(slide);
  V3<double> major = slope > 1e-9 ? slide * (1 / slope) : cross(normal, V3<double>{1, 0, 0});
  if (!(dot(major, major) > 0.5)) major = cross(normal, V3<double>{0, 1, 0});
  const V3<double> minor = cross(normal, major);
  const double half = std::fabs(width) / 2;
  const V3<double> axes[2] = {major * (half / facing), minor * half};
  const UvGradients slopes(seen.along_u, seen.along_v, normal);
  for (int i = 0; i < 2; ++i) {
    to.footprint[i] = vector_of(turned(vec3_of(axes[i]), seen.to_shape));
    to.footprint_u[i] = dot(slopes.u, axes[i]);
    to.footprint_v[i] = dot(slopes.v, axes[i]);
  }
}

/// How large the shape's space is here, and how far off the point may be in it.
void find_unit(const V3<double>& point, const V3<double>& normal, Seen& seen) {
  const auto largest = [](const V3<double>& v) {
    return std::fmax(std::fabs(v.x), std::fmax(std::fabs(v.y), std::fabs(v.z)));
  };
  TexturePoint& to = seen.at;
  seen.unit = 1 / length(vector_of(turned(vec3_of(normal), seen.to_shape)));
  to.error = (largest(point) + 0x1p-10) * kEpsilon / seen.unit + largest(to.point) * 0x1p-50;
}

template <class R>
Seen look(ShapeSpaces<R>& ways, LastShape<R>& shape, const FrozenTextures& textures,
          const HitPath& path, const V3<double>& point, const V3<double>& normal,
          const V3<double>& view, double width, const Wanted& wanted, TexturePoint& to) {
  ways.follow(path);
  shape.follow(ways.home(), path);
  Seen seen{to, ways.to_shape(shape.transform())};  // what nobody asks for stays as it is
  if (wanted.surface) {                             // many textures need a point alone
    // To the scene's own frame nothing moves, and no zero is left below 0.
    const Vec3 at = path.group == nullptr ? Vec3{point.x + 0.0, point.y + 0.0, point.z + 0.0}
                                          : moved(vec3_of(point), ways.to_group());
    Found found{.point = vector_of(at)};
    find_on_shape(ways.home(), textures, path, shape.transform(), found);
    seen.along_u = vector_of(turned(vec3_of(found.surface.along_u), ways.from_group()));
    seen.along_v = vector_of(turned(vec3_of(found.surface.along_v), ways.from_group()));
    to.u = found.surface.u, to.v = found.surface.v;
    to.v_ends = found.surface.v_ends;
  }
  to.point = vector_of(moved(vec3_of(point), seen.to_shape));
  if (wanted.footprint) find_footprint(seen, normal, view, width, to);
  to.error = 0;
  if (wanted.unit) find_unit(point, normal, seen);
  return seen;
}

/// How wide a ray's cone is at its hit.
template <class R>
double width_of_cone(const Level<R>& level, const Scratch<R>& scratch, std::size_t h) {
  const auto ray = static_cast<std::size_t>(level.hits.ray[h]);
  const std::size_t at = static_cast<std::size_t>(level.done) + ray;
  return static_cast<double>(level.rays.width[at]) +
         static_cast<double>(level.rays.spread[at]) * static_cast<double>(scratch.t[ray]);
}

/// The normal that a texture makes of a smooth one, on the side of the viewer.
V3<double> bent(const TextureSet& set, const NormalUse& use, const Seen& seen,
                const V3<double>& normal, const V3<double>& view) {
  V3<double> way = normal;
  if (use.kind == NormalUse::Kind::bump) {
    const V3<double> slope = set.slope(use.texture, seen.at);
    V3<double> rise;  // per unit of the engine's frame
    if (set.mapping(use.texture) == TextureMapping::uv) {
      const UvGradients slopes(seen.along_u, seen.along_v, normal);
      rise = slopes.u * slope.x + slopes.v * slope.y;
    } else {
      const Transform& t = seen.to_shape;
      rise = {dot(vector_of(t.along_x), slope), dot(vector_of(t.along_y), slope),
              dot(vector_of(t.along_z), slope)};
    }
    rise = rise * (use.height * seen.unit);
    way = normal - (rise - normal * dot(rise, normal));
  } else {
    const TextureValue m = set.value(use.texture, seen.at);
    const auto unit = [](const V3<double>& v) {
      const double l = length(v);
      return l > 0 ? v * (1 / l) : v;
    };
    // Red along u, green along v, blue along the normal (docs/textures.md).
    const V3<double> u = unit(seen.along_u - normal * dot(seen.along_u, normal));
    const V3<double> v = unit(seen.along_v - normal * dot(seen.along_v, normal));
    way = u * (2 * m.x - 1) + v * (2 * m.y - 1) + normal * (2 * m.z - 1);
  }
  const double size = length(way);
  if (!(size > 0) || !std::isfinite(size)) return normal;
  way = way * (1 / size);
  // What would look away from the viewer is turned until it only grazes: no light falls on a
  // normal from behind, and what is seen would be black.
  constexpr double kLeast = 0x1p-6;
  const double facing = dot(way, view);
  if (facing >= kLeast) return way;
  way = way + view * (kLeast - facing);
  return way * (1 / length(way));
}

}  // namespace

template <class R>
void find_coefficients(const FrozenScene<R>& scene, const Level<R>& level, Scratch<R>& scratch,
                       ColorHits<R>* color_hits) {
  const FrozenTextures& textures = *scene.textures;
  const auto n = static_cast<std::size_t>(level.hit_count);
  const auto begin = static_cast<std::size_t>(level.done);
  ShapeSpaces<R> ways(scene);
  LastShape<R> last;
  WaitingHits<R> waiting(scene, level, scratch, color_hits);
  TextureLookup known;
  TexturePoint own;  // of one hit after another
  for (std::size_t h = 0; h < n; ++h) {
    const std::int32_t material = scratch.material[h];
    const R* const from = scene.materials + std::ptrdiff_t{material} * kMaterialReals;
    R* const row = scratch.own_rows + h * kMaterialReals;
    std::memcpy(row, from, kMaterialReals * sizeof(R));
    const MaterialTextures& its = textures.of_material[material];
    const bool has_children =
        its.of_children || row[kReflection] != R(0) || row[kRefraction] != R(0);
    if (!its.any() && !has_children) {
      scratch.cones[h] = {0, 0};
      continue;
    }
    if (!scratch.explained && scratch.paths[h].group == nullptr) {
      if (its.in_lanes && color_hits != nullptr) {
        last.follow(scene, scratch.paths[h]);
        scratch.cones[h].curvature = has_children ? last.curvature() : 0;
        waiting.add(static_cast<std::int32_t>(h), material, last.transform());
        continue;
      }
      if (!its.any()) {
        last.follow(scene, scratch.paths[h]);
        scratch.cones[h] = {width_of_cone(level, scratch, h), last.curvature()};
        continue;
      }
    }
    const auto ray = static_cast<std::size_t>(level.hits.ray[h]);
    const V3<double> point = three(scratch.px, scratch.py, scratch.pz, h);
    const V3<double> view = three(scratch.vx, scratch.vy, scratch.vz, h);
    const double width = width_of_cone(level, scratch, h);
    const bool bends = its.normals.kind != NormalUse::Kind::none, all = scratch.explained;
    const Wanted wanted{its.sees_uv || all, has_children || all, its.sees_footprint || all,
                        its.has_borders || bends || all};
    V3<double> normal{};
    if (wanted.footprint || wanted.unit) {
      normal = three(scratch.nx, scratch.ny, scratch.nz, h);
      normal = normal * (1 / length(normal));
    }
    const Seen seen = look(ways, last, textures, scratch.paths[h], point, normal, view, width,
                           wanted, scratch.explained ? scratch.points[h] : own);
    scratch.cones[h] = {
        width, wanted.surface || wanted.curvature ? last.curvature() * ways.group_scale() : 0};
    seen.at.distance = (static_cast<double>(level.rays.travelled[begin + ray]) +
                        static_cast<double>(scratch.t[ray])) /
                       scene.frame_scale;
    known.start();
    for (std::int32_t i = 0; i < its.use_count; ++i)
      put(its.uses[i].coefficient, textures.set->value(its.uses[i].texture, seen.at, known), row);
    if (!bends) continue;
    if (scratch.smooth_x != nullptr) {
      scratch.smooth_x[h] = scratch.nx[h];
      scratch.smooth_y[h] = scratch.ny[h];
      scratch.smooth_z[h] = scratch.nz[h];
    }
    const V3<double> way = bent(*textures.set, its.normals, seen, normal, view);
    scratch.nx[h] = static_cast<R>(way.x);
    scratch.ny[h] = static_cast<R>(way.y);
    scratch.nz[h] = static_cast<R>(way.z);
  }
  waiting.color();
}

template <class R>
void spread_cones(const Level<R>& level, const Scratch<R>& scratch, Level<R>& next) {
  const auto n = static_cast<std::size_t>(level.hit_count);
  for (std::size_t h = 0; h < n; ++h) {
    if (level.hits.reflected[h] < 0 && level.hits.refracted[h] < 0) continue;
    const HitCone& cone = scratch.cones[h];
    const auto ray = static_cast<std::size_t>(level.done + level.hits.ray[h]);
    const R* const row = scratch.own_rows + h * kMaterialReals;
    const bool inside = scratch.inside[h] > R(0);
    const auto spread = static_cast<double>(level.rays.spread[ray]);
    // Over the cone's width the normal turns by `turn`, outwards where the surface bulges towards
    // the ray: a mirror spreads what it reflects by twice that, and a surface that refracts as
    // Snell's law for small angles has it. A lens draws a cone together, past its focus it widens
    // again: widths have a sign.
    const double turn = (inside ? -cone.curvature : cone.curvature) * cone.width;
    const auto put = [&](std::int32_t child, double wide) {
      if (child < 0) return;
      next.rays.width[child] = static_cast<R>(cone.width);
      next.rays.spread[child] = static_cast<R>(wide);
      next.rays.travelled[child] = level.rays.travelled[ray] + scratch.t[level.hits.ray[h]];
    };
    put(level.hits.reflected[h], spread + 2 * turn);
    const auto ratio = static_cast<double>(row[inside ? kRatioOut : kRatioIn]);
    put(level.hits.refracted[h], ratio * spread + (ratio - 1) * turn);
  }
}

template <class R>
void start_cones(const FrozenCamera<R>& camera, Level<R>& level) {
  const V3<double> right{static_cast<double>(camera.right.x), static_cast<double>(camera.right.y),
                         static_cast<double>(camera.right.z)};
  const V3<double> down{static_cast<double>(camera.down.x), static_cast<double>(camera.down.y),
                        static_cast<double>(camera.down.z)};
  const V3<double> first{static_cast<double>(camera.first.x), static_cast<double>(camera.first.y),
                         static_cast<double>(camera.first.z)};
  // A pixel as wide as the window's is where it is nearest to the eye; away from there it looks
  // smaller, which the cosine to the window's normal says.
  const V3<double> normal = cross(right, down);
  const double area = length(normal), away = std::fabs(dot(first, normal)) / area;
  const double spread = std::sqrt(area) / away;
  for (std::int32_t i = 0; i < level.ray_count; ++i) {
    const V3<double> d =
        three(level.rays.dx, level.rays.dy, level.rays.dz, static_cast<std::size_t>(i));
    const double cosine = std::fabs(dot(d, normal)) / area;
    level.rays.width[i] = R(0);
    level.rays.spread[i] = static_cast<R>(spread * cosine * std::sqrt(cosine));
    level.rays.travelled[i] = R(0);
  }
}

#define ZRAKA_FOR(R)                                                                   \
  template void find_coefficients(const FrozenScene<R>&, const Level<R>&, Scratch<R>&, \
                                  ColorHits<R>*);                                      \
  template void spread_cones(const Level<R>&, const Scratch<R>&, Level<R>&);           \
  template void start_cones(const FrozenCamera<R>&, Level<R>&);
ZRAKA_FOR_REALS(ZRAKA_FOR)
#undef ZRAKA_FOR

}  // namespace zraka
