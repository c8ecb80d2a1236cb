// SPDX-License-Identifier: Apache-2.0
// A range halved again and again, and which of the parts become children of one node.
#pragma once

#include <array>
#include <cstdint>
#include <memory>

#include "accel/kinds.hpp"

namespace zraka {

/// What leaves may be like, and what nodes cost.
struct CollapseRules {
  std::size_t whole;  ///< ranges of one kind up to this size are not halved any further
  std::size_t most;   ///< references that a leaf has at most, up to kNodeWidth
  float node_cost;    ///< what a ray pays for a node that it visits; 1 for a shape, 1 for a leaf
  /// Among ranges of up to 64 references, those of one kind end in leaves as full as can be: fewer
  /// nodes, which are what large scenes wait for.
  bool full_leaves;
};

/// A binary tree by the surface area heuristic over a range, and the cheapest way to make nodes of
/// up to sixteen children of it: for each part of the tree the least that rays pay for it as one
/// child, two, … sixteen, from the leaves upwards (Ylitie, Karras and Laine, "Efficient Incoherent
/// Ray Traversal on GPUs Through Compressed Wide BVHs", 2017).
class Collapse {
 public:
  /// Reorders the range's references, fewer than 2^14, by several tasks where there are many. Nodes
  /// have at most `levels` levels, of which there are fifteen or more.
  Collapse(const Range& range, int levels, const Kinds& kinds, const CollapseRules& rules);

  /// A part of the range.
  struct Part {
    BuildRef *begin, *end;
    BuildBounds bounds;
    bool leaf;  ///< or a node
    std::size_t size() const { return static_cast<std::size_t>(end - begin); }

   private:
    friend Collapse;
    std::int32_t left, right;  // what it was halved into, 0 if it was not
    int most;                  // children that it may become
    int in_node;               // children of the node that it may become
    // By the number of children: what rays pay at least, and how many of them then come from the
    // left half; 0 where one child less is as good.
    std::array<float, kNodeWidth + 1> cost;
    std::array<std::uint8_t, kNodeWidth + 1> from_left;
    std::uint8_t node_from_left;
  };
  /// The range itself; if it is a leaf, some node needs it as its only child.
  const Part& whole() const { return parts_[0]; }
  /// Calls function(part) for the two to sixteen children of a part that is a node.
  template <class Function>
  void each_child(const Part& part, const Function& function) const {
    each_of(at(part.left), part.node_from_left, function);
    each_of(at(part.right), part.in_node - part.node_from_left, function);
  }

 private:
  /// What all halvings share.
  struct Plan {
    const Kinds& kinds;
    const CollapseRules& rules;
  };
  void add(std::int32_t index, const Range& range, int levels, bool full_leaves, const Plan& plan);
  void add_both(const Part& part, const Range& left, const Range& right, int levels,
                bool full_leaves, const Plan& plan);
  void price(Part& part, bool can_be_leaf, float node_cost, float shape_cost) const;
  const Part& at(std::int32_t index) const { return parts_[static_cast<std::size_t>(index)]; }

  template <class Function>
  void each_of(const Part& part, int children, const Function& function) const {
    while (children > 1 && part.from_left[static_cast<std::size_t>(children)] == 0) --children;
    if (children == 1) return function(part);
    const int from_left = part.from_left[static_cast<std::size_t>(children)];
    each_of(at(part.left), from_left, function);
    each_of(at(part.right), children - from_left, function);
  }

  /// Whatever tasks do when, each part has its index: the parts of n references are at most 2n - 1,
  /// the first half's next to their whole and the second half's behind those.
  std::unique_ptr<Part[]> parts_;
};

}  // namespace zraka
