// SPDX-License-Identifier: Apache-2.0
// Pictures by other rules than the profile's, for lessons that show what a rule is for.
#pragma once

#include <zraka/explain.hpp>
#include <zraka/render.hpp>

#include "engine/engine.hpp"

namespace zraka {

/// What is varied. Functions that are empty vary nothing.
struct Variation {
  int number = 0;  ///< for the kernels, TraceSettings::variation
  /// The engine for an instruction set, but the oracle; all have the same bits.
  const Kernel<float>& (*kernel)(Isa) = nullptr;
  RecordTile<float>* record = nullptr;
  std::function<void(Scene&)> vary_scene{};
  std::function<void(RenderOptions&)> vary_options{};
  std::function<void(TraceSettings&)> vary_settings{};
  std::function<void(Image&)> vary_image{};
  VariedRules rules{};
};

/// Whether kernels of variations know a scene's camera: lessons have one ray a pixel, from the eye.
Result<void> check_lesson(const Scene& scene);

/// What to answer where the rules of a picture shall be varied that asks for more than the lab's.
tl::unexpected<Diagnostics> beyond_the_lab();

/// render() with a variation; not for Isa::oracle where it has a kernel, which fails where
/// is_beyond_the_lab().
Result<Rendering> render_varied(const Scene& scene, const RenderOptions& options,
                                const Variation& variation);
/// Explainer::create() with a variation.
Result<Explainer> varied_explainer(const Scene& scene, const RenderOptions& options,
                                   const Variation& variation);

}  // namespace zraka
