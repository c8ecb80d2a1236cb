// SPDX-License-Identifier: Apache-2.0
// What instruction sets compute at all hits of a batch: the bits that come of it hit by hit.
#include "engine/hit_services.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <string_view>
#include <vector>
#include <zraka/optics.hpp>

#include "core/random.hpp"
#include "engine/general/steps.hpp"
#include "math/elementary.hpp"
#include "render/isa.hpp"
#include "render/workspace.hpp"

namespace zraka {
namespace {

/// Not a multiple of any number of lanes.
constexpr std::int32_t kHitCount = 1003;
constexpr std::size_t kHitSize = kHitCount;

/// Hits of a level's batch, the light that arrives there, and rows of coefficients of which some
/// are 0.
template <class R>
struct LitHits {
  Random random{7};
  WorkspaceMemory<R> memory;
  std::vector<R> rows;
  std::vector<double> numbers = std::vector<double>(5 * (kHitSize + kArrayPadding));
  ArrivingLight arriving{};
  V3<R> color{R(0.7), R(0), R(0.3)};

  Scratch<R>& s() { return memory.workspace().scratch; }
  Level<R>& level() { return memory.workspace().levels[0]; }
  R any() { return static_cast<R>(2 * random.unit() - 1); }

  /// `recorded`: with room for normals that no texture has bent.
  explicit LitHits(bool recorded = false)
      : memory(WorkspaceNeeds{
            .batch = kHitCount, .max_depth = 0, .recorded = recorded, .general = true}) {
    double* const first = numbers.data();
    constexpr std::size_t kSize = kHitSize + kArrayPadding;
    arriving = {first, first + kSize, first + 2 * kSize, first + 3 * kSize, first + 4 * kSize};
    rows.assign(kHitSize * kMaterialReals, R(0));
    level().hit_count = kHitCount;
    level().done = 0;
    for (std::size_t h = 0; h < kHitSize; ++h) {
      for (R* array :
           {s().px, s().py, s().pz, s().nx, s().ny, s().nz, s().vx, s().vy, s().vz, s().lx, s().ly,
            s().lz, s().offset, level().hits.r, level().hits.g, level().hits.b})
        array[h] = any();
      // Some look along the mirror's direction.
      if (h % 3 == 0) s().lx[h] = s().nx[h], s().ly[h] = s().ny[h], s().lz[h] = s().nz[h];
      if (h % 3 == 0) s().vx[h] = s().nx[h], s().vy[h] = s().ny[h], s().vz[h] = s().nz[h];
      arriving.distance[h] = h % 11 == 0 ? std::numeric_limits<double>::infinity() : 5.0;
      arriving.strength[h] = h % 5 == 0 ? 0 : random.unit();
      arriving.l_n[h] = h % 7 == 0 ? 0 : 2 * random.unit() - 1;
      level().hits.ray[h] = static_cast<std::int32_t>((h * 19) % kHitSize);
      s().material[h] = static_cast<std::int32_t>((h / 30 * 31) % kHitSize);
      R* const row = rows.data() + h * kMaterialReals;
      for (int c = 0; c < 3; ++c) {
        if (h % 2 == 0) row[kDiffuse + c] = static_cast<R>(random.unit());
        if (h % 4 < 2) row[kSpecular + c] = static_cast<R>(random.unit());
      }
      row[kShininess] = static_cast<R>(h % 13 == 0 ? 0 : 1 + h % 40);
      row[kBlinn] = static_cast<R>(h / 8 % 2);
    }
    s().coefficients = rows.data();
    s().row = s().material;
  }
  const R* row(std::size_t h) { return rows.data() + s().row[h] * kMaterialReals; }
  bool is_dark(std::size_t h, int column) {
    return row(h)[column] == R(0) && row(h)[column + 1] == R(0) && row(h)[column + 2] == R(0);
  }
  double highlight(std::size_t h) {
    const V3<double> n{double(s().nx[h]), double(s().ny[h]), double(s().nz[h])},
        v{double(s().vx[h]), double(s().vy[h]), double(s().vz[h])},
        l{double(s().lx[h]), double(s().ly[h]), double(s().lz[h])}, half = l + v;
    const double cosine = row(h)[kBlinn] > R(0) ? dot(n, half) / std::sqrt(dot(half, half))
                                                : dot(n * (2 * dot(n, l)) - l, v);
    const auto shininess = static_cast<double>(row(h)[kShininess]);
    if (!(cosine >= 0)) return kFacesAway;
    if ((1 - cosine) * shininess > kNoHighlight) return 0;
    return elementary::pow(std::fmin(cosine, 1.0), shininess);
  }
};

template <class R>
void expect_light(const Services<R>& all, const Terms& terms, std::string_view name) {
  const HitServices<R>& services = *all.hits;
  LitHits<R> hits;
  Scratch<R>& s = hits.s();
  const HitArrays<R> arrays = hits.level().hits;
  const std::vector<R> before(arrays.g, arrays.g + kHitSize), red(arrays.r, arrays.r + kHitSize);
  services.find_shines(terms, kHitSize, s, hits.arriving);
  for (std::size_t h = 0; h < kHitSize; ++h) {
    const bool faces = hits.arriving.l_n[h] >= 0;
    ASSERT_EQ(s.strength[h], faces ? static_cast<R>(hits.arriving.strength[h]) : R(0)) << name;
    ASSERT_EQ(s.sdistance[h], static_cast<R>(std::fmin(hits.arriving.distance[h], kFarthest)))
        << name;
    if (!terms.specular || s.strength[h] == R(0) || hits.is_dark(h, kSpecular)) continue;
    const double wanted = hits.highlight(h);
    double& found = hits.arriving.highlight[h];
    if (found == kUnknownHighlight) found = wanted;
    ASSERT_EQ(found, wanted) << name << " " << h;
  }
  const std::size_t listed = services.list_facing(hits.color, terms, kHitSize, s, hits.arriving);
  std::vector<std::int32_t> facing;
  for (std::size_t h = 0; h < kHitSize; ++h) {
    const bool diffuse = terms.diffuse && !hits.is_dark(h, kDiffuse) && hits.arriving.l_n[h] > 0;
    const bool shines = terms.specular && !hits.is_dark(h, kSpecular) && hits.highlight(h) > 0;
    const bool counts = s.strength[h] != R(0) && (diffuse || shines);
    ASSERT_EQ(s.lit[h], counts ? R(1) : R(0)) << name << " " << h;
    if (counts) facing.push_back(static_cast<std::int32_t>(h));
  }
  EXPECT_EQ(std::vector<std::int32_t>(s.shadow_ray_hit, s.shadow_ray_hit + listed), facing);
  EXPECT_GT(listed, kHitSize / 20) << name;
  services.add_arriving(hits.color, terms, hits.level(), s, hits.arriving);
  for (std::size_t h = 0; h < kHitSize; ++h) {
    R wanted = red[h];
    if (s.lit[h] > R(0)) {
      const R radiance = hits.color.x * s.strength[h];
      if (terms.diffuse)
        wanted += radiance * hits.row(h)[kDiffuse] * static_cast<R>(hits.arriving.l_n[h]);
      if (terms.specular && !hits.is_dark(h, kSpecular) && hits.highlight(h) != kFacesAway)
        wanted += radiance * hits.row(h)[kSpecular] * static_cast<R>(hits.highlight(h));
    }
    ASSERT_EQ(arrays.r[h], wanted) << name << " " << h;
    ASSERT_EQ(arrays.g[h], before[h]) << name << " there is no green light";
  }
}

template <class R>
void expect_origins(const Services<R>& services, std::string_view name) {
  LitHits<R> hits;
  const Scratch<R>& s = hits.s();
  services.hits->start_shadow_rays(kHitSize, hits.s());
  for (std::size_t h = 0; h < kHitSize; ++h)
    ASSERT_EQ(s.soy[h],
              static_cast<R>(static_cast<double>(s.py[h]) +
                             static_cast<double>(s.ny[h]) * static_cast<double>(s.offset[h])))
        << name;
}

template <class R>
void expect_brought_back(const Services<R>& services, bool clamps, bool dims,
                         std::string_view name) {
  LitHits<R> hits;
  Level<R>& level = hits.level();
  std::vector<R> clear(kHitSize + kArrayPadding), left(kHitSize + kArrayPadding);
  for (std::size_t h = 0; h < kHitSize; ++h)
    clear[h] = h % 3 == 0 ? R(1) : hits.any(), left[h] = hits.any();
  const R *none = nullptr, *some = left.data();
  const HitArrays<R>& of = level.hits;
  services.hits->bring_back({of.r,
                             of.g,
                             of.b,
                             {dims ? some : none, dims ? some : none, dims ? some : none},
                             dims ? clear.data() : none,
                             {R(0.25), R(0.5), R(0.75)}},
                            clamps, level);
  for (std::size_t h = 0; h < kHitSize; ++h) {
    R wanted = of.b[h];
    if (clamps) wanted = wanted > R(0) ? (wanted < R(1) ? wanted : R(1)) : R(0);
    if (dims) wanted *= left[h];
    if (dims && clear[h] != R(1)) wanted = wanted * clear[h] + R(0.75) * (R(1) - clear[h]);
    ASSERT_EQ(level.rays.b[level.hits.ray[h]], wanted) << name << " " << h;
  }
}

template <class R>
void expect_exponentials(const Services<R>& services, std::string_view name) {
  Random random{3};
  std::vector<double> x(kHitSize + kArrayPadding), powers(kHitSize + kArrayPadding);
  for (std::size_t i = 0; i < kHitSize; ++i)
    x[i] = i % 9 == 0 ? 0 : -std::pow(10, 8 * random.unit() - 5);
  bool unknown = false;
  EXPECT_TRUE(services.hits->find_exponentials(kHitSize, x.data(), powers.data())) << name;
  for (std::size_t i = 0; i < kHitSize; ++i) {
    unknown = unknown || powers[i] < 0;
    ASSERT_EQ(powers[i], x[i] < -700 ? -1 : elementary::exp(x[i])) << name << " " << x[i];
  }
  EXPECT_TRUE(unknown) << name;
  x.assign(x.size(), -1);
  EXPECT_FALSE(services.hits->find_exponentials(kHitSize, x.data(), powers.data())) << name;
}

/// Bends and children of hits in any order, by the formulas of single hits.
template <class R>
void expect_children(const Services<R>& services, bool recorded, std::string_view name) {
  LitHits<R> hits(recorded);
  Scratch<R>& s = hits.s();
  ASSERT_EQ(s.smooth_x != nullptr, recorded);
  using general::unit;
  const auto wide = [](const R* x, const R* y, const R* z, std::size_t h) {
    return V3<double>{double(x[h]), double(y[h]), double(z[h])};
  };
  constexpr std::size_t kRoom = kHitSize + kArrayPadding;
  std::vector<std::int32_t> hit(kRoom);
  std::vector<double> n1(kRoom, 1), n2(kRoom, 1), by(kRoom), ratio(kRoom), quarter_d(kRoom),
      fresnel(kRoom);
  constexpr double kIndices[] = {1, 1.33, 1.5, 2.4};
  for (std::size_t h = 0; h < kHitSize; ++h) {
    // Of unit length, or as textures leave them; some look past the viewer, some along the surface.
    if (h % 4 != 0) {
      const V3<double> n = unit(wide(s.nx, s.ny, s.nz, h)), v = unit(wide(s.vx, s.vy, s.vz, h));
      s.nx[h] = R(n.x), s.ny[h] = R(n.y), s.nz[h] = R(n.z);
      s.vx[h] = R(v.x), s.vy[h] = R(v.y), s.vz[h] = R(v.z);
    }
    if (h % 17 == 0) s.nx[h] = R(1), s.ny[h] = s.nz[h] = s.vx[h] = R(0), s.vy[h] = R(1);
    s.mirror_side[h] = h % 5 == 0 ? R(-1) : R(1);
    if (s.smooth_x != nullptr)
      s.smooth_x[h] = s.nz[h], s.smooth_y[h] = s.nx[h], s.smooth_z[h] = s.ny[h];
    hit[h] = static_cast<std::int32_t>(h * 19 % kHitSize);
    n1[h] = kIndices[h % 4], n2[h] = kIndices[h / 4 % 4], by[h] = static_cast<double>(h % 3);
  }
  services.hits->find_bends(kHitSize, s,
                            {hit.data(), n1.data(), n2.data(), by.data(), ratio.data(),
                             quarter_d.data(), fresnel.data()});
  std::size_t total = 0, in = 0;
  for (std::size_t i = 0; i < kHitSize; ++i) {
    const auto h = static_cast<std::size_t>(hit[i]);
    const double cosine = std::fabs(dot(wide(s.vx, s.vy, s.vz, h), wide(s.nx, s.ny, s.nz, h)));
    const double eta = n1[i] / n2[i], sine2 = eta * eta * (1 - cosine * cosine);
    ASSERT_EQ(ratio[i], eta) << name;
    ASSERT_EQ(quarter_d[i], eta * eta * cosine * cosine - eta * eta + 1) << name;
    double wanted = 0;
    const double root = sine2 < 1 ? std::sqrt(1 - sine2) : 0;
    if (by[i] == static_cast<double>(Fresnel::exact)) {
      const double across = (eta * cosine - root) / (eta * cosine + root);
      const double along = (cosine - eta * root) / (cosine + eta * root);
      wanted = sine2 < 1 ? 0.5 * (across * across + along * along) : 1;
    } else if (by[i] == static_cast<double>(Fresnel::schlick)) {
      const double straight = (eta - 1) / (eta + 1), f0 = straight * straight;
      const double m = 1 - (eta > 1 ? root : cosine), m2 = m * m;
      wanted = eta > 1 && !(sine2 < 1) ? 1 : f0 + (1 - f0) * (m2 * m2 * m);
    }
    ASSERT_EQ(fresnel[i], wanted) << name << " " << i << ": " << cosine << " " << eta;
    total += !(quarter_d[i] >= 0), in += quarter_d[i] >= 0;
    if (i % 7 == 0) quarter_d[i] = -1;  // a reflected child
  }
  EXPECT_GT(total, kHitSize / 20);
  EXPECT_GT(in, kHitSize / 2);
  const RayArrays<R>& rays = hits.level().rays;
  const std::size_t n = kHitSize / 2;
  services.hits->aim_children(n, s, {hit.data(), ratio.data(), quarter_d.data()}, 3,
                              hits.level().rays);
  for (std::size_t i = 0; i < n; ++i) {
    const auto h = static_cast<std::size_t>(hit[i]);
    const V3<double> normal = wide(s.nx, s.ny, s.nz, h), view = wide(s.vx, s.vy, s.vz, h);
    const double seen = dot(view, normal);
    const bool enters = quarter_d[i] >= 0;
    const V3<double> turned = seen < 0 ? -normal : normal;
    const V3<double> way =
        unit(enters ? -(turned * (std::sqrt(quarter_d[i]) - ratio[i] * std::fabs(seen))) -
                          view * ratio[i]
                    : normal * (2 * seen) - view);
    const V3<double> along =
        s.smooth_x != nullptr ? wide(s.smooth_x, s.smooth_y, s.smooth_z, h) : normal;
    const double side = enters ? -1 : static_cast<double>(s.mirror_side[h]);
    const V3<double> from =
        wide(s.px, s.py, s.pz, h) + along * (side * static_cast<double>(s.offset[h]));
    ASSERT_EQ(rays.dx[i + 3], R(way.x)) << name << " " << i;
    ASSERT_EQ(rays.dy[i + 3], R(way.y)) << name << " " << i;
    ASSERT_EQ(rays.dz[i + 3], R(way.z)) << name << " " << i;
    ASSERT_EQ(rays.ox[i + 3], R(from.x)) << name << " " << i;
    ASSERT_EQ(rays.oy[i + 3], R(from.y)) << name << " " << i;
    ASSERT_EQ(rays.oz[i + 3], R(from.z)) << name << " " << i;
  }
}

/// Calls it with the services of all instruction sets, and their names.
void with_all(const auto& function) {
  for (const Isa isa : available_isas()) function(*kernel_of(isa).services, name_of(isa));
  function(isa_oracle::kServices, std::string_view("oracle"));
}

TEST(HitServices, AddLightAsHitByHit) {
  with_all([](const auto& services, std::string_view name) {
    expect_light(services, Terms{}, name);
    expect_light(services, Terms{.diffuse = false}, name);
    expect_light(services, Terms{.specular = false}, name);
  });
}

TEST(HitServices, StartShadowRaysInDouble) {
  with_all([](const auto& services, std::string_view name) { expect_origins(services, name); });
}

TEST(HitServices, FindChildrenAsHitByHit) {
  with_all([](const auto& services, std::string_view name) {
    for (const bool recorded : {false, true}) expect_children(services, recorded, name);
  });
}

TEST(HitServices, HaveTheBitsOfExp) {
  with_all(
      [](const auto& services, std::string_view name) { expect_exponentials(services, name); });
}

TEST(HitServices, BringBackWhatMediaAndFogLeave) {
  with_all([](const auto& services, std::string_view name) {
    for (const bool clamps : {false, true})
      for (const bool dims : {false, true}) expect_brought_back(services, clamps, dims, name);
  });
}

}  // namespace
}  // namespace zraka
