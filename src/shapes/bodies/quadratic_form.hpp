// SPDX-License-Identifier: Apache-2.0
// The quadric's polynomial: moved to where its box is, and its least value on a box' faces.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>

#include "math/pair.hpp"
#include "shapes/bodies/body.hpp"

namespace zraka {

/// Of x², y², z², xy, xz, yz, x, y, z and 1.
struct QuadraticForm {
  std::array<double, 10> c{};

  double value(const V3<double>& p) const {
    return (c[0] * p.x + c[3] * p.y + c[4] * p.z + c[6]) * p.x +
           (c[1] * p.y + c[5] * p.z + c[7]) * p.y + (c[2] * p.z + c[8]) * p.z + c[9];
  }
  V3<double> gradient(const V3<double>& p) const {
    return {2 * c[0] * p.x + c[3] * p.y + c[4] * p.z + c[6],
            c[3] * p.x + 2 * c[1] * p.y + c[5] * p.z + c[7],
            c[4] * p.x + c[5] * p.y + 2 * c[2] * p.z + c[8]};
  }
  double largest() const {
    double most = 0;
    for (const double k : c) most = std::fmax(most, std::fabs(k));
    return most;
  }
  QuadraticForm times(double s) const {
    QuadraticForm all = *this;
    for (double& k : all.c) k *= s;
    return all;
  }
  /// The same numbers of so many units along each axis.
  QuadraticForm in_units(const V3<double>& u) const {
    return {{c[0] * u.x * u.x, c[1] * u.y * u.y, c[2] * u.z * u.z, c[3] * u.x * u.y,
             c[4] * u.x * u.z, c[5] * u.y * u.z, c[6] * u.x, c[7] * u.y, c[8] * u.z, c[9]}};
  }
  /// Of what is relative to a point. That may be far away, where most of the coefficients cancels:
  /// so with pairs of doubles. Coefficients and point below 2^490.
  QuadraticForm relative_to(const V3<double>& p) const {
    using elementary::Pair;
    using elementary::product;
    using elementary::sum;
    const auto slope = [&](double linear, double kx, double ky, double kz) {
      const Pair xy = sum(product(kx, p.x), product(ky, p.y));
      return sum(sum(xy, product(kz, p.z)), Pair{linear, 0});
    };
    const Pair x = slope(c[6], 2 * c[0], c[3], c[4]), y = slope(c[7], c[3], 2 * c[1], c[5]),
               z = slope(c[8], c[4], c[5], 2 * c[2]);
    // By Euler's theorem twice the value is 2k plus the way times the slopes at both its ends.
    const auto share = [](const Pair& there, double here, double way) {
      return product(sum(there, Pair{here, 0}), Pair{way / 2, 0});
    };
    const Pair middle =
        sum(sum(share(x, c[6], p.x), share(y, c[7], p.y)), sum(share(z, c[8], p.z), Pair{c[9], 0}));
    QuadraticForm all = *this;
    all.c[6] = x.high, all.c[7] = y.high, all.c[8] = z.high, all.c[9] = middle.high;
    return all;
  }

  /// Its least value on the faces of the cube from -1 to 1: on a face where the slopes along it are
  /// 0, or on an edge, or at a corner.
  double least_on_cube() const {
    double least = c[9] + 10 * largest();
    for (const double side : {-1.0, 1.0}) {
      least = std::fmin(least, least_on_square(c[1], c[2], c[5], c[7] + side * c[3],
                                               c[8] + side * c[4], c[9] + c[0] + side * c[6]));
      least = std::fmin(least, least_on_square(c[0], c[2], c[4], c[6] + side * c[3],
                                               c[8] + side * c[5], c[9] + c[1] + side * c[7]));
      least = std::fmin(least, least_on_square(c[0], c[1], c[3], c[6] + side * c[4],
                                               c[7] + side * c[5], c[9] + c[2] + side * c[8]));
    }
    return least;
  }

  /// Whether where it is negative is an ellipsoid, or nothing, whose middle is in the cube from -1
  /// to 1: along each line it is convex, and its slopes are 0 there.
  bool has_its_least_in_cube() const {
    const double xy = c[3] / 2, xz = c[4] / 2, yz = c[5] / 2;
    const V3<double> x{c[0], xy, xz}, y{xy, c[1], yz}, z{xz, yz, c[2]};
    const double determinant = dot(x, cross(y, z));
    if (!(c[0] > 0 && c[0] * c[1] - xy * xy > 0 && determinant > 0)) return false;
    const V3<double> slope{c[6] / -2, c[7] / -2, c[8] / -2};  // Cramer's rule
    const V3<double> middle{dot(slope, cross(y, z)), dot(slope, cross(z, x)),
                            dot(slope, cross(x, y))};
    return std::fmax(std::fabs(middle.x), std::fmax(std::fabs(middle.y), std::fabs(middle.z))) <=
           determinant;
  }

 private:
  /// Of a·x² + b·y² + ab·xy + x_·x + y_·y + k on the square from -1 to 1.
  static double least_on_square(double a, double b, double ab, double x_, double y_, double k) {
    double least = std::fmin(
        std::fmin(least_on_line(a, x_ - ab, k + b - y_), least_on_line(a, x_ + ab, k + b + y_)),
        std::fmin(least_on_line(b, y_ - ab, k + a - x_), least_on_line(b, y_ + ab, k + a + x_)));
    const double determinant = 4 * a * b - ab * ab;
    if (a > 0 && determinant > 0) {
      const double x = (ab * y_ - 2 * b * x_) / determinant,
                   y = (ab * x_ - 2 * a * y_) / determinant;
      if (std::fabs(x) <= 1 && std::fabs(y) <= 1)
        least = std::fmin(least, k + (x_ * x + y_ * y) / 2);
    }
    return least;
  }
  static double least_on_line(double a, double x_, double k) {
    const double at_ends = k + a - std::fabs(x_);
    return a > 0 && std::fabs(x_) < 2 * a ? std::fmin(at_ends, k - x_ * x_ / (4 * a)) : at_ends;
  }
};

}  // namespace zraka
