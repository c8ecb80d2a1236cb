// SPDX-License-Identifier: Apache-2.0
// Zeros of functions along a ray, in lanes: where their sign changes.
#pragma once

#include "shapes/bodies/body.hpp"

#ifdef ZRAKA_ISA
namespace zraka::ZRAKA_ISA {

/// A function's value and its slope.
template <class F>
struct ValueAndSlope {
  F value, slope;
};

/// Those lanes of [a, b] in which a function has one zero: where its sign changes.
template <class F, class M>
struct Bracket {
  F a, b;
  M falls;  ///< it is positive at a and not at b, or the other way round
};

/// The zero, in the lanes that are wanted, to some 2^-52. Newton's steps as long as they stay
/// between the ends and become shorter by half each time; else the middle. What is found where
/// rounding hides the sign is a place of the bracket all the same. Begins with a guess, or in the
/// middle where that is not between the ends.
template <class F, class M, class Function>
ZRAKA_INLINE F zero_in(const Bracket<F, M>& bracket, M wanted, const Function& function,
                       F guess = F(kNever)) {
  constexpr int kMostSteps = 128;
  constexpr double kNear = 0x1p-52;
  F a = bracket.a, b = bracket.b, step = b - a;
  F x = select(both(guess > a, guess < b), guess, a + step * F(0.5));
  for (int k = 0; k < kMostSteps && any(wanted); ++k) {
    const ValueAndSlope<F> f = function(x);
    const auto positive = f.value > F(0.0);
    const auto before =
        either(both(bracket.falls, positive), but_not(f.value <= F(0.0), bracket.falls));
    a = select(both(wanted, before), x, a);
    b = select(but_not(wanted, before), x, b);
    const F newton = x - f.value / f.slope, middle = a + (b - a) * F(0.5);
    const auto good = both(both(newton >= a, newton <= b), abs(newton - x) * F(2.0) <= step);
    const F next = select(good, newton, middle);
    step = select(good, abs(newton - x), (b - a) * F(0.5));
    x = select(wanted, next, x);
    wanted = but_not(wanted, step <= F(kNear));
  }
  return x;
}

/// Puts a crossing before others.
template <class F, class M, int kMost>
ZRAKA_INLINE void put_first(M there, F t, F (&at)[kMost]) {
  for (int k = kMost - 1; k > 0; --k) at[k] = select(there, at[k - 1], at[k]);
  at[0] = select(there, t, at[0]);
}

}  // namespace zraka::ZRAKA_ISA
#endif
