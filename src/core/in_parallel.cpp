// SPDX-License-Identifier: Apache-2.0
#include "core/in_parallel.hpp"

#include <tbb/blocked_range.h>
#include <tbb/parallel_for.h>

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

}  // namespace zraka
