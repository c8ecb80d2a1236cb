// SPDX-License-Identifier: Apache-2.0
#include "engine/general/sky.hpp"

#include "math/elementary.hpp"

namespace zraka::general {

double fog_exponent(const OpticalFog& fog, double length) {
  const double thick = fog.density * (length - fog.start);
  if (!(thick > 0)) return 0;
  return fog.kind == Fog::Kind::squared ? -thick * thick : -thick;
}

double clear_share(const OpticalFog& fog, double length) {
  const double behind = length - fog.start;
  double left = 1;
  if (fog.kind == Fog::Kind::linear)
    left = fog.end > fog.start ? (fog.end - length) / (fog.end - fog.start) : (behind < 0 ? 1 : 0);
  if (has_exponent(fog)) left = elementary::exp(fog_exponent(fog, length));
  return std::fmin(std::fmax(left, 0.0), 1.0);
}

}  // namespace zraka::general
