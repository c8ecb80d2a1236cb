// SPDX-License-Identifier: Apache-2.0
// Along a ray, where residuals say what they should not.
#pragma once

#include <algorithm>
#include <vector>

#include "truth/truth.hpp"

namespace zraka::truth {

/// Where in [a, b] a function becomes positive that rises there.
template <class Function>
Real rises_at(Real a, Real b, const Function& function) {
  for (int k = 0; k < 64; ++k) {
    const Real middle = a + (b - a) / 2;
    (function(middle) > 0 ? b : a) = middle;
  }
  return a + (b - a) / 2;
}

/// Whether side·residual is below -error somewhere on a ray's way.
template <class T>
class Straying {
 public:
  Straying(const T& truth, const Ray& ray, Real side, Real error)
      : truth_(truth), ray_(ray), side_(side), error_(error) {}

  bool between(Real from, Real to) {
    least_width_ = (to - from) / 128;
    return visit(from, value(from), to, value(to));
  }

 private:
  Real value(Real t) const { return side_ * truth_.residual(ray_.at(t)); }
  Real slope(Real t) const { return side_ * dot(truth_.gradient(ray_.at(t)), ray_.direction); }

  /// Cuts the way into halves where the residual, which changes by no more than the way, does not
  /// say that it cannot be. Along a surface that leads nowhere: short ways are looked at where they
  /// are lowest, where that is not at an end.
  bool visit(Real a, Real at_a, Real b, Real at_b) const {
    if (std::min(at_a, at_b) < -error_) return true;
    const Real width = (b - a) * (1 + 1e-6L);
    if (at_a + at_b - width >= -2 * error_) return false;
    if (width < least_width_)
      return slope(a) < 0 && slope(b) > 0 &&
             value(rises_at(a, b, [&](Real t) { return slope(t); })) < -error_;
    const Real middle = a + (b - a) / 2, there = value(middle);
    return visit(a, at_a, middle, there) || visit(middle, there, b, at_b);
  }

  const T& truth_;
  const Ray& ray_;
  const Real side_, error_;
  Real least_width_ = 0;
};

/// Where a ray goes through an open surface, well within its rim: where its residual's sign changes
/// and comes to more than an error on both sides.
template <class T>
class Throughs {
 public:
  Throughs(const T& truth, const Ray& ray, Real error) : truth_(truth), ray_(ray), error_(error) {}

  std::vector<Real> between(Real from, Real to) {
    least_width_ = (to - from) / 64;
    last_ = 0;
    note(from);
    visit(from, to);
    note(to);
    return found_;
  }

 private:
  Real value(Real t) const { return truth_.residual(ray_.at(t)); }
  Real slope(Real t) const { return dot(truth_.gradient(ray_.at(t)), ray_.direction); }

  void visit(Real a, Real b) {
    const Real at_a = value(a), at_b = value(b), width = (b - a) * (1 + 1e-6L);
    if (at_a * at_b > 0 && std::fabs(at_a) + std::fabs(at_b) > width) return;
    if (width < least_width_) {
      const Real side = at_a > 0 ? 1 : -1;
      if (side * slope(a) < 0 && side * slope(b) > 0)
        note(rises_at(a, b, [&](Real t) { return side * slope(t); }));
      note(b);
      return;
    }
    const Real middle = a + (b - a) / 2;
    visit(a, middle);
    note(middle);
    visit(middle, b);
  }

  void note(Real t) {
    const Real here = value(t);
    if (std::fabs(here) <= error_) return;
    if (here * last_ < 0) {
      const Real side = here > 0 ? 1 : -1;
      const auto reaches = [&](Real level) {
        return rises_at(last_at_, t, [&](Real at) { return side * value(at) - level; });
      };
      const auto within_rim = [&](Real at) { return beyond(truth_, ray_.at(at)) < -4 * error_; };
      if (within_rim(reaches(-error_)) && within_rim(reaches(error_))) found_.push_back(reaches(0));
    }
    last_ = here;
    last_at_ = t;
  }

  const T& truth_;
  const Ray& ray_;
  const Real error_;
  Real least_width_ = 0, last_ = 0, last_at_ = 0;
  std::vector<Real> found_;
};

}  // namespace zraka::truth
