// SPDX-License-Identifier: Apache-2.0
// The truth of all bodies that are not made of others: of each line of ZRAKA_BODIES.
#pragma once

#include "truth/box.hpp"
#include "truth/capsule.hpp"
#include "truth/disc.hpp"
#include "truth/ellipsoid.hpp"
#include "truth/frustum.hpp"
#include "truth/parallelogram.hpp"
#include "truth/plane.hpp"
#include "truth/quadric.hpp"
#include "truth/superellipsoid.hpp"
#include "truth/torus.hpp"
