// SPDX-License-Identifier: Apache-2.0
#include "accel/build.hpp"

#include <tbb/task_group.h>

#include <algorithm>
#include <array>
#include <limits>
#include <memory>

#include "core/handover.hpp"

namespace zraka {
namespace {

constexpr int kBins = 16;
/// Ranges up to this size are leaves: one vector of them costs hardly more than one.
constexpr std::size_t kLeafSize = 4;
/// Ranges from this size on are built by a task of their own.
constexpr std::size_t kTaskSize = 4096;
/// Below this many levels of nodes ranges are halved, whatever the heuristic says: that bounds the
/// traversal's stack.
constexpr int kFreeDepth = kMaxNodeDepth - 16;

struct Bounds {
  std::array<float, 3> lower{std::numeric_limits<float>::infinity(),
                             std::numeric_limits<float>::infinity(),
                             std::numeric_limits<float>::infinity()};
  std::array<float, 3> upper{-lower[0], -lower[0], -lower[0]};

  void include(const float (&lo)[3], const float (&up)[3]) {
    for (std::size_t a = 0; a < 3; ++a) {
      lower[a] = std::min(lower[a], lo[a]);
      upper[a] = std::max(upper[a], up[a]);
    }
  }
  void include(const Bounds& other) {
    for (std::size_t a = 0; a < 3; ++a) {
      lower[a] = std::min(lower[a], other.lower[a]);
      upper[a] = std::max(upper[a], other.upper[a]);
    }
  }
  float half_area() const {
    const float x = upper[0] - lower[0], y = upper[1] - lower[1], z = upper[2] - lower[2];
    return x < 0 ? 0 : x * y + y * z + z * x;
  }
};

/// Twice the centre, which is all that bins need.
float center(const BuildRef& ref, std::size_t axis) {
  return ref.lower[axis] + ref.upper[axis];
}

struct Range {
  BuildRef *begin, *end;
  Bounds bounds, centers;
  std::size_t size() const { return static_cast<std::size_t>(end - begin); }
};

Range range_of(BuildRef* begin, BuildRef* end) {
  Range range{begin, end, {}, {}};
  for (const BuildRef* r = begin; r != end; ++r) {
    range.bounds.include(r->lower, r->upper);
    const float c[3] = {center(*r, 0), center(*r, 1), center(*r, 2)};
    range.centers.include(c, c);
  }
  return range;
}

struct Bin {
  Bounds bounds;
  std::size_t count = 0;
};

/// Which bin a centre falls into; monotonous in the centre.
struct Binning {
  float from, scale;
  explicit Binning(const Range& range, std::size_t axis)
      : from(range.centers.lower[axis]),
        scale(kBins / (range.centers.upper[axis] - range.centers.lower[axis])) {}
  int bin(float c) const { return std::clamp(static_cast<int>((c - from) * scale), 0, kBins - 1); }
};

struct Split {
  std::size_t axis = 3;  // 3: none was found
  int bin = 0;           // the first of the right side
  float cost = std::numeric_limits<float>::infinity();
};

Split best_split(const Range& range) {
  Split best;
  for (std::size_t axis = 0; axis < 3; ++axis) {
    if (!(range.centers.upper[axis] > range.centers.lower[axis])) continue;
    const Binning binning(range, axis);
    if (!(binning.scale < std::numeric_limits<float>::max())) continue;
    std::array<Bin, kBins> bins;
    for (const BuildRef* r = range.begin; r != range.end; ++r) {
      Bin& bin = bins[static_cast<std::size_t>(binning.bin(center(*r, axis)))];
      bin.bounds.include(r->lower, r->upper);
      ++bin.count;
    }
    // Costs of everything left of each border, then from the right.
    std::array<float, kBins> left{};
    Bin sum;
    for (std::size_t b = 0; b + 1 < kBins; ++b) {
      sum.bounds.include(bins[b].bounds);
      sum.count += bins[b].count;
      left[b + 1] = sum.bounds.half_area() * static_cast<float>(sum.count);
    }
    sum = {};
    for (std::size_t b = kBins - 1; b > 0; --b) {
      sum.bounds.include(bins[b].bounds);
      sum.count += bins[b].count;
      if (sum.count == 0 || sum.count == range.size()) continue;
      const float cost = left[b] + sum.bounds.half_area() * static_cast<float>(sum.count);
      if (cost < best.cost) best = {axis, static_cast<int>(b), cost};
    }
  }
  return best;
}

/// Two parts of a range, neither empty; the range has at least two references.
std::pair<Range, Range> split(const Range& range, int depth) {
  const Split best = depth < kFreeDepth ? best_split(range) : Split{};
  BuildRef* middle = range.begin + range.size() / 2;  // equal centres: any halves will do
  if (best.axis < 3) {
    const Binning binning(range, best.axis);
    middle = std::partition(range.begin, range.end, [&](const BuildRef& r) {
      return binning.bin(center(r, best.axis)) < best.bin;
    });
  }
  return {range_of(range.begin, middle), range_of(middle, range.end)};
}

bool one_kind(const Range& range) {
  return std::all_of(range.begin, range.end,
                     [&](const BuildRef& r) { return r.kind == range.begin->kind; });
}

/// A leaf holds one kind; a small range of several is cut where the kinds change.
bool is_leaf(const Range& range) {
  return range.size() <= kLeafSize && one_kind(range);
}

std::pair<Range, Range> split_kinds(const Range& range) {
  std::sort(range.begin, range.end, [](const BuildRef& a, const BuildRef& b) {
    return std::pair(a.kind, a.index) < std::pair(b.kind, b.index);
  });
  BuildRef* middle = std::find_if(range.begin, range.end,
                                  [&](const BuildRef& r) { return r.kind != range.begin->kind; });
  return {range_of(range.begin, middle), range_of(middle, range.end)};
}

/// A node before it has its place: its ranges, and the nodes of those that are no leaves.
struct BuildNode {
  std::vector<Range> ranges;
  std::vector<std::unique_ptr<BuildNode>> inner;  // by range; null for leaves
};

std::unique_ptr<BuildNode> build_node(const Range& whole, int depth) {
  auto node = std::make_unique<BuildNode>();
  node->ranges.reserve(kNodeWidth);
  node->ranges.push_back(whole);
  // Always splits what costs most, until sixteen children are there.
  while (node->ranges.size() < kNodeWidth) {
    Range* widest = nullptr;
    float most = -1;
    for (Range& range : node->ranges) {
      if (is_leaf(range)) continue;
      const float cost = range.bounds.half_area() * static_cast<float>(range.size());
      if (cost > most) most = cost, widest = &range;
    }
    if (widest == nullptr) break;
    auto [left, right] = widest->size() <= kLeafSize ? split_kinds(*widest) : split(*widest, depth);
    *widest = left;
    node->ranges.push_back(right);
  }
  node->inner.resize(node->ranges.size());
  tbb::task_group tasks;
  Handover to_tasks, from_tasks;
  to_tasks.give();
  for (std::size_t i = 0; i < node->ranges.size(); ++i) {
    if (is_leaf(node->ranges[i])) continue;
    const auto build = [&node, i, depth] {
      node->inner[i] = build_node(node->ranges[i], depth + 1);
    };
    if (node->ranges[i].size() >= kTaskSize)
      tasks.run([&, build] {
        to_tasks.take();
        build();
        from_tasks.give();
      });
    else
      build();
  }
  tasks.wait();
  from_tasks.take();
  return node;
}

/// Nodes into their places, depth first, and the primitives of the leaves into their order.
class Placement {
 public:
  Placement(BuiltHierarchy& out) : out_(out) {}

