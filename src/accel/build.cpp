// SPDX-License-Identifier: Apache-2.0
#include "accel/build.hpp"

#include <tbb/blocked_range.h>
#include <tbb/parallel_reduce.h>
#include <tbb/task_group.h>

#include <algorithm>
#include <array>
#include <cstring>
#include <limits>
#include <memory>

#include "core/handover.hpp"

namespace zraka {
namespace {

constexpr int kBins = 16;
/// Ranges under this size have half as many bins: what bins cost by themselves counts there.
constexpr std::size_t kFewBinsSize = 64;
/// Ranges up to this size are not split further.
constexpr std::size_t kSmallLeaf = 4;
/// Ranges up to this size are leaves rather than nodes of their own; a vector of shapes costs
/// hardly more than one.
constexpr std::size_t kLargeLeaf = 12;
/// Ranges from this size on are built by a task of their own.
constexpr std::size_t kTaskSize = 4096;
/// Below this many levels of nodes ranges are halved, whatever the heuristic says: that bounds the
/// traversal's stack.
constexpr int kFreeDepth = kMaxNodeDepth - 16;

/// Three numbers and one that does not matter, in one register (GCC's and clang's vectors).
using Four = float __attribute__((vector_size(16)));
using FourInts = int __attribute__((vector_size(16)));

Four smaller(Four a, Four b) {
  return a < b ? a : b;
}
Four larger(Four a, Four b) {
  return a > b ? a : b;
}
/// Half of a reference; the index or the kind beside the numbers would be the tiniest of floats,
/// which are slow.
Four half_of(const BuildRef& ref, std::size_t half) {
  static_assert(sizeof(BuildRef) == 2 * sizeof(Four));
  Four v;
  std::memcpy(&v, reinterpret_cast<const std::byte*>(&ref) + half * sizeof(v), sizeof(v));
  v[3] = 0;
  return v;
}
Four lower_of(const BuildRef& ref) {
  return half_of(ref, 0);
}
Four upper_of(const BuildRef& ref) {
  return half_of(ref, 1);
}
/// Twice the centre, which is all that bins need.
Four center_of(const BuildRef& ref) {
  return lower_of(ref) + upper_of(ref);
}

struct Bounds {
  static constexpr float kInfinity = std::numeric_limits<float>::infinity();
  Four lower = {kInfinity, kInfinity, kInfinity, kInfinity};
  Four upper = -lower;

