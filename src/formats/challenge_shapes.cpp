// SPDX-License-Identifier: Apache-2.0
// The Challenge's shapes: unit shapes that transforms put in their places, groups, CSG and OBJ
// files.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "core/text.hpp"
#include "formats/challenge.hpp"
#include "formats/vectors.hpp"
#include "mesh/mesh.hpp"
#include "scene/bounds_of.hpp"

namespace zraka {
namespace {

/// What goes on for ever ends here.
constexpr double kFar = 1000;
constexpr int kDeepestGroups = 32;

}  // namespace

std::string ChallengeReader::kind_of(const Node& item) {
  const Node* kind = item.find("add");
  if (kind == nullptr) kind = item.find("type");
  return kind == nullptr ? "" : kind->text;
}

bool ChallengeReader::may_add(const Node& at) {
  constexpr std::uint64_t kMost = 2'000'000;
  if (scene_.shape_count() < kMost) return true;
  fail(at, fmt::format("the scene has more than {} shapes", kMost));
  return false;
}

std::optional<AnyBody> ChallengeReader::body_of(std::string_view kind, const Node& item,
                                                bool is_member) {
  if (kind == "sphere") return Ellipsoid{};
  if (kind == "cube") return Box{{-1, -1, -1}, {1, 1, 1}};
  if (kind == "plane") return Plane{};
  if (kind != "cylinder" && kind != "cone") return std::nullopt;
  const auto low = number(item, "min", -kFar), high = number(item, "max", kFar);
  if (!low || !high) return std::nullopt;
  const double from = std::clamp(*low, -kFar, kFar), to = std::clamp(*high, -kFar, kFar);
  if (!(from < to)) {
    fail(item,
         fmt::format("min of a {} is {} and max {}: expected less and more", kind, *low, *high));
    return std::nullopt;
  }
  const bool is_closed = flag(item, "closed", false);
  if (is_member && !is_closed)
    warn(item, fmt::format("a {} of csg is closed, whatever it says", kind));
  const bool is_cone = kind == "cone";
  if (is_cone && from < 0 && to > 0 && is_member) {
    fail(item, "a double cone can be no part of csg: expected min or max to be 0");
    return std::nullopt;
  }
  return Frustum{{0, from, 0},
                 is_cone ? std::fabs(from) : 1,
                 {0, to, 0},
                 is_cone ? std::fabs(to) : 1,
                 is_closed || is_member};
}

/// Both halves of a double cone, which meet in a point.
bool ChallengeReader::add_cone(const Node& item, const Place& place) {
  const auto low = number(item, "min", -kFar), high = number(item, "max", kFar);
  if (!low || !high || !(*low < 0 && *high > 0)) return false;
  const double from = std::max(*low, -kFar), to = std::min(*high, kFar);
  const bool is_closed = flag(item, "closed", false);
  const std::uint32_t material = material_of(item, place);
  shapes_.add_body(scene_.frustums, Frustum{{0, from, 0}, -from, {0, 0, 0}, 0, false}, material,
                   place.world);
  shapes_.add_body(scene_.frustums, Frustum{{0, 0, 0}, 0, {0, to, 0}, to, false}, material,
                   place.world);
  if (!is_closed) return true;
  shapes_.add_body(scene_.discs, Disc{{0, from, 0}, {0, -1, 0}, -from}, material, place.world);
  shapes_.add_body(scene_.discs, Disc{{0, to, 0}, {0, 1, 0}, to}, material, place.world);
  return true;
}

void ChallengeReader::add_body(std::string_view kind, const Node& item, const Place& place) {
  if (kind == "cone" && add_cone(item, place)) return;
  const std::optional<AnyBody> body = body_of(kind, item, false);
  if (!body) {
    if (errors_.empty())
      fail(
          item, fmt::format("'{}' is no kind of shape, and not defined before this", shown(kind)),
          "kinds: plane, sphere, cube, cylinder, cone, triangle, smooth-triangle, group, csg, obj");
    return;
  }
  const std::uint32_t material = material_of(item, place);
  if (kind == "sphere") return shapes_.add_sphere({}, 1, material, place.world);
  if (const Box* const box = std::get_if<Box>(&*body))
    shapes_.add_body(scene_.boxes, *box, material, place.world);
  if (const Plane* const plane = std::get_if<Plane>(&*body))
    shapes_.add_body(scene_.planes, *plane, material, place.world);
  if (const Frustum* const frustum = std::get_if<Frustum>(&*body))
    shapes_.add_body(scene_.frustums, *frustum, material, place.world);
}

void ChallengeReader::add_mesh(const Node& item, const Place& place) {
  const Node* const file = item.find("file");
  if (file == nullptr) return fail(item, "obj has no file");
  const Result<std::string> path =
      has_folder_ ? folder_.path_of(file->text)
                  : Result<std::string>(failure("", "files beside the scene need a folder"));
  Result<Mesh> mesh = path ? read_mesh(*path) : tl::make_unexpected(path.error());
  if (!mesh) return fail(*file, fmt::format("{}: {}", shown(file->text), mesh.error()[0].message));
  if (!mesh->normals.empty()) mesh->add_normals();
  const std::uint32_t material = material_of(item, place);
  for (const Mesh::Triangle& t : mesh->triangles) {
    const auto point = [&](std::size_t k) { return mesh->points[t[k].point]; };
    const auto normal = [&](std::size_t k) { return mesh->normals[t[k].normal]; };
    if (mesh->normals.empty())
      shapes_.add_triangle(Triangle{point(0), point(1), point(2)}, material, place.world);
    else
      shapes_.add_triangle(
          SmoothTriangle{point(0), point(1), point(2), normal(0), normal(1), normal(2)}, material,
          place.world);
  }
}

std::optional<CsgMember> ChallengeReader::member_of(const Node& given, const Place& place) {
  const Node item = expanded(given);
  const std::string kind = kind_of(item);
  Place own = place;
  own.material = material_of(item, place);
  ++own.depth;
  CsgMember member;
  const Transform t = transform_of(item.find("transform"));
  member.transform = shapes_.index_of(t);
  member.material = own.material;
  if (own.depth > kDeepestGroups || !inverse(t)) {
    fail(item, own.depth > kDeepestGroups ? "csg is too deep in itself"
                                          : "a transform makes a shape flat");
    return std::nullopt;
  }
  if (kind != "csg") {
    const std::optional<AnyBody> body = body_of(kind, item, true);
    if (!body && errors_.empty())
      fail(item, fmt::format("'{}' can be no part of csg", shown(kind)),
           "parts: plane, sphere, cube, cylinder, cone, csg");
    if (!body) return std::nullopt;
    member.body = *body;
    return member;
  }
  Csg csg;
  const Node* const operation = item.find("operation");
  const std::string word = operation == nullptr ? "" : operation->text;
  csg.operation = word == "difference"     ? CsgOperation::subtract
                  : word == "intersection" ? CsgOperation::intersect
                                           : CsgOperation::unite;
  if (word != "difference" && word != "intersection" && word != "union")
    fail(item, "csg has no operation: expected union, intersection or difference");
  for (const char* side : {"left", "right"}) {
    const Node* const part = item.find(side);
    if (part == nullptr) {
      fail(item, fmt::format("csg has no {}", side));
      return std::nullopt;
    }
    std::optional<CsgMember> made = member_of(*part, own);
    if (!made) return std::nullopt;
    csg.of.push_back(std::move(*made));
  }
  member.body = std::move(csg);
  return member;
}

void ChallengeReader::add_csg(const Node& item, const Place& place) {
  // The item's own transform is in the place already.
  Node bare = item;
  std::erase_if(bare.members, [](const auto& member) { return member.first == "transform"; });
  std::optional<CsgMember> made = member_of(bare, place);
  if (made) shapes_.add_body(scene_.csgs, std::get<Csg>(made->body), made->material, place.world);
}

void ChallengeReader::add_shape(const Node& given, const Place& place) {
  const Node item = expanded(given);
  if (!errors_.empty() || !may_add(item)) return;
  const std::string kind = kind_of(item);
  Place own = place;
  own.world = then(transform_of(item.find("transform")), place.world);
  if (!errors_.empty()) return;
  if (!inverse(own.world))
    return fail(item, fmt::format("the transform of a {} makes it flat", kind));
  if (kind == "group") {
    own.material = material_of(item, place);
    own.has_shadow = flag(item, "shadow", true) && place.has_shadow;
    own.depth = item.find("material") != nullptr || place.depth > 0 ? place.depth + 1 : 0;
    if (++nesting_ > kDeepestGroups) fail(item, "groups are too deep in each other");
    if (const Node* const children = item.find("children"); errors_.empty() && children != nullptr)
      for (const Node& child : children->items) add_shape(child, own);
    --nesting_;
    return;
  }
  if (kind == "csg") return add_csg(item, own);
  if (kind == "obj") return add_mesh(item, own);
  if (kind == "triangle" || kind == "smooth-triangle") {
    const Vec3 a = vector(item, "p1", {0, 1, 0}), b = vector(item, "p2", {-1, 0, 0}),
               c = vector(item, "p3", {1, 0, 0});
    const std::uint32_t material = material_of(item, own);
    if (item.find("n1") == nullptr)
      return shapes_.add_triangle(Triangle{a, b, c}, material, own.world);
    return shapes_.add_triangle(SmoothTriangle{a, b, c, vector(item, "n1", {}),
                                               vector(item, "n2", {}), vector(item, "n3", {})},
                                material, own.world);
  }
  add_body(kind, item, own);
}

}  // namespace zraka
