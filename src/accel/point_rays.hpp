// SPDX-License-Identifier: Apache-2.0
// Rays of one point in all directions: which of them are blocked. Spheres are asked most quickly.
#pragma once

#include <cmath>

#include "accel/bundle.hpp"
#include "accel/plane_rays.hpp"
#include "accel/shadowless.hpp"

namespace zraka::ZRAKA_ISA {

/// A bit each, for lanes.
struct SingleBits {
  alignas(64) std::int32_t of[32];
  constexpr SingleBits() : of{} {
    for (std::uint32_t i = 0; i < 32; ++i) of[i] = static_cast<std::int32_t>(1u << i);
  }
};
inline constexpr SingleBits kSingleBits{};

/// Rays that begin in one point and look equally far. What they ask of a box or of a sphere is
/// found for that point first, for all of them.
template <class L>
class PointRays {
 public:
  using R = typename L::Real;
  using F = typename L::F;
  using I = typename L::I;
  /// A set of rays, a bit each.
  using Rays = std::uint64_t;
  static constexpr std::size_t kMost = 64;

  /// From the origin along the first `count` directions, kMost at most, with room for reads of a
  /// register past them; these have to stay where they are.
  ZRAKA_INLINE PointRays(const FrozenScene<R>& scene, const V3<R>& origin, R limit, const R* dx,
                         const R* dy, const R* dz, std::size_t count)
      : origin_{F(origin.x), F(origin.y), F(origin.z)},
        limit_(limit),
        limited_(may_be_beyond(limit, scene.reach, origin)),
        direction_{dx, dy, dz},
        all_(0) {
    for (std::size_t i = 0; i < count; i += L::kWidth) {
      const F x = L::load(dx + i), y = L::load(dy + i), z = L::load(dz + i);
      const F inverse[3] = {slab_inverse(x), slab_inverse(y), slab_inverse(z)};
      for (std::size_t axis = 0; axis < 3; ++axis) {
        L::store(inverse[axis], inverse_[axis] + i);
        L::store(select(inverse[axis] < F(0), I(2 * kNodeWidth), I(0)), near_[axis] + i);
      }
      // What overflows on its way becomes no number, and hits nothing.
      const F zero = (origin_.x + origin_.y + origin_.z + x + y + z) * F(0);
      all_ |= Rays{bits(both(zero == F(0), L::first(count - i)))} << i;
    }
  }

  /// All that are rays.
  ZRAKA_INLINE Rays all() const { return all_; }

  /// A child that some rays have still to visit. Of a node that the origin is in: which of its
  /// children they have visited, or that it is not known which of them the origin is in, too.
  struct Entry {
    std::int32_t child, leaf;
    std::uint32_t visited;
    Rays rays;
  };
  static constexpr std::uint32_t kAround = 1u << 31;

  /// Puts those of a node's children on a stack that the origin is in, and below them the node for
  /// the others. Returns the new top.
  ZRAKA_INLINE Entry* push_around(std::int32_t index, const Node& node, Rays rays,
                                  Entry* top) const {
    std::uint32_t around = 0;
    for (std::size_t k = 0; k < kNodeWidth; k += L::kWidth) {
      const auto within = [&](const float* lower, const float* upper, F o) {
        return both(L::load_box(lower + k) <= o, o <= L::load_box(upper + k));
      };
      around |= bits(both(both(within(node.lower_x, node.upper_x, origin_.x),
                               within(node.lower_y, node.upper_y, origin_.y)),
                          within(node.lower_z, node.upper_z, origin_.z)))
                << k;
    }
    *top++ = {index, 0, around, rays};
    for (; around != 0; around &= around - 1) {
      const auto lane = static_cast<std::size_t>(__builtin_ctz(around));
      *top++ = {node.child[lane], node.leaf[lane], kAround, rays};
    }
    return top;
  }