  void include(Four lo, Four up) {
    lower = smaller(lower, lo);
    upper = larger(upper, up);
  }
  void include(const Bounds& other) { include(other.lower, other.upper); }
  float half_area() const {
    const Four size = upper - lower;
    return size[0] < 0 ? 0 : size[0] * size[1] + size[1] * size[2] + size[2] * size[0];
  }
};

struct Range {
  BuildRef *begin, *end;
  Bounds bounds, centers;
  std::size_t size() const { return static_cast<std::size_t>(end - begin); }
};

Range range_of(BuildRef* begin, BuildRef* end) {
  Range range{begin, end, {}, {}};
  for (const BuildRef* r = begin; r != end; ++r) {
    range.bounds.include(lower_of(*r), upper_of(*r));
    const Four center = center_of(*r);
    range.centers.include(center, center);
  }
  return range;
}

struct Bin {
  Bounds bounds;
  std::size_t count = 0;
};
/// Bins along all three axes.
using Bins = std::array<std::array<Bin, kBins>, 3>;

/// Which bin a centre falls into along each axis; monotonous in the centre.
struct Binning {
  Four from, scale;
  int count;
  explicit Binning(const Range& range)
      : from(range.centers.lower), count(range.size() < kFewBinsSize ? kBins / 2 : kBins) {
    const Four extent = range.centers.upper - from;
    for (int a = 0; a < 4; ++a) {
      const float s = a < 3 ? static_cast<float>(count) / extent[a] : 0;
      scale[a] = s > 0 && s < std::numeric_limits<float>::max() ? s : 0;  // 0: no extent, no bins
    }
  }
  std::size_t bin(const BuildRef& ref, std::size_t axis) const {
    const Four place = (center_of(ref) - from) * scale;
    return bin_at(static_cast<int>(place[static_cast<int>(axis)]));
  }
  std::size_t bin_at(int place) const {
    return static_cast<std::size_t>(std::clamp(place, 0, count - 1));
  }
};

Bins binned(const BuildRef* begin, const BuildRef* end, const Binning& binning) {
  Bins bins;
  for (const BuildRef* r = begin; r != end; ++r) {
    const Four lower = lower_of(*r), upper = upper_of(*r);
    const auto place =
        __builtin_convertvector((lower + upper - binning.from) * binning.scale, FourInts);
    for (std::size_t axis = 0; axis < 3; ++axis) {
      Bin& bin = bins[axis][binning.bin_at(place[static_cast<int>(axis)])];
      bin.bounds.include(lower, upper);
      ++bin.count;
    }
  }
  return bins;
}

/// The bins of a large range by several tasks; minima, maxima and counts do not depend on how it is
/// cut.
Bins binned_by_tasks(const Range& range, const Binning& binning) {
  if (range.size() < 16 * kTaskSize) return binned(range.begin, range.end, binning);
  Handover handover;
  handover.give();
  const Bins bins = tbb::parallel_reduce(
      tbb::blocked_range<BuildRef*>(range.begin, range.end, 4 * kTaskSize), Bins(),
      [&](const tbb::blocked_range<BuildRef*>& part, Bins sum) {
        handover.take();
        const Bins more = binned(part.begin(), part.end(), binning);
        for (std::size_t axis = 0; axis < 3; ++axis)
          for (std::size_t b = 0; b < kBins; ++b) {
            sum[axis][b].bounds.include(more[axis][b].bounds);
            sum[axis][b].count += more[axis][b].count;
          }
        handover.give();
        return sum;
      },
      [](Bins a, const Bins& b) {
        for (std::size_t axis = 0; axis < 3; ++axis)
          for (std::size_t i = 0; i < kBins; ++i) {
            a[axis][i].bounds.include(b[axis][i].bounds);
            a[axis][i].count += b[axis][i].count;
          }
        return a;
      });
  handover.take();
  return bins;
}

struct Split {
  std::size_t axis = 3;  // 3: none was found
  std::size_t bin = 0;   // the first of the right side
  float cost = std::numeric_limits<float>::infinity();
};

Split best_split(const Range& range, const Binning& binning) {
  const Bins bins = binned_by_tasks(range, binning);
  Split best;
  for (std::size_t axis = 0; axis < 3; ++axis) {
    if (!(binning.scale[static_cast<int>(axis)] > 0)) continue;
    // Costs of everything left of each border, then from the right.
    const auto count = static_cast<std::size_t>(binning.count);
    std::array<float, kBins> left{};
    Bin sum;
    for (std::size_t b = 0; b + 1 < count; ++b) {
      sum.bounds.include(bins[axis][b].bounds);
      sum.count += bins[axis][b].count;
      left[b + 1] = sum.bounds.half_area() * static_cast<float>(sum.count);
    }
    sum = {};
    for (std::size_t b = count - 1; b > 0; --b) {
      sum.bounds.include(bins[axis][b].bounds);
      sum.count += bins[axis][b].count;
      if (sum.count == 0 || sum.count == range.size()) continue;
      const float cost = left[b] + sum.bounds.half_area() * static_cast<float>(sum.count);
      if (cost < best.cost) best = {axis, b, cost};
    }
  }
  return best;
}

/// Two parts of a range, neither empty; the range has at least two references.
std::pair<Range, Range> split(const Range& range, int depth) {
  const Binning binning(range);
  const Split best = depth < kFreeDepth ? best_split(range, binning) : Split{};
  if (best.axis == 3) {  // equal centres: any halves will do
    BuildRef* middle = range.begin + range.size() / 2;
    return {range_of(range.begin, middle), range_of(middle, range.end)};
  }
  // From both ends at once, and the bounds of the parts on the way.
  Range left{range.begin, range.begin, {}, {}}, right{range.end, range.end, {}, {}};
  const auto take = [](Range& side, const BuildRef& ref) {
    side.bounds.include(lower_of(ref), upper_of(ref));
    side.centers.include(center_of(ref), center_of(ref));
  };
  while (left.end != right.begin) {
    if (binning.bin(*left.end, best.axis) < best.bin) {
      take(left, *left.end++);
    } else {
      std::swap(*left.end, *--right.begin);
      take(right, *right.begin);
    }
  }
  return {left, right};
}

bool one_kind(const Range& range) {
  return std::all_of(range.begin, range.end,
                     [&](const BuildRef& r) { return r.kind == range.begin->kind; });
}

/// A leaf holds one kind; a small range of several is cut where the kinds change.
bool can_be_leaf(const Range& range, std::size_t most) {
  return range.size() <= most && one_kind(range);
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
  struct Child {
    BuildRef *begin, *end;
    Bounds bounds;
    std::unique_ptr<BuildNode> node;  // null for a leaf
  };
  std::vector<Child> children;
};

std::unique_ptr<BuildNode> build_node(const Range& whole, int depth) {
  std::vector<Range> ranges = {whole};
  ranges.reserve(kNodeWidth);
  // Always splits what costs most, until sixteen children are there.
  while (ranges.size() < kNodeWidth) {
    Range* widest = nullptr;
    float most = -1;
    for (Range& range : ranges) {
      if (can_be_leaf(range, kSmallLeaf)) continue;
      const auto size = static_cast<float>(range.size());
      const float cost = depth < kFreeDepth ? range.bounds.half_area() * size : size;
      if (widest == nullptr || cost > most) most = cost, widest = &range;
    }
    if (widest == nullptr) break;
    auto [left, right] =
        widest->size() <= kSmallLeaf ? split_kinds(*widest) : split(*widest, depth);
    *widest = left;
    ranges.push_back(right);
  }
  auto node = std::make_unique<BuildNode>();
  node->children.resize(ranges.size());
  tbb::task_group tasks;
  Handover to_tasks, from_tasks;
  to_tasks.give();
  for (std::size_t i = 0; i < ranges.size(); ++i) {
    BuildNode::Child& child = node->children[i];
    child.begin = ranges[i].begin;
    child.end = ranges[i].end;
    child.bounds = ranges[i].bounds;
    if (can_be_leaf(ranges[i], kLargeLeaf)) continue;
    const auto build = [&child, &range = ranges[i], depth] {
      child.node = build_node(range, depth + 1);
    };
    if (ranges[i].size() >= kTaskSize)
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

  /// Takes the nodes apart as it goes.
  std::int32_t place(std::unique_ptr<BuildNode> from) {
    const std::size_t at = out_.nodes.size();
    out_.nodes.emplace_back();
    Node node;
    for (std::size_t i = 0; i < kNodeWidth; ++i) {
      const bool there = i < from->children.size();
      const Bounds bounds = there ? from->children[i].bounds : Bounds{};
      node.lower_x[i] = bounds.lower[0], node.lower_y[i] = bounds.lower[1],
      node.lower_z[i] = bounds.lower[2];
      node.upper_x[i] = bounds.upper[0], node.upper_y[i] = bounds.upper[1],
      node.upper_z[i] = bounds.upper[2];
      node.child[i] = node.leaf[i] = 0;
      if (!there) continue;
      BuildNode::Child& child = from->children[i];
      if (child.node != nullptr)
        node.child[i] = place(std::move(child.node));
      else
        place_leaf(child, node.child[i], node.leaf[i]);
    }
    out_.nodes[at] = node;
    return static_cast<std::int32_t>(at);
  }

 private:
  void place_leaf(const BuildNode::Child& range, std::int32_t& child, std::int32_t& leaf) {
    const std::int32_t kind = range.begin->kind;
    std::vector<std::int32_t>& order = out_.order[static_cast<std::size_t>(kind)];
    child = static_cast<std::int32_t>(order.size());
    leaf = static_cast<std::int32_t>(range.end - range.begin) + 2 * kNodeWidth * kind;
    for (const BuildRef* r = range.begin; r != range.end; ++r) order.push_back(r->index);
  }
  BuiltHierarchy& out_;
};

std::size_t count_nodes(const BuildNode& node) {
  std::size_t count = 1;
  for (const BuildNode::Child& child : node.children)
    if (child.node != nullptr) count += count_nodes(*child.node);
  return count;
}

}  // namespace

BuiltHierarchy build_hierarchy(std::vector<BuildRef>& refs, int kinds) {
  BuiltHierarchy built;
  built.order.resize(static_cast<std::size_t>(kinds));
  if (refs.empty()) return built;
  auto root = build_node(range_of(refs.data(), refs.data() + refs.size()), 0);
  built.nodes.reserve(count_nodes(*root));
  std::vector<std::size_t> sizes(built.order.size(), 0);
  for (const BuildRef& ref : refs) ++sizes[static_cast<std::size_t>(ref.kind)];
  for (std::size_t kind = 0; kind < sizes.size(); ++kind) built.order[kind].reserve(sizes[kind]);
  Placement(built).place(std::move(root));
  return built;
}

}  // namespace zraka
