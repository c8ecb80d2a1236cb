// SPDX-License-Identifier: Apache-2.0
#include "explain/space.hpp"

#include <nlohmann/json.hpp>
#include <set>

#include "explain/names.hpp"
#include "explain/segments.hpp"
#include "shapes/shapes.hpp"

namespace zraka {
namespace {

using Json = nlohmann::ordered_json;

/// Scenes of so many shapes are drawn whole.
constexpr std::uint64_t kFewShapes = 60;

Json place(const Vec3& v) {
  return {v.x, v.y, v.z};
}

/// The outline of a shape: a sphere is its circle, anything else its bounds.
Json outline(const Sphere& s) {
  return {{"center", place(s.center)}, {"radius", s.radius}};
}
template <class Shape>
Json outline(const Shape& shape) {
  const Box box = ShapeTraits<Shape>::bounds(shape);
  return {{"lower", place(box.lower)}, {"upper", place(box.upper)}};
}

/// Shapes that a ray or a feeler of the trees meets.
std::map<ShapeId, std::string> met_shapes(const Explanation& explanation) {
  std::map<ShapeId, std::string> met;
  for (const RayTree& tree : explanation.trees)
    for (const ExplainedRay& ray : tree.rays) {
      if (!ray.hit) continue;
      met.emplace(ray.hit->shape.id, ray.hit->shape.name);
      for (const LightTerms& at : ray.hit->lights)
        if (at.blocker) met.emplace(at.blocker->shape.id, at.blocker->shape.name);
    }
  return met;
}

template <class Shape>
void add_shapes(Language language, const std::vector<Object<Shape>>& objects, std::int32_t kind,
                const std::map<ShapeId, std::string>& met, bool all, Json& shapes) {
  const auto add = [&](std::uint32_t index, const std::string* name) {
    Json shape = outline(objects[index].shape);
    shape["met"] = name != nullptr;
    shape["label"] = name == nullptr ? "" : label_of(language, NamedShape{{kind, index}, *name});
    shapes.push_back(std::move(shape));
  };
  if (all) {
    for (std::uint32_t i = 0; i < objects.size(); ++i) {
      const auto found = met.find({kind, i});
      add(i, found == met.end() ? nullptr : &found->second);
    }
    return;
  }
  for (auto it = met.lower_bound({kind, 0}); it != met.end() && it->first.kind == kind; ++it)
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
                    {"from", place(s.from)},
                    {"to", place(s.to)},
                    {"endless", s.endless},
                    {"weight", explanation.trees[s.tree].rays[s.ray].weight},
                    {"ray", ray_mark(s.tree, s.ray)}});
  const std::map<ShapeId, std::string> met = met_shapes(explanation);
  const bool all = scene.shape_count() <= kFewShapes;
  std::int32_t kind = 0;
#define ZRAKA_ADD(Type, plural) add_shapes(language, scene.plural, kind++, met, all, shapes);
  ZRAKA_SHAPES(ZRAKA_ADD)
#undef ZRAKA_ADD
  for (std::size_t i = 0; i < explanation.lights.size() && i < kFewShapes; ++i)
    lights.push_back({{"at", place(explanation.lights[i].position)},
                      {"label", say(language, Word::light, light_number(i))}});
  const Camera& camera = scene.camera;
  const Json json = {{"rays", std::move(rays)},
                     {"shapes", std::move(shapes)},
                     {"lights", std::move(lights)},
                     {"eye", place(camera.eye)},
                     {"window",
                      {{"center", place(camera.window_center)},
                       {"right", place(camera.window_right)},
                       {"up", place(camera.window_up)}}},
                     {"words",
                      {{"eye", text_of(language, Word::page_eye)},
                       {"window", text_of(language, Word::page_window)}}}};
  // Nothing in it may end the script element.
  std::string text;
  for (const char c : json.dump(-1, ' ', false, Json::error_handler_t::replace))
    text += c == '<' ? std::string("\\u003c") : std::string(1, c);
  return text;
}

}  // namespace zraka
