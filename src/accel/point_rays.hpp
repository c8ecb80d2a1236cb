// SPDX-License-Identifier: Apache-2.0
// Rays of one point in all directions, among spheres: which of them are blocked.
#pragma once

#include "accel/bundle.hpp"
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
  ZRAKA_INLINE PointRays(const V3<R>& origin, R limit, const R* dx, const R* dy, const R* dz,
                         std::size_t count)
      : origin_{F(origin.x), F(origin.y), F(origin.z)},
        limit_(limit),
        direction_{dx, dy, dz},
        all_(0) {
    for (std::size_t i = 0; i < count; i += L::kWidth) {
      const F x = L::load(dx + i), y = L::load(dy + i), z = L::load(dz + i);
      const F inverse[3] = {slab_inverse(x), slab_inverse(y), slab_inverse(z)};
      for (std::size_t axis = 0; axis < 3; ++axis) {
        L::store(inverse[axis], inverse_[axis] + i);
        L::store(select(inverse[axis] < F(0), I(kNodeWidth), I(0)), near_[axis] + i);
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
    Sides sides;
    alignas(64) std::int32_t keys[kNodeWidth];  // distances, and lanes in the lowest bits
    alignas(64) std::int32_t through[2][kNodeWidth];
    std::uint32_t wanted = 0;
    for (std::size_t k = 0; k < kNodeWidth; k += L::kWidth) {
      const V3<F> lower = V3<F>{L::load_box(node.lower_x + k), L::load_box(node.lower_y + k),
                                L::load_box(node.lower_z + k)} -
                          origin_;
      const V3<F> upper = V3<F>{L::load_box(node.upper_x + k), L::load_box(node.upper_y + k),
                                L::load_box(node.upper_z + k)} -
                          origin_;
      L::store(lower.x, sides[0] + k), L::store(upper.x, sides[0] + kNodeWidth + k);
      L::store(lower.y, sides[1] + k), L::store(upper.y, sides[1] + kNodeWidth + k);
      L::store(lower.z, sides[2] + k), L::store(upper.z, sides[2] + kNodeWidth + k);
      const V3<F> away{max(max(lower.x, -upper.x), F(0)), max(max(lower.y, -upper.y), F(0)),
                       max(max(lower.z, -upper.z), F(0))};
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
      std::uint32_t not_above = 0;
      for (std::size_t k = 0; k < kNodeWidth; k += L::kWidth)
        not_above |= bits(mine >= L::load(keys + k)) << k;
      top[__builtin_popcount(wanted & ~not_above)] = {
          node.child[lane], node.leaf[lane], 0,
          Rays{static_cast<std::uint32_t>(through[0][lane])} |
              Rays{static_cast<std::uint32_t>(through[1][lane])} << 32};
    }
    return top + __builtin_popcount(wanted);
  }

  /// Which of the rays the spheres [first, first + count) block.
  ZRAKA_INLINE Rays blocked_by(const FrozenScene<R>& scene, std::int32_t first, std::int32_t count,
                               Rays rays) const {
    constexpr auto kWidth = static_cast<std::int32_t>(L::kWidth);
    Rays blocked = 0;
    std::int32_t k = 0;
    if constexpr (kWidth < kNodeWidth)
      for (; count - k > kWidth; k += 2 * kWidth)
        blocked |= blocked_by_registers<2>(scene, first + k, count - k, rays & ~blocked);
    if (k < count) blocked |= blocked_by_registers<1>(scene, first + k, count - k, rays & ~blocked);
    return blocked;
  }

 private:
  /// Of a node's boxes, along each axis the lower sides and the upper ones.
  using Sides = R[3][2 * kNodeWidth];

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
        const auto nx = static_cast<std::size_t>(near_[0][i]), fx = nx ^ kNodeWidth;
        const auto ny = static_cast<std::size_t>(near_[1][i]), fy = ny ^ kNodeWidth;
        const auto nz = static_cast<std::size_t>(near_[2][i]), fz = nz ^ kNodeWidth;
        for (std::size_t r = 0; r < kRegistersOfNode; ++r) {
          const std::size_t k = r * L::kWidth;
          const F in = max(max(L::load(sides[0] + nx + k) * x, L::load(sides[1] + ny + k) * y),
                           max(L::load(sides[2] + nz + k) * z, F(0)));
          const F out = min(min(L::load(sides[0] + fx + k) * x, L::load(sides[1] + fy + k) * y),
                            L::load(sides[2] + fz + k) * z);
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

  /// Spheres as they are seen from the origin. A ray hits for sure what it is more `along` of than
  /// `inner`, and nothing that it is less along of than `outer`.
  struct Cones {
    V3<F> to_center;
    F inner, outer;
    /// The square of a direction times the way to the centre, with its sign.
    ZRAKA_INLINE F along(const V3<F>& direction) const {
      const F b =
          roughly_mul_add(direction.z, to_center.z,
                          roughly_mul_add(direction.y, to_center.y, direction.x * to_center.x));
      return b * abs(b);
    }
  };

  /// By b² - c of the sphere's power c, of which a hit is sure where it is above 0, and none where
  /// it is below, by 128 half units of its largest parts: as in ShapeLanes<Sphere>::blocks(), with
  /// as much again for b, which is rounded otherwise here.
  ZRAKA_INLINE Cones cones_of(const F* s, typename L::M exists) const {
    const F far(kFarAway<R>);
    const V3<F> to_center{s[0] - origin_.x, s[1] - origin_.y, s[2] - origin_.z};
    const F radius_square = select(exists, s[3] * s[3], -far);  // none is farther than any
    const F square = dot(to_center, to_center), c = square - radius_square;
    const F magnitude = square + radius_square, margin = magnitude * F(0x1p-17f);
    const auto outside = c > F(0);
    // What is inside, beyond the limit, or near to it, is asked where it is hit.
    const auto within = magnitude < F(limit_ * limit_ * R(0.4));
    return {to_center, select(both(outside, within), c + margin, far),
            select(outside, c - margin, -far)};
  }

  /// Of so many registers of spheres, the first `count` there are.
  template <int kCount>
  ZRAKA_INLINE Rays blocked_by_registers(const FrozenScene<R>& scene, std::int32_t first,
                                         std::int32_t count, Rays rays) const {
    F sphere[kCount][4];
    typename L::M exists[kCount], unknown[kCount];
    Cones cones[kCount];
    for (int n = 0; n < kCount; ++n) {
      const std::int32_t k = n * static_cast<std::int32_t>(L::kWidth);
      load_shapes<L>(scene.spheres, first + k, sphere[n]);
      exists[n] = L::first(static_cast<std::size_t>(count - k));
      if (scene.shadowless != nullptr)
        exists[n] = L::from_bits(that_throw_shadows(scene, scene.spheres, bits(exists[n]),
                                                    [&](int lane) { return first + k + lane; }));
      cones[n] = cones_of(sphere[n], exists[n]);
      unknown[n] = L::first(0);
    }
    Rays blocked = 0;
    for (Rays left = rays; left != 0; left &= left - 1) {
      const auto i = static_cast<std::size_t>(__builtin_ctzll(left));
      const V3<F> d = direction(i);
      auto by_any = L::first(0);
      for (int n = 0; n < kCount; ++n) {
        const F along = cones[n].along(d);
        const auto hit = along > cones[n].inner;
        unknown[n] = either(unknown[n], but_not(along > cones[n].outer, hit));
        by_any = n == 0 ? hit : either(by_any, hit);
      }
      blocked |= Rays{any(by_any)} << i;
    }
    for (int n = 0; n < kCount; ++n)
      if (any(unknown[n]))
        blocked |= blocked_exactly(sphere[n], exists[n], cones[n], rays & ~blocked);
    return blocked;
  }

  /// The same by the distances of those that may hit.
  __attribute__((noinline)) Rays blocked_exactly(const F* sphere, typename L::M exists,
                                                 const Cones& cones, Rays rays) const {
    Rays blocked = 0;
    for (; rays != 0; rays &= rays - 1) {
      const auto i = static_cast<std::size_t>(__builtin_ctzll(rays));
      const auto maybe = both(exists, cones.along(direction(i)) > cones.outer);
      if (!any(maybe)) continue;
      const F t = ShapeLanes<Sphere, L>::intersect(sphere, origin_, direction(i));
      blocked |= Rays{any(both(maybe, both(t > F(0), t < F(limit_))))} << i;
    }
    return blocked;
  }

  V3<F> origin_;
  R limit_;
  const R* direction_[3];
  Rays all_;
  alignas(64) R inverse_[3][kMost];
  alignas(64) std::int32_t near_[3][kMost];
};

/// Which of the rays from one point are blocked, a bit each, in a scene of a hierarchy of spheres.
template <class L, class R = typename L::Real>
std::uint64_t blocked_from_point(const FrozenScene<R>& scene, const PointRays<L>& rays) {
  using Entry = typename PointRays<L>::Entry;
  std::uint64_t left = rays.all();
  Entry stack[kMaxNodeDepth * kNodeWidth + kNodeWidth + 2];
  Entry* top = stack;
  *top++ = {0, 0, PointRays<L>::kAround, left};
  while (top != stack) {
    const Entry& entry = *--top;  // a copy would wait for the stores of its parts
    const std::uint64_t asking = entry.rays & left;
    if (asking == 0) continue;
    const std::int32_t child = entry.child;
    if (entry.leaf != 0) {
      left &= ~rays.blocked_by(scene, child, leaf_count(entry.leaf), asking);
      continue;
    }
    const Node& node = scene.hierarchy.nodes[child];
    top = entry.visited == PointRays<L>::kAround
              ? rays.push_around(child, node, asking, top)
              : rays.push_children(node, entry.visited, asking, top);
  }
  return rays.all() & ~left;
}

}  // namespace zraka::ZRAKA_ISA
