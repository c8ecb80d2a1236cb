// SPDX-License-Identifier: Apache-2.0
// Elementary functions of doubles by plain products and sums, the same bits on every machine,
// which libraries do not promise.
#pragma once

namespace zraka::elementary {

/// Relative errors are at most 3·2^-53, those of log and pow 1.1·2^-53. Zeros, infinities and NaNs
/// give what C's functions give (C17, annex F), angles of any size are reduced exactly.
double sin(double x);
double cos(double x);
/// Both of one angle, in little more time than one.
struct SineCosine {
  double sine, cosine;
};
SineCosine sine_cosine(double x);
double atan2(double y, double x);
double asin(double x);
double exp(double x);
double log(double x);
double pow(double x, double y);

}  // namespace zraka::elementary
