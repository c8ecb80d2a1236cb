// SPDX-License-Identifier: Apache-2.0
// What of a ray is between two planes across an axis, where bodies are bounded by such.
#pragma once

#include "shapes/bodies/body.hpp"

#ifdef ZRAKA_ISA
namespace zraka::ZRAKA_ISA {

/// Part of a ray: nothing where `in` is greater than `out`.
template <class F>
struct Span {
  F in{-kNever}, out{kNever};
};

/// Leaves of a span what is between -half and half along an axis on which the ray is o + t·d.
///
/// Along the planes, 1/d is infinite, and so are both distances: of one sign outside, of both
/// inside. On a plane one of them is no number, and then min and max keep what was.
template <class F>
ZRAKA_INLINE void clip(Span<F>& span, F o, F d, F half) {
  const F inverse = F(1.0) / d;
  const F far = copy_sign(half, d);
  span.in = max((-far - o) * inverse, span.in);
  span.out = min((far - o) * inverse, span.out);
}

}  // namespace zraka::ZRAKA_ISA
#endif
