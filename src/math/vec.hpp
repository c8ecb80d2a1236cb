// SPDX-License-Identifier: Apache-2.0
// Vectors of three, over a number or over lanes of numbers.
#pragma once

#include "math/inline.hpp"

namespace zraka {

template <class T>
struct V3 {
  T x, y, z;
};

template <class T>
ZRAKA_INLINE V3<T> operator+(const V3<T>& a, const V3<T>& b) {
  return {a.x + b.x, a.y + b.y, a.z + b.z};
}
template <class T>
ZRAKA_INLINE V3<T> operator-(const V3<T>& a, const V3<T>& b) {
  return {a.x - b.x, a.y - b.y, a.z - b.z};
}
/// Component by component: colours.
template <class T>
ZRAKA_INLINE V3<T> operator*(const V3<T>& a, const V3<T>& b) {
  return {a.x * b.x, a.y * b.y, a.z * b.z};
}
template <class T>
ZRAKA_INLINE V3<T> operator*(const V3<T>& a, const T& s) {
  return {a.x * s, a.y * s, a.z * s};
}
template <class T>
ZRAKA_INLINE V3<T> operator-(const V3<T>& a) {
  return {-a.x, -a.y, -a.z};
}
template <class T>
ZRAKA_INLINE T dot(const V3<T>& a, const V3<T>& b) {
  return a.x * b.x + a.y * b.y + a.z * b.z;
}
template <class T>
ZRAKA_INLINE V3<T> cross(const V3<T>& a, const V3<T>& b) {
  return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
}

}  // namespace zraka
