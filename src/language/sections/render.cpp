// SPDX-License-Identifier: Apache-2.0
// [render]: how the picture is made, where the command line does not say it.
#include <fmt/format.h>

#include <array>
#include <variant>

#include "language/sections.hpp"

namespace zraka::language {
namespace {

struct Grid {
  int grid = 2;
};
struct Adaptive {
  std::array<int, 2> adaptive{4, 64};
  double contrast = Sampling{}.contrast;
};
struct RenderEntry : RenderDefaults {
  std::variant<int, Grid, Adaptive> samples = 1;
  PixelFilter filter = PixelFilter::box;
  std::uint32_t seed = 0;
};

constexpr Choice kProfiles[] = {
    {"lab", "the course's rules, to the letter"},
    {"physical", "optics' rules"},
    {"spd", "the rules by which the Standard Procedural Databases count rays"},
    {"tachyon", "the rules of Tachyon, whose pictures store light as it is"},
};
constexpr Choice kShadows[] = {
    {"opaque", "whatever stands between a point and a light puts the point in shadow"},
    {"off", "there are none"},
    {"transparent", "each body that a shadow ray passes takes its share of the light"},
};
constexpr Choice kFilters[] = {
    {"box", "their mean"},
    {"tent", "less the farther from its middle, up to 1 pixel"},
    {"gauss", "by a bell curve, up to 1.5 pixels"},
    {"mitchell", "by Mitchell and Netravali (1988), up to 2 pixels, which sharpens edges"},
};

constexpr Field kGridFields[] = {
    field<&Grid::grid>(
        "grid", {.text = "how many in a row", .range = from_to(1, kMaxGrid), .required = true}),
};
constexpr Table kGrid = table_of<Grid>(
    "grid", "As many rows as there are in a row, in the middles of equal squares.", kGridFields);
constexpr Field kAdaptiveFields[] = {
    field<&Adaptive::adaptive>(
        "adaptive",
        {.text = "the fewest and the most", .range = from_to(1, kMaxSamples), .required = true}),
    field<&Adaptive::contrast>("contrast", {.text = "the difference between samples or neighbours "
                                                    "above which there are more",
                                            .range = from_to(0, 1)}),
};
constexpr Table kAdaptive =
    table_of<Adaptive>("adaptive", "More where the picture needs them.", kAdaptiveFields);

constexpr Field kRenderFields[] = {
    field<&RenderDefaults::profile>("profile",
                                    {.text = "the rules of light", .choices = kProfiles}),
    field<&RenderDefaults::max_depth>("max_depth",
                                      {.text = "levels of rays after those from the eye",
                                       .range = from_to(0, static_cast<double>(kMaxDepth))}),
    field<&RenderDefaults::min_contribution>(
        "min_contribution",
        {.text = "a ray that cannot bring its pixel as much as this is not traced",
         .range = at_least(0)}),
    field<&RenderDefaults::shadows>("shadows",
                                    {.text = "what shadow rays do", .choices = kShadows}),
    table_field<&RenderEntry::samples, kGrid, kAdaptive>(
        "samples", {.text = "rays a pixel; 1 goes through its middle, more are spread evenly",
                    .range = from_to(1, kMaxSamples)}),
    field<&RenderEntry::filter>("filter", {.text = "how samples become a pixel", .choices = kFilters}),
    field<&RenderDefaults::wavelengths>(
        "wavelengths", {.text = "into how many a ray splits that a dispersive body refracts",
                        .range = from_to(1, kMaxWavelengths)}),
    field<&RenderEntry::seed>("seed", {.text = "another one, other random numbers",
                                 .range = from_to(0, std::numeric_limits<std::uint32_t>::max())}),
};
constexpr Table kRenderTable =
    table_of<RenderEntry>("render", "How the picture is made; the command line wins.", kRenderFields);

struct SamplingOf {
  Sampling operator()(int count) const { return {.count = count}; }
  Sampling operator()(const Grid& grid) const {
    return {.kind = Sampling::Kind::grid, .count = grid.grid};
  }
  Sampling operator()(const Adaptive& a) const {
    return {Sampling::Kind::adaptive, a.adaptive[0], a.adaptive[1], a.contrast};
  }
};

void read_render(const toml::Node& node, Input& input) {
  RenderEntry entry;
  read_fields(node, kRenderTable, "render", &entry, input);
  if (const Adaptive* const a = std::get_if<Adaptive>(&entry.samples);
      a != nullptr && a->adaptive[0] > a->adaptive[1])
    input.problems.error(
        node.find("samples")->find("adaptive")->begin,
        fmt::format("adaptive of samples of render is [{}, {}]: expected the fewest, then the most",
                    a->adaptive[0], a->adaptive[1]));
  entry.sampling = std::visit(SamplingOf(), entry.samples);
  entry.sampling.filter = entry.filter;
  entry.sampling.seed = entry.seed;
  input.scene.defaults = entry;
}

void write_render(Output& output) {
  RenderEntry entry{output.scene.defaults, {}, {}, {}};
  const Sampling& sampling = entry.sampling;
  switch (sampling.kind) {
    case Sampling::Kind::sobol:
      entry.samples = sampling.count;
      break;
    case Sampling::Kind::grid:
      entry.samples = Grid{sampling.count};
      break;
    case Sampling::Kind::adaptive:
      entry.samples = Adaptive{{sampling.count, sampling.most}, sampling.contrast};
      break;
  }
  entry.filter = sampling.filter;
  entry.seed = sampling.seed;
  write_table("[render]", false, kRenderTable, "render", &entry, output.text);
}

}  // namespace

constexpr Section section::render = {
    .key = "render", .text = kRenderTable.text, .table = &kRenderTable, .read = read_render, .write = write_render};

}  // namespace zraka::language