  /// Puts the children that some of the rays hit on a stack, the nearest on top, and returns the
  /// new top.
  ZRAKA_INLINE Entry* push_children(const Node& node, std::uint32_t visited, Rays rays,
                                    Entry* top) const {
    alignas(64) Sides sides;
    alignas(64) std::int32_t keys[kNodeWidth];  // distances, and lanes in the lowest bits
    alignas(64) std::int32_t through[2][kNodeWidth];
    std::uint32_t wanted = 0;
    for (std::size_t k = 0; k < kNodeWidth; k += L::kWidth) {
      const V3<F> away{put_sides(node.lower_x, node.upper_x, origin_.x, k, sides[0]),
                       put_sides(node.lower_y, node.upper_y, origin_.y, k, sides[1]),
                       put_sides(node.lower_z, node.upper_z, origin_.z, k, sides[2])};
      const F square = dot(away, away);
      L::store(keys_of(square, k), keys + k);
      wanted |= bits(square <= F(limit_ * limit_ * R(1.01))) << k;
    }
    // A missing child's box is empty only as long as its sides are not turned round.
    wanted &= node.children & ~visited & hit_boxes(sides, rays, through);
    for (std::uint32_t left = wanted; left != 0; left &= left - 1) {
      const auto lane = static_cast<std::size_t>(__builtin_ctz(left));
      // Above all that are farther, without a branch.
      const I mine(keys[lane]);
      std::uint32_t farther = 0;
      for (std::size_t k = 0; k < kNodeWidth; k += L::kWidth)
        farther |= bits(L::load(keys + k) > mine) << k;
      top[__builtin_popcount(wanted & farther)] = {
          node.child[lane], node.leaf[lane], 0,
          Rays{static_cast<std::uint32_t>(through[0][lane])} |
              Rays{static_cast<std::uint32_t>(through[1][lane])} << 32};
    }
    return top + __builtin_popcount(wanted);
  }

  /// Which of the rays the spheres [first, first + count) block, and perhaps what some that follow
  /// these block besides: these are in the scene, too.
  ZRAKA_INLINE Rays blocked_by(const FrozenScene<R>& scene, std::int32_t first, std::int32_t count,
                               Rays rays) const {
    constexpr auto kWidth = static_cast<std::int32_t>(L::kWidth);
    if (scene.shadowless != nullptr) return blocked_exactly(scene, first, count, rays);
    Rays blocked = 0;
    std::int32_t k = 0;
    if constexpr (kWidth < kNodeWidth)
      for (; count - k > kWidth; k += 2 * kWidth)
        blocked |= blocked_by_registers<2>(scene, first + k, count - k, rays & ~blocked);
    if (k < count) blocked |= blocked_by_registers<1>(scene, first + k, count - k, rays & ~blocked);
    return blocked;
  }

  /// Which of the rays shapes of any kind block, those of a leaf from number `first` on.
  __attribute__((noinline)) Rays blocked_by_shapes(const FrozenScene<R>& scene, std::int32_t leaf,
                                                   std::int32_t first, Rays rays) const {
    Rays blocked = 0;
    with_kind(scene, leaf_kind(leaf), [&]<class Shape>(const FrozenShapes<R, Shape>& shapes) {
      if constexpr (!std::is_same_v<Shape, Body>)
        blocked = blocked_in_lanes(scene, shapes, first, leaf_count(leaf), rays);
    });
    return blocked;
  }

  /// Which of all rays the bodies block that have no bounds.
  Rays blocked_by_unbounded(const FrozenScene<R>& scene) const {
    const auto& bodies = scene.bodies;
    Rays blocked = 0;
    if (bodies.bounded == bodies.count) return blocked;
    for (std::size_t i = 0; i < kMost && all_ >> i != 0; i += L::kWidth) {
      const RayLanes<L> ray{origin_,
                            {L::load(direction_[0] + i), L::load(direction_[1] + i),
                             L::load(direction_[2] + i)},
                            F(limit_),
                            I(-1)};
      auto by_any = L::first(0);
      for (std::int32_t k = bodies.bounded; k < bodies.count; ++k) {
        if (is_shadowless(scene, bodies, k)) continue;
        const F t = intersect_unbounded<true, L>(bodies, k, ray);
        by_any = either(by_any, both(t > F(0), t < ray.t));
      }
      blocked |= Rays{bits(by_any)} << i;
    }
    return blocked & all_;
  }

