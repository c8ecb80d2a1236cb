// SPDX-License-Identifier: Apache-2.0
#include "core/threads.hpp"

#include <tbb/enumerable_thread_specific.h>
#include <tbb/global_control.h>
#include <tbb/info.h>
#include <tbb/task_arena.h>

#include <utility>

namespace zraka {

int processor_count() {
  return tbb::info::default_concurrency();
}

int threads_here() {
  return tbb::this_task_arena::max_concurrency();
}

int threads_allowed() {
  return static_cast<int>(
      tbb::global_control::active_value(tbb::global_control::max_allowed_parallelism));
}

void in_arena(int threads, FunctionRef<void()> work) {
  tbb::task_arena(threads).execute(work);
}

void undisturbed(FunctionRef<void()> work) {
  tbb::this_task_arena::isolate(work);
}

struct ThreadLimit::Impl {
  tbb::global_control control;
};

ThreadLimit::ThreadLimit(int threads)
    : impl_(new Impl{tbb::global_control(tbb::global_control::max_allowed_parallelism,
                                         static_cast<std::size_t>(threads))}) {}
ThreadLimit::~ThreadLimit() = default;

struct ThreadSlots::Impl {
  tbb::enumerable_thread_specific<Slot> slots;
};

ThreadSlots::ThreadSlots(std::function<Slot()> make)
    : impl_(new Impl{tbb::enumerable_thread_specific<Slot>(std::move(make))}) {}
ThreadSlots::~ThreadSlots() = default;

void* ThreadSlots::local() {
  return impl_->slots.local().get();
}

void ThreadSlots::each(FunctionRef<void(void*)> look) const {
  for (const Slot& slot : impl_->slots) look(slot.get());
}

}  // namespace zraka