  std::int32_t place(const BuildNode& from) {
    const std::size_t at = out_.nodes.size();
    out_.nodes.emplace_back();
    Node node;
    for (std::size_t i = 0; i < kNodeWidth; ++i) {
      const bool there = i < from.ranges.size();
      const Bounds bounds = there ? from.ranges[i].bounds : Bounds{};
      node.lower_x[i] = bounds.lower[0], node.lower_y[i] = bounds.lower[1],
      node.lower_z[i] = bounds.lower[2];
      node.upper_x[i] = bounds.upper[0], node.upper_y[i] = bounds.upper[1],
      node.upper_z[i] = bounds.upper[2];
      node.child[i] = node.leaf[i] = 0;
      if (!there) continue;
      if (from.inner[i] != nullptr)
        node.child[i] = place(*from.inner[i]);
      else
        place_leaf(from.ranges[i], node.child[i], node.leaf[i]);
    }
    out_.nodes[at] = node;
    return static_cast<std::int32_t>(at);
  }

 private:
  void place_leaf(const Range& range, std::int32_t& child, std::int32_t& leaf) {
    const std::int32_t kind = range.begin->kind;
    std::vector<std::int32_t>& order = out_.order[static_cast<std::size_t>(kind)];
    child = static_cast<std::int32_t>(order.size());
    leaf = static_cast<std::int32_t>(range.size()) + 2 * kNodeWidth * kind;
    for (const BuildRef* r = range.begin; r != range.end; ++r) order.push_back(r->index);
  }
  BuiltHierarchy& out_;
};

}  // namespace

BuiltHierarchy build_hierarchy(std::vector<BuildRef>& refs, int kinds) {
  BuiltHierarchy built;
  built.order.resize(static_cast<std::size_t>(kinds));
  if (refs.empty()) return built;
  const auto root = build_node(range_of(refs.data(), refs.data() + refs.size()), 0);
  Placement(built).place(*root);
  return built;
}

}  // namespace zraka
