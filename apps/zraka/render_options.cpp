// SPDX-License-Identifier: Apache-2.0
#include "render_options.hpp"

#include <fmt/format.h>
#include <tbb/global_control.h>

#include <algorithm>
#include <cmath>
#include <cstring>
#include <filesystem>
#include <optional>

#include "core/words.hpp"
#include "terminal.hpp"

namespace zraka::app {
namespace {

bool is_no_other_picture(const std::string& path) {
  const std::string extension = std::filesystem::path(path).extension().string();
  for (const char* other : {".jpg", ".jpeg", ".ppm", ".exr", ".bmp", ".tga", ".gif", ".tif",
                            ".tiff", ".hdr", ".webp", ".nff"})
    if (std::equal(extension.begin(), extension.end(), other, other + std::strlen(other),
                   [](char a, char b) { return (a >= 'A' && a <= 'Z' ? a + 32 : a) == b; }))
      return false;
  return true;
}

}  // namespace

CLI::Validator name_of_png() {
  return one_of("the name of a PNG, the one kind of picture that is written", is_no_other_picture);
}

CLI::Validator one_of(std::string what, bool (*accepts)(const std::string&)) {
  return CLI::Validator(
      [what, accepts](std::string& word) {
        return accepts(word) ? std::string() : fmt::format("'{}' is not {}", word, what);
      },
      "");
}

std::optional<Stage> stage_named(const std::string& word) {
  std::string plain;
  for (const char c : word) plain += c >= 'A' && c <= 'Z' ? static_cast<char>(c + 32) : c;
  for (std::size_t i = 0; i < kStageNames.size(); ++i)
    if (plain == kStageNames[i] || word == std::to_string(i + 1)) return static_cast<Stage>(i + 1);
  return std::nullopt;
}

void RenderWords::add_to(CLI::App& command) {
  command.add_option("SCENE", scene, "the scene file; - reads standard input")->required();
  command
      .add_option("--width", width,
                  "width of the picture, in pixels; the height follows if not given")
      ->check(CLI::Range(1u, 1u << 20));
  command.add_option("--height", height, "height of the picture, in pixels")
      ->check(CLI::Range(1u, 1u << 20));
  command
      .add_option("--max-depth", max_depth,
                  "levels of rays after those from the eye (default 4); each may double the time")
      ->check(CLI::Range(0, kMaxDepth));
  command
      .add_option(
          "--profile", profile,
          "lab (the course's rules, default for input.txt), physical (optics' rules, default for "
          "all else) or spd (the Standard Procedural Databases' rules for counting rays)")
      ->check(one_of("lab, physical or spd",
                     [](const std::string& word) { return profile_named(word).has_value(); }));
  command
      .add_option("--threads", threads, "how many threads; 0, the default, is all that there are")
      ->check(CLI::Range(0, kMaxThreads));
  command
      .add_option("--tile", tile,
                  "side of the tiles that threads work on; 0 chooses; no pixel changes")
      ->check(CLI::Range(0, kMaxTile));
  command
      .add_option("--mistake", mistake,
                  "make one of the mistakes of \"zraka grade --list\", to see what it does")
      ->check(one_of("the name of a mistake; zraka grade --list has them",
                     [](const std::string& word) { return mistake_named(word).has_value(); }));
  command.add_option("--isa", isa, "instruction set: avx512, avx2 or portable; no pixel changes")
      ->check(one_of("avx512, avx2 or portable",
                     [](const std::string& word) { return isa_named(word).has_value(); }));
  command.add_flag("-q,--quiet", quiet, "no progress bar, no warnings");
}

Result<Scene> RenderWords::load() const {
  // From reading to writing. The end of a limit lets more threads start, so this one has none:
  // where the system allows only one thread, one must do.
  if (threads > 0) {
    [[maybe_unused]] static const auto* const limit = new tbb::global_control(
        tbb::global_control::max_allowed_parallelism, static_cast<std::size_t>(threads));
  }
  Result<ReadScene> read = read_scene(scene);
  if (!read) return tl::make_unexpected(read.error());
  if (!quiet) show(read->warnings);
  Scene& loaded = read->scene;
  const Resolution own = loaded.resolution;
  const double aspect = static_cast<double>(own.width) / own.height;
  if (width > 0 && height > 0) {
    // The window keeps its height; its width follows the picture, so that pixels stay square.
    const double wider = static_cast<double>(width) / height / aspect;
    Vec3& right = loaded.camera.window_right;
    right = {right.x * wider, right.y * wider, right.z * wider};
    loaded.resolution = {width, height};
  } else if (width > 0) {
    loaded.resolution = {
        width, static_cast<std::uint32_t>(std::clamp(std::round(width / aspect), 1.0, 4e9))};
  } else if (height > 0) {
    loaded.resolution = {
        static_cast<std::uint32_t>(std::clamp(std::round(height * aspect), 1.0, 4e9)), height};
  }
  return std::move(loaded);
}

ProfileName RenderWords::profile_name(const Scene& loaded) const {
  return profile_named(profile).value_or(loaded.default_profile);
}

RenderOptions RenderWords::options(const Scene& loaded) const {
  RenderOptions options;
  options.profile = profile_of(profile_name(loaded));
  options.max_depth = max_depth;
  options.threads = threads;
  options.tile = tile;
  options.isa = isa_named(isa);
  options.mistake = mistake_named(mistake).value_or(Mistake::none);
  return options;
}

void add_language_to(CLI::App& command, std::string& language) {
  command.add_option("--lang", language, "language of all words: en (default) or hr")
      ->check(one_of("en or hr",
                     [](const std::string& word) { return language_named(word).has_value(); }));
}

void add_format_to(CLI::App& command, std::string& format) {
  command
      .add_option("--format", format,
                  "text, json or html; else by the name of the output, else text")
      ->check(CLI::IsMember({"text", "json", "html"}));
}

std::string format_of(const std::string& format, const std::string& output) {
  if (!format.empty()) return format;
  const std::string extension = std::filesystem::path(output).extension().string();
  return extension == ".json" ? "json" : extension == ".html" ? "html" : "text";
}

}  // namespace zraka::app
