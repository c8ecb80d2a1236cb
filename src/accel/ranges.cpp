// SPDX-License-Identifier: Apache-2.0
#include "accel/ranges.hpp"

#include <tbb/blocked_range.h>
#include <tbb/parallel_reduce.h>

#include <algorithm>
#include <array>
#include <new>

#include "core/handover.hpp"

namespace zraka {
namespace {

/// Ranges under this size have half as many bins: what bins cost by themselves counts there.
constexpr std::size_t kFewBinsSize = 64;

BuildBounds centers_of(const BuildRef* begin, const BuildRef* end) {
  BuildBounds centers;
  for (const BuildRef* r = begin; r != end; ++r) {
    const Four center = center_of(*r);
    centers.include(center, center);
  }
  return centers;
}

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
    const FourInts bin_indices = binning.bins_of(lower, upper);
    for (std::size_t axis = 0; axis < 3; ++axis) {
      Bin& bin = bins.at(axis, static_cast<std::size_t>(bin_indices[static_cast<int>(axis)]));
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
  BuildBounds left, right;
};

Split best_split(const Range& range, const Binning& binning, std::uint32_t leaf) {
  const Bins bins = binned_by_tasks(range, binning);
  const auto cost_of = [leaf](const Bin& side) {
    const std::uint32_t leaves = leaf == 1 ? side.count : (side.count + leaf - 1) / leaf;
    return side.bounds.half_area() * static_cast<float>(leaves);
  };
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
      left[b + 1] = cost_of(sum);
    }
    sum = {};
    for (std::size_t b = count - 1; b > 0; --b) {
      sum.bounds.include(bins.at(axis, b).bounds);
      sum.count += bins.at(axis, b).count;
      if (sum.count == 0 || sum.count == range.size()) continue;
      const float cost = left[b] + cost_of(sum);
      if (cost < best.cost) best = {axis, b, cost, {}, sum.bounds};
    }
  }
  for (std::size_t b = 0; b < best.bin; ++b) best.left.include(bins.at(best.axis, b).bounds);
  return best;
}

}  // namespace

Range range_of(BuildRef* begin, BuildRef* end) {
  Range range{begin, end, {}, {}};
  for (const BuildRef* r = begin; r != end; ++r) {
    range.bounds.include(lower_of(*r), upper_of(*r));
    const Four center = center_of(*r);
    range.centers.include(center, center);
  }
  return range;
}

BuildBounds centers_by_tasks(const BuildRef* begin, const BuildRef* end) {
  Handover handover;
  handover.give();
  const BuildBounds centers = tbb::parallel_reduce(
      tbb::blocked_range<const BuildRef*>(begin, end, 16 * kTaskSize), BuildBounds(),
      [&](const tbb::blocked_range<const BuildRef*>& part, BuildBounds sum) {
        handover.take();
        sum.include(centers_of(part.begin(), part.end()));
        handover.give();
        return sum;
      },
      [](BuildBounds a, const BuildBounds& b) {
        a.include(b);
        return a;
      });
  handover.take();
  return centers;
}

std::pair<Range, Range> split(const Range& range, std::uint32_t leaf, bool anyhow) {
  const Binning binning(range, range.size() < kFewBinsSize ? kBins / 2 : kBins);
  const Split best = anyhow || range.size() == 2 ? Split{} : best_split(range, binning, leaf);
  if (best.axis == 3) {  // two, or equal centres: any halves will do
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

}  // namespace zraka
