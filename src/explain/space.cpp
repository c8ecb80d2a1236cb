// SPDX-License-Identifier: Apache-2.0
#include "explain/space.hpp"

#include <set>

#include "core/json.hpp"
#include "explain/names.hpp"
#include "explain/optics_words.hpp"
#include "explain/segments.hpp"
#include "explain/surface_json.hpp"
#include "scene/bounds_of.hpp"

namespace zraka {
namespace {

/// Scenes of so many shapes are drawn whole.
constexpr std::uint64_t kFewShapes = 60;

/// The outline of a shape: a sphere is its circle, a plane itself, anything else its bounds;
/// nothing of what has none.
template <class Shape>
Json outline(const Whereabouts& where, const Object<Shape>& object) {
  if constexpr (std::is_same_v<Shape, Sphere>)
    return {{"center", point_json(object.shape.center)}, {"radius", object.shape.radius}};
  if constexpr (std::is_same_v<Shape, Plane>) {
    const Transform t = where.transform(object.transform);
    const auto normal = vector_of(object.shape.normal);
    // Gradients go to the world by the transposed inverse.
    const Transform own = inverse(t).value_or(Transform());
    return {{"point", point_json(moved(object.shape.point, t))},
            {"normal",
             {dot(vector_of(own.along_x), normal), dot(vector_of(own.along_y), normal),
              dot(vector_of(own.along_z), normal)}}};
  }
  const Bounds box = where.bounds(object);
  if (!box.bounded()) return Json::object();
  return {{"lower", point_json(box.lower)}, {"upper", point_json(box.upper)}};
}

/// Shapes that a ray or a shadow ray of the trees hits.
std::map<ShapeId, std::string> hit_shapes(const Explanation& explanation) {
  std::map<ShapeId, std::string> hit_shapes_by_id;
  for (const RayTree& tree : explanation.trees)
    for (const ExplainedRay& ray : tree.rays) {
      if (!ray.hit) continue;
      hit_shapes_by_id.emplace(ray.hit->shape.id, ray.hit->shape.name);
      for (const LightTerms& at : ray.hit->lights) {
        if (at.blocker) hit_shapes_by_id.emplace(at.blocker->shape.id, at.blocker->shape.name);
        if (at.filter)
          for (const PassedBody& body : at.passed)
            hit_shapes_by_id.emplace(body.shape.id, body.shape.name);
      }
    }
  return hit_shapes_by_id;
}

template <class Shape>
void add_shapes(Language language, const Whereabouts& where,
                const std::vector<Object<Shape>>& objects, std::int32_t kind,
                const std::map<ShapeId, std::string>& hit_shapes_by_id, bool all, Json& shapes) {
  const auto add = [&](std::uint32_t index, const std::string* name) {
    Json shape = outline(where, objects[index]);
    shape["met"] = name != nullptr;
    shape["label"] = name == nullptr ? "" : label_of(language, NamedShape{{kind, index}, *name});
    shapes.push_back(std::move(shape));
  };
  if (all) {
    for (std::uint32_t i = 0; i < objects.size(); ++i) {
      const auto found = hit_shapes_by_id.find({kind, i});
      add(i, found == hit_shapes_by_id.end() ? nullptr : &found->second);
    }
    return;
  }
  for (auto it = hit_shapes_by_id.lower_bound({kind, 0});
       it != hit_shapes_by_id.end() && it->first.kind == kind; ++it)
    add(it->first.index, &it->second);
}

}  // namespace

std::string ray_mark(std::size_t tree, std::size_t ray) {
  return fmt::format("t{}r{}", tree, ray);
}

std::string space_json(Language language, const Scene& scene, const Explanation& explanation) {
  Json rays = Json::array(), shapes = Json::array(), lights = Json::array();
  for (const Segment& s : segments_of(scene, explanation))
    rays.push_back({{"kind", static_cast<int>(s.kind)},
                    {"from", point_json(s.from)},
                    {"to", point_json(s.to)},
                    {"endless", s.endless},
                    {"weight", explanation.trees[s.tree].rays[s.ray].weight},
                    {"ray", ray_mark(s.tree, s.ray)}});
  const std::map<ShapeId, std::string> hit_shapes_by_id = hit_shapes(explanation);
  const bool all = scene.shape_count() <= kFewShapes;
  std::int32_t kind = 0;
  const Whereabouts where(scene);
#define ZRAKA_ADD(Type, plural) \
  add_shapes(language, where, scene.plural, kind++, hit_shapes_by_id, all, shapes);
  ZRAKA_SHAPES(ZRAKA_ADD)
#undef ZRAKA_ADD
  for (std::size_t i = 0; i < explanation.lights.size() && i < kFewShapes; ++i) {
    const Light& light = explanation.lights[i].light;
    if (light.kind == LightKind::directional) continue;  // it stands nowhere
    Vec3 at = explanation.lights[i].position;
    if (light.kind == LightKind::rectangle)
      at = {at.x + (light.edge_u.x + light.edge_v.x) / 2,
            at.y + (light.edge_u.y + light.edge_v.y) / 2,
            at.z + (light.edge_u.z + light.edge_v.z) / 2};
    lights.push_back({{"at", point_json(at)}, {"label", light_title(language, explanation, i)}});
  }
  const Camera& camera = scene.camera;
  const Json json = {{"rays", std::move(rays)},
                     {"shapes", std::move(shapes)},
                     {"lights", std::move(lights)},
                     {"eye", point_json(camera.eye)},
                     {"window",
                      {{"center", point_json(camera.window_center)},
                       {"right", point_json(camera.window_right)},
                       {"up", point_json(camera.window_up)}}},
                     {"words",
                      {{"eye", text_of(language, Word::page_eye)},
                       {"window", text_of(language, Word::page_window)}}}};
  // Nothing in it may end the script element.
  std::string text;
  for (const char c : json.dump()) text += c == '<' ? std::string("\\u003c") : std::string(1, c);
  return text;
}

}  // namespace zraka
