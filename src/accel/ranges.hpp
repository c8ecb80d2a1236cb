// SPDX-License-Identifier: Apache-2.0
// Ranges of references on their way to becoming nodes: their bounds, and the bins that their
// centres fall into.
#pragma once

#include <cstddef>
#include <cstdint>
#include <cstring>
#include <limits>
#include <utility>

#include "accel/build.hpp"

namespace zraka {

/// So many references are a small piece of work for a task that only looks at them.
inline constexpr std::size_t kTaskSize = 4096;
/// Bins along an axis.
inline constexpr int kBins = 16;

/// Three numbers and one that does not matter, in one register (GCC's and clang's vectors).
using Four = float __attribute__((vector_size(16)));
using FourInts = int __attribute__((vector_size(16)));

inline Four smaller(Four a, Four b) {
  return a < b ? a : b;
}
inline Four larger(Four a, Four b) {
  return a > b ? a : b;
}
/// Three numbers from here on, and any fourth that can be read.
inline Four four_at(const float* p) {
  Four v;
  std::memcpy(&v, p, sizeof(v));
  return v;
}
inline Four lower_of(const BuildRef& ref) {
  return four_at(ref.lower);
}
inline Four upper_of(const BuildRef& ref) {
  static_assert(offsetof(BuildRef, index) == offsetof(BuildRef, upper) + sizeof(ref.upper));
  Four v = four_at(ref.upper);
  v[3] = 0;  // an index would be the tiniest of floats, which are slow
  return v;
}
/// Twice the centre, which is all that bins need.
inline Four center_of(const BuildRef& ref) {
  return lower_of(ref) + upper_of(ref);
}

struct BuildBounds {
  static constexpr float kInfinity = std::numeric_limits<float>::infinity();
  Four lower = {kInfinity, kInfinity, kInfinity, kInfinity};
  Four upper = -lower;

  void include(Four lo, Four up) {
    lower = smaller(lower, lo);
    upper = larger(upper, up);
  }
  void include(const BuildBounds& other) { include(other.lower, other.upper); }
  bool empty() const { return !(lower[0] <= upper[0]); }
  float half_area() const {
    const Four size = upper - lower;
    return size[0] < 0 ? 0 : size[0] * size[1] + size[1] * size[2] + size[2] * size[0];
  }
};

struct Range {
  BuildRef *begin, *end;
  BuildBounds bounds, centers;
  std::size_t size() const { return static_cast<std::size_t>(end - begin); }
  /// What it costs to hit all of it, by the surface area heuristic.
  float cost() const { return bounds.half_area() * static_cast<float>(size()); }
};

/// With the bounds of references and of their centres.
Range range_of(BuildRef* begin, BuildRef* end);
BuildBounds centers_by_tasks(const BuildRef* begin, const BuildRef* end);

struct Bin {
  BuildBounds bounds;
  std::uint32_t count = 0;
};

/// Which bin a centre falls into along each axis; monotonous in the centre.
struct Binning {
  Four from, scale, last;
  int count;
  Binning(const Range& range, int bins) : from(range.centers.lower), count(bins) {
    const Four extent = range.centers.upper - from;
    for (int a = 0; a < 4; ++a) {
      const float s = a < 3 ? static_cast<float>(count) / extent[a] : 0;
      scale[a] = s > 0 && s < std::numeric_limits<float>::max() ? s : 0;  // 0: no extent, no bins
      last[a] = static_cast<float>(count - 1);
    }
  }
  FourInts bins_of(Four lower, Four upper) const {
    const Four bin = smaller((lower + upper - from) * scale, last);
    return __builtin_convertvector(larger(bin, Four{}), FourInts);
  }
};

/// The two parts of a range, neither empty, that cost least by the surface area heuristic, where a
/// part costs as much as the next multiple of `leaf` references; halves where `anyhow` is set or
/// all centres are equal. The range has at least two references.
std::pair<Range, Range> split(const Range& range, std::uint32_t leaf, bool anyhow);

}  // namespace zraka
