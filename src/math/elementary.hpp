// SPDX-License-Identifier: Apache-2.0
// Elementary functions of doubles by plain products and sums, the same bits on every machine,
// which libraries do not promise.
#pragma once

namespace zraka::elementary {

double sin(double x);
double cos(double x);
double atan2(double y, double x);
double asin(double x);
double exp(double x);
double log(double x);
double pow(double x, double y);

}  // namespace zraka::elementary
