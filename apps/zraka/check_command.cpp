// SPDX-License-Identifier: Apache-2.0
// zraka check: what is wrong with a scene file.
#include <fmt/format.h>

#include <memory>

#include "commands.hpp"
#include "scene_files.hpp"
#include "terminal.hpp"
#include "zraka/lint.hpp"
#include "zraka/zraka.hpp"

namespace zraka::app {
namespace {

struct CheckArguments {
  std::string scene;
  ReadOptions files;
};

int run(const CheckArguments& arguments) {
  const std::string& scene = arguments.scene;
  Result<ReadScene> read = read_scene(scene, arguments.files);
  if (!read) return fail(read.error());
  show(read->warnings);
  const Diagnostics wrong = about(scene, check(read->scene));
  if (!wrong.empty()) return fail(wrong);
  show(about(scene, lint(read->scene)));
  return kDone;
}

}  // namespace

void add_check(Command& program) {
  auto arguments = std::make_shared<CheckArguments>();
  Command app = program.add_command("check", "say what is wrong or odd in a scene file");
  app.add("SCENE", &arguments->scene, "the scene file; - reads standard input").required();
  add_allow_outside_to(app, arguments->files);
  app.footer(
      "Prints nothing where all is well. What can be rendered but is odd gets a warning, and the\n"
      "exit code is 0.\n"
      "Examples:\n"
      "  zraka check scene.toml\n"
      "  zraka check scenes/lab/input.txt && echo all is well");
  app.action([arguments] { return run(*arguments); });
}

}  // namespace zraka::app
