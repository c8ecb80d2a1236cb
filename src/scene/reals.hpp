// SPDX-License-Identifier: Apache-2.0
// The numbers that the engine computes with: floats, and doubles for the oracle, which is built
// where tests are: to compile everything for both takes a tenth more than for floats alone.
#pragma once

#include "oracle.inc"  // from CMake: ZRAKA_ORACLE, 0 or 1

/// function(R) for each of them.
#if ZRAKA_ORACLE
#define ZRAKA_FOR_REALS(function) function(float) function(double)
#else
#define ZRAKA_FOR_REALS(function) function(float)
#endif
