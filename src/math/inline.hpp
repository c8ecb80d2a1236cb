// SPDX-License-Identifier: Apache-2.0
// The mark of functions that must vanish into their callers. What the engine computes with is
// compiled once per instruction set, and a shared copy of an inline function would carry one set's
// code into the others.
#pragma once

#ifdef ZRAKA_ONE_ISA
// A sanitized build has one set alone: there compilers choose, and clang is done in a sixth of the time.
#define ZRAKA_INLINE inline
#else
#define ZRAKA_INLINE inline __attribute__((always_inline))
#endif
