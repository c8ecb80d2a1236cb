// SPDX-License-Identifier: Apache-2.0
#include "engine/general/sky.hpp"

#include "math/elementary.hpp"

namespace zraka::general {

double clear_share(const OpticalFog& fog, double length) {
  const double behind = length - fog.start, thick = fog.density * behind;
  double left = 1;
  if (fog.kind == Fog::Kind::linear)
    left = fog.end > fog.start ? (fog.end - length) / (fog.end - fog.start) : (behind < 0 ? 1 : 0);
  if (fog.kind == Fog::Kind::exponential) left = thick > 0 ? elementary::exp(-thick) : 1;
  if (fog.kind == Fog::Kind::squared) left = thick > 0 ? elementary::exp(-thick * thick) : 1;
  return std::fmin(std::fmax(left, 0.0), 1.0);
}

}  // namespace zraka::general
