// SPDX-License-Identifier: Apache-2.0
// All that there is to ask of a body's crossings.
#pragma once

#include "probed_body.hpp"
#include "truth/straying.hpp"

namespace zraka::truth {

/// Crossings that there are.
inline std::vector<Real> finite_ones(const BodyCrossings& found) {
  std::vector<Real> at;
  for (const double t : found.at)
    if (std::fabs(t) < HUGE_VAL) at.push_back(t);
  return at;
}

/// How far a ray is looked at.
template <class Shape>
Real far_from(const Placed<Shape>& body, const Ray& ray) {
  return length(ray.origin - body.middle()) + 4 * body.place.scale;
}

/// The ray is outside before the first crossing, inside behind it, and so on.
template <class Shape>
void expect_spans(const Placed<Shape>& body, const Ray& ray, const BodyCrossings& found) {
  const Real error = body.error(ray.origin), far = far_from(body, ray);
  Real side = 1, last = -far;
  for (const double t : found.at) {
    if (!(t < far)) break;
    if (t > last) {
      ASSERT_FALSE(Straying(body.truth, ray, side, error).between(last, t))
          << (side > 0 ? "inside" : "outside") << " somewhere from " << double(last) << " to " << t;
      last = t;
    }
    side = -side;
  }
  ASSERT_FALSE(Straying(body.truth, ray, side, error).between(last, far));
}

/// The same, where the residual has one least value along a ray: there it is inside, or nowhere.
template <class Shape>
void expect_convex_spans(const Placed<Shape>& body, const Ray& ray, const BodyCrossings& found) {
  const Real error = body.error(ray.origin), far = far_from(body, ray);
  const Real lowest = rises_at(
      -far, far, [&](Real t) { return dot(body.truth.gradient(ray.at(t)), ray.direction); });
  const std::size_t crossed = finite_ones(found).size();
  if (body.truth.residual(ray.at(lowest)) < -error) {
    ASSERT_EQ(crossed, 2u) << "inside at " << double(lowest);
    ASSERT_TRUE(found.at[0] < lowest && lowest < found.at[1]) << "inside at " << double(lowest);
  }
  ASSERT_LE(crossed, 2u);
}

/// Wherever it surely goes through the surface there is a crossing.
template <class Shape>
void expect_throughs(const Placed<Shape>& body, const Ray& ray, const BodyCrossings& found) {
  const Real error = body.error(ray.origin), far = far_from(body, ray);
  const std::vector<Real> at = finite_ones(found);
  for (const Real through : Throughs(body.truth, ray, error).between(-far, far))
    ASSERT_TRUE(std::any_of(at.begin(), at.end(),
                            [&](Real t) {
                              return std::fabs(body.truth.residual(ray.at((t + through) / 2))) <=
                                         error &&
                                     std::fabs(t - through) <= 0.01L * body.place.scale;
                            }))
        << "it goes through at " << double(through);
}

template <class Shape>
void expect_crossings(const Placed<Shape>& body, const std::vector<BodyProbeRay>& rays,
                      const std::vector<BodyCrossings>& found) {
  for (std::size_t i = 0; i < rays.size(); ++i) {
    const Ray ray = exact(rays[i]);
    SCOPED_TRACE(to_string(rays[i]) + " crosses " + to_string(found[i]));
    ASSERT_TRUE(std::is_sorted(found[i].at, found[i].at + kProbedCrossings));
    const Real error = body.error(ray.origin), far = far_from(body, ray);
    const std::vector<Real> at = finite_ones(found[i]);
    if (ShapeTraits<Shape>::bounds(body.shape).bounded()) {
      ASSERT_TRUE(at.empty() || (-far < at.front() && at.back() < far));
      if (is_closed(body.shape)) {
        ASSERT_EQ(at.size() % 2, 0u);
      }
    }
    for (const Real t : at) {
      if (std::fabs(t) > far) continue;
      ASSERT_LE(std::fabs(body.truth.residual(ray.at(t))), error) << "at " << double(t);
      ASSERT_LE(beyond(body.truth, ray.at(t)), error) << "at " << double(t);
    }
    if constexpr (requires { Truth<Shape>::kConvex; })
      expect_convex_spans(body, ray, found[i]);
    else if (is_closed(body.shape))
      expect_spans(body, ray, found[i]);
    else
      expect_throughs(body, ray, found[i]);
    if (testing::Test::HasFatalFailure()) return;
  }
}

}  // namespace zraka::truth
