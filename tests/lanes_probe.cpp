// SPDX-License-Identifier: Apache-2.0
#include "lanes_probe.hpp"

#include <algorithm>

#include "accel/traverse.hpp"
#include "math/power.hpp"
#include "shapes/shapes.hpp"

namespace zraka::ZRAKA_ISA {
namespace {

#ifdef ZRAKA_WIDE
using L = WideLanes;
#else
using L = ScalarLanes<double>;
#endif
using F = L::F;

/// The numbers stride·i + offset of the lanes from `first`, those past `count` 0.
F pick(const float* from, std::size_t stride, std::size_t offset, std::size_t first,
       std::size_t count) {
  L::Real lanes[L::kWidth] = {};
  for (std::size_t i = 0; i < L::kWidth && first + i < count; ++i)
    lanes[i] = from[stride * (first + i) + offset];
  return L::load(lanes);
}

void put(F value, float* out, std::size_t first, std::size_t count) {
  L::Real lanes[L::kWidth];
  L::store(value, lanes);
  for (std::size_t i = 0; i < L::kWidth && first + i < count; ++i)
    out[first + i] = static_cast<float>(lanes[i]);
}

void power_of(const float* x, const float* n, float* out, std::size_t count) {
  for (std::size_t i = 0; i < count; i += L::kWidth)
    put(power(pick(x, 1, 0, i, count), pick(n, 1, 0, i, count)), out, i, count);
}

void sphere(const float* origins, const float* directions, const float* spheres, float* t,
            std::size_t count) {
  constexpr std::size_t kReals = ShapeTraits<Sphere>::kReals;
  std::vector<float> frozen;
  for (std::size_t i = 0; i < count; ++i) {
    const float* s = spheres + 4 * i;
    double numbers[kReals];
    ShapeTraits<Sphere>::freeze({{s[0], s[1], s[2]}, s[3]}, Frame{}, numbers);
    for (const double number : numbers) frozen.push_back(static_cast<float>(number));
  }
  for (std::size_t i = 0; i < count; i += L::kWidth) {
    const auto vector = [&](const float* from) {
      return V3<F>{pick(from, 3, 0, i, count), pick(from, 3, 1, i, count),
                   pick(from, 3, 2, i, count)};
    };
    F shape[kReals];
    for (std::size_t k = 0; k < kReals; ++k) shape[k] = pick(frozen.data(), kReals, k, i, count);
    put(ShapeLanes<Sphere, L>::intersect(shape, vector(origins), vector(directions)), t, i, count);
  }
}

[[maybe_unused]] const FrozenScene<float>* own(const FrozenScene<float>* f,
                                               const FrozenScene<double>*, float) {
  return f;
}
[[maybe_unused]] const FrozenScene<double>* own(const FrozenScene<float>*,
                                                const FrozenScene<double>* d, double) {
  return d;
}

void trace(const FrozenScene<float>* floats, const FrozenScene<double>* doubles,
           const ProbeRay* rays, ProbeHit* hits, std::size_t count) {
  const FrozenScene<L::Real>* scene = own(floats, doubles, L::Real());
  const auto load = [&](std::size_t first) {
    L::Real o[3][L::kWidth] = {}, d[3][L::kWidth] = {}, limit[L::kWidth] = {};
    for (std::size_t i = 0; i < L::kWidth && first + i < count; ++i) {
      for (int k = 0; k < 3; ++k) {
        o[k][i] = static_cast<L::Real>(rays[first + i].origin[k]);
        d[k][i] = static_cast<L::Real>(rays[first + i].direction[k]);
      }
      limit[i] = static_cast<L::Real>(rays[first + i].limit);
    }
    return RayLanes<L>{{L::load(o[0]), L::load(o[1]), L::load(o[2])},
                       {L::load(d[0]), L::load(d[1]), L::load(d[2])},
                       L::load(limit),
                       L::I(-1)};
  };
  for (std::size_t first = 0; first < count; first += RayGroup<L>::kRays) {
    RayGroup<L> feelers(first, count, load), group(first, count, load);
    LastBlocker last;
    const std::uint32_t blocked = find_blocked<L>(*scene, last, feelers);
    find_nearest<L>(*scene, group);
    for (std::size_t i = 0; i < RayGroup<L>::kRays && first + i < count; ++i) {
      L::Real t[L::kWidth];
      std::int32_t slot[L::kWidth];
      const std::size_t lane = i % L::kWidth;
      L::store(group.ray[i / L::kWidth].t, t);
      L::store(group.ray[i / L::kWidth].slot, slot);
      hits[first + i] = {static_cast<double>(t[lane]),
                         slot[lane] < 0 ? -1 : id_of(*scene, slot[lane]), (blocked >> i & 1) != 0};
    }
  }
}

}  // namespace

LanesProbe probe();
LanesProbe probe() {
  return {{}, L::kWidth, power_of, sphere, trace};
}

}  // namespace zraka::ZRAKA_ISA
