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
/// Ranges from this size on are split several at once.
constexpr std::size_t kTogetherSize = 65536;
constexpr std::size_t kSplitsAtOnce = 4;
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
  std::int32_t build_node(const Range& whole, int depth);
  const NodePool& pool() const { return pool_; }

 private:
  std::int32_t kind_of(const BuildRef& ref) const {
    std::size_t kind = 0;
    while (ref.index >= kind_starts_[kind + 1]) ++kind;
    return static_cast<std::int32_t>(kind);
  }
  bool one_kind(const Range& range) const {
    return std::all_of(range.begin, range.end, [&](const BuildRef& r) {
      return kind_of(r) == kind_of(*range.begin);
    });
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
  void split_one(std::vector<Range>& ranges, std::size_t i, int depth) const {
    auto [left, right] =
        ranges[i].size() <= kSmallLeaf ? split_kinds(ranges[i]) : split(ranges[i], depth);
    ranges[i] = left;
    ranges.push_back(right);
  }
  void split_large(std::vector<Range>& ranges, const std::vector<std::size_t>& chosen,
                   int depth) const;

  BuildRef* refs_;
  const std::vector<std::int32_t>& kind_starts_;
  NodePool pool_;
};

/// Several large ranges at once, one task each.
void Builder::split_large(std::vector<Range>& ranges, const std::vector<std::size_t>& chosen,
                          int depth) const {
  std::vector<std::pair<Range, Range>> halves(chosen.size());
  tbb::task_group tasks;
  Handover to_tasks, from_tasks;
  to_tasks.give();
  for (std::size_t k = 0; k < chosen.size(); ++k)
    tasks.run([&, k] {
      to_tasks.take();
      halves[k] = split(ranges[chosen[k]], depth);
      from_tasks.give();
    });
  tasks.wait();
  from_tasks.take();
  for (std::size_t k = 0; k < chosen.size(); ++k) {
    ranges[chosen[k]] = halves[k].first;
    ranges.push_back(halves[k].second);
  }
}

std::int32_t Builder::build_node(const Range& whole, int depth) {
  std::vector<Range> ranges = {whole};
  ranges.reserve(kNodeWidth);
  // Always splits what costs most, of large ranges the several that do, until sixteen children are
  // there.
  std::vector<std::size_t> chosen;
  while (ranges.size() < kNodeWidth) {
    const std::size_t most_splits = std::min(kSplitsAtOnce, kNodeWidth - ranges.size());
    chosen.clear();
    while (chosen.size() < most_splits) {
      std::size_t best = ranges.size();
      float most = -1;
      for (std::size_t i = 0; i < ranges.size(); ++i) {
        const Range& range = ranges[i];
        if (can_be_leaf(range, kSmallLeaf)) continue;
        if (std::find(chosen.begin(), chosen.end(), i) != chosen.end()) continue;
        const auto size = static_cast<float>(range.size());
        const float cost = depth < kFreeDepth ? range.bounds.half_area() * size : size;
        if (best == ranges.size() || cost > most) most = cost, best = i;
      }
      if (best == ranges.size()) break;
      if (ranges[best].size() < kTogetherSize) {
        if (chosen.empty()) chosen.push_back(best);
        break;
      }
      chosen.push_back(best);
    }
    if (chosen.empty()) break;
    if (chosen.size() == 1)
      split_one(ranges, chosen.front(), depth);
    else
      split_large(ranges, chosen, depth);
  }

  Node node;
  for (std::size_t i = 0; i < kNodeWidth; ++i) {
    const Bounds bounds = i < ranges.size() ? ranges[i].bounds : Bounds{};
    node.lower_x[i] = bounds.lower[0], node.lower_y[i] = bounds.lower[1],
    node.lower_z[i] = bounds.lower[2];
    node.upper_x[i] = bounds.upper[0], node.upper_y[i] = bounds.upper[1],
    node.upper_z[i] = bounds.upper[2];
    node.child[i] = node.leaf[i] = 0;
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
  const std::int32_t root = builder.build_node(range_of(refs.begin(), refs.end()), 0);
  built.order = std::move(refs).into_indices();

  // By kinds: each kind's primitives in the order that they have among all.
  const auto kinds = static_cast<std::size_t>(std::count_if(
      kind_starts.begin() + 1, kind_starts.end(),
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
