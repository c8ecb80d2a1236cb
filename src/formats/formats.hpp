// SPDX-License-Identifier: Apache-2.0
// What a reader provides. The list of readers is in formats.cpp.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <zraka/formats.hpp>

namespace zraka {

class LargeFile;

/// Whether a text may be of a format.
enum class Likeness { none, possible, sure };

struct Format {
  const char* name;         ///< for people
  std::string_view ending;  ///< of its files' names, if any tells
  std::uint64_t largest;  ///< bytes that a file may have; NFF's is the largest of all
  Likeness (*likeness)(std::string_view text);  ///< after a byte order mark, if there is one
  Result<ReadScene> (*parse)(std::string_view text, const std::string& name,
                             const ReadOptions& options);
};

/// May stand before any UTF-8.
inline constexpr std::string_view kByteOrderMark = "\xEF\xBB\xBF";

/// Sure where the text begins, comments aside, with a statement of NFF, whether or not it may stand
/// first.
Likeness likeness_to_nff(std::string_view text);
Result<ReadScene> parse_nff(std::string_view text, const std::string& name,
                    const ReadOptions& options = {});
/// The same by blocks of about so many bytes, on all threads.
Result<ReadScene> parse_nff_by_blocks(std::string_view text, const std::string& name,
                                      std::size_t block);
/// Reads a file of NFF block by block, so that it is never in memory whole. Nothing where there is
/// any problem with it, even one to warn of: parse_nff() has words for it.
std::optional<ReadScene> read_nff_by_blocks(LargeFile& file, const std::string& name,
                                            std::size_t block);
/// Sure where the text begins, comments aside, with BEGIN_SCENE.
Likeness likeness_to_tachyon(std::string_view text);
Result<ReadScene> parse_tachyon_scene(std::string_view text, const std::string& name,
                                      const ReadOptions& options = {});
/// Sure where the text begins with a label or a value, possible where its first line may have been
/// meant as one, or if it is empty or no text, which the reader has words for.
Likeness likeness_to_lab_input(std::string_view text);
Result<ReadScene> parse_lab_input(std::string_view text, const std::string& name,
                    const ReadOptions& options = {});
/// Sure where the text begins, comments aside, with a header or a key and '='.
Likeness likeness_to_toml(std::string_view text);
Result<ReadScene> parse_toml(std::string_view text, const std::string& name,
                    const ReadOptions& options = {});

/// Sure where the content is one of the formats of meshes (mesh/read_mesh.cpp).
Likeness likeness_to_mesh(std::string_view text);
/// With a camera and lights that show all of it.
Result<ReadScene> parse_mesh_scene(std::string_view bytes, const std::string& name,
                                   const ReadOptions& options = {});

/// Sure where it is GLB, or JSON with an asset.
Likeness likeness_to_gltf(std::string_view text);
Result<ReadScene> parse_gltf(std::string_view text, const std::string& name,
                             const ReadOptions& options = {});

/// Sure where the text begins, comments aside, with an item that is added or defined.
Likeness likeness_to_challenge(std::string_view text);
Result<ReadScene> parse_challenge(std::string_view text, const std::string& name,
                                  const ReadOptions& options = {});
/// Sure where the text begins, comments aside, with its size, camera or depth.
Likeness likeness_to_cse167(std::string_view text);
Result<ReadScene> parse_cse167(std::string_view text, const std::string& name,
                               const ReadOptions& options = {});

/// Sure where the content is one of the formats of particles (particles/read_particles.cpp).
Likeness likeness_to_particles(std::string_view text);
/// With a look, a camera and lights that show all of it.
Result<ReadScene> parse_particle_scene(std::string_view bytes, const std::string& name,
                                       const ReadOptions& options = {});

}  // namespace zraka
