// SPDX-License-Identifier: Apache-2.0
// What is known of a picture's pixels besides their colours: a pass after the picture.
#pragma once

#include <zraka/render.hpp>

#include "render/picture_job.hpp"
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
  const PictureJob<R>& job;
};

/// Adds to rendering.layers what the options ask for, of a ray through the middle of each pixel, or
/// through its corner where the profile says so. False if it was cancelled.
template <class R>
bool make_layers(const LayerPass<R>& pass, Rendering& rendering);
/// The same of the part of the picture that the job is.
template <class R>
bool make_layers(const LayerPass<R>& pass, Layers& layers);

}  // namespace zraka
