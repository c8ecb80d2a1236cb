// SPDX-License-Identifier: Apache-2.0
#include "language/files.hpp"

#include <fmt/format.h>

#include "core/scene_folder.hpp"
#include "core/text.hpp"

namespace zraka::language {
namespace {

bool may_read_files(const toml::Node& node, std::string_view what, Input& input) {
  if (input.options.folder) return true;
  input.problems.error(node.begin, fmt::format("{} of {}: this scene comes from no file, and reads "
                                               "none",
                                               node.key, what));
  return false;
}

}  // namespace

std::optional<std::string> path_of(const toml::Node& node, std::string_view what, Input& input) {
  if (!may_read_files(node, what, input)) return std::nullopt;
  const SceneFolder folder{*input.options.folder, input.options.allow_outside};
  Result<std::string> path = folder.path_of(std::string(node.text));
  if (path) return std::move(*path);
  tell(path.error(), node, what, input);
  return std::nullopt;
}

std::shared_ptr<const Image> read_picture(const toml::Node& node, std::string_view what,
                                          Transfer transfer, Input& input) {
  if (!may_read_files(node, what, input)) return nullptr;
  const Result<std::shared_ptr<const Image>> image =
      input.images.load(std::string(node.text), transfer);
  if (image) return *image;
  tell(image.error(), node, what, input);
  return nullptr;
}

void tell(const Diagnostics& problems, const toml::Node& node, std::string_view what,
          Input& input) {
  for (const Diagnostic& problem : problems) {
    std::string place = problem.file.empty() ? "" : shown(node.text);
    for (const std::size_t number : {problem.line, problem.column})
      if (number > 0) place += fmt::format(":{}", number);
    input.problems.error(node.begin,
                         fmt::format("{} of {}: {}{}{}", node.key, what, place,
                                     place.empty() ? "" : ": ", problem.message),
                         problem.hint);
  }
}

}  // namespace zraka::language
