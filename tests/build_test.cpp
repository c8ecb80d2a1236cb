// SPDX-License-Identifier: Apache-2.0
// What the hierarchy is like that is built from boxes.
#include "accel/build.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>

#include "math/bounds.hpp"

namespace zraka {
namespace {

TEST(Build, IsBuiltFromAMillionEqualSpheres) {
#ifdef ZRAKA_SANITIZED
  constexpr std::int32_t kCount = 100000;
#else
  constexpr std::int32_t kCount = 1000000;
#endif
  BuildRefs refs(kCount);
  for (std::size_t i = 0; i < refs.size(); ++i)
    refs[i] = {{-1, -1, -1}, {1, 1, 1}, static_cast<std::int32_t>(i)};
  std::vector<std::int32_t> order = build_hierarchy(std::move(refs), {0, kCount}).order;
  std::sort(order.begin(), order.end());
  ASSERT_EQ(order.size(), static_cast<std::size_t>(kCount));
  for (std::size_t i = 0; i < order.size(); ++i) ASSERT_EQ(order[i], static_cast<std::int32_t>(i));
}

TEST(Build, IsGivenUpWhereItWasCancelled) {
  BuildRefs refs(100000);
  for (std::size_t i = 0; i < refs.size(); ++i)
    refs[i] = {{-1, -1, -1}, {1, 1, 1}, static_cast<std::int32_t>(i)};
  const std::atomic<bool> cancel{true};
  const BuiltHierarchy built = build_hierarchy(std::move(refs), {0, 100000}, &cancel);
  EXPECT_TRUE(built.nodes.empty());
  EXPECT_TRUE(built.order.empty());
}

TEST(Build, StaysFlatEnoughForItsStack) {
  // Every shape half as large as the one before and beside it: each cut takes off only a few.
  BuildRefs refs(20000);
  for (std::size_t i = 0; i < refs.size(); ++i) {
    const float at = std::ldexp(1.0f, -static_cast<int>(i % 140)),
                size = at * (1 + 1e-6f * static_cast<float>(i));
    refs[i] = {{at, 0, 0}, {at + size, size, size}, static_cast<std::int32_t>(i)};
  }
  const BuiltHierarchy built = build_hierarchy(std::move(refs), {0, 20000});
  std::vector<std::pair<std::int32_t, int>> open = {{0, 1}};
  int deepest = 0;
  while (!open.empty()) {
    const auto [at, depth] = open.back();
    open.pop_back();
    deepest = std::max(deepest, depth);
    const Node& node = built.nodes[static_cast<std::size_t>(at)];
    for (std::size_t i = 0; i < kNodeWidth; ++i)
      if (node.leaf[i] == 0 && node.lower_x[i] <= node.upper_x[i])
        open.push_back({node.child[i], depth + 1});
  }
  EXPECT_LE(deepest, kMaxNodeDepth);
}

TEST(Build, KeepsTheSetsOfANodesChildren) {
  BuildRefs refs(2000);  // two kinds, side by side
  for (std::size_t i = 0; i < refs.size(); ++i) {
    const auto x = static_cast<float>(i * 37 % 100), y = static_cast<float>(i * 37 / 100 % 100);
    refs[i] = {{x, y, 0}, {x + 0.1f, y + 0.1f, 1}, static_cast<std::int32_t>(i)};
  }
  std::size_t small = 0;
  for (const Node& node : build_hierarchy(std::move(refs), {0, 1000, 2000}).nodes) {
    for (std::size_t i = 0; i < kNodeWidth; ++i) {
      const std::int32_t leaf = node.leaf[i];
      EXPECT_EQ((node.children >> i & 1) != 0, leaf != kNoChild);
      for (std::int32_t kind = 0; kind < 2; ++kind)
        for (std::int32_t count = 1; count <= kMostInSmallLeaf; ++count) {
          const bool is = (node.small_leaves[kind][count - 1] >> i & 1) != 0;
          EXPECT_EQ(is, leaf == leaf_of(count, kind));
          small += is;
          EXPECT_TRUE(!is || (node.small_kinds >> kind & 1) != 0);
        }
    }
    for (int kind = 2; kind < static_cast<int>(kMostKinds); ++kind)
      EXPECT_EQ(node.small_kinds >> kind & 1, 0);
  }
  EXPECT_GT(small, 0u);
}

float half_area(const Bounds& box) {
  const Vec3 size{box.upper.x - box.lower.x, box.upper.y - box.lower.y, box.upper.z - box.lower.z};
  return static_cast<float>(size.x * size.y + size.y * size.z + size.z * size.x);
}

/// What a ray through the hierarchy's box pays by the surface area heuristic: two for a node, one
/// for a leaf and one for a shape.
float cost_of(const BuiltHierarchy& built) {
  float cost = 0, root = 0;
  for (const Node& node : built.nodes) {
    Bounds all;
    for (std::size_t i = 0; i < kNodeWidth; ++i) {
      if (node.leaf[i] == kNoChild) continue;
      const Bounds box{{node.lower_x[i], node.lower_y[i], node.lower_z[i]},
                       {node.upper_x[i], node.upper_y[i], node.upper_z[i]}};
      all.include(box);
      const auto shapes = static_cast<float>(leaf_count(node.leaf[i]));
      if (shapes > 0) cost += half_area(box) * (1 + shapes);
    }
    cost += 2 * half_area(all);
    if (&node == &built.nodes[0]) root = half_area(all);
  }
  return cost / root;
}

TEST(Build, CostsLittleAlsoWhereKindsMix) {
  // Joints: a shape of one kind beside one of the other.
  constexpr std::int32_t kCount = 8000;
  BuildRefs refs(kCount);
  std::mt19937 generator(1);
  std::uniform_real_distribution<float> anywhere(-1, 1);
  for (std::size_t i = 0; i < kCount / 2; ++i) {
    const float x = anywhere(generator), y = anywhere(generator), z = anywhere(generator),
                d = 0.02f;
    const auto first = static_cast<std::int32_t>(i), second = first + kCount / 2;
    refs[i] = {{x, y, z}, {x + d, y + d, z + d}, first};
    refs[i + kCount / 2] = {{x + d, y, z}, {x + 2 * d, y + d, z + d}, second};
  }
  const BuiltHierarchy built = build_hierarchy(std::move(refs), {0, kCount / 2, kCount});
  EXPECT_LT(cost_of(built), 23) << "24.5 if what costs most is always split next";
}

/// How many primitives each leaf below the root of so many boxes has.
std::vector<int> leaves_of(BuildRefs refs) {
  const auto count = static_cast<std::int32_t>(refs.size());
  const BuiltHierarchy built = build_hierarchy(std::move(refs), {0, count});
  std::vector<int> counts;
  for (const std::int32_t leaf : built.nodes[0].leaf)
    if (leaf != kNoChild) counts.push_back(leaf_count(leaf));
  return counts;
}

TEST(Build, SplitsLeavesWhereThatHalvesWhatRaysMeet) {
  BuildRefs posts(12), quads(12);
  for (std::int32_t i = 0; i < 12; ++i) {
    const auto x = static_cast<float>(i), pair = static_cast<float>(i / 2 * 2);
    posts[static_cast<std::size_t>(i)] = {{x, 0, 0}, {x + 0.1f, 9, 0.1f}, i};
    quads[static_cast<std::size_t>(i)] = {{pair, 0, 0}, {pair + 1, 1, 0.1f}, i};
  }
  EXPECT_EQ(leaves_of(std::move(posts)), std::vector<int>(12, 1)) << "thin ones apart: alone";
  EXPECT_EQ(leaves_of(std::move(quads)), std::vector<int>(6, 2)) << "halves of a quad: together";
}

/// How many primitives a leaf has in the mean, of so many cubes anywhere; every second one is of
/// another kind if they are two.
double fill_of(std::int32_t count, int kinds) {
  BuildRefs refs(static_cast<std::size_t>(count));
  std::mt19937 generator(1);
  std::uniform_real_distribution<float> anywhere(-1, 1);
  for (std::int32_t i = 0; i < count; ++i) {
    const float x = anywhere(generator), y = anywhere(generator), z = anywhere(generator),
                d = 0.01f;
    refs[static_cast<std::size_t>(i)] = {{x, y, z}, {x + d, y + d, z + d}, i};
  }
  std::vector<std::int32_t> kind_starts = {0, count / kinds};
  if (kinds == 2) kind_starts.push_back(count);
  int leaves = 0;
  for (const Node& node : build_hierarchy(std::move(refs), kind_starts).nodes)
    for (const std::int32_t leaf : node.leaf) leaves += leaf != 0 && leaf != kNoChild ? 1 : 0;
  return static_cast<double>(count) / leaves;
}

TEST(Build, FillsLeavesOfOneKindInLargeScenes) {
  EXPECT_LT(fill_of(10000, 1), 2) << "nodes stay in the cache";
  EXPECT_GT(fill_of(70000, 1), 12) << "nodes do not: 2.1 otherwise";
  EXPECT_LT(fill_of(70000, 2), 2) << "kinds mix";
}

}  // namespace
}  // namespace zraka
