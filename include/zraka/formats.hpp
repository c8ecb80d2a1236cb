// SPDX-License-Identifier: Apache-2.0
// Scenes from files and into files.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <zraka/api.hpp>
#include <zraka/diagnostic.hpp>
#include <zraka/scene.hpp>

namespace zraka {

/// What the colours of particles mean that a column of numbers has coloured.
struct ColorLegend {
  std::string title;                  ///< the column's name
  double low = 0, high = 0;           ///< the numbers of the first and of the last colour
  std::vector<std::uint32_t> colors;  ///< sRGB as 0xRRGGBB, evenly from low to high
  friend bool operator==(const ColorLegend&, const ColorLegend&) = default;
};

/// A scene and what its reader had to remark; warnings only, for errors make the reading fail.
struct ReadScene {
  Scene scene;
  Diagnostics warnings;
  std::vector<ColorLegend> legends{};
};

/// What the reader of a scene may do with names of other files in it: pictures, meshes.
struct ReadOptions {
  /// Where such names start; read_scene() takes the scene file's folder where nothing is said, and
  /// parse_scene() then reads no files.
  std::optional<std::string> folder{};
  bool allow_outside = false;  ///< whether names may lead out of the folder
  /// Of a file of particles: element, or the column whose numbers become colours; "": the file's
  /// own colours, else by element. A scene says that for itself.
  std::string color_by{};
  std::string color_map{};  ///< viridis if nothing is said
};

/// Reads a scene file. Fails with all the problems of the file at once.
ZRAKA_API Result<ReadScene> read_scene(const std::string& path, const ReadOptions& options = {});

/// The same from memory; `name` stands for the file in messages.
ZRAKA_API Result<ReadScene> parse_scene(std::string_view text, const std::string& name,
                                        const ReadOptions& options = {});

/// A scene in the course's input.txt format. Fails if the scene has what that format cannot say.
ZRAKA_API Result<std::string> write_lab_input(const Scene& scene);

/// A scene in the scene language (docs/scene-language/), in its canonical form: reading it gives an
/// equal scene, and writing that the same text. Materials without a name get one. Fails if the
/// scene has what the language cannot say.
ZRAKA_API Result<std::string> write_toml(const Scene& scene);

/// A scene as a file, and what it has lost by that: warnings.
struct WrittenScene {
  std::string text;
  Diagnostics losses;
};

/// A scene in a format: "toml", "nff", "tachyon", "povray" or "lab", or a file's name that ends like
/// one of the format. Fails if the format cannot say where the picture's window is, or has no such
/// shapes or lights.
ZRAKA_API Result<WrittenScene> write_scene(const Scene& scene, std::string_view format);

/// Writes text beside `path` and renames it, so that a failure leaves an old file as it was.
ZRAKA_API Result<void> write_text_file(const std::string& path, std::string_view text);

}  // namespace zraka
