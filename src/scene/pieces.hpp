// SPDX-License-Identifier: Apache-2.0
// Large triangles as pieces, for a point of a triangle is no more exact than its corners.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <type_traits>
#include <vector>

#include "shapes/shapes.hpp"

namespace zraka {

/// A kind of shape that can be cut: its frozen numbers are what three corners have, corner by
/// corner, kind of number by kind of number.
template <class Shape>
inline constexpr bool kHasPieces =
    std::is_same_v<Shape, Triangle> || std::is_same_v<Shape, SmoothTriangle>;

template <class Shape>
using Numbers = std::array<double, static_cast<std::size_t>(ShapeTraits<Shape>::kReals)>;

/// Cuts a frozen triangle through the middle of its longest edge, and the halves again, until no
/// edge is longer than `fine` or twice the distance from the frame's centre: a logarithm of its
/// size is how many that makes. The pieces overlap by more than their corners are rounded by, and
/// are added to `pieces`, at most `most`; false if there would be more.
template <class Shape>
bool cut_to_pieces(const Numbers<Shape>& whole, double fine, std::size_t most,
                   std::vector<Numbers<Shape>>& pieces) {
  constexpr std::size_t kVectors = std::tuple_size_v<Numbers<Shape>> / 9;  // at each corner
  const std::size_t before = pieces.size();
  std::vector<Numbers<Shape>> open{whole};
  while (!open.empty()) {
    Numbers<Shape> piece = open.back();
    open.pop_back();
    std::size_t from = 0;
    double longest = 0;
    for (std::size_t i = 0; i < 3; ++i) {
      const double *a = &piece[3 * i], *b = &piece[3 * ((i + 1) % 3)];
      const double length = std::hypot(a[0] - b[0], a[1] - b[1], a[2] - b[2]);
      if (length > longest) longest = length, from = i;
    }
    const double away = ShapeTraits<Triangle>::frozen_bounds(piece.data()).distance_to({});
    if (longest <= std::max(fine, 2 * away)) {
      constexpr double kOverlap = 0x1p-19;
      for (std::size_t k = 0; k < 3; ++k) {
        const double middle = (piece[k] + piece[3 + k] + piece[6 + k]) / 3;
        for (std::size_t i = k; i < 9; i += 3) piece[i] += (piece[i] - middle) * kOverlap;
      }
      if (pieces.size() - before >= most) return false;
      pieces.push_back(piece);
      continue;
    }
    Numbers<Shape> other = piece;
    const std::size_t to = (from + 1) % 3;
    for (std::size_t vector = 0; vector < kVectors; ++vector)
      for (std::size_t k = 9 * vector; k < 9 * vector + 3; ++k)
        piece[k + 3 * to] = other[k + 3 * from] = piece[k + 3 * from] / 2 + piece[k + 3 * to] / 2;
    open.push_back(piece);
    open.push_back(other);
  }
  return true;
}

}  // namespace zraka
