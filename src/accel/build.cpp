// SPDX-License-Identifier: Apache-2.0
#include "accel/build.hpp"

#include <tbb/task_group.h>

#include <algorithm>
#include <cstddef>
#include <cstring>
#include <mutex>
#include <new>
#include <utility>

#include "accel/collapse.hpp"
#include "accel/grid.hpp"
#include "core/handover.hpp"

namespace zraka {
namespace {

/// From the first size on nodes do not stay in a core's cache and cost more; scenes from the second
/// on take longer to build than to render, and memory.
constexpr std::size_t kLargeScene = std::size_t{1} << 16, kHugeScene = std::size_t{1} << 20;
CollapseRules rules_for(std::size_t shapes) {
  if (shapes < kLargeScene) return {1, 12, 2, false};
  if (shapes < kHugeScene) return {1, kNodeWidth, 8, true};
  return {8, kNodeWidth, 8, true};
}
/// Ranges from this size on are cut into sixteen at once.
constexpr std::size_t kGridSize = 16384;
/// Children of such nodes from this size on are built by a task each.
constexpr std::size_t kChildTaskSize = 512;
/// Below this many levels of nodes such ranges are cut by numbers, whatever the heuristic says:
/// that bounds the traversal's stack, with five levels for 2^31 shapes and sixteen for kGridSize.
constexpr int kFreeDepth = kMaxNodeDepth - 21;

/// Nodes from many threads, before they are laid out.
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

void set_box(Node& node, std::size_t i, const BuildBounds& bounds) {
  node.lower_x[i] = bounds.lower[0], node.lower_y[i] = bounds.lower[1],
  node.lower_z[i] = bounds.lower[2];
  node.upper_x[i] = bounds.upper[0], node.upper_y[i] = bounds.upper[1],
  node.upper_z[i] = bounds.upper[2];
}

class Builder {
 public:
  Builder(BuildRef* refs, const std::vector<std::int32_t>& kind_starts,
          const std::atomic<bool>* cancel)
      : refs_(refs),
        cancel_(cancel),
        kinds_(kind_starts),
        rules_(rules_for(static_cast<std::size_t>(kind_starts.back()))) {}

  /// The root's number in the pool; a leaf's child is its first reference's index.
  std::int32_t build(const Range& all);
  const NodePool& pool() const { return pool_; }
  bool cancelled() const { return cancel_ != nullptr && cancel_->load(std::memory_order_relaxed); }

 private:
  Collapse collapse(const Range& range, int depth) const;
  std::int32_t add_node(const Range& whole, int depth);
  std::int32_t add_node(const Collapse& collapse, const Collapse::Part& part);
  void set_child(Node& node, std::size_t i, const Range& range, int depth);
  void set_child(Node& node, std::size_t i, const Collapse& collapse, const Collapse::Part& part);

