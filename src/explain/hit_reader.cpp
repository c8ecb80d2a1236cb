// SPDX-License-Identifier: Apache-2.0
#include "explain/hit_reader.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

#include "accel/body_surface.hpp"
#include "explain/roundest.hpp"
#include "explain/shape_lookup.hpp"
#include "scene/bounds_of.hpp"
#include "shapes/bodies/csg.hpp"
#include "textures/texture_set.hpp"

namespace zraka {
namespace {

/// Which of a CSG body's members a body is, from 0.
std::size_t index_of_member(const FrozenBodies& bodies, std::int32_t whole, std::int32_t member) {
  const CsgNumbers csg{bodies.numbers + bodies.start[whole]};
  for (int i = 0; i < csg.members(); ++i)
    if (csg.member(i) == member) return static_cast<std::size_t>(i);
  return 0;
}

/// How far the engine's point may be off the one that it stands for, in its own frame.
double rounding_of(float v) {
  const float size = std::fabs(v);
  return static_cast<double>(std::nextafter(size, std::numeric_limits<float>::infinity()) - size) /
         2;
}

Vec3 roundest(const Vec3& p, double error) {
  return {roundest_within(p.x, error), roundest_within(p.y, error), roundest_within(p.z, error)};
}

double most_stretch(const Transform& t) {
  double square = 0;
  for (const Vec3& v : {t.along_x, t.along_y, t.along_z})
    square += v.x * v.x + v.y * v.y + v.z * v.z;
  return std::sqrt(square);
}

Float3 value_in_row(Coefficient coefficient, const float* row) {
  switch (coefficient) {
    case Coefficient::ambient:
      return {row[kAmbient], row[kAmbient + 1], row[kAmbient + 2]};
    case Coefficient::diffuse:
      return {row[kDiffuse], row[kDiffuse + 1], row[kDiffuse + 2]};
    case Coefficient::specular:
      return {row[kSpecular], row[kSpecular + 1], row[kSpecular + 2]};
    case Coefficient::shininess:
      return {row[kShininess], row[kShininess], row[kShininess]};
    case Coefficient::reflection:
      return {row[kReflection], row[kReflection], row[kReflection]};
    case Coefficient::refraction:
      return {row[kRefraction], row[kRefraction], row[kRefraction]};
  }
  return {};
}

}  // namespace

ExplainedTexture HitReader::texture(std::uint32_t index) const {
  const auto name = scene_.texture_names.find(index);
  return {index, scene_.textures[index].kind,
          name == scene_.texture_names.end() ? std::string() : name->second};
}

ExplainedPath HitReader::path(const HitPath* path) const {
  ExplainedPath way;
  if (path == nullptr) return way;
  for (int i = 0; i < path->depth; ++i) {
    const Home at = home(way);
    const ShapeId id =
        shape_in_slot(*at.shapes, *at.frozen, at.frozen->bodies.first_slot + path->instance[i]);
    const std::uint32_t group = instance_of(*at.shapes, id)->group;
    way.instances.push_back({named(*at.shapes, id), group, scene_.groups[group].name,
                             transform_at(scene_, transform_of(*at.shapes, id))});
  }
  const Home at = home(way);
  const ShapeId id = shape_in_slot(*at.shapes, *at.frozen, path->slot);
  if (path->depth > 0) way.inner = named(*at.shapes, id);
  const FrozenBodies& bodies = at.frozen->bodies;
  if (const Csg* const csg = csg_of(*at.shapes, id))
    way.member = member_of(scene_, *csg,
                           index_of_member(bodies, path->slot - bodies.first_slot, path->body));
  return way;
}

/// Where the shape at the end of a path stands.
HitReader::Home HitReader::home(const ExplainedPath& path) const {
  return path.instances.empty() ? Home{&scene_, &store_.scene} : group(path.instances.back().group);
}

/// The ray once more, in double, through the body that it has hit.
std::optional<ExplainedCrossings> HitReader::crossings(
    const ShapeId& shape, const ExplainedPath& path, const HitPath& from, const Level<float>& level,
    const Scratch<float>& scratch, std::size_t h, std::size_t ray) const {
  if (!path.member) return std::nullopt;
  const Home at = home(path);
  const FrozenBodies& bodies = at.frozen->bodies;
  const std::int32_t whole = from.slot - bodies.first_slot;
  const double(&m)[12] = from.to_frame;
  const Transform to_group =
      inverse({{m[0], m[1], m[2]}, {m[3], m[4], m[5]}, {m[6], m[7], m[8]}, {m[9], m[10], m[11]}})
          .value_or(Transform());
  const auto three = [&](const float* x, const float* y, const float* z) {
    const std::size_t i = static_cast<std::size_t>(level.done) + ray;
    return Vec3{static_cast<double>(x[i]), static_cast<double>(y[i]), static_cast<double>(z[i])};
  };
  // Directions keep their length, so that distances are the engine's.
  const RayArrays<float>& rays = level.rays;
  const Vec3 origin = moved(three(rays.ox, rays.oy, rays.oz), to_group);
  const Vec3 direction = turned(three(rays.dx, rays.dy, rays.dz), to_group);
  std::vector<CsgCrossing> found(kMostCsgCrossings);
  const int count =
      isa_oracle::csg_crossings(bodies, whole, vector_of(origin), vector_of(direction),
                                found.data(), static_cast<int>(found.size()));
  found.resize(std::min(found.size(), static_cast<std::size_t>(count)));

  ExplainedCrossings all{.starts_inside = scratch.inside[h] > 0};
  // The first behind which the ray is no longer where it began is the hit.
  const auto hit = std::find_if(found.begin(), found.end(), [&](const CsgCrossing& crossing) {
    return crossing.whole != all.starts_inside;
  });
  if (hit != found.end())
    found.erase(std::find_if(hit, found.end(),
                             [&](const CsgCrossing& crossing) { return crossing.t > hit->t; }),
                found.end());
  if (found.size() > kMostCrossingsKept) all.left_out = found.size() - kMostCrossingsKept;
  std::vector<std::size_t> listed;  // members, in the order of all.members
  for (std::size_t i = all.left_out; i < found.size(); ++i) {
    const std::size_t member = index_of_member(bodies, whole, found[i].body);
    const auto known = std::find(listed.begin(), listed.end(), member);
    all.all.push_back({frame_.world_length(found[i].t),
                       static_cast<std::size_t>(known - listed.begin()), found[i].enters,
                       found[i].whole});
    if (known != listed.end()) continue;
    listed.push_back(member);
    all.members.push_back(
        member_of(scene_, *csg_of(*at.shapes, path.inner ? path.inner->id : shape), member));
  }
  return all;
}

void HitReader::read_textures(const Scratch<float>& scratch, std::size_t h,
                              ExplainedHit& hit) const {
  if (store_.scene.textures == nullptr) return;
  const MaterialTextures& its = store_.scene.textures->of_material[scratch.material[h]];
  if (!its.any()) return;
  const TexturePoint& at = scratch.points[h];
  hit.own = {.point = roundest({at.point.x, at.point.y, at.point.z}, at.error),
             .uv = {{at.u, at.v}},
             .footprint = frame_.world_length(std::fabs(scratch.cones[h].width))};
  const float* const row = scratch.coefficients + scratch.row[h] * kMaterialReals;
  for (std::int32_t i = 0; i < its.use_count; ++i)
    hit.textures.push_back({its.uses[i].coefficient, texture(its.uses[i].texture),
                            value_in_row(its.uses[i].coefficient, row)});
  if (its.normals.kind != NormalUse::Kind::none)
    hit.bent = {its.normals.kind,
                texture(its.normals.texture),
                {scratch.smooth_x[h], scratch.smooth_y[h], scratch.smooth_z[h]}};
}

void HitReader::read(const Level<float>& level, const Scratch<float>& scratch, std::size_t h,
                     std::size_t ray, ExplainedHit& hit) const {
  const HitPath& from = scratch.paths[h];
  hit.path = path(&from);
  hit.crossings = crossings(hit.shape.id, hit.path, from, level, scratch, h, ray);
  read_textures(scratch, h, hit);

  const std::uint32_t own =
      transform_of(*home(hit.path).shapes, hit.path.inner ? hit.path.inner->id : hit.shape.id);
  Transform all = transform_at(scene_, own);
  if (hit.path.member) all = then(hit.path.member->transform, all);
  for (auto i = hit.path.instances.rbegin(); i != hit.path.instances.rend(); ++i)
    all = then(all, i->transform);
  if (all == Transform()) return;
  hit.transform = all;
  if (hit.own) return;
  const Transform to_own = inverse(all).value_or(Transform());
  const double error = frame_.world_length(std::max(
      {rounding_of(scratch.px[h]), rounding_of(scratch.py[h]), rounding_of(scratch.pz[h])}));
  hit.own = {.point = roundest(moved(hit.point, to_own), error * most_stretch(to_own))};
}

}  // namespace zraka