 private:
  /// Of a node's boxes along each axis, seen from the origin: near and far sides of rays that go
  /// up, then of those that go down. What is near is not behind the origin.
  using Sides = R[3][4 * kNodeWidth];

  /// Puts the sides of the boxes from number k on along one axis; returns how far these are away.
  static ZRAKA_INLINE F put_sides(const float* lower, const float* upper, F origin, std::size_t k,
                                  R (&sides)[4 * kNodeWidth]) {
    const F low = L::load_box(lower + k) - origin, high = L::load_box(upper + k) - origin;
    const F ahead = max(low, F(0)), behind = min(high, F(0));
    L::store(ahead, sides + k), L::store(high, sides + kNodeWidth + k);
    L::store(behind, sides + 2 * kNodeWidth + k), L::store(low, sides + 3 * kNodeWidth + k);
    return max(ahead, -behind);
  }

  /// Whether something in a scene of that reach may be beyond the limit.
  static ZRAKA_INLINE bool may_be_beyond(R limit, R reach, const V3<R>& origin) {
    for (const R o : {origin.x, origin.y, origin.z}) reach = std::fmax(reach, std::fabs(o));
    return !(limit * limit * R(0.4) > reach * reach * R(16));
  }

  ZRAKA_INLINE V3<F> direction(std::size_t i) const {
    return {F(direction_[0][i]), F(direction_[1][i]), F(direction_[2][i])};
  }

  /// By box: which of the rays hit it, the first 32 and the others. Returns which boxes any hit.
  ZRAKA_INLINE std::uint32_t hit_boxes(const Sides& sides, Rays rays,
                                       std::int32_t (&through)[2][kNodeWidth]) const {
    constexpr std::size_t kRegistersOfNode = kNodeWidth / L::kWidth;
    std::uint32_t hit_by_none = 0xFFFF;
    for (std::size_t half = 0; half < 2; ++half) {
      I hit[kRegistersOfNode];
      for (I& by : hit) by = I(0);
      for (auto left = static_cast<std::uint32_t>(rays >> (half * 32)); left != 0;
           left &= left - 1) {
        const auto bit = static_cast<std::size_t>(__builtin_ctz(left)), i = half * 32 + bit;
        const F x(inverse_[0][i]), y(inverse_[1][i]), z(inverse_[2][i]);
        const I one(kSingleBits.of[bit]);
        const R *const nx = sides[0] + near_[0][i], *const ny = sides[1] + near_[1][i],
                       *const nz = sides[2] + near_[2][i];
        for (std::size_t r = 0; r < kRegistersOfNode; ++r) {
          const std::size_t k = r * L::kWidth, far = kNodeWidth + k;
          const F in = max(max(L::load(nx + k) * x, L::load(ny + k) * y), L::load(nz + k) * z);
          const F out =
              min(min(L::load(nx + far) * x, L::load(ny + far) * y), L::load(nz + far) * z);
          hit[r] = set_bits(in <= out, one, hit[r]);
        }
      }
      std::uint32_t none = 0;
      for (std::size_t r = 0; r < kRegistersOfNode; ++r) {
        L::store(hit[r], through[half] + r * L::kWidth);
        none |= bits(hit[r] == I(0)) << (r * L::kWidth);
      }
      hit_by_none &= none;
    }
    return ~hit_by_none;
  }

