// SPDX-License-Identifier: Apache-2.0
#include "scene/bounds_of.hpp"

#include <algorithm>
#include <cmath>

namespace zraka {

double least_stretch(const Transform& to_own) {
  const auto square = [](const Vec3& v) { return v.x * v.x + v.y * v.y + v.z * v.z; };
  return 1 / std::sqrt(square(to_own.along_x) + square(to_own.along_y) + square(to_own.along_z));
}

std::optional<Transform> inverse(const Transform& t) {
  // Scaled first: determinants of what is small or large leave the range of doubles.
  double largest = 0;
  for (const Vec3& v : {t.along_x, t.along_y, t.along_z})
    largest = std::max({largest, std::fabs(v.x), std::fabs(v.y), std::fabs(v.z)});
  if (!(largest > 0) || !std::isfinite(largest)) return std::nullopt;
  const V3<double> x = vector_of(t.along_x) * (1 / largest), y = vector_of(t.along_y) * (1 / largest),
                   z = vector_of(t.along_z) * (1 / largest);
  const V3<double> yz = cross(y, z), zx = cross(z, x), xy = cross(x, y);
  const double determinant = dot(x, yz);
  const auto length = [](const V3<double>& v) { return std::sqrt(dot(v, v)); };
  // What is left of it by rounding alone is nothing.
  if (!(std::fabs(determinant) > 0x1p-45 * length(x) * length(y) * length(z))) return std::nullopt;
  const double scale = 1 / determinant / largest;
  const Transform linear{{yz.x * scale, zx.x * scale, xy.x * scale},
                         {yz.y * scale, zx.y * scale, xy.y * scale},
                         {yz.z * scale, zx.z * scale, xy.z * scale},
                         {}};
  Transform all = linear;
  const Vec3 back = turned(t.origin, linear);
  all.origin = {back.x * -1, back.y * -1, back.z * -1};
  return all;
}

Bounds moved(const Bounds& box, const Transform& t) {
  if (box.empty()) return box;
  if (!box.bounded()) return Bounds::everything();
  const Vec3 middle{box.lower.x / 2 + box.upper.x / 2, box.lower.y / 2 + box.upper.y / 2,
                    box.lower.z / 2 + box.upper.z / 2};
  const Vec3 half{box.upper.x - middle.x, box.upper.y - middle.y, box.upper.z - middle.z};
  const Vec3 at = moved(middle, t);
  const auto reach = [&](double Vec3::*axis) {
    return std::fabs(t.along_x.*axis) * half.x + std::fabs(t.along_y.*axis) * half.y +
           std::fabs(t.along_z.*axis) * half.z;
  };
  const Vec3 r{reach(&Vec3::x), reach(&Vec3::y), reach(&Vec3::z)};
  return {{at.x - r.x, at.y - r.y, at.z - r.z}, {at.x + r.x, at.y + r.y, at.z + r.z}};
}

bool keeps_balls(const Transform& t) {
  const V3<double> x = vector_of(t.along_x), y = vector_of(t.along_y), z = vector_of(t.along_z);
  const double xx = dot(x, x), yy = dot(y, y), zz = dot(z, z);
  const double most = std::max({xx, yy, zz}), slack = most * 0x1p-40;
  return most > 0 && most - std::min({xx, yy, zz}) <= slack && std::fabs(dot(x, y)) <= slack &&
         std::fabs(dot(y, z)) <= slack && std::fabs(dot(z, x)) <= slack;
}

Whereabouts::Whereabouts(const Scene& scene)
    : scene_(scene), groups_(scene.groups.size()), known_(scene.groups.size()) {
  for (std::uint32_t i = 0; i < scene.groups.size(); ++i) look_at(i);
}

void Whereabouts::look_at(std::uint32_t group) {
  if (known_[group]) return;
  known_[group] = true;
  for (const Object<Instance>& object : scene_.groups[group].instances) look_at(object.shape.group);
  groups_[group] = bounds_of_all(scene_.groups[group]);
}

Bounds Whereabouts::bounds_of_all(const ShapeLists& shapes) const {
  Bounds all;
#define ZRAKA_INCLUDE(Type, plural) \
  for (const auto& object : shapes.plural) all.include(bounds(object));
  ZRAKA_SHAPES(ZRAKA_INCLUDE)
#undef ZRAKA_INCLUDE
  return all;
}

Bounds Whereabouts::bounds(const Csg& csg, const Transform& transform) const {
  Bounds all;
  bool first = true;
  for (const CsgMember& member : csg.of) {
    const Bounds box = std::visit(
        [&]<class Shape>(const Shape& shape) -> Bounds {
          if constexpr (std::is_same_v<Shape, std::monostate>)
            return {};
          else
            return bounds(shape, then(this->transform(member.transform), transform));
        },
        member.body);
    if (first || csg.operation == CsgOperation::unite) {
      all.include(box);
    } else if (csg.operation == CsgOperation::intersect) {
      all.lower = {std::max(all.lower.x, box.lower.x), std::max(all.lower.y, box.lower.y),
                   std::max(all.lower.z, box.lower.z)};
      all.upper = {std::min(all.upper.x, box.upper.x), std::min(all.upper.y, box.upper.y),
                   std::min(all.upper.z, box.upper.z)};
    }
    first = false;
  }
  // Nothing is left: somewhere in it all the same.
  if (!(all.lower.x <= all.upper.x && all.lower.y <= all.upper.y && all.lower.z <= all.upper.z))
    all.lower = all.upper = transform.origin;
  return all;
}

Bounds Whereabouts::bounds(const Instance& instance, const Transform& transform) const {
  const Bounds& box = groups_[instance.group];
  if (box.empty()) return {transform.origin, transform.origin};
  return moved(box, transform);
}

double Whereabouts::distance(const Csg& csg, const Transform& transform, const Vec3& point) const {
  double least = Bounds::kInfinity;
  for (const CsgMember& member : csg.of)
    std::visit(
        [&]<class Shape>(const Shape& shape) {
          if constexpr (!std::is_same_v<Shape, std::monostate>)
            least = std::min(
                least, distance(shape, then(this->transform(member.transform), transform), point));
        },
        member.body);
  const double outside = bounds(csg, transform).distance_to(point);
  return std::max(least, outside);
}

double Whereabouts::distance(const Instance& instance, const Transform& transform,
                             const Vec3& point) const {
  const double outside = bounds(instance, transform).distance_to(point);
  const std::optional<Transform> to_own = inverse(transform);
  const Group& group = scene_.groups[instance.group];
  // Groups that hold groups, or a great many shapes, would take too long to ask from within: a
  // distance may be less than it is.
  constexpr std::uint64_t kMostAsked = 100'000;
  if (outside > 0 || !to_own || !group.instances.empty() || group.shape_count() > kMostAsked)
    return outside;
  const Vec3 own = moved(point, *to_own);
  double least = Bounds::kInfinity;
#define ZRAKA_NEAREST(Type, plural) \
  for (const auto& object : group.plural) least = std::min(least, distance(object, own));
  ZRAKA_SHAPES(ZRAKA_NEAREST)
#undef ZRAKA_NEAREST
  return least * least_stretch(*to_own);
}

}  // namespace zraka
