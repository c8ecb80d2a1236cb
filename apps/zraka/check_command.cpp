// SPDX-License-Identifier: Apache-2.0
// zraka check: what is wrong with a scene file.
#include <fmt/format.h>

#include <memory>

#include "commands.hpp"
#include "terminal.hpp"
#include "zraka/lint.hpp"
#include "zraka/zraka.hpp"

namespace zraka::app {
namespace {

int run(const std::string& scene) {
  Result<ReadScene> read = read_scene(scene);
  if (!read) return fail(read.error());
  show(read->warnings);
  const Diagnostics wrong = about(scene, check(read->scene));
  if (!wrong.empty()) return fail(wrong);
  show(about(scene, lint(read->scene)));
  return kDone;
}

}  // namespace

void add_check(Command& program) {
  auto scene = std::make_shared<std::string>();
  Command app = program.add_command("check", "say what is wrong or odd in a scene file");
  app.add("SCENE", scene.get(), "the scene file; - reads standard input").required();
  app.footer(
      "Prints nothing where all is well. What can be rendered but is odd gets a warning, and the\n"
      "exit code is 0.\n"
      "Examples:\n"
      "  zraka check scene.toml\n"
      "  zraka check scenes/lab/input.txt && echo all is well");
  app.action([scene] { return run(*scene); });
}

}  // namespace zraka::app
