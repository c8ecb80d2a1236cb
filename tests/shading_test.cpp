// SPDX-License-Identifier: Apache-2.0
// What instruction sets compute of light at many hits in lanes of doubles: the bits that come of it
// hit by hit.
#include <gtest/gtest.h>

#include <bit>
#include <cmath>
#include <limits>
#include <string_view>
#include <vector>

#include "core/random.hpp"
#include "math/elementary.hpp"
#include "render/isa.hpp"
#include "render/workspace.hpp"
#include "sampling/warp.hpp"

namespace zraka {
namespace {

/// Not a multiple of any number of lanes.
constexpr std::int32_t kHits = 4003;
constexpr std::size_t kCount = kHits;

V3<double> any_way(Random& random) {
  for (;;) {
    const V3<double> v{2 * random.unit() - 1, 2 * random.unit() - 1, 2 * random.unit() - 1};
    const double square = dot(v, v);
    if (square > 0.01 && square < 1) return v * (1 / std::sqrt(square));
  }
}
template <class R>
void put(const V3<double>& v, R* x, R* y, R* z, std::size_t i) {
  x[i] = static_cast<R>(v.x), y[i] = static_cast<R>(v.y), z[i] = static_cast<R>(v.z);
}
template <class R>
V3<double> at(const R* x, const R* y, const R* z, std::size_t i) {
  return {static_cast<double>(x[i]), static_cast<double>(y[i]), static_cast<double>(z[i])};
}
std::uint64_t bits_of(double value) {
  return std::bit_cast<std::uint64_t>(value);
}

/// Hits with normals, ways to the viewer and rows of coefficients, and a shadow ray of each.
template <class R>
struct Hits {
  Random random{5};
  WorkspaceMemory<R> memory{WorkspaceNeeds{.batch = kHits, .general = true}};
  std::vector<R> rows;

