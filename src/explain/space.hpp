// SPDX-License-Identifier: Apache-2.0
// What a page draws in space, as data for its script.
#pragma once

#include <string>
#include <zraka/explain.hpp>

#include "core/words.hpp"

namespace zraka {

/// JSON that can stand inside an HTML script element: rays, shapes that the tree hits (and all,
/// where they are few), lights, eye, window, and labels in the language.
std::string space_json(Language language, const Scene& scene, const Explanation& explanation);

/// The mark of a ray in the page: "t0r3".
std::string ray_mark(std::size_t tree, std::size_t ray);

}  // namespace zraka
