// SPDX-License-Identifier: Apache-2.0
#include "accel/collapse.hpp"

#include <tbb/task_group.h>

#include <algorithm>

#include "core/handover.hpp"

namespace zraka {
namespace {

/// What a ray pays for a leaf besides its shapes, and for a body among them.
constexpr float kLeafCost = 1, kBodyCost = 8;
/// Ranges of several kinds up to this size are cut where the kinds change.
constexpr std::size_t kFew = 4;
/// Ranges from here to there may end in full leaves; smaller ones of one kind are found among
/// shapes of other kinds.
constexpr std::size_t kFullFrom = kNodeWidth + 1, kFullTo = 64;
/// Halves from this size on are halved further by a task each.
constexpr std::size_t kHalvingTaskSize = 256;
/// So many halvings by numbers alone end at single references.
constexpr int kLastLevels = 15;

}  // namespace

Collapse::Collapse(const Range& range, int levels, const Kinds& kinds, const CollapseRules& rules)
    : parts_(new Part[2 * range.size()]) {
  add(0, range, levels, false, {kinds, rules});
}

void Collapse::add(std::int32_t index, const Range& range, int levels, bool full_leaves,
                   const Plan& plan) {
  const CollapseRules& rules = plan.rules;
  const std::size_t size = range.size();
  Part& part = parts_[static_cast<std::size_t>(index)];
  part.begin = range.begin, part.end = range.end, part.bounds = range.bounds;
  part.left = part.right = 0;
  if (rules.full_leaves && !full_leaves && size >= kFullFrom && size <= kFullTo)
    full_leaves = plan.kinds.are_one(range) && !plan.kinds.is_body(*range.begin);
  const bool one_kind =
      full_leaves || (size <= std::max(rules.most, kFew) && plan.kinds.are_one(range));
  const bool bodies = one_kind && plan.kinds.is_body(*range.begin);
  const std::size_t whole = full_leaves ? kNodeWidth : bodies ? 1 : rules.whole;
  if (size > 1 && !(one_kind && size <= whole)) {
    const auto [left, right] =
        size <= kFew && !one_kind
            ? plan.kinds.split(range)
            : split(range, full_leaves ? kNodeWidth : 1, levels <= kLastLevels);
    part.left = index + 1;
    part.right = index + static_cast<std::int32_t>(2 * left.size());
    add_both(part, left, right, levels - 1, full_leaves, plan);
  }
  price(part, one_kind && size <= std::max(rules.most, whole), rules.node_cost,
        bodies ? kBodyCost : 1);
}

void Collapse::add_both(const Part& part, const Range& left, const Range& right, int levels,
                        bool full_leaves, const Plan& plan) {
  if (left.size() < kHalvingTaskSize || right.size() < kHalvingTaskSize) {
    add(part.left, left, levels, full_leaves, plan);
    add(part.right, right, levels, full_leaves, plan);
    return;
  }
  tbb::task_group tasks;
  Handover to_task, from_task;
  to_task.give();
  tasks.run([&] {
    to_task.take();
    add(part.right, right, levels, full_leaves, plan);
    from_task.give();
  });
  add(part.left, left, levels, full_leaves, plan);
  tasks.wait();
  from_task.take();
}

void Collapse::price(Part& part, bool can_be_leaf, float node_cost, float shape_cost) const {
  const float area = part.bounds.half_area();
  const float as_leaf = area * (kLeafCost + shape_cost * static_cast<float>(part.size()));
  part.leaf = true;
  part.most = part.in_node = 1;
  part.cost.fill(as_leaf);
  part.from_left.fill(0);
  part.node_from_left = 0;
  if (part.left == 0) return;

  const Part &left = at(part.left), &right = at(part.right);
  std::array<float, kNodeWidth + 1> cost;
  for (std::size_t l = 1; l <= static_cast<std::size_t>(left.most); ++l)
    for (std::size_t r = 1; r <= static_cast<std::size_t>(right.most) && l + r <= kNodeWidth; ++r) {
      const float sum = left.cost[l] + right.cost[r];
      if (part.from_left[l + r] != 0 && !(sum < cost[l + r])) continue;
      cost[l + r] = sum;
      part.from_left[l + r] = static_cast<std::uint8_t>(l);
    }
  part.most = std::min(left.most + right.most, kNodeWidth);
  const auto most = static_cast<std::size_t>(part.most);
  const auto cheapest = std::min_element(cost.begin() + 2, cost.begin() + part.most + 1);
  part.in_node = static_cast<int>(cheapest - cost.begin());
  part.node_from_left = part.from_left[static_cast<std::size_t>(part.in_node)];

  const float as_node = node_cost * area + *cheapest;
  part.leaf = can_be_leaf && as_leaf <= as_node;
  part.cost.fill(part.leaf ? as_leaf : as_node);
  for (std::size_t i = 2; i <= kNodeWidth; ++i) {
    part.cost[i] = part.cost[i - 1];
    if (i > most || cost[i] >= part.cost[i])
      part.from_left[i] = 0;
    else
      part.cost[i] = cost[i];
  }
}

}  // namespace zraka
