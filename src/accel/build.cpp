// SPDX-License-Identifier: Apache-2.0
#include "accel/build.hpp"

#include <tbb/task_group.h>

#include <algorithm>
#include <cstddef>
#include <cstring>
#include <mutex>
#include <new>
#include <utility>

#include "accel/grid.hpp"
#include "core/handover.hpp"

namespace zraka {
namespace {

/// Ranges up to this size are split further only where that shrinks what rays meet to kWorthwhile:
/// thin shapes apart from each other, but not neighbours of a mesh.
constexpr std::size_t kSmallLeaf = 4;
constexpr float kWorthwhile = 0.5F;
/// Scenes from this size on take longer to build than to render: there such ranges stay whole.
constexpr std::size_t kLargeScene = std::size_t{1} << 20;
/// Ranges up to this size are leaves rather than nodes of their own; a vector of shapes costs
/// hardly more than one. In large scenes they may fill a leaf, which saves a quarter of the nodes.
constexpr std::size_t kLargeLeaf = 12;
/// Ranges from this size on are cut into sixteen at once.
constexpr std::size_t kGridSize = 16384;
/// Below this many levels of nodes ranges are halved, whatever the heuristic says: that bounds the
/// traversal's stack.
constexpr int kFreeDepth = kMaxNodeDepth - 16;

/// Nodes from many threads, before they have their places.
class NodePool {
 public:
  std::int32_t add(const Node& node) {
    const std::lock_guard<std::mutex> lock(mutex_);
    if (size_ % kChunk == 0) chunks_.push_back(std::make_unique<Node[]>(kChunk));
    chunks_[size_ / kChunk][size_ % kChunk] = node;
    return static_cast<std::int32_t>(size_++);
  }
  std::size_t size() const { return size_; }
  const Node& operator[](std::int32_t i) const {
    return chunks_[static_cast<std::size_t>(i) / kChunk][static_cast<std::size_t>(i) % kChunk];
  }

 private:
  static constexpr std::size_t kChunk = 1024;
  std::mutex mutex_;
  std::vector<std::unique_ptr<Node[]>> chunks_;
  std::size_t size_ = 0;
};

class Builder {
 public:
  Builder(BuildRef* refs, const std::vector<std::int32_t>& kind_starts)
      : refs_(refs),
        kind_starts_(kind_starts),
        large_scene_(static_cast<std::size_t>(kind_starts.back()) >= kLargeScene) {}

  /// The node of a range, its children before it; a leaf's child is its first reference's place.
  std::int32_t build_node(Range whole, int depth);
  const NodePool& pool() const { return pool_; }

 private:
  std::int32_t kind_of(const BuildRef& ref) const {
    std::size_t kind = 0;
    while (ref.index >= kind_starts_[kind + 1]) ++kind;
    return static_cast<std::int32_t>(kind);
  }
  bool one_kind(const Range& range) const {
    return std::all_of(range.begin, range.end,
                       [&](const BuildRef& r) { return kind_of(r) == kind_of(*range.begin); });
  }
  /// A leaf holds one kind; a small range of several is cut where the kinds change.
  bool can_be_leaf(const Range& range, std::size_t most) const {
    return range.size() <= most && one_kind(range);
  }
  std::pair<Range, Range> split_kinds(const Range& range) const {
    std::sort(range.begin, range.end,
              [](const BuildRef& a, const BuildRef& b) { return a.index < b.index; });
    BuildRef* middle = std::find_if(range.begin, range.end, [&](const BuildRef& r) {
      return kind_of(r) != kind_of(*range.begin);
    });
    return {range_of(range.begin, middle), range_of(middle, range.end)};
  }
  void split_greedily(std::vector<Range>& ranges, int depth) const;

