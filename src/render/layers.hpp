// SPDX-License-Identifier: Apache-2.0
// What is known of a picture's pixels besides their colours: a pass after the picture.
#pragma once

#include <zraka/render.hpp>

#include "engine/engine.hpp"
#include "engine/first_hits.hpp"
#include "render/prepare.hpp"

namespace zraka {

/// Whether layers ask the scene as it was read, which then has to outlive the picture.
inline bool need_scene(const LayerSet& layers) {
  return layers.has(Layer::uv) || layers.has(Layer::cryptomatte);
}

/// What the pass reads.
template <class R>
struct LayerPass {
  const Scene* scene;  ///< read only where need_scene() says so
  const PreparedScene<R>& prepared;
  const Kernel<R>& kernel;
  TraceFirstHitsOfTile<R>& first_hits;
  const TraceSettings& settings;
  const RenderOptions& options;
  int tile, threads;
};

/// Fills rendering.layers as the options have them, of a ray through each pixel; the picture is as
/// the engine left it, before corners are averaged. Where it shall be transparent, takes the light
/// from pixels that hit nothing. False if it was cancelled.
template <class R>
bool make_layers(const LayerPass<R>& pass, Rendering& rendering);

}  // namespace zraka
