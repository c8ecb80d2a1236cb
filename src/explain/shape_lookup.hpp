// SPDX-License-Identifier: Apache-2.0
// From the engine's numbers of shapes to those that people use, and to what their files say.
#pragma once

#include <zraka/explained_shape.hpp>

#include "scene/frozen.hpp"

namespace zraka {

/// Which of a scene's, or of a group's, shapes a slot of it holds.
ShapeId shape_in_slot(const ShapeLists& shapes, const FrozenScene<float>& frozen,
                      std::int32_t slot);

NamedShape named(const ShapeLists& shapes, const ShapeId& id);

/// From the space that something is described in, by Object::transform.
Transform transform_at(const Scene& scene, std::uint32_t index);

/// As Object::transform.
std::uint32_t transform_of(const ShapeLists& shapes, const ShapeId& id);

/// The CSG shape or instance with this id; nullptr where it is of another kind.
const Csg* csg_of(const ShapeLists& shapes, const ShapeId& id);
const Instance* instance_of(const ShapeLists& shapes, const ShapeId& id);

/// The i-th, from 0, of a CSG shape's members that are none themselves, in the order of the
/// expression: as they are frozen.
ExplainedMember member_of(const Scene& scene, const Csg& csg, std::size_t i);

}  // namespace zraka
