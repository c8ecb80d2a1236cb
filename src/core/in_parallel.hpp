// SPDX-License-Identifier: Apache-2.0
// A long list in parts, by all threads.
#pragma once

#include <tbb/blocked_range.h>
#include <tbb/parallel_for.h>

#include <cstddef>

#include "core/handover.hpp"

namespace zraka {

/// function(begin, end) for parts of [0, count), of at most so many each, by all threads.
template <class Function>
void in_parallel(std::size_t count, const Function& function, std::size_t most = 16384) {
  if (count <= most) return function(std::size_t{0}, count);
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
