// SPDX-License-Identifier: Apache-2.0
// The bounding volume hierarchy as the engine reads it: plain nodes of sixteen boxes.
#pragma once

#include <cstdint>
#include <vector>

#include "math/inline.hpp"

namespace zraka {

/// Children of a node; also the most primitives of a leaf, which is one register of the widest set.
inline constexpr int kNodeWidth = 16;

/// Leaves of up to so many shapes are small: rays that are few hit their shapes without visiting
/// them.
inline constexpr std::int32_t kMostInSmallLeaf = 2;

/// Kinds of shapes that a node has room for.
inline constexpr std::size_t kMostKinds = 8;

/// Levels of nodes that a hierarchy may have.
inline constexpr int kMaxNodeDepth = 64;

/// Node::leaf where there is no child: no primitives of a kind that there is not. Rays that are not
/// numbers may come to it through its empty box, and find nothing.
inline constexpr std::int32_t kNoChild = std::int32_t{1} << 20;

/// Node::leaf of a leaf, and its parts.
ZRAKA_INLINE constexpr std::int32_t leaf_of(std::int32_t count, std::int32_t kind) {
  return count + 2 * kNodeWidth * kind;
}
ZRAKA_INLINE constexpr std::int32_t leaf_count(std::int32_t leaf) {
  return leaf & (2 * kNodeWidth - 1);
}
ZRAKA_INLINE constexpr std::int32_t leaf_kind(std::int32_t leaf) {
  return leaf / (2 * kNodeWidth);
}

/// Sixteen boxes in the engine's frame, a column for each side; boxes of missing children are empty
/// (lower above upper). Boxes are larger than what they hold by what a primitive's intersection can
/// err, so that no ray that hits a primitive by its arithmetic can miss the box by its own.
struct alignas(64) Node {
  float lower_x[kNodeWidth], lower_y[kNodeWidth], lower_z[kNodeWidth];
  float upper_x[kNodeWidth], upper_y[kNodeWidth], upper_z[kNodeWidth];
  /// An inner child: the index of its node. A leaf: its first primitive, among those of its kind.
  std::int32_t child[kNodeWidth];
  /// An inner child: 0. A leaf: leaf_of() its number of primitives and their kind. A missing child:
  /// kNoChild.
  std::int32_t leaf[kNodeWidth];
  /// The same as sets of children, a bit each: those with one shape, with two…, by their kind.
  std::uint16_t small_leaves[kMostKinds][kMostInSmallLeaf];
  std::uint16_t children;     ///< all that there are
  std::uint16_t small_kinds;  ///< which kinds have small leaves, a bit each
  friend bool operator==(const Node&, const Node&) = default;
};
static_assert(kNodeWidth <= 16);

/// An empty hierarchy (no nodes) means that the shapes are few enough to be asked one by one.
struct Hierarchy {
  const Node* nodes = nullptr;  ///< the root is the first
  std::int32_t node_count = 0;
  /// By slot: its rank in the order of the leaves, over all kinds; nullptr where that is the
  /// slot's own number, and in large scenes, which have no memory for it.
  const std::int32_t* rank = nullptr;
};

/// A primitive as the builder sees it: its box, already enlarged, and its slot as it was frozen.
struct BuildRef {
  float lower[3], upper[3];
  std::int32_t index;
};

/// What the builder makes of all the references.
struct BuiltHierarchy {
  std::vector<Node> nodes;
  /// The primitives' slots as they were frozen, in the order of the leaves, kind after kind; empty
  /// where there are no nodes.
  std::vector<std::int32_t> order;
  /// By slot in this order: its rank among all leaves' primitives; empty where that is the slot.
  std::vector<std::int32_t> rank;
};

}  // namespace zraka
