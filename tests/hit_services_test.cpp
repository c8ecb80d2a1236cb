// SPDX-License-Identifier: Apache-2.0
// What instruction sets compute at all hits of a batch: the bits that come of it hit by hit.
#include "engine/hit_services.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <string_view>
#include <vector>

#include "core/random.hpp"
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
  WorkspaceMemory<R> memory{WorkspaceNeeds{.batch = kHitCount, .max_depth = 0, .general = true}};
  std::vector<R> rows;
  std::vector<double> numbers = std::vector<double>(5 * (kHitSize + kArrayPadding));
  ArrivingLight arriving{};
  V3<R> color{R(0.7), R(0), R(0.3)};

  Scratch<R>& s() { return memory.workspace().scratch; }
  Level<R>& level() { return memory.workspace().levels[0]; }
  R any() { return static_cast<R>(2 * random.unit() - 1); }

  LitHits() {
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
