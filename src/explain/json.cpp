// SPDX-License-Identifier: Apache-2.0
#include "explain/json.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "core/append.hpp"
#include "core/json.hpp"
#include "explain/angles.hpp"
#include "explain/optics_words.hpp"
#include "explain/surface_json.hpp"

namespace zraka {
namespace {

template <class T>
Json if_there(const std::optional<T>& value) {
  return value ? number_json(*value) : Json();
}

constexpr const char* kReachNames[] = {"lit", "unchecked", "behind", "blocked", "dark"};
constexpr const char* kAbsenceNames[] = {
    "", "share is 0", "depth limit", "stage", "total internal reflection", "contribution"};
constexpr const char* kRayNames[] = {"camera", "reflected", "refracted"};

Json body_json(const NamedShape& shape, const ExplainedPath& path) {
  Json json = shape_json(shape);
  add_path(path, json);
  return json;
}

/// What a light of the scene is, beyond a point that shines alike in all directions and distances.
void add_kind(const Light& light, Json& json) {
  constexpr const char* kKinds[] = {"point", "directional", "spot", "rectangle", "disc", "sphere"};
  if (light.kind != LightKind::point) json["kind"] = kKinds[static_cast<int>(light.kind)];
  if (light.kind == LightKind::directional || light.kind == LightKind::spot)
    json["direction"] = point_json(light.direction);
  if (light.kind == LightKind::spot) {
    json["inner_deg"] = light.inner_deg;
    json["outer_deg"] = light.outer_deg;
  }
  if (light.kind == LightKind::rectangle) {
    json["edge_u"] = point_json(light.edge_u);
    json["edge_v"] = point_json(light.edge_v);
  }
  if (light.kind == LightKind::disc) json["normal"] = point_json(light.normal);
  if (light.kind == LightKind::disc || light.kind == LightKind::sphere)
    json["radius"] = light.radius;
  if (light.kind != LightKind::directional && light.attenuation != Vec3{1, 0, 0})
    json["attenuation"] = point_json(light.attenuation);
}

/// What shadow rays come through, and how many there are.
void add_way(const LightTerms& at, Json& json) {
  if (at.samples > 1) {
    json["samples"] = at.samples;
    json["facing"] = at.facing;
    json["reaching"] = at.reaching;
  }
  if (!at.filter) return;
  json["filter"] = number_json(*at.filter);
  if (at.last)
    json["last"] = {{"length", at.last->length},
                    {"transmittance", number_json(at.last->transmittance)}};
  json["passed"] = Json::array();
  for (const PassedBody& body : at.passed) {
    Json passed = body_json(body.shape, body.path);
    passed["distance"] = body.distance;
    passed["share"] = number_json(body.share);
    if (body.length > 0) {
      passed["length"] = body.length;
      passed["transmittance"] = number_json(body.transmittance);
    }
    json["passed"].push_back(std::move(passed));
  }
}

Json light_json(const LightTerms& at, std::size_t light, const Float3& intensity) {
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
  if (at.arriving != intensity) json["arriving"] = number_json(at.arriving);
  add_way(at, json);
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
  if (snell.n1 != 0) {
    json["n1"] = snell.n1;
    json["n2"] = snell.n2;
  }
  if (snell.nm) json["nm"] = *snell.nm;
  if (snell.fresnel) json["fresnel"] = *snell.fresnel;
  return json;
}

Json ray_json(const Explanation& e, const RayTree& tree, std::size_t place_of_ray);

Json child_json(const Explanation& e, const RayTree& tree, const Child& child) {
  if (child.ray < 0) {
    Json json = {{"ray", nullptr}, {"absence", kAbsenceNames[static_cast<int>(child.absence)]}};
    if (child.bound) json["bound"] = *child.bound;
    return json;
  }
  Json json = {{"share", number_json(child.share)}};
  if (!is_grey(child.shares)) json["shares"] = number_json(child.shares);
  json["ray"] = ray_json(e, tree, static_cast<std::size_t>(child.ray));
  return json;
}

/// What the material is beyond Phong's coefficients, and what the ray has come through.
void add_optics(const ExplainedHit& hit, Json& json) {
  Json& material = json["material"];
  if (!is_grey(hit.reflection)) material["k1_rgb"] = number_json(hit.reflection);
  if (!is_grey(hit.refraction)) material["k2_rgb"] = number_json(hit.refraction);
  if (hit.highlight == Highlight::blinn) material["highlight"] = "blinn";
  if (hit.cap)
    json["cap"] = {{"cut", std::uint64_t{hit.cap->cut} + 1}, {"eye_only", hit.cap->eye_only}};
  if (hit.medium) {
    json["medium"] = {{"material", std::uint64_t{hit.medium->material} + 1}};
    if (!hit.medium->name.empty()) json["medium"]["name"] = hit.medium->name;
    json["medium"]["absorption"] = number_json(hit.medium->absorption);
    json["medium"]["transmittance"] = number_json(hit.medium->transmittance);
  }
  if (hit.occlusion) json["occlusion"] = number_json(*hit.occlusion);
}

Json hit_json(const Explanation& e, const RayTree& tree, const ExplainedHit& hit) {
  Json json = shape_json(hit.shape);
  json["distance"] = hit.distance;
  json["point"] = point_json(hit.point);
  json["normal"] = number_json(hit.normal);
  json["flipped"] = hit.flipped;
  add_surface(hit, json);
  json["material"] = {{"ka", number_json(hit.ka)}, {"kd", number_json(hit.kd)},
                      {"ks", number_json(hit.ks)}, {"n", number_json(hit.shininess)},
                      {"k1", number_json(hit.k1)}, {"k2", number_json(hit.k2)}};
  add_optics(hit, json);
  json["ambient"] = number_json(hit.ambient);
  json["lights"] = Json::array();
  for (std::size_t i = 0; i < hit.lights.size(); ++i)
    json["lights"].push_back(light_json(hit.lights[i], i, e.lights[i].color));
  json["local"] = number_json(hit.local);
  json["snell"] = hit.snell ? snell_json(*hit.snell) : Json();
  json["reflected"] = child_json(e, tree, hit.reflected);
  json["refracted"] = child_json(e, tree, hit.refracted);
  for (const SplitChild& part : hit.split) {
    Json child = {{"nm", part.nm}};
    const Json its = child_json(e, tree, part.child);
    for (const auto& [key, member] : *its.if_object()) child[key] = member;
    json["split"].push_back(std::move(child));
  }
  if (hit.sky_beyond)
    json["sky_beyond"] = {{"reflected", number_json(hit.sky_beyond->reflected)},
                          {"refracted", number_json(hit.sky_beyond->refracted)}};
  json["sum"] = number_json(hit.sum);
  return json;
}

Json ray_json(const Explanation& e, const RayTree& tree, std::size_t place_of_ray) {
  const ExplainedRay& ray = tree.rays[place_of_ray];
  Json json = {{"kind", kRayNames[static_cast<int>(ray.kind)]},
               {"depth", ray.depth},
               {"weight", ray.weight},
               {"origin", point_json(ray.origin)},
               {"direction", number_json(ray.direction)}};
  if (ray.nm) json["nm"] = *ray.nm;
  for (const NamedBody& body : ray.inside)
    json["inside"].push_back(body_json(body.shape, body.path));
  json["hit"] = ray.hit ? hit_json(e, tree, *ray.hit) : Json();
  if (ray.fog)
    json["fog"] = {{"left", number_json(ray.fog->left)}, {"color", number_json(ray.fog->color)}};
  json["color"] = number_json(ray.color);
  return json;
}

Json tree_json(const Explanation& e) {
  if (e.trees.size() == 1) return ray_json(e, e.trees.front(), 0);
  Json json = {{"kind", "mean"}, {"corners", Json::array()}, {"color", number_json(e.color)}};
  for (const RayTree& tree : e.trees) json["corners"].push_back(ray_json(e, tree, 0));
  return json;
}

/// What rays share beyond the lab's optics.
void add_settings(const Explanation& e, Json& json) {
  constexpr const char* kSkies[] = {"", "gradient", "image"};
  if (e.sky != Sky::Kind::flat) json["sky"] = kSkies[static_cast<int>(e.sky)];
  if (e.samples > 1) {
    json["sample"] = std::uint64_t{e.sample} + 1;
    json["samples"] = e.samples;
  }
  if (!e.general) return;
  if (e.transparent_shadows) json["shadows"] = "transparent";
  if (e.min_contribution > 0) {
    json["min_contribution"] = e.min_contribution;
    json["brightest"] = e.brightest;
  }
  const auto is_split = [](const ExplainedRay& ray) { return ray.nm.has_value(); };
  if (std::any_of(e.trees.begin(), e.trees.end(), [&](const RayTree& tree) {
        return std::any_of(tree.rays.begin(), tree.rays.end(), is_split);
      }))
    json["wavelengths"] = e.wavelengths;
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
      append(out, "{}\n{:{}}", separator, "", indent + 1);
    if (key != nullptr) out += Json(*key).dump() + ": ";
    print(member, indent + 1, out);
    separator = ",";
  };
  out += object != nullptr ? '{' : '[';
  if (object != nullptr)
    for (const auto& [key, member] : *object) print_member(&key, member);
  else
    for (const Json& member : *array) print_member(nullptr, member);
  if (!one_line) append(out, "\n{:{}}", "", indent);
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
  for (const ExplainedLight& light : e.lights) {
    Json one = {{"position", point_json(light.position)}, {"color", number_json(light.color)}};
    add_kind(light.light, one);
    json["lights"].push_back(std::move(one));
  }
  add_settings(e, json);
  json["color"] = number_json(e.color);
  json["bytes"] = Json::array();
  for (const float c : e.color)
    json["bytes"].push_back(e.outlined ? 0 : quantize(c, e.profile.transfer, 8));
  if (e.outlined) json["outlined"] = true;
  json["words"] = words;
  json["tree"] = tree_json(e);
  std::string text;
  print(json, 0, text);
  return text + "\n";
}

}  // namespace zraka
