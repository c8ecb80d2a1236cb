// SPDX-License-Identifier: Apache-2.0
// oneTBB's threads at the start of what they do together.
#pragma once

#include <chrono>

namespace zraka {

/// Waits until threads - 1 workers have come into this thread's arena, but not for long: they may
/// be at work elsewhere; not at all if there are fewer processors. Says how many have come. Where
/// there are as many threads as processors, each begins on one of its own; all may run wherever
/// they might before.
///
/// Some kernels start or wake a thread on the processor of the one that asks for it, or gather
/// threads on few processors, and take milliseconds to notice that another one is idle: longer than
/// a small picture takes. (Linux from 6.2 on remembers that a thread has been moved: it is then not
/// given processors that its container gets later.)
int spread_workers(int threads,
                   std::chrono::microseconds patience = std::chrono::microseconds(300));

}  // namespace zraka
