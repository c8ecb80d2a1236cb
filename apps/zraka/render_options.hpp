// SPDX-License-Identifier: Apache-2.0
// Options that all commands that render share.
#pragma once

#include <optional>
#include <string>
#include <vector>
#include <zraka/formats.hpp>
#include <zraka/school/school.hpp>

#include "command.hpp"
#include "look_options.hpp"
#include "sampling_options.hpp"

namespace zraka::app {

enum class Needs { always, perhaps };

struct RenderArguments {
  std::string scene;
  std::uint32_t width = 0, height = 0;  // 0: the scene's
  int max_depth = -1;                   // the scene's
  std::string profile;                  // "": the scene's
  int threads = 0;
  int tile = 0;
  std::string isa;
  bool quiet = false;
  ReadOptions files;
  SamplingArguments sampling;  // for commands that add them
  LookArguments look;          // the same

  void add_to(Command& command, Needs scene_needed = Needs::always);

  /// The scene with the size and the sampling that were asked for; its warnings have been shown.
  /// Fails where an output would be written over what is read, or over another output.
  Result<Scene> load(const std::vector<std::string>& outputs,
                     std::vector<std::string> other_inputs = {},
                     std::vector<ColorLegend>* legends = nullptr) const;
  /// The profile asked for, or the scene's.
  ProfileName profile_name(const Scene& scene) const;
  /// All but progress and crop; the terms are those of all stages.
  RenderOptions options(const Scene& scene) const;
};

/// Checks a word against the names of stages: 1…7 or a name.
std::optional<Stage> stage_named(const std::string& word);

/// The terms of a stage, as far as the scene has them: it may say that there are no shadows.
Terms terms_of(Stage stage, const Scene& scene);

/// Accepts the name of a PNG to write: whoever asks for a.jpg would be surprised by a PNG in it.
void check_png_name(Option option);

/// Accepts the name of a picture of any kind that is written.
void check_picture_name(Option option);

/// --mistake.
void add_mistake_to(Command& command, std::string& key);
/// The mistake of this key; none for "".
Mistake mistake_of(const std::string& key);

/// --stage.
void add_stage_to(Command& command, std::string& stage);

/// --lang.
void add_language_to(Command& command, std::string& language);

/// --format, for commands that write text, JSON or a page.
void add_format_to(Command& command, std::string& format);
/// The format asked for; else the one that the output's name asks for; else text.
std::string format_of(const std::string& format, const std::string& output);

}  // namespace zraka::app
