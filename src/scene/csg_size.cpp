// SPDX-License-Identifier: Apache-2.0
#include "scene/csg_size.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <type_traits>

// Of the lanes' side of bodies only how many crossings they have is asked for here.
#define ZRAKA_ISA isa_none
#include "math/double_lanes.hpp"
#include "shapes/bodies.hpp"

namespace zraka {

CsgSize size_of(const Csg& csg) {
  CsgSize size;
  int before = 0;  // operands that wait already
  const auto add = [&](const CsgSize& part) {
    size.crossings += part.crossings;
    size.waiting = std::max(size.waiting, before++ + part.waiting);
    size.depth = std::max(size.depth, part.depth + 1);
  };
  for (const CsgMember& member : csg.of)
    std::visit(
        [&]<class Shape>(const Shape& shape) {
          if constexpr (std::is_same_v<Shape, Csg>)
            add(size_of(shape));
          else if constexpr (!std::is_same_v<Shape, std::monostate>)
            if constexpr (!ShapeTraits<Shape>::kComposed)
              add({isa_none::BodyLanes<Shape, isa_none::ScalarDoubles>::kMost, 1, 0});
        },
        member.body);
  return size;
}

std::string problem_of_size(const CsgSize& size) {
  if (size.depth > kMostCsgDepth)
    return fmt::format("CSG shapes are {} deep in each other: at most {} fit", size.depth,
                       kMostCsgDepth);
  if (size.crossings > kMostCsgCrossings)
    return fmt::format("a ray may cross its members {} times: at most {} fit", size.crossings,
                       kMostCsgCrossings);
  if (size.waiting > kMostCsgWaiting)
    return fmt::format("{} of its members wait for each other: at most {} fit", size.waiting,
                       kMostCsgWaiting);
  return "";
}

}  // namespace zraka
