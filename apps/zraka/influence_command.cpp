// SPDX-License-Identifier: Apache-2.0
// zraka influence: which pixels a shape reaches, and by which ways.
#include <fmt/format.h>

#include <cstdio>

#include "commands.hpp"
#include "core/counted.hpp"
#include "core/json.hpp"
#include "core/text.hpp"
#include "core/words.hpp"
#include "explain/names.hpp"
#include "progress.hpp"
#include "render_options.hpp"
#include "terminal.hpp"

namespace zraka::app {
namespace {

struct InfluenceArguments : RenderArguments {
  std::vector<std::string> name;
  std::string output, format = "text", language = "en";
};

/// The marks of the picture, linear; the first bit of a pixel decides.
struct Mark {
  InfluenceBit bit;
  float color[3];
};
constexpr Mark kMarks[] = {{kSeen, {1.0f, 0.4f, 0.05f}},
                           {kMirrored, {0.05f, 0.3f, 1.0f}},
                           {kThroughGlass, {0.55f, 0.1f, 0.8f}},
                           {kBothWays, {0.05f, 0.6f, 0.2f}},
                           {kShadow, {0.8f, 0.03f, 0.03f}}};

/// The picture in dark grey, with the pixels that the shape reaches in colours.
Image marked(Image image, const Influence& influence) {
  for (std::size_t i = 0; i < influence.pixels.size(); ++i) {
    float* pixel = image.pixels.data() + 3 * i;
    const auto unit = [](float v) { return v > 0 ? std::min(v, 1.0f) : 0.0f; };
    const float grey =
        0.2126f * unit(pixel[0]) + 0.7152f * unit(pixel[1]) + 0.0722f * unit(pixel[2]);
    for (int c = 0; c < 3; ++c) pixel[c] = 0.35f * grey;
    for (const Mark& mark : kMarks) {
      if ((influence.pixels[i] & mark.bit) == 0) continue;
      for (int c = 0; c < 3; ++c) pixel[c] = mark.color[c] * (0.35f + 0.65f * grey);
      break;
    }
  }
  return image;
}

std::string way_text(Language language, const InfluenceWay& way) {
  std::string path;
  for (const RayKind kind : way.path)
    path += fmt::format(
        "{}{}", path.empty() ? "" : " → ",
        text_of(language, kind == RayKind::reflected ? Word::ray_reflected : Word::ray_refracted));
  if (way.longer) path += " → …";
  const std::string seen =
      path.empty() ? say(language, Word::way_seen) : say(language, Word::way_by, path);
  return way.shadow ? say(language, Word::way_shadow, seen) : seen;
}

constexpr unsigned kAnyBit = 0xFF;

/// What was asked for: a shape, and the group that it is in; "" for the scene's own.
struct Asked {
  NamedShape shape;
  std::string group;

