// SPDX-License-Identifier: Apache-2.0
// How scenes of Tachyon are read, and what Tachyon's command line changes of that.
#pragma once

#include <optional>

#include "formats/formats.hpp"

namespace zraka {

/// Tachyon's shaders; the lower ones leave out more.
enum class TachyonMode { full, medium, low, lowest };

/// What overrides the file.
struct TachyonSettings {
  std::optional<Resolution> resolution{};
  std::optional<double> samples{};  ///< of a pixel, besides the first
  std::optional<TachyonMode> mode{};
  std::optional<bool> shadow_filter{};
  bool trans_vmd = false;       ///< what is transparent shines less by itself
  bool trans_raster3d = false;  ///< opacity by the angle, which is not drawn
  bool fog_vmd = false;
  std::optional<Highlight> highlight{};
  bool no_highlight = false;
  double light_scale = 1;            ///< of all lights
  std::optional<double> skylight{};  ///< ambient occlusion as bright as this
  std::optional<int> skylight_samples{};
};

Result<ReadScene> parse_tachyon(std::string_view text, const std::string& name,
                                const ReadOptions& options, const TachyonSettings& settings);

}  // namespace zraka
