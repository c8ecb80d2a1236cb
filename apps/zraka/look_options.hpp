// SPDX-License-Identifier: Apache-2.0
// Options that show more of a scene than it says: cuts, depth, outlines, the colours of particles.
#pragma once

#include <string>
#include <zraka/formats.hpp>
#include <zraka/render.hpp>

#include "command.hpp"

namespace zraka::app {

struct LookArguments {
  std::string cut;  // numbers with commas between them, four for each cut
  bool cut_eye_only = false, depth_cue = false;
  int outlines = 0;
  std::string color_by, color_map;

  void add_to(Command& command);
  /// What is wrong with them together, or "".
  std::string problem() const;

  /// For the reader of the scene.
  void apply_to(ReadOptions& options) const;
  /// Fails where the scene cannot have what is asked for.
  Result<void> apply_to(Scene& scene, const std::string& name) const;
};

}  // namespace zraka::app
