// SPDX-License-Identifier: Apache-2.0
#include "explain/json.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "core/json.hpp"
#include "explain/angles.hpp"
#include "explain/surface_json.hpp"

namespace zraka {
namespace {

template <class T>
Json if_there(const std::optional<T>& value) {
  return value ? number_json(*value) : Json();
}

constexpr const char* kReachNames[] = {"lit", "unchecked", "behind", "blocked", "dark"};
constexpr const char* kAbsenceNames[] = {"", "share is 0", "depth limit", "stage",
                                         "total internal reflection", "contribution"};
constexpr const char* kRayNames[] = {"camera", "reflected", "refracted"};

Json light_json(const LightTerms& at, std::size_t light) {
  Json json = {{"light", light + 1},
               {"reach", kReachNames[static_cast<int>(at.reach)]},
               {"distance", at.distance},
               {"L", number_json(at.to_light)},
               {"l_n", number_json(at.l_n)}};
  if (at.blocker) {
    json["blocker"] = shape_json(at.blocker->shape);
    json["blocker"]["distance"] = at.blocker->distance;
    add_path(at.blocker->path, json["blocker"]);
  }
  json["diffuse"] = if_there(at.diffuse);
  json["r_v"] = if_there(at.r_v);
  json["highlight"] = if_there(at.highlight);
  json["specular"] = if_there(at.specular);
  return json;
}

Json snell_json(const SnellTerms& snell) {
  const Angles angles = angles_of(snell);
  Json json = {{"cos_alpha", number_json(snell.cosine)},
               {"b", number_json(snell.ratio)},
               {"quarter_d", number_json(snell.quarter_d)},
               {"a", if_there(snell.a)},
               {"total", snell.total},
               {"alpha_deg", angles.alpha_deg}};
  json["beta_deg"] = angles.beta_deg ? Json(*angles.beta_deg) : Json();
  json["critical_deg"] = angles.critical_deg ? Json(*angles.critical_deg) : Json();
  return json;
}

Json ray_json(const RayTree& tree, std::size_t place_of_ray);

Json child_json(const RayTree& tree, const Child& child) {
  if (child.ray < 0)
    return {{"ray", nullptr}, {"absence", kAbsenceNames[static_cast<int>(child.absence)]}};
  return {{"share", number_json(child.share)},
          {"ray", ray_json(tree, static_cast<std::size_t>(child.ray))}};
}

Json hit_json(const RayTree& tree, const ExplainedHit& hit) {
  Json json = shape_json(hit.shape);
  json["distance"] = hit.distance;
  json["point"] = point_json(hit.point);
  json["normal"] = number_json(hit.normal);
  json["flipped"] = hit.flipped;
  add_surface(hit, json);
  json["material"] = {{"ka", number_json(hit.ka)}, {"kd", number_json(hit.kd)},
                      {"ks", number_json(hit.ks)}, {"n", number_json(hit.shininess)},
                      {"k1", number_json(hit.k1)}, {"k2", number_json(hit.k2)}};
  json["ambient"] = number_json(hit.ambient);
  json["lights"] = Json::array();
  for (std::size_t i = 0; i < hit.lights.size(); ++i)
    json["lights"].push_back(light_json(hit.lights[i], i));
  json["local"] = number_json(hit.local);
  json["snell"] = hit.snell ? snell_json(*hit.snell) : Json();
  json["reflected"] = child_json(tree, hit.reflected);
  json["refracted"] = child_json(tree, hit.refracted);
  json["sum"] = number_json(hit.sum);
  return json;
}

Json ray_json(const RayTree& tree, std::size_t place_of_ray) {
  const ExplainedRay& ray = tree.rays[place_of_ray];
  return {{"kind", kRayNames[static_cast<int>(ray.kind)]},
          {"depth", ray.depth},
          {"weight", ray.weight},
          {"origin", point_json(ray.origin)},
          {"direction", number_json(ray.direction)},
          {"hit", ray.hit ? hit_json(tree, *ray.hit) : Json()},
          {"color", number_json(ray.color)}};
}

Json tree_json(const Explanation& e) {
  if (e.trees.size() == 1) return ray_json(e.trees.front(), 0);
  Json json = {{"kind", "mean"}, {"corners", Json::array()}, {"color", number_json(e.color)}};
  for (const RayTree& tree : e.trees) json["corners"].push_back(ray_json(tree, 0));
  return json;
}

/// An object's members on lines of their own, a vector on one line.
void print(const Json& json, std::size_t indent, std::string& out) {
  const Json::Array* array = json.if_array();
  const Json::Object* object = json.if_object();
  if (array == nullptr && object == nullptr) {
    out += json.dump();
    return;
  }
  const bool one_line =
      array != nullptr && std::none_of(array->begin(), array->end(), [](const Json& member) {
        return member.is_array() || member.is_object();
      });
  const char* separator = "";
  const auto print_member = [&](const std::string* key, const Json& member) {
    if (one_line)
      out += *separator == ',' ? ", " : "";
    else
      fmt::format_to(std::back_inserter(out), "{}\n{:{}}", separator, "", indent + 1);
    if (key != nullptr) out += Json(*key).dump() + ": ";
    print(member, indent + 1, out);
    separator = ",";
  };
  out += object != nullptr ? '{' : '[';
  if (object != nullptr)
    for (const auto& [key, member] : *object) print_member(&key, member);
  else
    for (const Json& member : *array) print_member(nullptr, member);
  if (!one_line) fmt::format_to(std::back_inserter(out), "\n{:{}}", "", indent);
  out += object != nullptr ? '}' : ']';
}

}  // namespace

std::string to_json(const Explanation& e, const std::string& scene, const std::string& profile,
                    const std::string& words) {
  Json json = {{"scene", scene},
               {"pixel", {e.x, e.y}},
               {"resolution", {e.resolution.width, e.resolution.height}},
               {"profile", profile},
               {"max_depth", e.max_depth},
               {"clamp_levels", e.profile.clamp_levels},
               {"terms",
                {{"silhouette", e.terms.silhouette},
                 {"ambient", e.terms.ambient},
                 {"diffuse", e.terms.diffuse},
                 {"specular", e.terms.specular},
                 {"shadows", e.terms.shadows},
                 {"reflection", e.terms.reflection},
                 {"refraction", e.terms.refraction}}},
               {"mistake", e.varied ? Json(e.varied->key) : Json()},
               {"background", number_json(e.background)},
               {"ambient_light", number_json(e.ambient_light)},
               {"lights", Json::array()}};
  for (const ExplainedLight& light : e.lights)
    json["lights"].push_back(
        {{"position", point_json(light.position)}, {"color", number_json(light.color)}});
  json["color"] = number_json(e.color);
  json["bytes"] = Json::array();
  for (const float c : e.color) json["bytes"].push_back(quantize(c, e.profile.transfer, 8));
  json["words"] = words;
  json["tree"] = tree_json(e);
  std::string text;
  print(json, 0, text);
  return text + "\n";
}

}  // namespace zraka