  BuildRef* refs_;
  const std::atomic<bool>* cancel_;
  const Kinds kinds_;
  const CollapseRules rules_;
  NodePool pool_;
};

Node empty_node() {
  Node node{};
  for (std::size_t i = 0; i < kNodeWidth; ++i) {
    set_box(node, i, {});
    node.child[i] = 0;
    node.leaf[i] = kNoChild;
  }
  return node;
}

/// The sets of a node's children, from each child's own words.
void set_sets(Node& node) {
  const auto add = [](std::uint16_t& set, auto i) {
    set = static_cast<std::uint16_t>(set | 1u << i);
  };
  for (std::size_t i = 0; i < kNodeWidth; ++i) {
    const std::int32_t leaf = node.leaf[i];
    if (leaf == kNoChild) continue;
    add(node.children, i);
    if (leaf == 0 || leaf_count(leaf) > kMostInSmallLeaf) continue;
    add(node.small_leaves[leaf_kind(leaf)][leaf_count(leaf) - 1], i);
    add(node.small_kinds, leaf_kind(leaf));
  }
}

/// Ranges of equal size.
std::vector<Range> sixteenths(const Range& range) {
  std::vector<Range> ranges;
  for (std::size_t i = 0; i < kNodeWidth; ++i)
    ranges.push_back(range_of(range.begin + range.size() * i / kNodeWidth,
                              range.begin + range.size() * (i + 1) / kNodeWidth));
  return ranges;
}

std::int32_t Builder::build(const Range& all) {
  if (all.size() >= kGridSize) return add_node(all, 0);
  const Collapse whole = collapse(all, 0);
  if (!whole.whole().leaf) return add_node(whole, whole.whole());
  Node node = empty_node();
  set_child(node, 0, whole, whole.whole());
  return pool_.add(node);
}

Collapse Builder::collapse(const Range& range, int depth) const {
  return {range.centers.empty() ? range_of(range.begin, range.end) : range, kMaxNodeDepth - depth,
          kinds_, rules_};
}

/// The node of a large range, its children before it.
std::int32_t Builder::add_node(const Range& whole, int depth) {
  std::vector<Range> ranges;
  if (depth < kFreeDepth) {
    Range range = whole;
    if (range.centers.empty()) range.centers = centers_by_tasks(whole.begin, whole.end);
    ranges = counted(range, Binning(range, kBins)).cut(range, kNodeWidth);
  }
  if (ranges.size() < 2) ranges = sixteenths(whole);

  Node node = empty_node();
  tbb::task_group tasks;
  Handover to_tasks, from_tasks;
  to_tasks.give();
  for (std::size_t i = 0; i < ranges.size(); ++i) {
    const Range& range = ranges[i];
    if (range.size() >= kChildTaskSize)
      tasks.run([&, i, depth] {
        to_tasks.take();
        set_child(node, i, range, depth + 1);
        from_tasks.give();
      });
    else
      set_child(node, i, range, depth + 1);
  }
  tasks.wait();
  from_tasks.take();
  return pool_.add(node);
}

std::int32_t Builder::add_node(const Collapse& collapse, const Collapse::Part& part) {
  Node node = empty_node();
  std::size_t i = 0;
  collapse.each_child(part,
                      [&](const Collapse::Part& child) { set_child(node, i++, collapse, child); });
  return pool_.add(node);
}

void Builder::set_child(Node& node, std::size_t i, const Range& range, int depth) {
  if (cancelled()) return;  // nobody will look at the node
  if (range.size() >= kGridSize) {
    set_box(node, i, range.bounds);
    node.leaf[i] = 0;
    node.child[i] = add_node(range, depth);
  } else {
    const Collapse parts = collapse(range, depth);
    set_child(node, i, parts, parts.whole());
  }
}

void Builder::set_child(Node& node, std::size_t i, const Collapse& collapse,
                        const Collapse::Part& part) {
  set_box(node, i, part.bounds);
  if (part.leaf) {
    node.child[i] = static_cast<std::int32_t>(part.begin - refs_);
    node.leaf[i] = leaf_of(static_cast<std::int32_t>(part.size()), kinds_.of(*part.begin));
  } else {
    node.child[i] = add_node(collapse, part);
    node.leaf[i] = 0;
  }
}

/// Lays the nodes out, depth first; leaves count their primitives by `index_in_kind`, if there
/// are several kinds.
std::int32_t lay_out(const NodePool& pool, std::int32_t from,
                     const std::vector<std::int32_t>& index_in_kind, std::vector<Node>& nodes) {
  const std::size_t at = nodes.size();
  nodes.push_back(pool[from]);
  set_sets(nodes[at]);
  for (std::size_t i = 0; i < kNodeWidth; ++i) {
    const std::int32_t child = nodes[at].child[i];
    if (nodes[at].leaf[i] == kNoChild) continue;
    if (nodes[at].leaf[i] == 0)
      nodes[at].child[i] = lay_out(pool, child, index_in_kind, nodes);
    else if (!index_in_kind.empty())
      nodes[at].child[i] = index_in_kind[static_cast<std::size_t>(child)];
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

BuiltHierarchy build_hierarchy(BuildRefs refs, const std::vector<std::int32_t>& kind_starts,
                               const std::atomic<bool>* cancel) {
  BuiltHierarchy built;
  if (refs.size() == 0) return built;
  Builder builder(refs.data(), kind_starts, cancel);
  Range all{refs.begin(), refs.end(), {}, {}};
  if (refs.size() < kGridSize) all = range_of(refs.begin(), refs.end());
  const std::int32_t root = builder.build(all);
  if (builder.cancelled()) return built;
  built.order = std::move(refs).into_indices();

  // By kinds: each kind's primitives in the order that they have among all.
  const auto kinds = static_cast<std::size_t>(
      std::count_if(kind_starts.begin() + 1, kind_starts.end(),
                    [before = kind_starts.front()](std::int32_t start) mutable {
                      return std::exchange(before, start) != start;
                    }));
  std::vector<std::int32_t> index_in_kind;
  if (kinds > 1) {
    index_in_kind.resize(built.order.size());
    std::vector<std::int32_t> grouped(built.order.size());
    if (grouped.size() < kHugeScene) built.rank.resize(grouped.size());
    std::vector<std::int32_t> next = kind_starts;
    for (std::size_t i = 0; i < built.order.size(); ++i) {
      std::size_t kind = 0;
      while (built.order[i] >= kind_starts[kind + 1]) ++kind;
      index_in_kind[i] = next[kind] - kind_starts[kind];
      if (!built.rank.empty())
        built.rank[static_cast<std::size_t>(next[kind])] = static_cast<std::int32_t>(i);
      grouped[static_cast<std::size_t>(next[kind]++)] = built.order[i];
    }
    built.order = std::move(grouped);
  }
  built.nodes.reserve(builder.pool().size());
  lay_out(builder.pool(), root, index_in_kind, built.nodes);
  return built;
}

}  // namespace zraka
