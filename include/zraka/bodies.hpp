// SPDX-License-Identifier: Apache-2.0
// Bodies: shapes that are described in a space of their own and stand in the world by a transform.
// One struct of parameters each; what a body can do stands in src/shapes/bodies/NAME.hpp.
#pragma once

#include <array>
#include <cstdint>
#include <string>
#include <variant>
#include <vector>
#include <zraka/values.hpp>

namespace zraka {

/// The material of what is a part of something, a member of CSG or a shape of a group, and has
/// none of its own: that of the whole, as its index would be.
inline constexpr std::uint32_t kMaterialOfWhole = 0xFFFFFFFF;

/// An affine map: (x, y, z) goes to origin + x·along_x + y·along_y + z·along_z.
struct Transform {
  Vec3 along_x{1, 0, 0}, along_y{0, 1, 0}, along_z{0, 0, 1};
  Vec3 origin;
  friend bool operator==(const Transform&, const Transform&) = default;
};

struct Ellipsoid {
  Vec3 center;
  Vec3 radii{1, 1, 1};  ///< along x, y and z, greater than 0
  friend bool operator==(const Ellipsoid&, const Ellipsoid&) = default;
};

/// Sides along the axes.
struct Box {
  Vec3 min, max{1, 1, 1};
  double radius = 0;  ///< of rounded edges, at most half the shortest side
  friend bool operator==(const Box&, const Box&) = default;
};

/// Unbounded. In CSG the half-space behind it: where its normal does not point.
struct Plane {
  Vec3 point;
  Vec3 normal{0, 1, 0};  ///< of any length but 0
  friend bool operator==(const Plane&, const Plane&) = default;
};

/// Flat; seen from both sides.
struct Parallelogram {
  Vec3 corner, edge_u{1, 0, 0}, edge_v{0, 1, 0};
  friend bool operator==(const Parallelogram&, const Parallelogram&) = default;
};

/// Flat; seen from both sides. A ring where the inner radius is not 0.
struct Disc {
  Vec3 center;
  Vec3 normal{0, 1, 0};  ///< of any length but 0
  double radius = 1;
  double inner_radius = 0;
  friend bool operator==(const Disc&, const Disc&) = default;
};

/// A cone, a frustum or a cylinder as a solid; without caps the side alone, like Cone, but under
/// any transform.
struct Frustum {
  Vec3 base;
  double base_radius = 1;  ///< 0 or more, one of the two more
  Vec3 top{0, 1, 0};
  double top_radius = 1;
  bool caps = true;
  friend bool operator==(const Frustum&, const Frustum&) = default;
};

/// All points within a radius of a line.
struct Capsule {
  Vec3 base, top{0, 1, 0};
  double radius = 1;
  friend bool operator==(const Capsule&, const Capsule&) = default;
};

/// Round its axis; the tube's radius is at most the radius of the tube's middle circle.
struct Torus {
  Vec3 center;
  Vec3 normal{0, 1, 0};  ///< the axis' direction
  double radius = 1;
  double tube_radius = 0.25;
  friend bool operator==(const Torus&, const Torus&) = default;
};

/// Where coefficients·(x², y², z², xy, xz, yz, x, y, z, 1) is 0, as far as it is in a box; the
/// inside is where it is negative.
struct Quadric {
  std::array<double, 10> coefficients{1, 1, 1, 0, 0, 0, 0, 0, 0, -1};
  Vec3 min{-1, -1, -1}, max{1, 1, 1};
  friend bool operator==(const Quadric&, const Quadric&) = default;
};

/// (|x|^(2/e) + |y|^(2/e))^(e/n) + |z|^(2/n) = 1 in units of the radii (Barr, "Superquadrics and
/// angle-preserving transformations", 1981).
struct Superellipsoid {
  Vec3 center;
  Vec3 radii{1, 1, 1};
  double e = 1, n = 1;  ///< greater than 0
  friend bool operator==(const Superellipsoid&, const Superellipsoid&) = default;
};

enum class CsgOperation : std::uint8_t { unite, intersect, subtract };

struct CsgMember;
/// Constructive solid geometry: closed bodies united, intersected, or the others taken from the
/// first.
struct Csg {
  CsgOperation operation = CsgOperation::unite;
  std::vector<CsgMember> of;
};

/// A group of shapes, as its index in Scene::groups, once more.
struct Instance {
  std::uint32_t group = 0;
  friend bool operator==(const Instance&, const Instance&) = default;
};

}  // namespace zraka

/// X(Type, plural): every body, in the order of their ids, after the shapes of ZRAKA_PRIMITIVES.
#define ZRAKA_BODIES(X)              \
  X(Ellipsoid, ellipsoids)           \
  X(Plane, planes)                   \
  X(Box, boxes)                      \
  X(Frustum, frustums)               \
  X(Torus, tori)                     \
  X(Disc, discs)                     \
  X(Parallelogram, parallelograms)   \
  X(Capsule, capsules)               \
  X(Quadric, quadrics)               \
  X(Superellipsoid, superellipsoids) \
  X(Csg, csgs)                       \
  X(Instance, instances)

namespace zraka {

/// Any body.
#define ZRAKA_OR(Type, plural) , Type
using AnyBody = std::variant<std::monostate ZRAKA_BODIES(ZRAKA_OR)>;
#undef ZRAKA_OR

/// A body of a CSG shape.
struct CsgMember {
  AnyBody body;
  std::uint32_t material = kMaterialOfWhole;  ///< index in Scene::materials
  std::uint32_t transform = 0;  ///< as Object::transform, into the whole shape's space
  std::string name{};           ///< UTF-8, "" where it has none
};

}  // namespace zraka
