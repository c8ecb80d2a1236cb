// SPDX-License-Identifier: Apache-2.0
// Sixteen numbers at a time, or as many as Embree asks about, by the compiler's own vectors.
#pragma once

#ifdef __AVX512F__
#include <immintrin.h>
#endif

#include <cmath>
#include <cstring>

typedef float Float16Wide __attribute__((vector_size(64)));
#if defined(__AVX512F__) && defined(__GLIBC__)
/// powf for sixteen at a time, from the C library's libmvec.
extern "C" Float16Wide _ZGVeN16vv_powf(Float16Wide, Float16Wide);  // NOLINT: its name
#endif

namespace zraka::embree {

inline constexpr int kWide = 16;
using Float16 = Float16Wide;
/// Whole numbers, or a mask: -1 or 0.
typedef int Int16 __attribute__((vector_size(64)));

/// As many numbers as Embree has in a packet of rays: 4, 8 or 16.
template <int N>
struct Packed {
  typedef float Float __attribute__((vector_size(4 * N)));
  typedef int Int __attribute__((vector_size(4 * N)));
};

inline Float16 all(float v) {
  return v - Float16{};
}
inline Int16 all(int v) {
  return v - Int16{};
}
inline Int16 numbers_from(int first) {
  return first + Int16{0, 1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11, 12, 13, 14, 15};
}

template <class V, class T>
inline V load(const T* from) {
  V v;
  static_assert(sizeof(T) == 4);
  std::memcpy(&v, from, sizeof v);
  return v;
}
inline Float16 load(const float* from) {
  return load<Float16>(from);
}
inline Int16 load(const int* from) {
  return load<Int16>(from);
}
template <class V, class T>
inline void store(V v, T* to) {
  static_assert(sizeof(T) == 4);
  std::memcpy(to, &v, sizeof v);
}

inline Float16 min(Float16 a, Float16 b) {
  return a < b ? a : b;
}
inline Float16 max(Float16 a, Float16 b) {
  return a > b ? a : b;
}
inline Float16 abs(Float16 a) {
  return max(a, -a);
}
inline float sqrt(float v) {
  return __builtin_sqrtf(v);
}
template <class V>
inline V sqrt(V v) {
  for (unsigned i = 0; i < sizeof(V) / sizeof(float); ++i) v[i] = __builtin_sqrtf(v[i]);
  return v;
}
inline Float16 power(Float16 x, Float16 n) {
#if defined(__AVX512F__) && defined(__GLIBC__)
  return _ZGVeN16vv_powf(x, n);
#else
  for (int i = 0; i < kWide; ++i) x[i] = __builtin_powf(x[i], n[i]);
  return x;
#endif
}

/// A bit for each lane of a mask.
template <class Mask>
inline unsigned bits(Mask mask) {
#ifdef __AVX512DQ__
  if constexpr (sizeof(Mask) == sizeof(Int16))
    return _mm512_movepi32_mask(reinterpret_cast<__m512i>(mask));
#endif
  unsigned out = 0;
  for (unsigned i = 0; i < sizeof(Mask) / sizeof(int); ++i) out |= mask[i] != 0 ? 1u << i : 0u;
  return out;
}

template <class Function>
inline void each_bit(unsigned bits, const Function& function) {
  for (; bits != 0; bits &= bits - 1) function(__builtin_ctz(bits));
}

/// table[index] for each lane.
inline Float16 gather(const float* table, Int16 index) {
#ifdef __AVX512F__
  return reinterpret_cast<Float16>(
      _mm512_mask_i32gather_ps(__m512{}, 0xFFFF, reinterpret_cast<__m512i>(index), table, 4));
#else
  Float16 out;
  for (int i = 0; i < kWide; ++i) out[i] = table[index[i]];
  return out;
#endif
}

inline Int16 gather(const int* table, Int16 index) {
#ifdef __AVX512F__
  return reinterpret_cast<Int16>(
      _mm512_mask_i32gather_epi32(__m512i{}, 0xFFFF, reinterpret_cast<__m512i>(index), table, 4));
#else
  Int16 out;
  for (int i = 0; i < kWide; ++i) out[i] = table[index[i]];
  return out;
#endif
}

/// The lanes of `mask`, close together; `to` has room for all sixteen.
inline void pack(Float16 v, unsigned mask, float* to) {
#ifdef __AVX512F__
  _mm512_storeu_ps(
      to, _mm512_maskz_compress_ps(static_cast<__mmask16>(mask), reinterpret_cast<__m512>(v)));
#else
  each_bit(mask, [&](int i) { *to++ = v[i]; });
#endif
}
inline void pack(Int16 v, unsigned mask, int* to) {
#ifdef __AVX512F__
  _mm512_storeu_si512(
      to, _mm512_maskz_compress_epi32(static_cast<__mmask16>(mask), reinterpret_cast<__m512i>(v)));
#else
  each_bit(mask, [&](int i) { *to++ = v[i]; });
#endif
}

/// Three numbers, or three times sixteen.
template <class F>
struct Three {
  F x, y, z;
};
template <class F>
inline Three<F> operator+(Three<F> a, Three<F> b) {
  return {a.x + b.x, a.y + b.y, a.z + b.z};
}
template <class F>
inline Three<F> operator-(Three<F> a, Three<F> b) {
  return {a.x - b.x, a.y - b.y, a.z - b.z};
}
template <class F>
inline Three<F> operator*(Three<F> a, Three<F> b) {
  return {a.x * b.x, a.y * b.y, a.z * b.z};
}
template <class F>
inline Three<F> operator*(Three<F> a, F s) {
  return {a.x * s, a.y * s, a.z * s};
}
template <class F>
inline F dot(Three<F> a, Three<F> b) {
  return a.x * b.x + a.y * b.y + a.z * b.z;
}
using Vec = Three<float>;
inline Three<Float16> all(Vec v) {
  return {all(v.x), all(v.y), all(v.z)};
}
inline Three<Float16> unit(Three<Float16> v) {
  return v * (1.0f / sqrt(dot(v, v)));
}
inline Three<Float16> choose(Int16 mask, Three<Float16> a, Three<Float16> b) {
  return {mask ? a.x : b.x, mask ? a.y : b.y, mask ? a.z : b.z};
}

}  // namespace zraka::embree
