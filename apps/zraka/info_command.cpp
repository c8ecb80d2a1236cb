// SPDX-License-Identifier: Apache-2.0
// zraka info: what a scene file holds.
#include <fmt/format.h>

#include <cstdio>
#include <set>

#include "commands.hpp"
#include "core/json.hpp"
#include "core/text.hpp"
#include "scene/bounds_of.hpp"
#include "scene_files.hpp"
#include "terminal.hpp"
#include "zraka/zraka.hpp"

namespace zraka::app {
namespace {

struct InfoArguments {
  std::string scene;
  std::string format = "text";
  ReadOptions files;
};

/// In the order of LightKind.
constexpr const char* kLightKinds[] = {"point",     "directional", "spot",
                                       "rectangle", "disc",        "sphere"};

struct Facts {
  std::size_t mirrors = 0, glasses = 0;
  Bounds bounds;
};

Facts facts_of(const Scene& scene) {
  Facts facts;
  for (const Material& m : scene.materials) {
    facts.mirrors += m.reflection.most() != 0;
    facts.glasses += m.refraction.most() != 0;
  }
  const Whereabouts where(scene);
#define ZRAKA_INCLUDE(Type, plural)       \
  for (const auto& object : scene.plural) \
    if (const Bounds box = where.bounds(object); box.bounded()) facts.bounds.include(box);
  ZRAKA_SHAPES(ZRAKA_INCLUDE)
#undef ZRAKA_INCLUDE
  return facts;
}

Json json_of(const Vec3& v) {
  return {v.x, v.y, v.z};
}

void print_json(const Scene& scene, const Facts& facts) {
  Json json = {{"format", scene.format},
               {"profile", name_of(scene.defaults.profile)},
               {"resolution", {scene.resolution.width, scene.resolution.height}},
               {"eye", json_of(scene.camera.eye)}};
  json["lights"] = Json::array();
  for (const Light& light : scene.lights) {
    const bool far = light.kind == LightKind::directional;
    json["lights"].push_back(
        {{"kind", kLightKinds[static_cast<int>(light.kind)]},
         {far ? "direction" : "position", json_of(far ? light.direction : light.position)}});
  }
#define ZRAKA_COUNT(Type, plural) json["shapes"][ShapeTraits<Type>::kName] = scene.plural.size();
  ZRAKA_SHAPES(ZRAKA_COUNT)
#undef ZRAKA_COUNT
  json["materials"] = {
      {"all", scene.materials.size()}, {"mirrors", facts.mirrors}, {"glasses", facts.glasses}};
  if (!facts.bounds.empty())
    json["bounds"] = {{"lower", json_of(facts.bounds.lower)},
                      {"upper", json_of(facts.bounds.upper)}};
  std::puts(json.dump(2).c_str());
}

std::string text_of(const Vec3& v) {
  return fmt::format("({:.6g}, {:.6g}, {:.6g})", v.x, v.y, v.z);
}

void print_light(const Light& light) {
  const char* const kind = kLightKinds[static_cast<int>(light.kind)];
  if (light.kind == LightKind::point)
    fmt::print("light       {}\n", text_of(light.position));
  else if (light.kind == LightKind::directional)
    fmt::print("light       {}, towards {}\n", kind, text_of(light.direction));
  else
    fmt::print("light       {}, at {}\n", kind, text_of(light.position));
}

void print_text(const Scene& scene, const Facts& facts) {
  fmt::print("format      {}, drawn with the {} profile\n", scene.format,
             name_of(scene.defaults.profile));
  fmt::print("picture     {} × {} pixels\n", scene.resolution.width, scene.resolution.height);
  fmt::print("eye         {}\n", text_of(scene.camera.eye));
  for (const Light& light : scene.lights) print_light(light);
  const auto count = [](const char* what, std::size_t number) {
    if (number > 0) fmt::print("{:<11} {}\n", what, grouped(number));
  };
#define ZRAKA_COUNT(Type, plural) count(#plural, scene.plural.size());
  ZRAKA_SHAPES(ZRAKA_COUNT)
#undef ZRAKA_COUNT
  count("groups", scene.groups.size());
  count("textures", scene.textures.size());
  fmt::print("materials   {}, of which {} reflect and {} refract\n",
             grouped(scene.materials.size()), facts.mirrors, facts.glasses);
  if (!facts.bounds.empty())
    fmt::print("bounds      {} to {}\n", text_of(facts.bounds.lower), text_of(facts.bounds.upper));
}

int run(const InfoArguments& arguments) {
  const Result<ReadScene> read = read_scene(arguments.scene, arguments.files);
  if (!read) return fail(read.error());
  show(read->warnings);
  const Facts facts = facts_of(read->scene);
  if (arguments.format == "json")
    print_json(read->scene, facts);
  else
    print_text(read->scene, facts);
  return kDone;
}

}  // namespace

void add_info(Command& program) {
  auto arguments = std::make_shared<InfoArguments>();
  Command app = program.add_command("info", "say what a scene file holds");
  app.add("SCENE", &arguments->scene, "the scene file; - reads standard input").required();
  app.add("--format", &arguments->format, "text (default) or json").one_of({"text", "json"});
  add_allow_outside_to(app, arguments->files);
  app.footer(
      "Examples:\n"
      "  zraka info scenes/lab/input.txt\n"
      "  zraka info input.txt --format json | jq .bounds");
  app.action([arguments] { return run(*arguments); });
}

}  // namespace zraka::app
