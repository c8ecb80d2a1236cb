// SPDX-License-Identifier: Apache-2.0
// Options of how many rays a picture is worth, and which part of it.
#pragma once

#include <optional>
#include <string>
#include <zraka/render.hpp>

#include "command.hpp"

namespace zraka::app {

/// What is not given is the scene's.
struct SamplingArguments {
  std::string quality, adaptive, filter, crop, shadows;
  int samples = 0, grid = 0, wavelengths = 0;
  std::string seed;
  double min_contribution = -1;

  /// All but --crop.
  void add_to(Command& command);
  void add_crop_to(Command& command);
  /// What is wrong with them together, or "".
  std::string problem() const;

  /// Changes what the scene says of itself: first --quality, then what was given by itself.
  void apply_to(RenderDefaults& defaults) const;
  std::optional<PixelRect> crop_rect() const;
};

}  // namespace zraka::app
