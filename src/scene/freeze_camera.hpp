// SPDX-License-Identifier: Apache-2.0
// From the camera as read to the camera as traced.
#pragma once

#include <zraka/render.hpp>

#include "math/frame.hpp"
#include "scene/frozen.hpp"

namespace zraka {

/// Of a scene that check() finds nothing wrong with.
template <class R>
FrozenCamera<R> freeze_camera(const Scene& scene, const Profile& profile, const Frame& frame);

}  // namespace zraka
