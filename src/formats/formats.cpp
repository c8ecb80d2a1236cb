// SPDX-License-Identifier: Apache-2.0
// The list of scene formats, and how a file finds its own.
#include "formats/formats.hpp"

#include <array>

#include "core/file.hpp"

namespace zraka {
namespace {

/// The first whose extension a file has; the last stands for files of any name.
constexpr std::array kFormats = {
    Format{"NFF", ".nff", std::uint64_t{1} << 36, parse_nff},
    Format{"lab input.txt", "", std::uint64_t{1} << 30, parse_lab_input},
};

const Format& format_of(std::string_view name) {
  for (const Format& format : kFormats)
    if (*format.extension != '\0' && name.ends_with(format.extension)) return format;
  return kFormats.back();
}

}  // namespace

Result<ReadScene> parse_scene(std::string_view text, const std::string& name) {
  const Format& format = format_of(name);
  Result<ReadScene> read = format.parse(text, name);
  if (read) read->scene.format = format.name;
  return read;
}

Result<ReadScene> read_scene(const std::string& path) {
  const Result<std::string> text = read_file(path, format_of(path).largest);
  if (!text) return tl::make_unexpected(text.error());
  return parse_scene(*text, path == "-" ? "standard input" : path);
}

}  // namespace zraka
