// SPDX-License-Identifier: Apache-2.0
// What comes before the first ray, for all who trace: options checked, the scene frozen.
#pragma once

#include <memory>
#include <zraka/render.hpp>

#include "engine/engine.hpp"
#include "math/frame.hpp"
#include "render/variation.hpp"
#include "scene/freeze.hpp"

namespace zraka {

/// What is wrong with options or scene; empty when all is well.
Diagnostics check_request(const Scene& scene, const RenderOptions& options);

/// Whether the picture asks for more than the lean engine's optics: then the general engine traces
/// it (engine/general/).
bool needs_general_engine(const Scene& scene, const RenderOptions& options);

/// Whether the picture asks for more than the lab's optics: then lessons cannot vary its rules.
bool is_beyond_the_lab(const Scene& scene, const RenderOptions& options);

/// The scene as the engine reads it, and the memory behind it.
template <class R>
struct PreparedScene {
  Frame frame;
  BuiltHierarchy hierarchy;
  std::unique_ptr<FrozenStore<R>> store;
};

/// Whether the caller wants no result any more.
inline bool is_cancelled(const RenderOptions& options) {
  return options.cancel != nullptr && options.cancel->load(std::memory_order_relaxed);
}

/// Builds and freezes a scene that check_request() finds nothing wrong with. Afterwards ask
/// is_cancelled(): what was cancelled on the way is not whole, and nobody may trace it.
template <class R>
PreparedScene<R> prepare(const Scene& scene, const RenderOptions& options);
/// The same, with a hierarchy that also serves eyes up to `room` from the frame's centre, in its
/// unit: how far any coordinate may be.
template <class R>
PreparedScene<R> prepare_with_room(const Scene& scene, const RenderOptions& options, R room);
/// The same as the first; the scene is gone before the hierarchy needs its memory.
template <class R>
PreparedScene<R> prepare(Scene&& scene, const RenderOptions& options);

template <class R>
TraceSettings settings_of(const RenderOptions& options, const PreparedScene<R>& prepared,
                          const Variation& variation = {});

}  // namespace zraka