  /// Spheres as they are seen from the origin: what a ray `passes` is above `margin` where it hits
  /// for sure, and below -margin where it misses.
  struct Cones {
    V3<F> to_center;
    F minus_power, margin;
    /// b² - c of the sphere's power c, where the ray goes away from the sphere -c.
    ZRAKA_INLINE F passes(const V3<F>& direction) const {
      const F b =
          roughly_mul_add(direction.z, to_center.z,
                          roughly_mul_add(direction.y, to_center.y, direction.x * to_center.x));
      return roughly_mul_add(max(b, F(0)), b, minus_power);
    }
  };

  /// The margin is 128 half units of the largest parts: as in ShapeLanes<Sphere>::blocks(), with as
  /// much again for b, which is rounded otherwise here. Of a sphere that the origin is in nothing
  /// is sure.
  ZRAKA_INLINE Cones cones_of(const FrozenShapes<R, Sphere>& spheres, std::int32_t first) const {
    const auto column = [&](std::size_t k) { return L::load(spheres.column[k] + first); };
    const V3<F> to_center{column(0) - origin_.x, column(1) - origin_.y, column(2) - origin_.z};
    const F radius = column(3);
    const F square =
        roughly_mul_add(to_center.z, to_center.z,
                        roughly_mul_add(to_center.y, to_center.y, to_center.x * to_center.x));
    const F minus_power = roughly_mul_sub(radius, radius, square);
    const F magnitude = roughly_mul_add(radius, radius, square), margin = magnitude * F(0x1p-17f);
    const F inside = (minus_power + margin) * F(0x1p60f);
    Cones cones{to_center, minus_power, max(margin, inside)};
    if (limited_) {
      // What is beyond the limit, or near to it, is asked where it may be hit: from -margin on.
      const auto near = magnitude < F(limit_ * limit_ * R(0.4));
      const F large = max(magnitude * F(4), inside);
      cones.minus_power = select(near, minus_power, minus_power + margin - large);
      cones.margin = select(near, cones.margin, large);
    }
    return cones;
  }

  /// Of so many registers of spheres, of which the first `count` are those that are asked for.
  template <int kCount>
  ZRAKA_INLINE Rays blocked_by_registers(const FrozenScene<R>& scene, std::int32_t first,
                                         std::int32_t count, Rays rays) const {
    Cones cones[kCount];
    F closest[kCount];  // to 0 of what the rays pass
    for (int n = 0; n < kCount; ++n) {
      cones[n] = cones_of(scene.spheres, first + n * static_cast<std::int32_t>(L::kWidth));
      closest[n] = F(kFarAway<R>);
    }
    Rays blocked = 0;
    for (Rays left = rays; left != 0; left &= left - 1) {
      const auto i = static_cast<std::size_t>(__builtin_ctzll(left));
      const V3<F> d = direction(i);
      auto by_any = L::first(0);
      for (int n = 0; n < kCount; ++n) {
        const F passes = cones[n].passes(d);
        const auto hit = passes > cones[n].margin;
        closest[n] = min(closest[n], abs(passes));
        by_any = n == 0 ? hit : either(by_any, hit);
      }
      blocked |= Rays{any(by_any)} << i;
    }
    auto unknown = closest[0] <= cones[0].margin;
    for (int n = 1; n < kCount; ++n) unknown = either(unknown, closest[n] <= cones[n].margin);
    if (any(unknown)) blocked |= blocked_exactly(scene, first, count, rays & ~blocked);
    return blocked;
  }

