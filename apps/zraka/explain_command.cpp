// SPDX-License-Identifier: Apache-2.0
// zraka explain: why a pixel has its colour.
#include <fmt/format.h>

#include <charconv>
#include <filesystem>
#include <limits>

#include "commands.hpp"
#include "core/text.hpp"
#include "core/words.hpp"
#include "explain/json.hpp"
#include "explain/page.hpp"
#include "explain/rays_file.hpp"
#include "explain/segments.hpp"
#include "explain/sentence.hpp"
#include "explain/text.hpp"
#include "render_options.hpp"
#include "terminal.hpp"

namespace zraka::app {
namespace {

struct ExplainArguments : RenderArguments {
  std::string x, y;
  std::string output = "-";
  std::string format;  // "": by the output's name
  std::string language = "en";
  std::string stage = "refraction", mistake;
  std::string rays;  // a file for the segments
  std::string sample = "1";
};

/// A column or a row: a whole number. What is too large for any picture is the largest that fits.
std::optional<std::uint32_t> coordinate(const std::string& word) {
  std::uint32_t value = 0;
  const auto [end, error] = std::from_chars(word.data(), word.data() + word.size(), value);
  if (end != word.data() + word.size() || error == std::errc::invalid_argument) return std::nullopt;
  return error == std::errc() ? value : std::numeric_limits<std::uint32_t>::max();
}

bool is_rays_file(const std::string& path) {
  const std::string extension = std::filesystem::path(path).extension().string();
  return extension == ".obj" || extension == ".gltf";
}

Result<void> write_rays(const ExplainArguments& arguments, const Scene& scene,
                        const Explanation& explanation) {
  const std::vector<Segment> segments = segments_of(scene, explanation);
  const bool obj = std::filesystem::path(arguments.rays).extension() == ".obj";
  return write_text_file(
      arguments.rays,
      obj ? rays_as_obj(segments, fmt::format("rays of pixel ({}, {}) of {}", explanation.x,
                                              explanation.y, shown(arguments.scene)))
          : rays_as_gltf(segments));
}

/// The explanation in the format that is asked for.
Result<std::string> text_for(const ExplainArguments& arguments, Scene& scene,
                             const RenderOptions& options, Explainer& explainer,
                             const Explanation& explanation) {
  constexpr std::uint32_t kNeighbours = 15;
  const Language language = *language_named(arguments.language);
  const ProfileName profile = arguments.profile_name(scene);
  const std::string format = format_of(arguments.format, arguments.output);
  if (format == "json")
    return to_json(explanation, arguments.scene, std::string(name_of(profile)),
                   in_words(language, explanation));
  if (format == "text")
    return to_text(explanation, {.language = language,
                                 .color = arguments.output == "-" && output_in_color(),
                                 .scene = arguments.scene,
                                 .profile = profile});
  PagePictures pictures{{}, explainer.around(explanation.x, explanation.y, kNeighbours)};
  Result<Image> picture = picture_for_page(scene, options);
  if (!picture) return tl::make_unexpected(picture.error());
  pictures.picture = std::move(*picture);
  return to_page(scene, explanation, pictures,
                 {.language = language, .scene = arguments.scene, .profile = profile});
}

int run(const ExplainArguments& arguments) {
  speak(*language_named(arguments.language));
  Result<Scene> scene = arguments.load({arguments.output, arguments.rays});
  if (!scene) return fail(scene.error());
  RenderOptions options = arguments.options(*scene);
  options.terms = terms_of(*stage_named(arguments.stage), *scene);
  Result<Explainer> explainer = mistaken_explainer(*scene, options, mistake_of(arguments.mistake));
  if (!explainer) return fail(explainer.error());
  const Result<Explanation> explanation = explainer->pixel(
      *coordinate(arguments.x), *coordinate(arguments.y), *coordinate(arguments.sample) - 1);
  if (!explanation) return fail(explanation.error());
  const Result<std::string> text = text_for(arguments, *scene, options, *explainer, *explanation);
  if (!text) return fail(text.error());
  if (!arguments.rays.empty()) {
    const Result<void> written = write_rays(arguments, *scene, *explanation);
    if (!written) return fail(written.error());
  }
  const Result<void> written = write_text_file(arguments.output, *text);
  return written ? +kDone : fail(written.error());
}

}  // namespace

void add_explain(Command& program) {
  auto arguments = std::make_shared<ExplainArguments>();
  Command app = program.add_command("explain",
                                    "say why a pixel has its colour: its ray tree with every term");
  arguments->add_to(app);
  arguments->sampling.add_to(app);
  arguments->look.add_to(app);
  add_mistake_to(app, arguments->mistake);
  constexpr auto kWhole = "a whole number, 0 or more";
  const auto is_whole = [](const std::string& word) { return coordinate(word).has_value(); };
  app.add("X", &arguments->x, "column of the pixel, from 0 at the left")
      .required()
      .check(kWhole, is_whole);
  app.add("Y", &arguments->y, "row of the pixel, from 0 at the top")
      .required()
      .check(kWhole, is_whole);
  app.add("--sample", &arguments->sample, "which of the pixel's samples, from 1 (the default)")
      .check("a whole number, 1 or more",
             [](const std::string& word) { return coordinate(word).value_or(0) > 0; });
  app.add("-o,--output", &arguments->output, "the file to write; - (default) is standard output");
  add_format_to(app, arguments->format);
  add_language_to(app, arguments->language);
  add_stage_to(app, arguments->stage);
  app.add("--rays", &arguments->rays, "also write all rays as lines: NAME.obj or NAME.gltf")
      .check("the name of a .obj or a .gltf", is_rays_file);
  app.footer(
      "Examples:\n"
      "  zraka explain scenes/lab/input.txt 110 160\n"
      "  zraka explain input.txt 250 300 --stage shadows --lang hr\n"
      "  zraka explain input.txt 250 300 --format json | jq .tree.hit.lights\n"
      "  zraka explain input.txt 250 300 -o pixel.html --rays rays.gltf");
  app.check([arguments] { return arguments->look.problem(); });
  app.action([arguments] { return run(*arguments); });
}

}  // namespace zraka::app
