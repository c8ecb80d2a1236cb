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

Result<ReadScene> parse_text(std::string_view text, const std::string& name, const Passed& passed) {
  for (const Format& format : kFormats) {
    if (!format.looks_like(text)) continue;
    Result<ReadScene> read =
        text.size() <= format.largest
            ? format.parse(text, name, passed)
            : failure(name, fmt::format("is too large: over {} bytes", format.largest));
    if (read) read->scene.format = format.name;
    return read;
  }
  return failure(name, "is of no known format");
}

}  // namespace

Result<ReadScene> parse_scene(std::string_view text, const std::string& name) {
  return parse_text(text, name, [](const char*) {});
}

Result<ReadScene> read_scene(const std::string& path) {
  const Result<FileText> file = FileText::open(path, kFormats.front().largest);
  if (!file) return tl::make_unexpected(file.error());
  return parse_text(file->view(), path == "-" ? "standard input" : path,
                    [&](const char* at) { file->pass(at); });
}

}  // namespace zraka
