// SPDX-License-Identifier: Apache-2.0
// A pixel's rays as files that 3-D programs read.
#pragma once

#include <string>
#include <vector>

#include "explain/segments.hpp"

namespace zraka {

/// Wavefront OBJ: an object for each kind of rays, a line element for each ray. `title` is a
/// comment.
std::string rays_as_obj(const std::vector<Segment>& segments, const std::string& title);

/// glTF 2.0 in one file: a node and a mesh of lines for each kind of rays, in a colour of its own.
std::string rays_as_gltf(const std::vector<Segment>& segments);

}  // namespace zraka
