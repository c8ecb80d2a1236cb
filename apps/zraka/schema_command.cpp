// SPDX-License-Identifier: Apache-2.0
// zraka schema: the scene language for editors.
#include <fmt/format.h>

#include <memory>

#include "commands.hpp"
#include "language/help.hpp"
#include "terminal.hpp"
#include "zraka/zraka.hpp"

namespace zraka::app {

void add_schema(Command& program) {
  auto output = std::make_shared<std::string>("-");
  Command app = program.add_command("schema", "print the JSON Schema of the scene language");
  app.add("-o,--output", output.get(), "the file to write; - (default) is standard output");
  app.footer(
      "Editors that know TOML complete and check scenes with it.\n"
      "Examples:\n"
      "  zraka schema -o zraka.schema.json");
  app.action([output] {
    const Result<void> written = write_text_file(*output, language::json_schema());
    return written ? +kDone : fail(written.error());
  });
}

}  // namespace zraka::app