  BuildRef* refs_;
  const std::vector<std::int32_t>& kind_starts_;
  const bool large_scene_;
  NodePool pool_;
};

/// Always splits what costs most, until sixteen children are there.
void Builder::split_greedily(std::vector<Range>& ranges, int depth) const {
  std::uint32_t whole = 0;  // those that stay as they are, a bit each
  while (ranges.size() < kNodeWidth) {
    std::size_t best = ranges.size();
    float most = -1;
    for (std::size_t i = 0; i < ranges.size(); ++i) {
      const Range& range = ranges[i];
      if (range.size() < 2 || (whole >> i & 1) != 0) continue;
      if (large_scene_ && can_be_leaf(range, kSmallLeaf)) continue;
      const float cost = depth < kFreeDepth ? range.cost() : static_cast<float>(range.size());
      if (best == ranges.size() || cost > most) most = cost, best = i;
    }
    if (best == ranges.size()) return;
    const Range range = ranges[best];
    const bool few = range.size() <= kSmallLeaf, could_stay = few && one_kind(range);
    const auto [left, right] =
        few && !could_stay ? split_kinds(range) : split(range, depth >= kFreeDepth);
    if (could_stay && !(left.cost() + right.cost() <= kWorthwhile * range.cost())) {
      whole |= 1u << best;
      continue;
    }
    ranges[best] = left;
    ranges.push_back(right);
  }
}

std::int32_t Builder::build_node(Range whole, int depth) {
  if (whole.centers.empty()) whole.centers = centers_by_tasks(whole.begin, whole.end);
  std::vector<Range> ranges;
  ranges.reserve(kNodeWidth);
  if (whole.size() >= kGridSize && depth < kFreeDepth) {
    const Binning binning(whole, kBins);
    ranges = counted(whole, binning).cut(whole, kNodeWidth);
  } else {
    ranges = {whole};
    split_greedily(ranges, depth);
  }
  if (ranges.size() < 2) split_greedily(ranges, depth);

  Node node;
  for (std::size_t i = 0; i < kNodeWidth; ++i) {
    const Bounds bounds = i < ranges.size() ? ranges[i].bounds : Bounds{};
    node.lower_x[i] = bounds.lower[0], node.lower_y[i] = bounds.lower[1],
    node.lower_z[i] = bounds.lower[2];
    node.upper_x[i] = bounds.upper[0], node.upper_y[i] = bounds.upper[1],
    node.upper_z[i] = bounds.upper[2];
    node.child[i] = 0;
    node.leaf[i] = i < ranges.size() ? 0 : kNoChild;
  }
  tbb::task_group tasks;
  Handover to_tasks, from_tasks;
  to_tasks.give();
  for (std::size_t i = 0; i < ranges.size(); ++i) {
    const Range& range = ranges[i];
    if (can_be_leaf(range, large_scene_ ? std::size_t{kNodeWidth} : kLargeLeaf)) {
      node.child[i] = static_cast<std::int32_t>(range.begin - refs_);
      node.leaf[i] =
          static_cast<std::int32_t>(range.size()) + 2 * kNodeWidth * kind_of(*range.begin);
    } else if (range.size() >= kTaskSize) {
      tasks.run([&, i, depth] {
        to_tasks.take();
        node.child[i] = build_node(range, depth + 1);
        from_tasks.give();
      });
    } else {
      node.child[i] = build_node(range, depth + 1);
    }
  }
  tasks.wait();
  from_tasks.take();
  return pool_.add(node);
}

/// Nodes into their places, depth first; leaves count their primitives by `place_in_kind`, if there
/// are several kinds.
std::int32_t place(const NodePool& pool, std::int32_t from,
                   const std::vector<std::int32_t>& place_in_kind, std::vector<Node>& nodes) {
  const std::size_t at = nodes.size();
  nodes.push_back(pool[from]);
  for (std::size_t i = 0; i < kNodeWidth; ++i) {
    const bool there = nodes[at].lower_x[i] <= nodes[at].upper_x[i];
    const std::int32_t child = nodes[at].child[i];
    if (!there) continue;
    if (nodes[at].leaf[i] == 0)
      nodes[at].child[i] = place(pool, child, place_in_kind, nodes);
    else if (!place_in_kind.empty())
      nodes[at].child[i] = place_in_kind[static_cast<std::size_t>(child)];
  }
  return static_cast<std::int32_t>(at);
}

}  // namespace

BuildRefs::BuildRefs(std::size_t size)
    : memory_(std::malloc(std::max<std::size_t>(size, 1) * sizeof(BuildRef))), size_(size) {
  if (memory_ == nullptr) throw std::bad_alloc();
}

std::vector<std::int32_t> BuildRefs::into_indices() && {
  // Index i lies before reference i, so it can be written there at once.
  auto* bytes = static_cast<std::byte*>(memory_.get());
  for (std::size_t i = 0; i < size_; ++i)
    std::memmove(bytes + i * sizeof(std::int32_t),
                 bytes + i * sizeof(BuildRef) + offsetof(BuildRef, index), sizeof(std::int32_t));
  void* less = std::realloc(memory_.get(), std::max<std::size_t>(size_, 1) * sizeof(std::int32_t));
  if (less != nullptr) {
    (void)memory_.release();
    memory_.reset(less);
  }
  std::vector<std::int32_t> indices(size_);
  if (size_ > 0) std::memcpy(indices.data(), memory_.get(), size_ * sizeof(std::int32_t));
  memory_.reset();
  size_ = 0;
  return indices;
}

BuiltHierarchy build_hierarchy(BuildRefs refs, const std::vector<std::int32_t>& kind_starts) {
  BuiltHierarchy built;
  if (refs.size() == 0) return built;
  Builder builder(refs.data(), kind_starts);
  Range all{refs.begin(), refs.end(), {}, {}};
  if (refs.size() < kGridSize) all = range_of(refs.begin(), refs.end());
  const std::int32_t root = builder.build_node(all, 0);
  built.order = std::move(refs).into_indices();

  // By kinds: each kind's primitives in the order that they have among all.
  const auto kinds = static_cast<std::size_t>(
      std::count_if(kind_starts.begin() + 1, kind_starts.end(),
                    [before = kind_starts.front()](std::int32_t start) mutable {
                      return std::exchange(before, start) != start;
                    }));
  std::vector<std::int32_t> place_in_kind;
  if (kinds > 1) {
    place_in_kind.resize(built.order.size());
    std::vector<std::int32_t> grouped(built.order.size());
    std::vector<std::int32_t> next = kind_starts;
    for (std::size_t i = 0; i < built.order.size(); ++i) {
      std::size_t kind = 0;
      while (built.order[i] >= kind_starts[kind + 1]) ++kind;
      place_in_kind[i] = next[kind] - kind_starts[kind];
      grouped[static_cast<std::size_t>(next[kind]++)] = built.order[i];
    }
    built.order = std::move(grouped);
  }
  built.nodes.reserve(builder.pool().size());
  place(builder.pool(), root, place_in_kind, built.nodes);
  return built;
}

}  // namespace zraka
