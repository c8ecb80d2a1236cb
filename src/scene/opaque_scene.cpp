// SPDX-License-Identifier: Apache-2.0
// The scene that shadow rays ask first: where they go through the shapes that they may pass.
#include <algorithm>

#include "scene/freeze.hpp"
#include "scene/reals.hpp"

namespace zraka {
namespace {

bool is_transparent(const OpticalMaterial& m) {
  return m.textured_k2 || m.k2.x != 0 || m.k2.y != 0 || m.k2.z != 0;
}

/// Whether any part of a whole may be passed, or a whole: what of it a ray meets is not asked for
/// its material.
template <class R>
bool has_passable_whole(const FrozenStore<R>& store) {
  const auto passable = [&](std::int32_t m) {
    return m >= 0 && store.passable[static_cast<std::size_t>(m)] != 0;
  };
  const FrozenBodies& bodies = store.scene.bodies;
  for (std::size_t i = 0; i < store.bodies.material.size(); ++i) {
    const bool is_part = static_cast<std::int32_t>(i) >= bodies.count;
    const bool is_whole = bodies.type[i] == kTypeCsg || bodies.type[i] == kTypeInstance;
    if ((is_part || is_whole) && passable(bodies.material[i])) return true;
  }
  return std::any_of(store.group_stores.begin(), store.group_stores.end(), [&](const auto& group) {
    bool any = std::any_of(group->bodies.material.begin(), group->bodies.material.end(), passable);
    const auto look_at = [&](const auto& shapes) {
      any = any || std::any_of(shapes.material, shapes.material + shapes.count, passable);
    };
#define ZRAKA_LOOK(Type, plural) look_at(group->scene.plural);
    ZRAKA_INLINED_KINDS(ZRAKA_LOOK)
#undef ZRAKA_LOOK
    return any;
  });
}

}  // namespace

template <class R>
void add_opaque_scene(FrozenStore<R>& store, bool transparent) {
  FrozenScene<R>& scene = store.scene;
  if (scene.optics == nullptr) return;
  for (const OpticalMaterial& m : store.optics->materials) {
    const bool passable = !m.casts_shadow || (transparent && is_transparent(m));
    // What absorbs light does so whether it casts a shadow or not; and where there are cuts, what
    // is opaque may be passed, too.
    const bool filters =
        (passable || scene.optics->cut_count > 0) && (m.casts_shadow || scene.optics->absorbing);
    store.passable.push_back(passable ? 1 : 0);
    store.unfiltering.push_back(filters ? 0 : 1);
  }
  const bool has_any =
      std::find(store.passable.begin(), store.passable.end(), 1) != store.passable.end();
  if (!has_any || has_passable_whole(store)) return;
  store.opaque = store.filtering = scene;
  store.opaque.shadowless = store.passable.data();
  store.filtering.shadowless = store.unfiltering.data();
  scene.opaque = &store.opaque;
  scene.filtering = &store.filtering;
}

#define ZRAKA_FOR(R) template void add_opaque_scene(FrozenStore<R>&, bool);
ZRAKA_FOR_REALS(ZRAKA_FOR)
#undef ZRAKA_FOR

}  // namespace zraka
