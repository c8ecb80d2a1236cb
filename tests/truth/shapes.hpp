// SPDX-License-Identifier: Apache-2.0
// The truth of all shapes: of each line of ZRAKA_SHAPES, and of each kind that the engine makes of
// them.
#pragma once

#include "truth/cone.hpp"
#include "truth/smooth_triangle.hpp"
#include "truth/sphere.hpp"
#include "truth/triangle.hpp"