  /// A register of shapes at a time, and a ray after the other.
  template <class Shape>
  ZRAKA_INLINE Rays blocked_in_lanes(const FrozenScene<R>& scene,
                                     const FrozenShapes<R, Shape>& shapes, std::int32_t first,
                                     std::int32_t count, Rays rays) const {
    Rays blocked = 0;
    for (std::int32_t k = 0; k < count; k += static_cast<std::int32_t>(L::kWidth)) {
      const auto exists = L::first(static_cast<std::size_t>(count - k));
      const F limit = select(exists, F(limit_), F(-1));
      NumbersOf<Shape, L> shape;
      load_shapes<L>(shapes, first + k, shape);
      for (Rays left = rays & ~blocked; left != 0; left &= left - 1) {
        const auto i = static_cast<std::size_t>(__builtin_ctzll(left));
        const F t = intersect_shape<true, Shape, L>(shape, origin_, direction(i), limit);
        const std::uint32_t by =
            that_throw_shadows(scene, shapes, bits(both(t > F(0), t < limit)),
                               [&](int lane) { return first + k + lane; });
        blocked |= Rays{by != 0} << i;
      }
    }
    return blocked;
  }

  /// What blocked_by_registers() finds by the distances of those that may hit.
  __attribute__((noinline)) Rays blocked_exactly(const FrozenScene<R>& scene, std::int32_t first,
                                                 std::int32_t count, Rays rays) const {
    Rays blocked = 0;
    for (std::int32_t k = 0; k < count; k += static_cast<std::int32_t>(L::kWidth)) {
      F sphere[4];
      load_shapes<L>(scene.spheres, first + k, sphere);
      const Cones cones = cones_of(scene.spheres, first + k);
      const auto exists = L::from_bits(that_throw_shadows(
          scene, scene.spheres, bits(L::first(static_cast<std::size_t>(count - k))),
          [&](int lane) { return first + k + lane; }));
      for (Rays left = rays & ~blocked; left != 0; left &= left - 1) {
        const auto i = static_cast<std::size_t>(__builtin_ctzll(left));
        const auto maybe = both(exists, cones.passes(direction(i)) >= -cones.margin);
        if (!any(maybe)) continue;
        const F t = ShapeLanes<Sphere, L>::intersect(sphere, origin_, direction(i));
        blocked |= Rays{any(both(maybe, both(t > F(0), t < F(limit_))))} << i;
      }
    }
    return blocked;
  }

  V3<F> origin_;
  R limit_;
  bool limited_;  ///< there may be spheres beyond the limit
  const R* direction_[3];
  Rays all_;
  alignas(64) R inverse_[3][kMost];
  alignas(64) std::int32_t near_[3][kMost];
};

/// Which of the rays from one point are blocked, a bit each, in a scene with a hierarchy that holds
/// no bodies.
template <class L, class R = typename L::Real>
std::uint64_t blocked_from_point(const FrozenScene<R>& scene, const PointRays<L>& rays) {
  using Entry = typename PointRays<L>::Entry;
  std::uint64_t left = rays.all() & ~rays.blocked_by_unbounded(scene);
  Entry stack[kMaxNodeDepth * kNodeWidth + kNodeWidth + 2];
  Entry* top = stack;
  *top++ = {0, 0, PointRays<L>::kAround, left};
  // What the leaf before has blocked is left out one entry later: so the processor need not wait
  // for the one to begin with the other.
  std::uint64_t last = 0;
  while (top != stack) {
    const Entry& entry = *--top;  // a copy would wait for the stores of its parts
    const std::uint64_t asking = entry.rays & left;
    if (asking == 0) continue;
    const std::int32_t child = entry.child;
    if (entry.leaf != 0) {
      left &= ~last;
      last = leaf_kind(entry.leaf) == kKindOfSphere
                 ? rays.blocked_by(scene, child, leaf_count(entry.leaf), asking)
                 : rays.blocked_by_shapes(scene, entry.leaf, child, asking);
      continue;
    }
    const Node& node = scene.hierarchy.nodes[child];
    top = entry.visited == PointRays<L>::kAround
              ? rays.push_around(child, node, asking, top)
              : rays.push_children(node, entry.visited, asking, top);
  }
  return rays.all() & ~(left & ~last);
}

}  // namespace zraka::ZRAKA_ISA
