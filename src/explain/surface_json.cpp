// SPDX-License-Identifier: Apache-2.0
#include "explain/surface_json.hpp"

#include <charconv>

#include "explain/names.hpp"
#include "explain/surface_words.hpp"

namespace zraka {
namespace {

constexpr const char* kOperationKeys[] = {"union", "intersection", "difference"};
constexpr const char* kNormalKinds[] = {"", "bump", "normal_map"};

Json transform_json(const Transform& t) {
  return {{"x", point_json(t.along_x)},
          {"y", point_json(t.along_y)},
          {"z", point_json(t.along_z)},
          {"origin", point_json(t.origin)}};
}

Json instance_json(const ExplainedInstance& instance) {
  Json json = shape_json(instance.shape);
  json["group"] = std::uint64_t{instance.group} + 1;
  if (!instance.group_name.empty()) json["group_name"] = instance.group_name;
  json["transform"] = transform_json(instance.transform);
  return json;
}

Json member_json(const ExplainedMember& member) {
  Json json = {{"member", position_of(member)}, {"shape", noun_of(Language::english, member.kind)}};
  if (!member.name.empty()) json["name"] = member.name;
  json["operation"] = kOperationKeys[static_cast<int>(member.operation)];
  json["operands"] = member.operands;
  return json;
}

Json crossings_json(const ExplainedCrossings& crossings) {
  Json json = Json::array();
  for (const ExplainedCrossing& crossing : crossings.all)
    json.push_back({{"distance", crossing.distance},
                    {"member", position_of(crossings.members[crossing.member])},
                    {"enters", crossing.enters},
                    {"inside", crossing.inside}});
  return json;
}

Json own_json(const OwnPlace& own) {
  Json json = {{"point", point_json(own.point)}};
  if (own.uv) {
    json["u"] = (*own.uv)[0];
    json["v"] = (*own.uv)[1];
  }
  if (own.footprint) json["footprint"] = *own.footprint;
  return json;
}

Json texture_json(const ExplainedTexture& texture) {
  Json json = {{"texture", std::uint64_t{texture.index} + 1}};
  if (!texture.name.empty()) json["name"] = texture.name;
  json["kind"] = noun_of(Language::english, texture.kind);
  return json;
}

}  // namespace

Json number_json(float v) {
  char text[32];
  const auto written = std::to_chars(text, text + sizeof text, v);
  double shortest = 0;
  std::from_chars(text, written.ptr, shortest);
  return static_cast<float>(shortest) == v ? shortest : static_cast<double>(v);
}
Json number_json(const Float3& v) {
  return {number_json(v[0]), number_json(v[1]), number_json(v[2])};
}
Json point_json(const Vec3& v) {
  return {v.x, v.y, v.z};
}

Json shape_json(const NamedShape& shape) {
  Json json = {{"shape", plain_name(shape.id)}};
  if (!shape.name.empty()) json["name"] = shape.name;
  return json;
}

void add_path(const ExplainedPath& path, Json& json) {
  if (path.inner) {
    json["instances"] = Json::array();
    for (const ExplainedInstance& instance : path.instances)
      json["instances"].push_back(instance_json(instance));
    json["inner"] = shape_json(*path.inner);
  }
  if (path.member) json["csg"] = member_json(*path.member);
}

void add_surface(const ExplainedHit& hit, Json& json) {
  add_path(hit.path, json);
  if (hit.crossings) {
    json["csg"]["starts_inside"] = hit.crossings->starts_inside;
    if (hit.crossings->left_out > 0) json["csg"]["left_out"] = hit.crossings->left_out;
    json["csg"]["crossings"] = crossings_json(*hit.crossings);
  }
  if (hit.transform) json["transform"] = transform_json(*hit.transform);
  if (hit.own) json["own"] = own_json(*hit.own);
  for (const TexturedCoefficient& one : hit.textures) {
    Json texture = texture_json(one.texture);
    texture["coefficient"] = symbol_of(one.coefficient);
    texture["value"] =
        is_color(one.coefficient) ? number_json(one.value) : number_json(one.value[0]);
    json["textures"].push_back(std::move(texture));
  }
  if (!hit.bent) return;
  json["bent"] = texture_json(hit.bent->texture);
  json["bent"]["by"] = kNormalKinds[static_cast<int>(hit.bent->kind)];
  json["bent"]["smooth"] = number_json(hit.bent->smooth);
}

}  // namespace zraka
