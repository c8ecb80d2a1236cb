// SPDX-License-Identifier: Apache-2.0
// Bodies as the engine reads them: of all types in one list, for they are one kind to the hierarchy.
#pragma once

#include <cstdint>
#include <zraka/bodies.hpp>

#include "math/bounds.hpp"

namespace zraka {

/// Number of each type of body, in the order of the list.
enum BodyType : std::uint8_t {
#define ZRAKA_TYPE(Type, plural) kType##Type,
  ZRAKA_BODIES(ZRAKA_TYPE)
#undef ZRAKA_TYPE
      kBodyTypes
};
template <class Shape>
inline constexpr std::uint8_t kTypeOf = kBodyTypes;
#define ZRAKA_TYPE(Type, plural) \
  template <>                    \
  inline constexpr std::uint8_t kTypeOf<Type> = kType##Type;
ZRAKA_BODIES(ZRAKA_TYPE)
#undef ZRAKA_TYPE

/// The first numbers of most bodies: the middle in the engine's frame, and the matrix, row by row,
/// of the map from what is relative to it to the body's own space. Then Placement's numbers.
enum BodyColumn { kBodyCenter = 0, kBodyMatrix = 3, kBodyNumbers = 12 };

/// In the order of the hierarchy's leaves; then those that are unbounded and stand outside of it;
/// then those that are no shapes by themselves, members of CSG.
struct FrozenBodies {
  const std::uint8_t* type;   ///< BodyType
  const std::int32_t* start;  ///< of a body's numbers
  const double* numbers;
  const std::int32_t* material;   ///< -1: that of the whole that it is a part of
  const std::int32_t* transform;  ///< as Object::transform
  const std::int32_t* id;         ///< as FrozenShapes::id; not of members
  const Bounds* bounds;  ///< in the engine's frame, of bounded ones until the hierarchy has them
  std::int32_t count;             ///< without the members
  std::int32_t bounded;           ///< so many stand in the hierarchy
  std::int32_t first_slot;
  std::int32_t first_id;  ///< the least id
};

/// The kind of shapes in the hierarchy that all bodies are.
struct Body {};

}  // namespace zraka
