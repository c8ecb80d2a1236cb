// SPDX-License-Identifier: Apache-2.0
// The list of scene formats, and how a file finds its own.
#include "formats/formats.hpp"

#include <algorithm>
#include <array>
#include <filesystem>

#include "core/file.hpp"
#include "core/phrase.hpp"
#include "core/text.hpp"
#include "core/unpack.hpp"
#include "formats/foreign.hpp"
#include "mesh/mesh.hpp"
#include "particles/particles.hpp"

namespace zraka {
namespace {

/// Found by the content where it tells, for names can be anything, else by the name's ending.
constexpr std::array kFormats = {
    Format{"mesh", "", std::uint64_t{1} << 33, likeness_to_mesh, parse_mesh_scene},
    Format{"NFF", ".nff", std::uint64_t{1} << 36, likeness_to_nff, parse_nff},
    Format{"TOML", ".toml", std::uint64_t{1} << 30, likeness_to_toml, parse_toml},
    Format{"Tachyon", ".dat", std::uint64_t{1} << 36, likeness_to_tachyon, parse_tachyon_scene},
    Format{"glTF", ".gltf", std::uint64_t{1} << 32, likeness_to_gltf, parse_gltf},
    Format{"Ray Tracer Challenge", ".yml", std::uint64_t{1} << 22, likeness_to_challenge,
           parse_challenge},
    Format{"CSE 167", ".test", std::uint64_t{1} << 30, likeness_to_cse167, parse_cse167},
    Format{"particles", "", kLargestParticleFile, likeness_to_particles, parse_particle_scene},
    Format{"lab input.txt", "", std::uint64_t{1} << 30, likeness_to_lab_input, parse_lab_input},
};

constexpr const Format& kMeshes = kFormats[0];
constexpr const Format& kNff = kFormats[1];
constexpr const Format& kParticles = kFormats[7];
static_assert(kMeshes.parse == parse_mesh_scene && kNff.parse == parse_nff &&
              kParticles.parse == parse_particle_scene);

/// A name as it is before gzip or zstd.
std::string_view unpacked_name(std::string_view name) {
  for (const std::string_view packed : {".gz", ".zst"})
    if (ends_with(name, packed)) name.remove_suffix(packed.size());
  return name;
}

const Format* format_of(std::string_view text, std::string_view name) {
  name = unpacked_name(name);
  if (text.starts_with(kByteOrderMark)) text.remove_prefix(kByteOrderMark.size());
  for (const Format& format : kFormats)
    if (format.likeness(text) == Likeness::sure) return &format;
  for (const Format& format : kFormats)
    if (ends_with(name, format.ending)) return &format;
  if (particle_format_of(text, name) != nullptr) return &kParticles;
  if (is_mesh_name(name)) return &kMeshes;
  for (const Format& format : kFormats)
    if (format.likeness(text) == Likeness::possible) return &format;
  return nullptr;
}

Result<ReadScene> parse_text(std::string_view text, const std::string& name,
                             const ReadOptions& options) {
  const Format* const format = format_of(text, name);
  // Some have words of their own for it.
  const bool is_utf16 = text.starts_with("\xFF\xFE") || text.starts_with("\xFE\xFF");
  if (is_utf16 && (format == nullptr ||
                   (format->parse != parse_lab_input && format->parse != parse_tachyon_scene)))
    return failure(name, phrase(Word::path_utf16), phrase(Word::lab_utf16));
  // The lab's reader takes whatever begins with a number.
  std::string_view beginning = text;
  if (beginning.starts_with(kByteOrderMark)) beginning.remove_prefix(kByteOrderMark.size());
  const bool is_own =
      format != nullptr &&
      (format->parse == parse_toml || format == &kParticles ||
       (format->parse != parse_lab_input && format->likeness(beginning) == Likeness::sure));
  if (const ForeignFormat foreign = foreign_format_of(beginning);
      !is_own && !foreign.english.empty())
    return failure(name,
                   phrase(Word::path_foreign,
                          Phrase{std::string(foreign.english), std::string(foreign.croatian)}),
                   phrase(Word::path_formats));
  if (format == nullptr)
    return failure(name, phrase(Word::path_no_format), phrase(Word::path_formats));
  Result<ReadScene> read = text.size() <= format->largest
                               ? format->parse(text, name, options)
                               : failure(name, phrase(Word::path_too_large, format->largest));
  if (read) read->scene.format = format->name;
  return read;
}

}  // namespace

Result<ReadScene> parse_scene(std::string_view text, const std::string& name,
                              const ReadOptions& options) {
  return parse_text(text, name, options);
}

Result<ReadScene> read_scene(const std::string& path, const ReadOptions& given) {
  constexpr std::size_t kBeginning = std::size_t{1} << 16, kBlock = std::size_t{1} << 18;
  const Format& nff = kNff;
  if (std::optional<LargeFile> file = LargeFile::open(path, nff.largest)) {
    std::string beginning(kBeginning, '\0');
    beginning.resize(file->read(beginning.data(), kBeginning));
    file->rewind();
    if (format_of(beginning, path) == &nff)
      if (std::optional<ReadScene> read = read_nff_by_blocks(*file, path, kBlock)) {
        read->scene.format = nff.name;
        return std::move(*read);
      }
    if (file->shortened()) return failure(path, phrase(Word::path_shortened));
  }
  // What comes without end is not waited for where its beginning is no scene's.
  const auto goes_on = [&](std::string_view beginning) {
    if (is_packed(beginning)) return true;
    const Format* const format = format_of(beginning, path);
    return format != nullptr && format->likeness(beginning) == Likeness::sure;
  };
  Result<std::string> text = read_file(path, nff.largest, goes_on);
  if (text && is_packed(*text)) text = unpacked(*text, path);
  if (!text) return tl::make_unexpected(text.error());
  ReadOptions options = given;
  if (!options.folder) options.folder = std::filesystem::path(path).parent_path().string();
  return parse_text(*text, path == "-" ? "standard input" : path, options);
}

}  // namespace zraka
