// SPDX-License-Identifier: Apache-2.0
// The engine with MistakenSteps; TraceSettings::variation is the mistake, or two of them.
#pragma once

#include <zraka/school/mistakes.hpp>

#include "engine/engine.hpp"
#include "math/inline.hpp"

namespace zraka {

/// Two mistakes in one number, and back.
ZRAKA_INLINE int number_of(Mistake first, Mistake second) {
  return static_cast<int>(first) | static_cast<int>(second) << 8;
}
ZRAKA_INLINE Mistake first_of_number(int number) {
  return static_cast<Mistake>(number & 0xFF);
}
ZRAKA_INLINE Mistake second_of_number(int number) {
  return static_cast<Mistake>(number >> 8);
}

}  // namespace zraka

namespace zraka::isa_avx2 {

extern const Kernel<float> kMistakenKernel;

}  // namespace zraka::isa_avx2

namespace zraka::isa_portable {

extern const Kernel<float> kMistakenKernel;
RecordTile<float> record_mistaken_tile;

}  // namespace zraka::isa_portable
