// SPDX-License-Identifier: Apache-2.0
// All bodies' files. The list itself is ZRAKA_BODIES in include/zraka/bodies.hpp.
#pragma once

#include <type_traits>

#include "shapes/bodies/box.hpp"
#include "shapes/bodies/capsule.hpp"
#include "shapes/bodies/csg.hpp"
#include "shapes/bodies/disc.hpp"
#include "shapes/bodies/ellipsoid.hpp"
#include "shapes/bodies/frustum.hpp"
#include "shapes/bodies/instance.hpp"
#include "shapes/bodies/parallelogram.hpp"
#include "shapes/bodies/plane.hpp"
#include "shapes/bodies/quadric.hpp"
#include "shapes/bodies/superellipsoid.hpp"
#include "shapes/bodies/torus.hpp"

namespace zraka {

#define ZRAKA_OR(Type, plural) || std::is_same_v<Shape, Type>
template <class Shape>
inline constexpr bool is_body = false ZRAKA_BODIES(ZRAKA_OR);
#undef ZRAKA_OR

}  // namespace zraka
