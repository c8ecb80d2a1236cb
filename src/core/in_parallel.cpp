// SPDX-License-Identifier: Apache-2.0
#include "core/in_parallel.hpp"

#include <tbb/blocked_range.h>
#include <tbb/parallel_for.h>
#include <tbb/parallel_pipeline.h>

#include "core/handover.hpp"

namespace zraka {

void in_parallel(std::size_t count, PartFunction function, std::size_t most) {
  if (count <= most) return function(0, count);
  Handover to_tasks, from_tasks;
  to_tasks.give();
  tbb::parallel_for(tbb::blocked_range<std::size_t>(0, count, most),
                    [&](const tbb::blocked_range<std::size_t>& part) {
                      to_tasks.take();
                      function(part.begin(), part.end());
                      from_tasks.give();
                    });
  from_tasks.take();
}

void in_order(std::size_t at_once, FunctionRef<WorkPiece()> next, FunctionRef<void(void*)> work,
              FunctionRef<void(void*)> take) {
  Handover made, worked, taken;
  made.give();
  const auto make_one = [&](tbb::flow_control& flow) -> WorkPiece {
    made.take();
    WorkPiece piece = next();
    made.give();
    if (piece == nullptr) flow.stop();
    return piece;
  };
  const auto work_on = [&](WorkPiece piece) {
    made.take();
    work(piece.get());
    worked.give();
    return piece;
  };
  const auto take_one = [&](const WorkPiece& piece) {
    worked.take();
    taken.take();
    take(piece.get());
    taken.give();
  };
  using tbb::filter_mode, tbb::make_filter;
  tbb::parallel_pipeline(at_once,
                         make_filter<void, WorkPiece>(filter_mode::serial_in_order, make_one) &
                             make_filter<WorkPiece, WorkPiece>(filter_mode::parallel, work_on) &
                             make_filter<WorkPiece, void>(filter_mode::serial_in_order, take_one));
  taken.take();
}

}  // namespace zraka