  Scratch<R>& scratch() { return memory.workspace().scratch; }
  Hits() {
    Scratch<R>& s = scratch();
    for (std::size_t h = 0; h < kCount; ++h) {
      put(any_way(random), s.nx, s.ny, s.nz, h);
      put(any_way(random), s.vx, s.vy, s.vz, h);
      put(any_way(random) * (h % 7 == 0 ? 0.0 : 4.0), s.px, s.py, s.pz, h);
    }
    // Shadow rays in another order than hits; some highlights are right in the mirror's direction.
    for (std::size_t i = 0; i < kCount; ++i) {
      const std::size_t h = (i * 17) % kCount;
      s.shadow_ray_hit[i] = static_cast<std::int32_t>(h);
      const V3<double> n = at(s.nx, s.ny, s.nz, h), v = at(s.vx, s.vy, s.vz, h);
      V3<double> way = n * (2 * dot(n, v)) - v + any_way(random) * (i % 3 == 0 ? 0.0 : 0.3);
      way = way * (1 / std::sqrt(dot(way, way)));
      put(i % 5 == 0 ? any_way(random) : way, s.sdx, s.sdy, s.sdz, i);
    }
    // Each hit has a row, and not its own.
    rows.assign(kCount * kMaterialReals, R(0));
    for (std::size_t i = 0; i < kCount; ++i) {
      const double sizes[] = {0, 1, 2, 20, 80.5, std::pow(10, 8 * random.unit() - 2), 1e-30};
      rows[i * kMaterialReals + kShininess] = static_cast<R>(sizes[i % std::size(sizes)]);
      rows[i * kMaterialReals + kBlinn] = static_cast<R>(i / 7 % 2);
      s.material[i] = static_cast<std::int32_t>((i * 31) % kCount);
    }
    s.coefficients = rows.data();
    s.row = s.material;
  }
};

template <class R>
void expect_highlights_of_pow(const Services<R>& services, std::string_view name) {
  Hits<R> hits;
  const Scratch<R>& s = hits.scratch();
  std::vector<double> highlights(kCount + kArrayPadding);
  services.find_highlights(kCount, s, highlights.data());
  int unknown = 0, none = 0, away = 0;
  for (std::size_t i = 0; i < kCount; ++i) {
    const auto h = static_cast<std::size_t>(s.shadow_ray_hit[i]);
    const V3<double> n = at(s.nx, s.ny, s.nz, h), v = at(s.vx, s.vy, s.vz, h);
    const V3<double> l = at(s.sdx, s.sdy, s.sdz, i), half = l + v;
    const R* const row = s.coefficients + s.row[h] * kMaterialReals;
    const double cosine = row[kBlinn] > R(0) ? dot(n, half) / std::sqrt(dot(half, half))
                                             : dot(n * (2 * dot(n, l)) - l, v);
    const auto shininess = static_cast<double>(row[kShininess]);
    double wanted = kFacesAway;
    if (cosine >= 0 && (1 - cosine) * shininess > kNoHighlight)
      wanted = 0, ++none;
    else if (cosine >= 0)
      wanted = elementary::pow(std::fmin(cosine, 1.0), shininess);
    else
      ++away;
    if (highlights[i] == kUnknownHighlight) {
      ++unknown;
      EXPECT_TRUE(shininess == 0 || wanted < 1e-300) << name << " " << cosine << "^" << shininess;
      continue;
    }
    EXPECT_EQ(bits_of(highlights[i]), bits_of(wanted))
        << name << " " << cosine << "^" << shininess << ": " << highlights[i] << ", where "
        << wanted << " was expected";
  }
  EXPECT_LT(unknown, 800) << name;  // those without an exponent
  EXPECT_GT(none, 50) << name;
  EXPECT_GT(away, 50) << name;
}

TEST(Shading, HasTheHighlightsOfPow) {
  for (const Isa isa : available_isas())
    expect_highlights_of_pow(*kernel_of(isa).services, name_of(isa));
  expect_highlights_of_pow(isa_oracle::kServices, "oracle");
}

/// What arrives at a point, step by step.
struct Arrives {
  V3<double> to;
  double distance, strength, cosine;
};
Arrives arrives(const OpticalLight& light, const V3<double>& point) {
  if (light.kind == LightKind::directional)
    return {-light.direction, std::numeric_limits<double>::infinity(), 1, 1};
  const V3<double> way = light.position - point;
  const double distance = std::sqrt(dot(way, way));
  if (!(distance > 0)) return {{0, 0, 0}, 0, 0, 1};
  Arrives all{way * (1 / distance), distance, 0, 1};
  all.strength =
      1 / (light.constant + light.linear * distance + light.quadratic * distance * distance);
  if (light.kind != LightKind::spot) return all;
  all.cosine = -dot(all.to, light.direction);
  const double span = light.cos_inner - light.cos_outer;
  if (light.linear_edge_counts()) return all;
  const double x = std::fmin(std::fmax((all.cosine - light.cos_outer) / span, 0.0), 1.0);
  all.strength *= span > 0 ? x * x * (3 - 2 * x) : (all.cosine >= light.cos_outer ? 1.0 : 0.0);
  return all;
}

template <class R>
void expect_arriving(const Services<R>& services, const OpticalLight& light,
                     std::string_view name) {
  Hits<R> hits;
  Scratch<R>& s = hits.scratch();
  std::vector<double> numbers(4 * (kCount + kArrayPadding));
  double* const first = numbers.data();
  constexpr std::size_t kSize = kCount + kArrayPadding;
  const ArrivingLight found{first, first + kSize, first + 2 * kSize, first + 3 * kSize};
  services.find_arriving(light, kCount, s, found);
  for (std::size_t h = 0; h < kCount; ++h) {
    const Arrives wanted = arrives(light, at(s.px, s.py, s.pz, h));
    ASSERT_EQ(bits_of(found.distance[h]), bits_of(wanted.distance)) << name << h;
    ASSERT_EQ(bits_of(found.strength[h]), bits_of(wanted.strength)) << name << h;
    if (wanted.distance > 0) {
      ASSERT_EQ(bits_of(found.cosine[h]), bits_of(wanted.cosine)) << name << h;
    }
    ASSERT_EQ(found.l_n[h], dot(wanted.to, at(s.nx, s.ny, s.nz, h))) << name << h;
    ASSERT_EQ(s.lx[h], static_cast<R>(wanted.to.x)) << name << h;
    ASSERT_EQ(s.ly[h], static_cast<R>(wanted.to.y)) << name << h;
    ASSERT_EQ(s.lz[h], static_cast<R>(wanted.to.z)) << name << h;
  }
}

TEST(Shading, HasTheLightThatArrives) {
  OpticalLight light{};
  light.position = {0.5, 1.5, -2};
  light.direction = {0.6, -0.8, 0};
  light.constant = 1;
  std::vector<OpticalLight> lights;
  for (const LightKind kind : {LightKind::point, LightKind::directional, LightKind::spot}) {
    light.kind = kind;
    light.cos_inner = 0.7, light.cos_outer = 0.2;
    lights.push_back(light);
    lights.push_back(light);
    lights.back().linear = 0.3, lights.back().quadratic = 0.07;
  }
  lights.push_back(light);
  lights.back().cos_outer = 0.7;  // a sharp edge
  lights.push_back(light);
  lights.back().linear_edge = true, lights.back().inner = 0.5, lights.back().outer = 1;
  lights.push_back(light);
  lights.back().position = {0, 0, 0};  // where some of the hits are
  for (const OpticalLight& each : lights) {
    for (const Isa isa : available_isas())
      expect_arriving(*kernel_of(isa).services, each, name_of(isa));
    expect_arriving(isa_oracle::kServices, each, "oracle");
  }
}

/// A point on a light that is a surface.
V3<double> point_on(const OpticalLight& light, const V3<double>& seen_from, const Point2& at) {
  if (light.kind == LightKind::rectangle)
    return light.position + light.edge_u * at.u + light.edge_v * at.v;
  const DiscPoint on = quick_concentric_disc(at);
  if (light.kind == LightKind::disc)
    return light.position + light.edge_u * on.x + light.edge_v * on.y;
  const V3<double> way = light.position - seen_from;
  const double away = std::sqrt(dot(way, way));
  if (!(away > light.radius)) return light.position;
  const V3<double> axis = way * (1 / away);
  V3<double> a{}, b{};
  basis_of(axis, a, b);
  const double sine = light.radius / away, cosine = std::sqrt(1 - sine * sine);
  return light.position - axis * (light.radius * sine) +
         (a * on.x + b * on.y) * (light.radius * cosine);
}

template <class R>
void expect_samples(const Services<R>& services, const OpticalLight& light,
                    std::string_view name) {
  Hits<R> hits;
  Scratch<R>& s = hits.scratch();
  constexpr std::size_t kSize = kCount + kArrayPadding;
  std::vector<std::uint32_t> shuffle(kSize), u(kSize), v(kSize), number(kSize);
  std::vector<R> dx(kSize), dy(kSize), dz(kSize), distance(kSize), strength(kSize);
  std::vector<double> l_n(kSize);
  for (std::size_t i = 0; i < kCount; ++i) {
    const Sobol2 points(static_cast<std::uint32_t>(i / 5));
    shuffle[i] = points.shuffle, u[i] = points.scramble_u, v[i] = points.scramble_v;
    number[i] = static_cast<std::uint32_t>(i * 77);
  }
  services.sample_light(light, {shuffle.data(), u.data(), v.data(), number.data()},
                        s.shadow_ray_hit, kCount, s,
                        {dx.data(), dy.data(), dz.data(), distance.data(), strength.data(),
                         l_n.data()});
  for (std::size_t i = 0; i < kCount; ++i) {
    const auto h = static_cast<std::size_t>(s.shadow_ray_hit[i]);
    const V3<double> point = at(s.px, s.py, s.pz, h), normal = at(s.nx, s.ny, s.nz, h);
    const Point2 place = Sobol2(static_cast<std::uint32_t>(i / 5))[number[i]];
    OpticalLight there = light;
    there.kind = LightKind::point;
    there.position = point_on(light, point, place);
    const Arrives wanted = arrives(there, point);
    ASSERT_EQ(dx[i], static_cast<R>(wanted.to.x)) << name << i;
    ASSERT_EQ(dy[i], static_cast<R>(wanted.to.y)) << name << i;
    ASSERT_EQ(dz[i], static_cast<R>(wanted.to.z)) << name << i;
    ASSERT_EQ(distance[i], static_cast<R>(wanted.distance)) << name << i;
    ASSERT_EQ(strength[i], static_cast<R>(wanted.strength)) << name << i;
    ASSERT_EQ(l_n[i], dot(wanted.to, normal)) << name << i;
  }
}

TEST(Shading, HasTheSamplesOfSurfacesThatShine) {
  OpticalLight light{};
  light.position = {0.5, 1.5, -2};
  light.edge_u = {0.25, 0.5, -1}, light.edge_v = {1, 0, 0.125};
  light.radius = 1.75;  // some of the hits are in it
  light.constant = 1;
  std::vector<OpticalLight> lights;
  for (const LightKind kind : {LightKind::rectangle, LightKind::disc, LightKind::sphere}) {
    light.kind = kind;
    lights.push_back(light);
    lights.push_back(light);
    lights.back().linear = 0.3, lights.back().quadratic = 0.07;
    lights.push_back(light);
    lights.back().position = {0, 0, 0};  // where some of the hits are
    lights.back().edge_u = lights.back().edge_v = {0, 0, 0};
  }
  for (const OpticalLight& each : lights) {
    for (const Isa isa : available_isas())
      expect_samples(*kernel_of(isa).services, each, name_of(isa));
    expect_samples(isa_oracle::kServices, each, "oracle");
  }
}

}  // namespace
}  // namespace zraka
