// SPDX-License-Identifier: Apache-2.0
// The list of formats of meshes.
#include <fmt/format.h>

#include <algorithm>

#include "core/file.hpp"
#include "core/text.hpp"
#include "mesh/mesh.hpp"

namespace zraka {
namespace {

/// The first line that is neither empty nor a comment, if there is one at the beginning.
std::string_view first_statement(std::string_view text) {
  constexpr int kMostLines = 200;
  for (int i = 0; i < kMostLines && !text.empty(); ++i) {
    const std::size_t end = std::min(text.find('\n'), text.size());
    const std::string_view line = trimmed(text.substr(0, end));
    if (!line.empty() && !line.starts_with('#')) return line;
    text.remove_prefix(std::min(end + 1, text.size()));
  }
  return {};
}

/// NFF has a v, too, alone on its line.
bool is_obj(std::string_view text) {
  std::string_view line = first_statement(text);
  const auto take_word = [&] {
    line = trimmed(line);
    const std::string_view word = line.substr(0, line.find_first_of(" \t"));
    line.remove_prefix(word.size());
    return word;
  };
  const std::string_view word = take_word();
  if (word == "mtllib") return true;
  if (word == "o" || word == "g") return text.find("\nv ") != std::string_view::npos;
  if (word != "v") return false;
  for (int i = 0; i < 3; ++i)
    if (!parse_number(take_word())) return false;
  return true;
}

bool is_ply(std::string_view text) {
  return text.starts_with("ply\n") || text.starts_with("ply\r");
}

bool is_stl(std::string_view text) {
  if (text.starts_with("solid") && text.find("facet") != std::string_view::npos) return true;
  constexpr std::size_t kHeader = 84, kFacet = 50;
  if (text.size() <= kHeader) return false;
  std::uint64_t count = 0;
  for (std::size_t i = 4; i-- > 0;) count = count << 8 | static_cast<unsigned char>(text[80 + i]);
  return count > 0 && text.size() == kHeader + kFacet * count;
}

bool is_off(std::string_view text) {
  const std::string_view line = first_statement(text);
  const std::string_view word = line.substr(0, line.find_first_of(" \t"));
  return word == "OFF" || word == "COFF" || word == "NOFF" || word == "STOFF";
}

struct MeshFormat {
  std::string_view ending;
  bool (*is)(std::string_view text);
  Result<Mesh> (*parse)(std::string_view bytes, const std::string& name);
};
constexpr MeshFormat kFormats[] = {{".obj", is_obj, parse_obj},
                                   {".ply", is_ply, parse_ply},
                                   {".stl", is_stl, parse_stl},
                                   {".off", is_off, parse_off}};
constexpr std::string_view kScenes[] = {".gltf", ".glb"};

constexpr std::uint64_t kLargest = std::uint64_t{1} << 33;

const MeshFormat* by_name(std::string_view name) {
  for (const std::string_view packed : {".gz", ".zst"})
    if (ends_with(name, packed)) name.remove_suffix(packed.size());
  for (const MeshFormat& format : kFormats)
    if (ends_with(name, format.ending)) return &format;
  return nullptr;
}

const MeshFormat* by_content(std::string_view text) {
  for (const MeshFormat& format : kFormats)
    if (format.is(text)) return &format;
  return nullptr;
}

}  // namespace

bool is_mesh(std::string_view text) {
  return by_content(text) != nullptr;
}

bool is_mesh_name(std::string_view name) {
  return by_name(name) != nullptr;
}

Result<Mesh> parse_mesh(std::string_view bytes, const std::string& name) {
  const MeshFormat* format = by_content(bytes);
  if (format == nullptr) format = by_name(name);
  if (format == nullptr) return failure(name, "is no mesh that can be read");
  return format->parse(bytes, name);
}

Result<Mesh> read_mesh(const std::string& path) {
  for (const std::string_view ending : kScenes)
    if (ends_with(path, ending))
      return failure(path, fmt::format("is a scene: meshes of {} files are not taken out", ending),
                     "most programs that write them write .obj or .ply, too");
  if (const MeshFormat* const format = by_name(path)) {
    const Result<std::string> bytes = read_file(path, kLargest);
    if (!bytes) return tl::make_unexpected(bytes.error());
    return format->parse(*bytes, path);
  }
  return failure(path, "its name ends like that of no mesh: expected .obj, .ply, .stl or .off");
}

}  // namespace zraka
