// SPDX-License-Identifier: Apache-2.0
// [scene]: the light that comes from everywhere, and from nowhere.
#include <fmt/format.h>

#include <variant>

#include "language/files.hpp"
#include "language/sections.hpp"
#include "language/textures.hpp"

namespace zraka::language {
namespace {

struct Gradient {
  Color bottom, top;
  Vec3 up = Sky{}.up;
  double low = Sky{}.low, high = Sky{}.high;
};
/// One of the two.
struct Panorama {
  std::optional<std::string> file;
  std::optional<TextureIndex> texture;
  Vec3 up = Sky{}.up;
};
struct Occlusion : AmbientOcclusion {
  Occlusion() { samples = 64; }
  explicit Occlusion(const AmbientOcclusion& other) : AmbientOcclusion(other) {}
};
/// A kind each, for what each kind has keys for.
struct LinearFog : Fog {};
struct ExponentialFog : Fog {};
struct SquaredFog : Fog {};
struct SceneEntry {
  Color ambient = Scene{}.ambient_light;
  std::variant<Color, Gradient, Panorama> background;
  std::optional<Occlusion> occlusion;
  std::variant<std::monostate, LinearFog, ExponentialFog, SquaredFog> fog;
};

constexpr Field kGradientFields[] = {
    field<&Gradient::bottom>(
        "bottom", {.text = "the colour straight down", .range = at_least(0), .required = true}),
    field<&Gradient::top>(
        "top", {.text = "the colour straight up", .range = at_least(0), .required = true}),
    field<&Gradient::up>("up", {.text = "which way is up", .unit = Unit::direction}),
    field<&Gradient::low>("low",
                          {.text = "up to which height it is all bottom: the height's sine, -1 "
                                   "straight down",
                           .range = from_to(-1, 1)}),
    field<&Gradient::high>("high",
                           {.text = "from which height on it is all top: the height's sine, "
                                    "more than low",
                            .range = from_to(-1, 1)}),
};
constexpr Table kGradient = table_of<Gradient>(
    "gradient", "From colour to colour, evenly with the height of the ray's direction.",
    kGradientFields);
constexpr Field kSkyPanoramaFields[] = {
    field<&Panorama::file>("file", {.text = "the picture: PNG, JPEG, BMP, TGA, PPM, PGM, PFM, HDR or OpenEXR",
                                    .unit = Unit::picture}),
    field<&Panorama::texture>("texture", {.text = "in its place, a texture of kind image"}),
    field<&Panorama::up>("up", {.text = "which way is up", .unit = Unit::direction}),
};
constexpr Table kSkyPanorama = table_of<Panorama>(
    "image", "A panorama: columns are longitudes, rows latitudes, its middle is seen towards -z.",
    kSkyPanoramaFields);

constexpr Field kOcclusionFields[] = {
    field<&AmbientOcclusion::samples>("samples", {.text = "rays over the hemisphere at each point",
                                                  .range = from_to(1, kMaxSamples)}),
    field<&AmbientOcclusion::distance>("distance",
                                       {.text = "how far away shapes matter; 0: all of them do",
                                        .unit = Unit::length,
                                        .range = at_least(0)}),
    field<&AmbientOcclusion::color>(
        "color", {.text = "the factor of the ambient light that is left", .range = at_least(0)}),
};
constexpr Table kOcclusion = table_of<Occlusion>(
    "ambient_occlusion",
    "Takes from the ambient light the share of rays over the hemisphere that meet something.",
    kOcclusionFields);

constexpr Field fog_start(std::string_view text) {
  return field<&Fog::start>("start", {.text = text, .unit = Unit::length});
}
constexpr Field fog_density() {
  return field<&Fog::density>(
      "density", {.text = "how dense it is, per unit of length", .range = at_least(0)});
}
constexpr Field fog_color() {
  return field<&Fog::color>("color", {.text = "its colour", .range = at_least(0)});
}
constexpr Field fog_planar() {
  return field<&Fog::planar>(
      "planar", {.text = "by depth from the eye instead of distance, and not over the background"});
}
constexpr Field kLinearFogFields[] = {
    fog_start("up to where there is none"),
    field<&Fog::end>("end", {.text = "from where on there is nothing else, beyond start",
                             .unit = Unit::length,
                             .range = at_least(0)}),
    fog_color(), fog_planar()};
constexpr Table kLinearFog = table_of<LinearFog>(
    "linear", "Leaves (end - d)/(end - start) at the distance d.", kLinearFogFields);
constexpr Field kExponentialFogFields[] = {fog_density(), fog_start("where it begins"), fog_color(),
                                           fog_planar()};
constexpr Table kExponentialFog = table_of<ExponentialFog>(
    "exponential", "Leaves exp(-density·(d - start)) at the distance d.", kExponentialFogFields);
constexpr Field kSquaredFogFields[] = {fog_density(), fog_start("where it begins"), fog_color(),
                                       fog_planar()};
constexpr Table kSquaredFog = table_of<SquaredFog>(
    "squared", "Leaves exp(-(density·(d - start))²) at the distance d.", kSquaredFogFields);

constexpr Field kSceneFields[] = {
    field<&SceneEntry::ambient>(
        "ambient", {.text = "the light that is everywhere", .range = at_least(0), .symbol = "Ia"}),
    table_field<&SceneEntry::background, kGradient, kSkyPanorama>(
        "background",
        {.text = "the colour of rays that hit nothing", .range = at_least(0), .by_kind = true}),
    table_field<&SceneEntry::occlusion, kOcclusion>(
        "ambient_occlusion", {.text = "how much less of the ambient light corners get"}),
    table_field<&SceneEntry::fog, kLinearFog, kExponentialFog, kSquaredFog>(
        "fog", {.text = "what distance puts over the colours", .by_kind = true}),
};
constexpr Table kSceneTable =
    table_of<SceneEntry>("scene", "The light that is everywhere, and the background.", kSceneFields);

/// The texture of a panorama; none, and the problem told, if there is anything wrong with it.
std::optional<std::uint32_t> texture_of(const Panorama& panorama, const toml::Node& node,
                                        Input& input) {
  constexpr std::string_view kWhat = "background of scene";
  const toml::Node* const named = node.find("texture");
  if (panorama.file && named != nullptr) {
    input.problems.error(named->key_begin,
                         fmt::format("{} has file and texture: expected one of them", kWhat));
    return std::nullopt;
  }
  if (panorama.texture) {
    const std::uint32_t index = panorama.texture->index;
    if (input.scene.textures[index].kind == TextureKind::image) return index;
    if (input.problems.errors() == 0)  // else it may be what could not be read
      input.problems.error(named->begin,
                           fmt::format("texture of {} is no texture of kind image", kWhat));
    return std::nullopt;
  }
  if (!panorama.file) {
    if (named == nullptr && node.find("file") == nullptr)
      input.problems.missing(
          node.begin, fmt::format("{} has no file: expected {}, {}", kWhat,
                                  kSkyPanoramaFields[0].about.text, expected_of(kSkyPanoramaFields[0])));
    return std::nullopt;
  }
  Texture texture;
  texture.kind = TextureKind::image;
  texture.mapping = TextureMapping::uv;
  texture.file = *panorama.file;
  texture.image = read_picture(*node.find("file"), kWhat, texture.transfer, input);
  input.scene.textures.push_back(std::move(texture));
  return static_cast<std::uint32_t>(input.scene.textures.size() - 1);
}

Sky gradient_of(const Gradient& g, const toml::Node& node, Input& input) {
  if (!(g.low < g.high))
    input.problems.error(node.find("background")->begin,
                         fmt::format("background of scene is all top from {} on, and all bottom up "
                                     "to {}: expected high to be more than low",
                                     g.high, g.low));
  return {.kind = Sky::Kind::gradient,
          .bottom = g.bottom,
          .top = g.top,
          .up = g.up,
          .low = g.low,
          .high = g.high};
}

/// No fog in the place of none, and of one that ends before it starts.
Fog fog_of(const SceneEntry& entry, const toml::Node& node, Input& input) {
  Fog fog;
  if (const auto* const linear = std::get_if<LinearFog>(&entry.fog)) {
    fog = *linear;
    fog.kind = Fog::Kind::linear;
    if (fog.end > fog.start) return fog;
    input.problems.error(node.find("fog")->begin,
                         fmt::format("fog of scene ends at {}, and starts at {}: expected an end "
                                     "beyond its start",
                                     fog.end, fog.start));
    return {};
  }
  if (const auto* const exponential = std::get_if<ExponentialFog>(&entry.fog)) {
    fog = *exponential;
    fog.kind = Fog::Kind::exponential;
  }
  if (const auto* const squared = std::get_if<SquaredFog>(&entry.fog)) {
    fog = *squared;
    fog.kind = Fog::Kind::squared;
  }
  return fog;
}

void set_fog(const Fog& fog, SceneEntry& entry) {
  if (fog.kind == Fog::Kind::linear) entry.fog = LinearFog{fog};
  if (fog.kind == Fog::Kind::exponential) entry.fog = ExponentialFog{fog};
  if (fog.kind == Fog::Kind::squared) entry.fog = SquaredFog{fog};
}

void read_scene(const toml::Node& node, Input& input) {
  SceneEntry entry;
  Scene& scene = input.scene;
  read_fields(node, kSceneTable, "scene", &entry, input);
  scene.ambient_light = entry.ambient;
  if (entry.occlusion) scene.ambient_occlusion = *entry.occlusion;
  scene.fog = fog_of(entry, node, input);
  if (const Color* const color = std::get_if<Color>(&entry.background)) scene.background = *color;
  if (const Gradient* const g = std::get_if<Gradient>(&entry.background))
    scene.sky = gradient_of(*g, node, input);
  if (const Panorama* const p = std::get_if<Panorama>(&entry.background))
    if (const auto texture = texture_of(*p, *node.find("background"), input))
      scene.sky = {.kind = Sky::Kind::image, .up = p->up, .texture = *texture};
}

void write_scene(Output& output) {
  const Scene& scene = output.scene;
  const Sky& sky = scene.sky;
  SceneEntry entry{scene.ambient_light, scene.background, {}, {}};
  set_fog(scene.fog, entry);
  if (sky.kind == Sky::Kind::gradient)
    entry.background = Gradient{sky.bottom, sky.top, sky.up, sky.low, sky.high};
  if (sky.kind == Sky::Kind::image)
    entry.background = Panorama{{}, TextureIndex{sky.texture}, sky.up};
  if (scene.ambient_occlusion.samples > 0) entry.occlusion = Occlusion(scene.ambient_occlusion);
  write_table("[scene]", false, kSceneTable, "scene", &entry, output.text);
}

}  // namespace

constexpr Section section::scene = {
    .key = "scene", .text = kSceneTable.text, .table = &kSceneTable, .read = read_scene, .write = write_scene};

}  // namespace zraka::language