  Asked(const Scene& scene, const ShapeInScene& found) : shape{found.id, ""} {
    const ShapeLists* shapes = &scene;
    if (found.group >= 0) {
      const Group& its = scene.groups[static_cast<std::size_t>(found.group)];
      group = its.name.empty() ? fmt::format("{}", found.group + 1) : its.name;
      shapes = &its;
    }
    if (const auto own = shapes->names.find(shape.id); own != shapes->names.end())
      shape.name = own->second;
  }
  std::string label(Language language) const {
    const std::string bare = label_of(language, shape);
    return group.empty()
               ? bare
               : say(language, Word::of_group, bare, fmt::format("'{}'", shown_line(group)));
  }
};

void print_text(const InfluenceArguments& arguments, const Asked& asked,
                const Influence& influence) {
  constexpr std::size_t kMostWays = 16;
  const Language language = *language_named(arguments.language);
  const std::uint64_t all = influence.pixels.size(), reached = influence.count(kAnyBit);
  fmt::print(
      "{}\n",
      capitalized(
          say(language, Word::influence_of, asked.label(language), grouped(reached), grouped(all),
              with_comma(language, fmt::format("{:.3g}", 100 * static_cast<double>(reached) /
                                                             static_cast<double>(all))))));
  std::uint64_t rest = 0;
  for (std::size_t i = 0; i < influence.ways.size(); ++i) {
    if (i < kMostWays)
      fmt::print("{:>12}  {}\n", grouped(influence.ways[i].pixels),
                 way_text(language, influence.ways[i]));
    else
      rest = std::max(rest, influence.ways[i].pixels);
  }
  if (influence.ways.size() > kMostWays)
    fmt::print("{:>12}  {}\n", "…",
               say(language, Word::ways_more, influence.ways.size() - kMostWays, grouped(rest)));
  if (!arguments.output.empty() && arguments.output != "-")
    fmt::print("{}\n", say(language, Word::influence_legend));
}

void print_json(const Asked& asked, const Influence& influence) {
  Json json = {{"shape", plain_name(asked.shape.id)}};
  if (!asked.shape.name.empty()) json["name"] = asked.shape.name;
  if (!asked.group.empty()) json["group"] = asked.group;
  json["resolution"] = {influence.width, influence.height};
  json["pixels"] = {
      {"any", influence.count(kAnyBit)},         {"seen", influence.count(kSeen)},
      {"mirrored", influence.count(kMirrored)},  {"through_glass", influence.count(kThroughGlass)},
      {"both_ways", influence.count(kBothWays)}, {"shadow", influence.count(kShadow)}};
  json["ways"] = Json::array();
  for (const InfluenceWay& way : influence.ways) {
    Json path = Json::array();
    for (const RayKind kind : way.path)
      path.push_back(kind == RayKind::reflected ? "reflected" : "refracted");
    json["ways"].push_back({{"path", std::move(path)},
                            {"longer", way.longer},
                            {"shadow", way.shadow},
                            {"pixels", way.pixels}});
  }
  std::puts(json.dump(2).c_str());
}

int run(const InfluenceArguments& arguments) {
  speak(*language_named(arguments.language));
  const Result<Scene> scene = arguments.load({arguments.output});
  if (!scene) return fail(scene.error());
  std::string name;
  for (const std::string& word : arguments.name)
    name += fmt::format("{}{}", name.empty() ? "" : " ", word);
  const Result<ShapeInScene> shape = find_shape(*scene, name);
  if (!shape) return fail(shape.error());
  const RenderOptions options = arguments.options(*scene);
  const Result<Influence> found = influence(*scene, options, *shape);
  if (!found) return fail(found.error());
  if (!arguments.output.empty()) {
    const Result<Rendering> rendering = render(*scene, options);
    if (!rendering) return fail(rendering.error());
    const Result<void> written = write_png(marked(rendering->image, *found), arguments.output,
                                           {8, Transfer::srgb, options.threads});
    if (!written) return fail(written.error());
    if (arguments.output == "-") return kDone;
  }
  const Asked asked(*scene, *shape);
  if (arguments.format == "json")
    print_json(asked, *found);
  else
    print_text(arguments, asked, *found);
  return kDone;
}

}  // namespace

void add_influence(Command& program) {
  auto arguments = std::make_shared<InfluenceArguments>();
  Command app = program.add_command(
      "influence",
      "say which pixels a shape has a part in: seen, mirrored, through glass, by shadow");
  arguments->add_to(app);
  app.add("NAME", &arguments->name,
          "the shape: its name in the file, or its kind and number, as in sphere 3; GROUP/NAME for "
          "one of a group, in all its instances")
      .required();
  check_png_name(
      app.add("-o,--output", &arguments->output,
              "also write a PNG with these pixels marked; - is standard output, then alone"));
  app.add("--format", &arguments->format, "text (default) or json").one_of({"text", "json"});
  add_language_to(app, arguments->language);
  app.footer(
      "A shadow counts where the shape is the first that a shadow ray hits on its way to a light.\n"
      "Examples:\n"
      "  zraka influence scenes/lab/input.txt zrcalo\n"
      "  zraka influence scenes/lab/input.txt sphere 3 -o glass.png\n"
      "  zraka influence scenes/lab/input.txt sphere 3 --format json | jq .pixels\n"
      "  zraka influence room.toml chair/leg");
  app.action([arguments] { return run(*arguments); });
}

}  // namespace zraka::app
