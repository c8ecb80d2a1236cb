// SPDX-License-Identifier: Apache-2.0
#include "lanes_probe.hpp"

#include <algorithm>
#include <cmath>
#include <deque>
#include <random>
#include <utility>

#include "accel/point_rays.hpp"
#include "accel/traverse.hpp"
#include "engine/hits.hpp"
#include "math/elementary_power.hpp"
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

void double_power_of(const double* x, const double* y, double* out, std::size_t count) {
  using D = DoublesOf<L>;
  for (std::size_t first = 0; first < count; first += D::kWidth) {
    double base[D::kWidth], exponent[D::kWidth], power[D::kWidth];
    for (std::size_t i = 0; i < D::kWidth; ++i)
      base[i] = x[std::min(first + i, count - 1)], exponent[i] = y[std::min(first + i, count - 1)];
    D::store(elementary_power(D::load(base), D::load(exponent), typename D::F(-1)), power);
    std::copy_n(power, std::min(D::kWidth, count - first), out + first);
  }
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

/// Rays past, onto, out of and into spheres, by hairs, too: limits end before, behind, and by a few
/// units in the last place at the hits.
std::size_t wrong_blocks(unsigned seed) {
  using R = L::Real;
  std::mt19937 random(seed);
  std::uniform_real_distribution<double> uniform(-1, 1);
  std::uniform_int_distribution<int> kind(0, 3), exponent(0, 24);
  const auto tiny = [&] { return uniform(random) * std::ldexp(1.0, -exponent(random)); };
  std::size_t wrong = 0;
  for (int round = 0; round < 4000; ++round) {
    R numbers[4][L::kWidth], from[3][L::kWidth], way[3][L::kWidth];
    for (std::size_t i = 0; i < L::kWidth; ++i) {
      const double r = std::fabs(tiny()) + 1e-6, away = kind(random) * r * std::exp(2 * tiny());
      double d[3], side[3];
      for (int k = 0; k < 3; ++k) d[k] = uniform(random), side[k] = uniform(random);
      const double length = std::sqrt(d[0] * d[0] + d[1] * d[1] + d[2] * d[2]);
      const double along = (side[0] * d[0] + side[1] * d[1] + side[2] * d[2]) / (length * length);
      double across = 0;
      for (int k = 0; k < 3; ++k) side[k] -= along * d[k], across += side[k] * side[k];
      // Anywhere, or a hair beside where it grazes.
      const double beside = kind(random) == 0 ? std::fabs(uniform(random)) : 1 + tiny();
      for (std::size_t k = 0; k < 3; ++k) {
        numbers[k][i] = static_cast<R>(uniform(random));
        way[k][i] = static_cast<R>(d[k] / length);
        from[k][i] = static_cast<R>(static_cast<double>(numbers[k][i]) - d[k] / length * away +
                                    side[k] / std::sqrt(across) * r * beside);
      }
      numbers[3][i] = static_cast<R>(r);
    }
    F shape[4];
    for (std::size_t k = 0; k < 4; ++k) shape[k] = L::load(numbers[k]);
    const V3<F> origin{L::load(from[0]), L::load(from[1]), L::load(from[2])};
    const V3<F> direction{L::load(way[0]), L::load(way[1]), L::load(way[2])};
    const F hit = ShapeLanes<Sphere, L>::intersect(shape, origin, direction);
    // From there, and from where that is.
    for (const F& start : {F(0), select(hit > F(0), hit, F(0))}) {
      const V3<F> here = origin + direction * start;
      const F t = ShapeLanes<Sphere, L>::intersect(shape, here, direction);
      for (const F& limit : {F(0x1p+100f), t, t * F(1 + 0x1p-23f), t * F(0.999f), F(-1)}) {
        const auto expected = both(t > F(0), t < limit);
        const auto found = blocks<Sphere, L>(shape, here, direction, limit);
        wrong += count(either(but_not(expected, found), but_not(found, expected)));
      }
    }
  }
  return wrong;
}

void gather_four(const float* from, const std::int32_t* at, float (*out)[4], std::size_t count) {
  alignas(16) L::Real numbers[256];
  for (std::size_t i = 0; i < std::size(numbers); ++i) numbers[i] = static_cast<L::Real>(from[i]);
  for (std::size_t i = 0; i < count; i += L::kWidth) {
    std::int32_t places[L::kWidth] = {};
    for (std::size_t lane = 0; lane < L::kWidth && i + lane < count; ++lane)
      places[lane] = at[i + lane];
    F four[4];
    L::gather_four(numbers, L::load(places), four);
    for (std::size_t k = 0; k < 4; ++k) {
      L::Real lanes[L::kWidth];
      L::store(four[k], lanes);
      for (std::size_t lane = 0; lane < L::kWidth && i + lane < count; ++lane)
        out[i + lane][k] = static_cast<float>(lanes[lane]);
    }
  }
}

std::size_t wrong_pairs(unsigned seed) {
  using Pair = std::pair<std::int32_t, std::int32_t>;  // ray, shape
  std::mt19937 random(seed);
  const auto below = [&](std::size_t n) {
    return std::uniform_int_distribution<std::size_t>(0, n - 1)(random);
  };
  constexpr auto kAll = static_cast<std::uint32_t>((std::uint64_t{1} << L::kWidth) - 1);
  PairQueue<L> queue;
  std::deque<Pair> want;
  std::size_t wrong = 0;
  const auto take = [&](bool all) {
    while (queue.ready(all)) {
      const auto taken = queue.take();
      for (std::size_t i = 0; i < taken.count; ++i) {
        wrong += want.empty() || want.front() != Pair{taken.ray[i], taken.shape[i]} ? 1 : 0;
        if (!want.empty()) want.pop_front();
      }
    }
    wrong += want.size() >= (all ? 1 : L::kWidth) ? 1 : 0;
  };
  std::int32_t shape = 0;  // of lane i: this and 2i
  for (int round = 0; round < 2000; ++round, shape += 100) {
    const bool full = round % 7 == 1;  // as many pairs as there ever are
    const std::size_t most = std::min(FewRays<L>::kMost, RayGroup<L>::kRays);
    const std::size_t few = full ? most : 1 + below(most);
    FewRays<L> rays;
    while (rays.count < few) {
      rays.ray[rays.count] = static_cast<std::int32_t>(below(RayGroup<L>::kRays));
      rays.hit[rays.count++] =
          full ? kAll : static_cast<std::uint32_t>(below(std::size_t{1} << L::kWidth));
    }
    if (round % 2 == 0 && !full) {  // a leaf
      std::uint32_t bits = 0;
      for (std::size_t r = 0; r < rays.count; ++r) bits |= 1u << rays.ray[r];
      const auto count = static_cast<std::int32_t>(1 + below(5));
      queue.add(bits, shape, count);
      for (std::int32_t i = 0; i < count; ++i)
        for (std::int32_t r = 0; r < static_cast<std::int32_t>(RayGroup<L>::kRays); ++r)
          if ((bits >> r & 1) != 0) want.emplace_back(r, shape + i);
    } else {  // a node's leaves of one shape and of two, in as many steps as lanes need
      for (std::size_t k = 0; k < kNodeWidth; k += L::kWidth) {
        const auto two =
            full ? kAll : static_cast<std::uint32_t>(below(std::size_t{1} << L::kWidth));
        const auto one = two | static_cast<std::uint32_t>(below(std::size_t{1} << L::kWidth));
        for (std::int32_t i = 0; i < kMostInSmallLeaf; ++i) {
          const std::uint32_t wanted = i == 0 ? one : two;
          std::int32_t shapes[L::kWidth];
          for (std::size_t lane = 0; lane < L::kWidth; ++lane)
            shapes[lane] = shape + 2 * static_cast<std::int32_t>(k + lane) + i;
          queue.add(rays, wanted, L::load(shapes));
          for (std::size_t r = 0; r < rays.count; ++r)
            for (std::size_t lane = 0; lane < L::kWidth; ++lane)
              if ((rays.hit[r] & wanted) >> lane & 1) want.emplace_back(rays.ray[r], shapes[lane]);
        }
      }
    }
    wrong += queue.fits() ? 0 : 1;
    take(round % 50 == 0);
  }
  take(true);
  return wrong;
}

bool stack_fits() {
  UnorderedStack<L> stack;
  BundleEntry<L::Real> ahead{0, 0, 0, 1};  // a child's number is its depth
  for (int step = 0; step < 10000; ++step) {
    const BundleEntry<L::Real> entry = ahead;
    ahead = stack.pop_if_any();
    if (entry.rays == 0 || entry.child + 1 == kMaxNodeDepth) continue;
    for (int i = 0; i < kNodeWidth; ++i) {
      if (!stack.fits()) return false;
      stack.push({0, entry.child + 1, 0, 1});
    }
  }
  return true;
}

[[maybe_unused]] const FrozenScene<float>* own(const FrozenScene<float>* f,
                                               const FrozenScene<double>*, float) {
  return f;
}
[[maybe_unused]] const FrozenScene<double>* own(const FrozenScene<float>*,
                                                const FrozenScene<double>* d, double) {
  return d;
}

/// The rays from `first` on, those past `count` zeros.
RayLanes<L> load_rays(const ProbeRay* rays, std::size_t first, std::size_t count) {
  L::Real o[3][L::kWidth] = {}, d[3][L::kWidth] = {}, limit[L::kWidth] = {};
  for (std::size_t i = 0; i < L::kWidth && first + i < count; ++i) {
    for (int k = 0; k < 3; ++k) {
      o[k][i] = static_cast<L::Real>(rays[first + i].origin[k]);
      d[k][i] = static_cast<L::Real>(rays[first + i].direction[k]);
    }
    limit[i] = static_cast<L::Real>(rays[first + i].limit);
  }
  return {{L::load(o[0]), L::load(o[1]), L::load(o[2])},
          {L::load(d[0]), L::load(d[1]), L::load(d[2])},
          L::load(limit),
          L::I(-1)};
}

void trace(const FrozenScene<float>* floats, const FrozenScene<double>* doubles,
           const ProbeRay* rays, ProbeHit* hits, std::size_t count) {
  const FrozenScene<L::Real>* scene = own(floats, doubles, L::Real());
  const auto load = [&](std::size_t first) { return load_rays(rays, first, count); };
  for (std::size_t first = 0; first < count; first += RayGroup<L>::kRays) {
    RayGroup<L> shadow_rays(first, count, load), group(first, count, load);
    LastBlocker last;
    const std::uint32_t blocked = find_blocked<L>(*scene, last, shadow_rays);
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

std::uint64_t from_point(const FrozenScene<float>* floats, const FrozenScene<double>* doubles,
                         const ProbeRay* rays, std::size_t count) {
  using R = L::Real;
  R d[3][PointRays<L>::kMost + 16] = {};
  for (std::size_t i = 0; i < count; ++i)
    for (int k = 0; k < 3; ++k) d[k][i] = static_cast<R>(rays[i].direction[k]);
  const V3<R> origin{static_cast<R>(rays->origin[0]), static_cast<R>(rays->origin[1]),
                     static_cast<R>(rays->origin[2])};
  const PointRays<L> all(*own(floats, doubles, R()), origin, static_cast<R>(rays->limit), d[0], d[1], d[2], count);
  return blocked_from_point<L>(*own(floats, doubles, R()), all);
}

void surfaces(const FrozenScene<float>* floats, const FrozenScene<double>* doubles,
              const ProbeRay* rays, ProbeSurface* out, std::size_t count) {
  const FrozenScene<L::Real>& scene = *own(floats, doubles, L::Real());
  const auto each = [&](std::size_t first, const F& value, const auto& take) {
    L::Real lanes[L::kWidth];
    L::store(value, lanes);
    for (std::size_t i = 0; i < L::kWidth && first + i < count; ++i)
      take(out[first + i], static_cast<double>(lanes[i]));
  };
  const auto store = [&](std::size_t first, const V3<F>& v, double(ProbeSurface::*to)[3]) {
    each(first, v.x, [&](ProbeSurface& s, double x) { (s.*to)[0] = x; });
    each(first, v.y, [&](ProbeSurface& s, double y) { (s.*to)[1] = y; });
    each(first, v.z, [&](ProbeSurface& s, double z) { (s.*to)[2] = z; });
  };
  const auto load = [&](std::size_t first) { return load_rays(rays, first, count); };
  for (std::size_t begin = 0; begin < count; begin += RayGroup<L>::kRays) {
    RayGroup<L> group(begin, count, load);
    find_nearest<L>(scene, group);
    for (std::size_t r = 0; r < kRegisters<L>; ++r) {
      const std::size_t first = begin + r * L::kWidth;
      const RayLanes<L>& ray = group.ray[r];
      const SurfacePoint<L> surface =
          surfaces_at<L>(scene, ray.slot, ray.origin, ray.direction, ray.t).at;
      std::int32_t slot[L::kWidth];
      L::store(ray.slot, slot);
      for (std::size_t i = 0; i < L::kWidth && first + i < count; ++i)
        out[first + i].id = slot[i] < 0 ? -1 : id_of(scene, slot[i]);
      store(first, surface.point, &ProbeSurface::point);
      store(first, surface.normal, &ProbeSurface::normal);
      each(first, ray.t, [](ProbeSurface& s, double t) { s.t = t; });
      each(first, surface.offset, [](ProbeSurface& s, double offset) { s.offset = offset; });
      each(first, select(surface.inside, F(1), F(0)),
           [](ProbeSurface& s, double inside) { s.inside = inside > 0; });
    }
  }
}

}  // namespace

LanesProbe probe();
LanesProbe probe() {
  return {{},          L::kWidth,   power_of,   double_power_of, sphere,  wrong_blocks,
          gather_four, wrong_pairs, stack_fits, trace, from_point, surfaces};
}

}  // namespace zraka::ZRAKA_ISA
