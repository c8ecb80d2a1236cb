// SPDX-License-Identifier: Apache-2.0
// The list of scene formats, and how a file finds its own.
#include "formats/formats.hpp"

#include <fmt/format.h>

#include <array>

#include "core/file.hpp"

namespace zraka {
namespace {

/// Found by the content where it tells, for names can be anything; the last stands for all else.
constexpr std::array kFormats = {
    Format{"NFF", std::uint64_t{1} << 36, looks_like_nff, parse_nff},
    Format{"lab input.txt", std::uint64_t{1} << 30, [](std::string_view) { return true; },
           parse_lab_input},
};

}  // namespace

Result<ReadScene> parse_scene(std::string_view text, const std::string& name) {
  for (const Format& format : kFormats) {
    if (!format.looks_like(text)) continue;
    Result<ReadScene> read =
        text.size() <= format.largest
            ? format.parse(text, name)
            : failure(name, fmt::format("is too large: over {} bytes", format.largest));
    if (read) read->scene.format = format.name;
    return read;
  }
  return failure(name, "is of no known format");
}

Result<ReadScene> read_scene(const std::string& path) {
  const Result<std::string> text = read_file(path, kFormats.front().largest);
  if (!text) return tl::make_unexpected(text.error());
  return parse_scene(*text, path == "-" ? "standard input" : path);
}

}  // namespace zraka
