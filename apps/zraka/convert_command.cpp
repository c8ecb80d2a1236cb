// SPDX-License-Identifier: Apache-2.0
// zraka convert and zraka format: scenes written in a format, or in their canonical form.
#include <fmt/format.h>

#include <filesystem>
#include <memory>
#include <set>

#include "commands.hpp"
#include "core/new_file.hpp"
#include "core/text.hpp"
#include "formats/writers.hpp"
#include "scene_files.hpp"
#include "terminal.hpp"
#include "zraka/zraka.hpp"

namespace zraka::app {
namespace {

struct ConvertArguments {
  std::string scene, output = "-", format;
  bool quiet = false;
  ReadOptions files;
};

/// Pictures that the written scene names where they are not.
Diagnostics lost_files(const Scene& scene, const std::string& output) {
  namespace fs = std::filesystem;
  Diagnostics lost;
  std::set<std::string> seen;
  std::error_code error;
  for (const Texture& texture : scene.textures)
    if (!texture.file.empty() && seen.insert(texture.file).second &&
        !fs::exists(fs::path(output).parent_path() / texture.file, error))
      lost.push_back({.severity = Severity::warning,
                      .file = output,
                      .message = fmt::format("names the picture {}, which is not beside it",
                                             shown(texture.file)),
                      .hint = "names of files start at the scene's folder"});
  return lost;
}

int run(const ConvertArguments& arguments) {
  if (const Result<void> apart = check_outputs({arguments.scene}, {arguments.output}); !apart)
    return fail(apart.error());
  Result<ReadScene> read = read_scene(arguments.scene, arguments.files);
  if (!read) return fail(read.error());
  if (!arguments.quiet) show(read->warnings);
  const Result<WrittenScene> written =
      write_scene(read->scene, arguments.format.empty() ? arguments.output : arguments.format);
  if (!written) return fail(about(arguments.scene, written.error()));
  if (!arguments.quiet) show(about(arguments.scene, written->losses));
  const Result<void> saved = write_text_file(arguments.output, written->text);
  if (!saved) return fail(saved.error());
  if (!arguments.quiet && arguments.output != "-") show(lost_files(read->scene, arguments.output));
  return kDone;
}

}  // namespace

void add_convert(Command& program) {
  auto arguments = std::make_shared<ConvertArguments>();
  Command app = program.add_command("convert", "write a scene in another format");
  app.add("SCENE", &arguments->scene, "the scene file; - reads standard input").required();
  app.add("OUTPUT", &arguments->output, "the file to write; - is standard output").required();
  std::vector<std::string> keys;
  for (const SceneWriter& writer : scene_writers()) keys.emplace_back(writer.key);
  app.add("--to", &arguments->format, "a format (lab is input.txt); else by the output's name")
      .one_of(keys);
  app.add("-q,--quiet", &arguments->quiet, "say nothing of what the format cannot hold");
  add_allow_outside_to(app, arguments->files);
  app.footer(
      "Examples:\n"
      "  zraka convert scenes/lab/input.txt scene.toml\n"
      "  zraka convert scene.toml scene.pov && povray +W400 +H400 scene.pov\n"
      "  zraka convert molecule.pdb - --to tachyon");
  app.action([arguments] { return run(*arguments); });
}

void add_format(Command& program) {
  auto arguments = std::make_shared<ConvertArguments>();
  arguments->format = "toml";
  Command app =
      program.add_command("format", "write a scene in the scene language's canonical form");
  app.add("SCENE", &arguments->scene, "the scene file; - reads standard input").required();
  app.add("-o,--output", &arguments->output, "the file to write; - (default) is standard output");
  add_allow_outside_to(app, arguments->files);
  app.footer(
      "Comments are not kept, and what is short for something else is written out.\n"
      "Examples:\n"
      "  zraka format scene.toml\n"
      "  zraka format scene.toml -o formatted.toml");
  app.action([arguments] { return run(*arguments); });
}

}  // namespace zraka::app
