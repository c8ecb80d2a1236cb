// SPDX-License-Identifier: Apache-2.0
// A polynomial of the second degree, within a box.
#pragma once

#include <algorithm>
#include <array>

#include "truth/truth.hpp"

namespace zraka::truth {

/// A sum of products, of which nothing is lost but what is rounded of the last of all.
class ExactSum {
 public:
  void add(Real a, Real b = 1, Real c = 1) {
    const Real ab = a * b, rest = std::fma(a, b, -ab);
    add_product(ab, c);
    add_product(rest, c);
  }
  Real value() const { return high_ + low_; }

 private:
  void add_product(Real a, Real b) {
    const Real product = a * b, sum = high_ + product, of_product = sum - high_;
    low_ += std::fma(a, b, -product) + ((high_ - (sum - of_product)) + (product - of_product));
    high_ = sum;
  }
  Real high_ = 0, low_ = 0;
};

template <>
struct Truth<Quadric> {
  Point middle, half;
  std::array<Real, 10> c;  ///< relative to the middle
  Real steepest = 0;       ///< in the box: at a corner

  explicit Truth(const Quadric& s)
      : middle((exact(s.min) + exact(s.max)) * 0.5L), half((exact(s.max) - exact(s.min)) * 0.5L) {
    std::copy(s.coefficients.begin(), s.coefficients.end(), c.begin());
    const auto& k = s.coefficients;
    const Real x = middle.x, y = middle.y, z = middle.z;
    const auto linear = [&](std::size_t axis, Real xs, Real ys, Real zs) {
      ExactSum sum;
      sum.add(k[6 + axis]), sum.add(xs, x), sum.add(ys, y), sum.add(zs, z);
      return sum.value();
    };
    c[6] = linear(0, 2 * Real{k[0]}, k[3], k[4]);
    c[7] = linear(1, k[3], 2 * Real{k[1]}, k[5]);
    c[8] = linear(2, k[4], k[5], 2 * Real{k[2]});
    ExactSum sum;
    sum.add(k[0], x, x), sum.add(k[1], y, y), sum.add(k[2], z, z);
    sum.add(k[3], x, y), sum.add(k[4], x, z), sum.add(k[5], y, z);
    sum.add(k[6], x), sum.add(k[7], y), sum.add(k[8], z), sum.add(k[9]);
    c[9] = sum.value();
    for (int corner = 0; corner < 8; ++corner)
      steepest = std::max(
          steepest, length(slopes({corner & 1 ? half.x : -half.x, corner & 2 ? half.y : -half.y,
                                   corner & 4 ? half.z : -half.z})));
  }

  /// Of the box' nearest point: what is outside of it is beyond the rim.
  Real residual(const Point& p) const {
    const auto [x, y, z] = in_box(p);
    return (c[0] * x * x + c[1] * y * y + c[2] * z * z + c[3] * x * y + c[4] * x * z +
            c[5] * y * z + c[6] * x + c[7] * y + c[8] * z + c[9]) /
           steepest;
  }
  Point gradient(const Point& p) const {
    const Point q = p - middle, g = slopes(in_box(p)) * (1 / steepest);
    return {std::fabs(q.x) < half.x ? g.x : 0, std::fabs(q.y) < half.y ? g.y : 0,
            std::fabs(q.z) < half.z ? g.z : 0};
  }
  Point normal(const Point& p) const { return slopes(in_box(p)); }
  Real beyond(const Point& p) const {
    const Point q = p - middle;
    return std::max({std::fabs(q.x) - half.x, std::fabs(q.y) - half.y, std::fabs(q.z) - half.z});
  }

  /// Ellipsoids in the box and such as are cut off, cylinders, hyperboloids, paraboloids and
  /// saddles, turned anyhow.
  static Quadric random(Random& random, const Place& place) {
    constexpr int kSigns[][3] = {{1, 1, 1},   {1, 1, 1}, {1, 1, -1},
                                 {1, -1, -1}, {1, 1, 0}, {1, -1, 0}};
    const int(&signs)[3] = kSigns[random() % std::size(kSigns)];
    Point axes[3];
    axes[0] = exact(on_unit_sphere(random));
    axes[1] = unit(cross(axes[0], exact(on_unit_sphere(random))));
    axes[2] = cross(axes[0], axes[1]);
    Real q[3][3] = {};
    for (int k = 0; k < 3; ++k) {
      const Real size = between(0.25, 0.6, random), weight = signs[k] / (size * size);
      const Real axis[] = {axes[k].x, axes[k].y, axes[k].z};
      for (int i = 0; i < 3; ++i)
        for (int j = 0; j < 3; ++j) q[i][j] += weight * axis[i] * axis[j];
    }
    // Of p = (world - m)/scale: p·Qp + 2·slope·p - 1, times scale².
    const Vec3 center = place.point(in_cube(random));
    const Real m[] = {center.x, center.y, center.z}, scale = place.scale;
    const Point along = signs[2] == 0 ? axes[2] : Point{0, 0, 0};  // parabolic along it
    const Real slope[] = {along.x, along.y, along.z};
    Real linear[3], constant = -scale * scale;
    for (int i = 0; i < 3; ++i) {
      linear[i] = 2 * scale * slope[i];
      constant -= 2 * scale * slope[i] * m[i];
      for (int j = 0; j < 3; ++j) {
        linear[i] -= 2 * q[i][j] * m[j];
        constant += q[i][j] * m[i] * m[j];
      }
    }
    const auto number = [](Real v) { return static_cast<double>(v); };
    const double reach = place.length(random() % 2 == 0 ? 0.7 : 0.35);
    return {{number(q[0][0]), number(q[1][1]), number(q[2][2]), number(2 * q[0][1]),
             number(2 * q[0][2]), number(2 * q[1][2]), number(linear[0]), number(linear[1]),
             number(linear[2]), number(constant)},
            {center.x - reach, center.y - reach, center.z - reach},
            {center.x + reach, center.y + reach, center.z + reach}};
  }

 private:
  Point in_box(const Point& p) const {
    const Point q = p - middle;
    return {std::clamp(q.x, -half.x, half.x), std::clamp(q.y, -half.y, half.y),
            std::clamp(q.z, -half.z, half.z)};
  }
  Point slopes(const Point& q) const {
    return {2 * c[0] * q.x + c[3] * q.y + c[4] * q.z + c[6],
            c[3] * q.x + 2 * c[1] * q.y + c[5] * q.z + c[7],
            c[4] * q.x + c[5] * q.y + 2 * c[2] * q.z + c[8]};
  }
};

}  // namespace zraka::truth
