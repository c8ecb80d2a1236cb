// SPDX-License-Identifier: Apache-2.0
// Shapes that are a group of triangles of their own, and an instance of it.
#pragma once

#include "language/shapes.hpp"
#include "mesh/mesh.hpp"

namespace zraka::language {

/// Adds a group of the mesh's triangles to the scene: smooth ones where all corners have normals.
/// Its index; none, and the problem told, if something is wrong with a triangle.
std::optional<std::uint32_t> add_group(const Mesh& mesh, bool smooth, Item& item);

/// Puts an instance of such a group to where the item goes.
void add_instance(std::uint32_t group, Item& item);

}  // namespace zraka::language
