// SPDX-License-Identifier: Apache-2.0
// All shapes' files. The list itself is ZRAKA_SHAPES in include/zraka/shapes.hpp.
#pragma once

#include "shapes/cone.hpp"
#include "shapes/smooth_triangle.hpp"
#include "shapes/sphere.hpp"
#include "shapes/triangle.hpp"
