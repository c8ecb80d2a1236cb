// SPDX-License-Identifier: Apache-2.0
#include "accel/build.hpp"

#include <tbb/blocked_range.h>
#include <tbb/parallel_reduce.h>
#include <tbb/task_group.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstring>
#include <limits>
#include <mutex>
#include <new>
#include <utility>

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
/// Ranges from this size on are cut into sixteen at once.
constexpr std::size_t kGridSize = 16384;
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
/// Three numbers from here on, and any fourth that can be read.
Four four_at(const float* p) {
  Four v;
  std::memcpy(&v, p, sizeof(v));
  return v;
}
Four lower_of(const BuildRef& ref) {
  return four_at(ref.lower);
}
Four upper_of(const BuildRef& ref) {
  static_assert(offsetof(BuildRef, index) == offsetof(BuildRef, upper) + sizeof(ref.upper));
  Four v = four_at(ref.upper);
  v[3] = 0;  // an index would be the tiniest of floats, which are slow
  return v;
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
  bool empty() const { return !(lower[0] <= upper[0]); }
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

Bounds centers_of(const BuildRef* begin, const BuildRef* end) {
  Bounds centers;
  for (const BuildRef* r = begin; r != end; ++r) {
    const Four center = center_of(*r);
    centers.include(center, center);
  }
  return centers;
}

Bounds centers_by_tasks(const BuildRef* begin, const BuildRef* end) {
  Handover handover;
  handover.give();
  const Bounds centers = tbb::parallel_reduce(
      tbb::blocked_range<const BuildRef*>(begin, end, 16 * kTaskSize), Bounds(),
      [&](const tbb::blocked_range<const BuildRef*>& part, Bounds sum) {
        handover.take();
        sum.include(centers_of(part.begin(), part.end()));
        handover.give();
        return sum;
      },
      [](Bounds a, const Bounds& b) {
        a.include(b);
        return a;
      });
  handover.take();
  return centers;
}

struct Bin {
  Bounds bounds;
  std::uint32_t count = 0;
};

/// Which bin a centre falls into along each axis; monotonous in the centre.
struct Binning {
  Four from, scale, last;
  int count;
  explicit Binning(const Range& range)
      : Binning(range, range.size() < kFewBinsSize ? kBins / 2 : kBins) {}
  Binning(const Range& range, int bins) : from(range.centers.lower), count(bins) {
    const Four extent = range.centers.upper - from;
    for (int a = 0; a < 4; ++a) {
      const float s = a < 3 ? static_cast<float>(count) / extent[a] : 0;
      scale[a] = s > 0 && s < std::numeric_limits<float>::max() ? s : 0;  // 0: no extent, no bins
      last[a] = static_cast<float>(count - 1);
    }
  }
  FourInts bins_of(Four lower, Four upper) const {
    const Four place = smaller((lower + upper - from) * scale, last);
    return __builtin_convertvector(larger(place, Four{}), FourInts);
  }
};

/// Bins along all three axes.
class Bins {
 public:
  explicit Bins(int count) : count_(static_cast<std::size_t>(count)) {
    for (std::size_t i = 0; i < 3 * count_; ++i) new (bins_ + i) Bin;
  }
  std::size_t count() const { return count_; }
  Bin& at(std::size_t axis, std::size_t i) { return bins_[axis * count_ + i]; }
  const Bin& at(std::size_t axis, std::size_t i) const { return bins_[axis * count_ + i]; }
  void add(const Bins& other) {
    for (std::size_t i = 0; i < 3 * count_; ++i) {
      bins_[i].bounds.include(other.bins_[i].bounds);
      bins_[i].count += other.bins_[i].count;
    }
  }

 private:
  std::size_t count_;
  union {
    Bin bins_[3 * kBins];  // as many as are counted
  };
};

Bins binned(const BuildRef* begin, const BuildRef* end, const Binning& binning) {
  Bins bins(binning.count);
  for (const BuildRef* r = begin; r != end; ++r) {
    const Four lower = lower_of(*r), upper = upper_of(*r);
    const FourInts places = binning.bins_of(lower, upper);
    for (std::size_t axis = 0; axis < 3; ++axis) {
      Bin& bin = bins.at(axis, static_cast<std::size_t>(places[static_cast<int>(axis)]));
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
      tbb::blocked_range<BuildRef*>(range.begin, range.end, 4 * kTaskSize), Bins(binning.count),
      [&](const tbb::blocked_range<BuildRef*>& part, Bins sum) {
        handover.take();
        sum.add(binned(part.begin(), part.end(), binning));
        handover.give();
        return sum;
      },
      [](Bins a, const Bins& b) {
        a.add(b);
        return a;
      });
  handover.take();
  return bins;
}

struct Split {
  std::size_t axis = 3;  // 3: none was found
  std::size_t bin = 0;   // the first of the right side
  float cost = std::numeric_limits<float>::infinity();
  Bounds left, right;
};

Split best_split(const Range& range, const Binning& binning) {
  const Bins bins = binned_by_tasks(range, binning);
  Split best;
  for (std::size_t axis = 0; axis < 3; ++axis) {
    if (!(binning.scale[static_cast<int>(axis)] > 0)) continue;
    // Costs of everything left of each border, then from the right.
    const std::size_t count = bins.count();
    std::array<float, kBins> left{};
    Bin sum;
    for (std::size_t b = 0; b + 1 < count; ++b) {
      sum.bounds.include(bins.at(axis, b).bounds);
      sum.count += bins.at(axis, b).count;
      left[b + 1] = sum.bounds.half_area() * static_cast<float>(sum.count);
    }
    sum = {};
    for (std::size_t b = count - 1; b > 0; --b) {
      sum.bounds.include(bins.at(axis, b).bounds);
      sum.count += bins.at(axis, b).count;
      if (sum.count == 0 || sum.count == range.size()) continue;
      const float cost = left[b] + sum.bounds.half_area() * static_cast<float>(sum.count);
      if (cost < best.cost) best = {axis, b, cost, {}, sum.bounds};
    }
  }
  for (std::size_t b = 0; b < best.bin; ++b) best.left.include(bins.at(best.axis, b).bounds);
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
  // From both ends at once.
  const auto axis = static_cast<int>(best.axis), border = static_cast<int>(best.bin);
  BuildRef* middle = std::partition(range.begin, range.end, [&](const BuildRef& ref) {
    return binning.bins_of(lower_of(ref), upper_of(ref))[axis] < border;
  });
  Range left{range.begin, middle, best.left, centers_of(range.begin, middle)};
  Range right{middle, range.end, best.right, centers_of(middle, range.end)};
  return {left, right};
}

/// A range's references counted by cells of their centres, 16 a side: four levels of splits from
/// one look at the references.
class Grid {
 public:
  explicit Grid(const Binning& binning) : binning_(binning), bounds_(kCells), counts_(kCells, 0) {}

  std::size_t cell_of(const BuildRef& ref) const {
    const FourInts at = binning_.bins_of(lower_of(ref), upper_of(ref));
    return static_cast<std::size_t>((at[2] * kSide + at[1]) * kSide + at[0]);
  }
  void count(const BuildRef* begin, const BuildRef* end) {
    for (const BuildRef* r = begin; r != end; ++r) {
      const std::size_t cell = cell_of(*r);
      bounds_[cell].include(lower_of(*r), upper_of(*r));
      ++counts_[cell];
    }
  }
  void add(const Grid& other) {
    for (std::size_t i = 0; i < kCells; ++i) {
      bounds_[i].include(other.bounds_[i]);
      counts_[i] += other.counts_[i];
    }
  }
  /// At most `most` ranges, each with its bounds but not those of its centres, in place of one;
  /// fewer than two where all references lie in one cell.
  std::vector<Range> cut(const Range& range, std::size_t most) const;

 private:
  static constexpr int kSide = 16;
  static constexpr std::size_t kCells = std::size_t{kSide} * kSide * kSide;

  /// A box of cells, and where to split it best.
  struct Block {
    int from[3] = {0, 0, 0}, to[3] = {kSide, kSide, kSide};
    Bounds bounds;
    std::size_t count = 0;
    int axis = 3, border = 0;  // 3: cannot be split
  };
  template <class Function>
  static void each_cell(const Block& block, const Function& function) {
    for (int z = block.from[2]; z < block.to[2]; ++z)
      for (int y = block.from[1]; y < block.to[1]; ++y)
        for (int x = block.from[0]; x < block.to[0]; ++x)
          function(static_cast<std::size_t>((z * kSide + y) * kSide + x), x, y, z);
  }
  void look_into(Block& block) const;

  Binning binning_;
  std::vector<Bounds> bounds_;
  std::vector<std::uint32_t> counts_;
};

/// Its bounds, its count, and its best split.
void Grid::look_into(Block& block) const {
  std::array<std::array<Bin, kSide>, 3> slabs;
  each_cell(block, [&](std::size_t cell, int x, int y, int z) {
    if (counts_[cell] == 0) return;
    for (const auto& [axis, at] : {std::pair(0, x), std::pair(1, y), std::pair(2, z)}) {
      Bin& slab = slabs[static_cast<std::size_t>(axis)][static_cast<std::size_t>(at)];
      slab.bounds.include(bounds_[cell]);
      slab.count += counts_[cell];
    }
  });
  block.bounds = {};
  block.count = 0;
  block.axis = 3;
  for (const Bin& slab : slabs[0]) {
    block.bounds.include(slab.bounds);
    block.count += slab.count;
  }
  float best = std::numeric_limits<float>::infinity();
  for (std::size_t axis = 0; axis < 3; ++axis) {
    std::array<float, kSide> left{};
    Bin sum;
    for (std::size_t i = 0; i + 1 < kSide; ++i) {
      sum.bounds.include(slabs[axis][i].bounds);
      sum.count += slabs[axis][i].count;
      left[i + 1] = sum.bounds.half_area() * static_cast<float>(sum.count);
    }
    sum = {};
    for (std::size_t i = kSide - 1; i > 0; --i) {
      sum.bounds.include(slabs[axis][i].bounds);
      sum.count += slabs[axis][i].count;
      if (sum.count == 0 || sum.count == block.count) continue;
      const float cost = left[i] + sum.bounds.half_area() * static_cast<float>(sum.count);
      if (cost >= best) continue;
      best = cost;
      block.axis = static_cast<int>(axis);
      block.border = static_cast<int>(i);
    }
  }
}

std::vector<Range> Grid::cut(const Range& range, std::size_t most) const {
  std::vector<Block> blocks(1);
  look_into(blocks.front());
  while (blocks.size() < most) {
    Block* widest = nullptr;
    float cost = -1;
    for (Block& block : blocks) {
      const float its = block.bounds.half_area() * static_cast<float>(block.count);
      if (block.axis < 3 && (widest == nullptr || its > cost)) cost = its, widest = &block;
    }
    if (widest == nullptr) break;
    Block right = *widest;
    widest->to[widest->axis] = right.from[widest->axis] = widest->border;
    look_into(*widest);
    look_into(right);
    blocks.push_back(right);
  }

  // Each reference into its block's part, by exchange with what stands where it belongs.
  std::vector<std::uint8_t> block_of(kCells);
  std::vector<Range> ranges;
  std::vector<BuildRef*> next;
  BuildRef* at = range.begin;
  for (std::size_t i = 0; i < blocks.size(); ++i) {
    each_cell(blocks[i], [&](std::size_t cell, int, int, int) {
      block_of[cell] = static_cast<std::uint8_t>(i);
    });
    ranges.push_back({at, at + blocks[i].count, blocks[i].bounds, {}});
    next.push_back(at);
    at += blocks[i].count;
  }
  for (std::size_t i = 0; i < ranges.size(); ++i)
    while (next[i] != ranges[i].end) {
      BuildRef moving = *next[i];
      for (std::size_t to; (to = block_of[cell_of(moving)]) != i;) std::swap(moving, *next[to]++);
      *next[i]++ = moving;
    }
  return ranges;
}

/// The grid of a large range, by several tasks.
Grid counted(const Range& range, const Binning& binning) {
  Grid grid(binning);
  constexpr std::size_t kPart = std::size_t{1} << 18;
  if (range.size() <= kPart) {
    grid.count(range.begin, range.end);
    return grid;
  }
  Handover handover;
  handover.give();
  grid = tbb::parallel_reduce(
      tbb::blocked_range<BuildRef*>(range.begin, range.end, kPart), Grid(binning),
      [&](const tbb::blocked_range<BuildRef*>& part, Grid sum) {
        handover.take();
        sum.count(part.begin(), part.end());
        handover.give();
        return sum;
      },
      [](Grid a, const Grid& b) {
        a.add(b);
        return a;
      },
      tbb::simple_partitioner());
  handover.take();
  return grid;
}

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
      : refs_(refs), kind_starts_(kind_starts) {}

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
  NodePool pool_;
};

/// Always splits what costs most, until sixteen children are there.
void Builder::split_greedily(std::vector<Range>& ranges, int depth) const {
  while (ranges.size() < kNodeWidth) {
    std::size_t best = ranges.size();
    float most = -1;
    for (std::size_t i = 0; i < ranges.size(); ++i) {
      const Range& range = ranges[i];
      if (can_be_leaf(range, kSmallLeaf)) continue;
      const auto size = static_cast<float>(range.size());
      const float cost = depth < kFreeDepth ? range.bounds.half_area() * size : size;
      if (best == ranges.size() || cost > most) most = cost, best = i;
    }
    if (best == ranges.size()) return;
    auto [left, right] =
        ranges[best].size() <= kSmallLeaf ? split_kinds(ranges[best]) : split(ranges[best], depth);
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
    if (can_be_leaf(range, kLargeLeaf)) {
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
