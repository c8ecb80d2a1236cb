// SPDX-License-Identifier: Apache-2.0
// What is odd about a scene that can be rendered.
#pragma once

#include <zraka/api.hpp>
#include <zraka/diagnostic.hpp>
#include <zraka/scene.hpp>

namespace zraka {

/// Warnings about what is seldom meant: materials that give back more light than they get or whose
/// optics change nothing, an eye or a light inside a closed body, spheres and boxes that overlap
/// where priorities do not say which one counts, soft lights of one sample, shapes too small beside
/// the scene for floats, no light, nothing in view. Of each kind the first few, then a count.
ZRAKA_API Diagnostics lint(const Scene& scene);

}  // namespace zraka
