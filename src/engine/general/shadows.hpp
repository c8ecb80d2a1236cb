// SPDX-License-Identifier: Apache-2.0
// Shadow rays of the general engine: they wait until there are many, go together in the order of
// their directions, and what is transparent is walked through.
#pragma once

#include <algorithm>

#include "engine/general/steps.hpp"

namespace zraka::general {

/// Where the shadow rays of all hits begin.
template <class R>
void find_shadow_origins(const Batch<R>& batch);

/// Makes what waits in one place wait in another, which is not behind it.
template <class R>
void move_waiting(const Batch<R>& batch, std::size_t from, std::size_t to) {
  Scratch<R>& scratch = batch.scratch;
  Waiting<R>& waiting = batch.general.of_waiting;
  scratch.sdx[to] = scratch.sdx[from];
  scratch.sdy[to] = scratch.sdy[from];
  scratch.sdz[to] = scratch.sdz[from];
  scratch.sdistance[to] = scratch.sdistance[from];
  scratch.shadow_ray_hit[to] = scratch.shadow_ray_hit[from];
  waiting.l_n[to] = waiting.l_n[from];
  waiting.strength[to] = waiting.strength[from];
  waiting.highlight[to] = waiting.highlight[from];
  waiting.sample[to] = waiting.sample[from];
}

/// In which order shadow rays are traced.
enum class Order { by_direction, as_listed };

/// What shadows leave of all that wait: general.filter and general.maybe_blocked. Where ways have to
/// be followed, those that an opaque body blocks wait no longer, unless somebody listens.
template <class R>
void trace_waiting(const Batch<R>& batch, Order order);

template <class R>
bool may_be_passed(const Batch<R>& batch) {
  return batch.settings.transparent_shadows;
}

/// Whether what a shadow ray meets may let it on: transparent bodies, those that cast no shadow,
/// and what is cut away.
template <class R>
bool may_go_on(const Batch<R>& batch) {
  return (may_be_passed(batch) && batch.optics().transparent) || batch.optics().shadowless ||
         batch.optics().cut_count > 0;
}

/// Whether all that light may pass on its way leaves all of it.
template <class R>
bool passes_whole(const Batch<R>& batch) {
  return !(may_be_passed(batch) && batch.optics().transparent) && !batch.optics().absorbing;
}

/// Where no way has to be followed: the scene whose shapes block a shadow ray if they hit it, and
/// let all of it arrive if they don't. Else nullptr.
template <class R>
const FrozenScene<R>* deciding_scene(const Batch<R>& batch) {
  if (!may_go_on(batch)) return &batch.scene;
  return batch.optics().cut_count == 0 && passes_whole(batch) ? batch.scene.opaque : nullptr;
}

/// Which scenes say what ways come to that are not followed; nullptr: none.
template <class R>
struct Unfollowed {
  const FrozenScene<R>* dark;   ///< nothing is left of what it blocks
  const FrozenScene<R>* lit;    ///< all is left of what neither it nor `dark` blocks
  const FrozenScene<R>* asked;  ///< of what `dark` does not block, it blocks all that is to be followed

  explicit Unfollowed(const Batch<R>& batch)
      : dark(deciding_scene(batch)), lit(dark), asked(&batch.scene) {
    if (lit != nullptr || batch.settings.filter_first_only || batch.scene.opaque == nullptr) return;
    if (batch.optics().cut_count == 0) dark = batch.scene.opaque;
    asked = batch.scene.filtering;
    if (!batch.optics().absorbing) lit = asked;
  }
  bool decide() const { return dark != nullptr && dark == lit; }
};

/// Whether shadow rays of a hit begin inside of what absorbs.
template <class R>
bool starts_in_absorber(const Batch<R>& batch, std::size_t hit) {
  if (!batch.optics().absorbing || !may_be_passed(batch)) return false;
  const std::int32_t medium = medium_of(batch.inside_of(hit), batch.optics().materials);
  return medium >= 0 && batch.optics().materials[medium].absorbs();
}

/// Follows the ways of all that wait, and takes what is lost on them from general.filter.
template <class R>
void follow_waiting(const Batch<R>& batch);

/// As many samples as a ray's weight in the pixel is worth: what counts little may be noisier.
template <class R>
std::int32_t samples_for(std::int32_t of_light, const RayState<R>& ray) {
  if (of_light == 1) return 1;
  const auto most = static_cast<double>(most_size(ray.weight));
  return std::clamp(static_cast<std::int32_t>(std::ceil(of_light * std::fmin(most, 1.0))), 1,
                    of_light);
}

/// How much of the ambient light reaches each hit: general.occlusion.
template <class R>
void find_occlusion(const Batch<R>& batch);

}  // namespace zraka::general
