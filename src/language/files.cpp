// SPDX-License-Identifier: Apache-2.0
#include "language/files.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>

#include "core/text.hpp"

namespace zraka::language {
namespace {

namespace fs = std::filesystem;

/// Whether a path is the folder's or below it, links followed.
bool is_inside(const fs::path& path, const fs::path& folder) {
  std::error_code error;
  const fs::path whole = fs::weakly_canonical(folder, error);
  if (error) return false;
  const fs::path target = fs::weakly_canonical(path, error);
  if (error) return false;
  const auto [end, rest] = std::mismatch(whole.begin(), whole.end(), target.begin(), target.end());
  return end == whole.end() && rest != target.end();
}

}  // namespace

std::optional<std::string> path_of(const toml::Node& node, std::string_view what, Input& input) {
  const auto refuse = [&](std::string_view problem, std::string hint) {
    input.problems.error(node.begin,
                         fmt::format("{} of {}: {} {}", node.key, what, shown(node.text), problem),
                         std::move(hint));
    return std::nullopt;
  };
  if (node.text.empty() || node.text.find('\0') != std::string_view::npos)
    return refuse("no file is called so", "");
  if (!input.options.folder)
    return refuse("is a file, but this scene comes from none, and reads none", "");
  const fs::path folder = input.options.folder->empty() ? "." : *input.options.folder;
  const fs::path path = folder / fs::path(node.text);
  if (!input.options.allow_outside && !is_inside(path, folder))
    return refuse("leads out of the scene file's folder", "--allow-outside allows that");
  return path.string();
}

void tell(const Diagnostics& problems, const toml::Node& node, std::string_view what,
          Input& input) {
  for (const Diagnostic& problem : problems) {
    std::string place = shown(node.text);
    for (const std::size_t number : {problem.line, problem.column})
      if (number > 0) place += fmt::format(":{}", number);
    input.problems.error(node.begin,
                         fmt::format("{} of {}: {}: {}", node.key, what, place, problem.message),
                         problem.hint);
  }
}

std::shared_ptr<const Image> read_picture(const toml::Node& node, std::string_view what,
                                          Input& input) {
  const std::optional<std::string> path = path_of(node, what, input);
  if (!path) return nullptr;
  if (const auto known = input.pictures.find(*path); known != input.pictures.end())
    return known->second;
  Result<ReadImage> read = read_image(*path);
  if (!read) {
    tell(read.error(), node, what, input);
    return nullptr;
  }
  return input.pictures[*path] = std::make_shared<const Image>(std::move(read->image));
}

}  // namespace zraka::language
