// SPDX-License-Identifier: Apache-2.0
// The mark of functions that must vanish into their callers. What the engine computes with is
// compiled once per instruction set, and a shared copy of an inline function would carry one set's
// code into the others.
#pragma once

#define ZRAKA_INLINE inline __attribute__((always_inline))
