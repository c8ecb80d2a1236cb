// SPDX-License-Identifier: Apache-2.0
#include "explain/json.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>

#include "core/json.hpp"
#include "explain/angles.hpp"
#include "explain/names.hpp"

namespace zraka {
namespace {

/// The double with the float's shortest decimal, so that 0.1f is printed as 0.1 and read back as
/// 0.1f.
Json number(float v) {
  char text[32];
  const auto written = std::to_chars(text, text + sizeof text, v);
  double shortest = 0;
  std::from_chars(text, written.ptr, shortest);
  return static_cast<float>(shortest) == v ? shortest : static_cast<double>(v);
}
Json number(const Float3& v) {
  return {number(v[0]), number(v[1]), number(v[2])};
}
Json point_json(const Vec3& v) {
  return {v.x, v.y, v.z};
}
template <class T>
Json if_there(const std::optional<T>& value) {
  return value ? number(*value) : Json();
}

Json shape_json(const NamedShape& shape) {
  Json json = {{"shape", plain_name(shape.id)}};
  if (!shape.name.empty()) json["name"] = shape.name;
  return json;
}

constexpr const char* kReachNames[] = {"lit", "unchecked", "behind", "blocked"};
constexpr const char* kAbsenceNames[] = {"", "share is 0", "depth limit", "stage",
                                         "total internal reflection"};
constexpr const char* kRayNames[] = {"camera", "reflected", "refracted"};

Json light_json(const LightTerms& at, std::size_t light) {
  Json json = {{"light", light + 1},
               {"reach", kReachNames[static_cast<int>(at.reach)]},
               {"distance", at.distance},
               {"L", number(at.to_light)},
               {"l_n", number(at.l_n)}};
  if (at.blocker) {
    json["blocker"] = shape_json(at.blocker->shape);
    json["blocker"]["distance"] = at.blocker->distance;
  }
  json["diffuse"] = if_there(at.diffuse);
  json["r_v"] = if_there(at.r_v);
  json["highlight"] = if_there(at.highlight);
  json["specular"] = if_there(at.specular);
  return json;
}

Json snell_json(const SnellTerms& snell) {
  const Angles angles = angles_of(snell);
  Json json = {{"cos_alpha", number(snell.cosine)},
               {"b", number(snell.ratio)},
               {"quarter_d", number(snell.quarter_d)},
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
  return {{"share", number(child.share)},
          {"ray", ray_json(tree, static_cast<std::size_t>(child.ray))}};
}

Json hit_json(const RayTree& tree, const ExplainedHit& hit) {
  Json json = shape_json(hit.shape);
  json["distance"] = hit.distance;
  json["point"] = point_json(hit.point);
  json["normal"] = number(hit.normal);
  json["flipped"] = hit.flipped;
  json["material"] = {{"ka", number(hit.ka)},       {"kd", number(hit.kd)}, {"ks", number(hit.ks)},
                      {"n", number(hit.shininess)}, {"k1", number(hit.k1)}, {"k2", number(hit.k2)}};
  json["ambient"] = number(hit.ambient);
  json["lights"] = Json::array();
  for (std::size_t i = 0; i < hit.lights.size(); ++i)
    json["lights"].push_back(light_json(hit.lights[i], i));
  json["local"] = number(hit.local);
  json["snell"] = hit.snell ? snell_json(*hit.snell) : Json();
  json["reflected"] = child_json(tree, hit.reflected);
  json["refracted"] = child_json(tree, hit.refracted);
  json["sum"] = number(hit.sum);
  return json;
}

Json ray_json(const RayTree& tree, std::size_t place_of_ray) {
  const ExplainedRay& ray = tree.rays[place_of_ray];
  return {{"kind", kRayNames[static_cast<int>(ray.kind)]},
          {"depth", ray.depth},
          {"weight", ray.weight},
          {"origin", point_json(ray.origin)},
          {"direction", number(ray.direction)},
          {"hit", ray.hit ? hit_json(tree, *ray.hit) : Json()},
          {"color", number(ray.color)}};
}

Json tree_json(const Explanation& e) {
  if (e.trees.size() == 1) return ray_json(e.trees.front(), 0);
  Json json = {{"kind", "mean"}, {"corners", Json::array()}, {"color", number(e.color)}};
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
               {"background", number(e.background)},
               {"ambient_light", number(e.ambient_light)},
               {"lights", Json::array()}};
  for (const ExplainedLight& light : e.lights)
    json["lights"].push_back(
        {{"position", point_json(light.position)}, {"color", number(light.color)}});
  json["color"] = number(e.color);
  json["bytes"] = Json::array();
  for (const float c : e.color) json["bytes"].push_back(quantize(c, e.profile.transfer, 8));
  json["words"] = words;
  json["tree"] = tree_json(e);
  std::string text;
  print(json, 0, text);
  return text + "\n";
}

}  // namespace zraka
