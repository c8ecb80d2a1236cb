// SPDX-License-Identifier: Apache-2.0
// Lights as the lean engine reads them.
#pragma once

#include <zraka/scene.hpp>

#include "math/frame.hpp"
#include "scene/frozen.hpp"

namespace zraka {

/// Whether distance or a cone take of the light of one that is no surface.
bool fades(const Light& light);

/// Of a surface only the colour counts.
template <class R>
FrozenLight<R> freeze_lean_light(const Light& light, const Frame& frame);

}  // namespace zraka
