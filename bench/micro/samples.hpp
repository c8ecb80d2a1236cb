// SPDX-License-Identifier: Apache-2.0
// A shape of each kind to throw rays at, about as large as the unit sphere.
#pragma once

#include <zraka/shapes.hpp>

namespace zraka::micro {

inline void make_sample(Sphere& s) {
  s = {{0, 0, 0}, 1};
}
inline void make_sample(Triangle& s) {
  s = {{-1, -0.7, 0.2}, {1, -0.6, -0.1}, {0.1, 0.9, 0.3}};
}
inline void make_sample(SmoothTriangle& s) {
  s = {{-1, -0.7, 0.2}, {1, -0.6, -0.1}, {0.1, 0.9, 0.3}, {-0.1, 0, 1}, {0.1, 0, 1}, {0, 0.1, 1}};
}
inline void make_sample(Cone& s) {
  s = {{0, -0.8, 0.1}, 0.6, {0.2, 0.8, 0}, 0.3};
}
inline void make_sample(Cylinder& s) {
  s = {{{0, -0.8, 0.1}, 0.45, {0.2, 0.8, 0}, 0.45}};
}

}  // namespace zraka::micro
