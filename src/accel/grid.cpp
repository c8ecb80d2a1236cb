// SPDX-License-Identifier: Apache-2.0
#include "accel/grid.hpp"

#include <tbb/blocked_range.h>
#include <tbb/parallel_reduce.h>

#include <array>

#include "core/handover.hpp"
#include "core/in_parallel.hpp"
#include "core/unset_vector.hpp"

namespace zraka {
namespace {

/// Moves each reference into its part, by exchange with what stands where it belongs. The number of
/// each one's part moves along: to compute it on the way would be most of the way.
void put_in_place(const std::vector<Range>& parts, std::uint8_t* part_of) {
  BuildRef* const refs = parts.front().begin;
  std::vector<std::size_t> next;
  for (const Range& part : parts) next.push_back(static_cast<std::size_t>(part.begin - refs));
  for (std::size_t i = 0; i < parts.size(); ++i) {
    const auto end = static_cast<std::size_t>(parts[i].end - refs);
    for (std::size_t& at = next[i]; at != end; ++at) {
      std::uint8_t to = part_of[at];
      if (to == i) continue;
      BuildRef moving = refs[at];
      do {
        const std::size_t position = next[to]++;
        std::swap(moving, refs[position]);
        std::swap(to, part_of[position]);
      } while (to != i);
      refs[at] = moving;
    }
  }
}

}  // namespace

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

  std::vector<std::uint8_t> block_of(kCells);
  std::vector<Range> ranges;
  BuildRef* at = range.begin;
  for (std::size_t i = 0; i < blocks.size(); ++i) {
    each_cell(blocks[i], [&](std::size_t cell, int, int, int) {
      block_of[cell] = static_cast<std::uint8_t>(i);
    });
    ranges.push_back({at, at + blocks[i].count, blocks[i].bounds, {}});
    at += blocks[i].count;
  }
  UnsetVector<std::uint8_t> part_of(range.size());
  in_parallel(range.size(), [&](std::size_t begin, std::size_t end) {
    for (std::size_t i = begin; i < end; ++i) part_of[i] = block_of[cell_of(range.begin[i])];
  });
  put_in_place(ranges, part_of.data());
  return ranges;
}

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

}  // namespace zraka
