// SPDX-License-Identifier: Apache-2.0
// Marks where data passes from one thread to another.
#pragma once

#include <atomic>

namespace zraka {

/// What a thread wrote before give() can be read by any thread after a take() that comes later.
/// oneTBB sees to the order of its tasks, but its library is not built for ThreadSanitizer, which
/// sees the order from these calls.
class Handover {
 public:
  void give() { given_.fetch_add(1, std::memory_order_acq_rel); }
  void take() { (void)given_.load(std::memory_order_acquire); }

 private:
  std::atomic<unsigned> given_{0};
};

}  // namespace zraka
