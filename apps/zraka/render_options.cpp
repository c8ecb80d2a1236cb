// SPDX-License-Identifier: Apache-2.0
#include "render_options.hpp"

#include <fmt/format.h>
#include <unistd.h>

#include <algorithm>
#include <cmath>
#include <cstring>
#include <filesystem>
#include <optional>

#include "core/new_file.hpp"
#include "core/threads.hpp"
#include "core/words.hpp"
#include "scene_files.hpp"
#include "terminal.hpp"

namespace zraka::app {
namespace {

/// Names without an ending, and those of devices and pipes, are anybody's.
bool is_png_name(const std::string& path) {
  std::string ending = std::filesystem::path(path).extension().string();
  for (char& c : ending) c = c >= 'A' && c <= 'Z' ? static_cast<char>(c + 32) : c;
  std::error_code ignored;  // a folder has an error of its own
  return ending.empty() || ending == ".png" || path.starts_with("/dev/") ||
         std::filesystem::is_directory(path, ignored);
}

}  // namespace

namespace {

void check_no_terminal(Option option) {
  option.check("for a terminal, which shows no PNG: name a file, or redirect the output",
               [](const std::string& path) { return path != "-" || ::isatty(STDOUT_FILENO) == 0; });
}

}  // namespace

void check_png_name(Option option) {
  check_no_terminal(
      option.check("the name of a PNG, the one kind of picture that is written here", is_png_name));
}

void check_picture_name(Option option) {
  std::string endings;
  for (const PictureFormat& format : picture_formats())
    for (const std::string_view ending : format.endings)
      endings += fmt::format("{}{}", endings.empty() ? "" : ", ", ending);
  check_no_terminal(
      option.check(fmt::format("the name of a picture that can be written: known are {}", endings),
                   [](const std::string& path) {
                     std::error_code ignored;  // a folder has an error of its own
                     return picture_format_of(path) || std::filesystem::is_directory(path, ignored);
                   }));
}

std::optional<Stage> stage_named(const std::string& word) {
  std::string plain;
  for (const char c : word) plain += c >= 'A' && c <= 'Z' ? static_cast<char>(c + 32) : c;
  for (std::size_t i = 0; i < kStageNames.size(); ++i)
    if (plain == kStageNames[i] || word == std::to_string(i + 1)) return static_cast<Stage>(i + 1);
  return std::nullopt;
}

void RenderArguments::add_to(Command& command, Needs scene_needed) {
  Option scene_option = command.add("SCENE", &scene, "the scene file; - reads standard input");
  if (scene_needed == Needs::always) scene_option.required();
  command.add("--width", &width, "width of the picture, in pixels; the height follows if not given")
      .range(1, 1u << 20);
  command.add("--height", &height, "height of the picture, in pixels").range(1, 1u << 20);
  command
      .add(
          "--max-depth", &max_depth,
          "levels of rays after those from the eye (default: the scene's, else 4); each may double "
          "the time")
      .range(0, kMaxDepth);
  command
      .add("--profile", &profile,
           "lab (the course's rules, default for input.txt), physical (optics' rules, default for "
           "all else), spd (the Standard Procedural Databases' rules for counting rays) or tachyon "
           "(default for Tachyon's scenes)")
      .check("lab, physical, spd or tachyon",
             [](const std::string& name) { return profile_named(name).has_value(); })
      .propose([] {
        return std::vector<std::string>{"lab", "physical", "spd", "tachyon"};
      });
  command.add("--threads", &threads, "how many threads; 0, the default, is all that there are")
      .range(0, kMaxThreads);
  command
      .add("--tile", &tile, "side of the tiles that threads work on; 0 chooses; no pixel changes")
      .range(0, kMaxTile);
  command.add("--isa", &isa, "instruction set: avx512, avx2 or portable; no pixel changes")
      .check("avx512, avx2 or portable",
             [](const std::string& name) { return isa_named(name).has_value(); })
      .propose([] {
        return std::vector<std::string>{"avx512", "avx2", "portable"};
      });
  add_allow_outside_to(command, files);
  command.add("-q,--quiet", &quiet, "no progress bar, no warnings");
}

void add_mistake_to(Command& command, std::string& key) {
  command
      .add("--mistake", &key,
           "make one of the mistakes of \"zraka grade --list\", to see what it does")
      .check("the name of a mistake; zraka grade --list has them",
             [](const std::string& name) { return mistake_named(name).has_value(); })
      .propose([] {
        std::vector<std::string> keys;
        for (const MistakeEntry& entry : all_mistakes()) keys.emplace_back(entry.key);
        return keys;
      });
}

Mistake mistake_of(const std::string& key) {
  return mistake_named(key).value_or(Mistake::none);
}

void add_stage_to(Command& command, std::string& stage) {
  command
      .add("--stage", &stage,
           "up to which stage of the lab: 1…7, or silhouette, ambient, diffuse, specular,\n"
           "shadows, reflection, refraction (default: all)")
      .check(
          "a stage: 1…7, silhouette, ambient, diffuse, specular, shadows, reflection or refraction",
          [](const std::string& name) { return stage_named(name).has_value(); })
      .propose([] { return std::vector<std::string>(kStageNames.begin(), kStageNames.end()); });
}

Result<Scene> RenderArguments::load(const std::vector<std::string>& outputs,
                                    std::vector<std::string> other_inputs,
                                    std::vector<ColorLegend>* legends) const {
  other_inputs.push_back(scene);
  if (const Result<void> good = check_outputs(other_inputs, outputs); !good)
    return tl::make_unexpected(good.error());
  // From reading to writing. The end of a limit lets more threads start, so this one has none:
  // where the system allows only one thread, one must do.
  if (threads > 0) {
    [[maybe_unused]] static const auto* const limit = new ThreadLimit(threads);
  }
  ReadOptions reading = files;
  look.apply_to(reading);
  Result<ReadScene> read = read_scene(scene, reading);
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
  sampling.apply_to(loaded.defaults);
  if (const Result<void> good = look.apply_to(loaded, scene); !good)
    return tl::make_unexpected(good.error());
  if (legends != nullptr) *legends = std::move(read->legends);
  return std::move(loaded);
}

ProfileName RenderArguments::profile_name(const Scene& loaded) const {
  return profile_named(profile).value_or(loaded.defaults.profile);
}

Terms terms_of(Stage stage, const Scene& scene) {
  Terms terms = zraka::terms_of(stage);
  terms.shadows = terms.shadows && scene.defaults.shadows != Shadows::off;
  return terms;
}

RenderOptions RenderArguments::options(const Scene& loaded) const {
  RenderOptions options;
  options.profile = profile_of(profile_name(loaded));
  options.terms = terms_of(Stage::refraction, loaded);
  options.max_depth = max_depth < 0 ? loaded.defaults.max_depth : max_depth;
  options.shadows = loaded.defaults.shadows;
  options.min_contribution = loaded.defaults.min_contribution;
  options.wavelengths = loaded.defaults.wavelengths;
  options.sampling = loaded.defaults.sampling;
  options.outlines = look.outlines;
  options.threads = threads;
  options.bind_threads = true;
  options.tile = tile;
  options.isa = isa_named(isa);
  return options;
}

void add_language_to(Command& command, std::string& language) {
  command.add("--lang", &language, "language of all words: en (default) or hr")
      .check("en or hr", [](const std::string& name) { return language_named(name).has_value(); })
      .propose([] {
        return std::vector<std::string>{"en", "hr"};
      });
}

void add_format_to(Command& command, std::string& format) {
  command.add("--format", &format, "text, json or html; else by the name of the output, else text")
      .one_of({"text", "json", "html"});
}

std::string format_of(const std::string& format, const std::string& output) {
  if (!format.empty()) return format;
  const std::string extension = std::filesystem::path(output).extension().string();
  return extension == ".json" ? "json" : extension == ".html" ? "html" : "text";
}

}  // namespace zraka::app
