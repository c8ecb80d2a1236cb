// SPDX-License-Identifier: Apache-2.0
// Functions of libraries that few commands need, found at the first call: to load them with the
// program took most of the time that a small command takes.
#pragma once

#include <atomic>
#include <zraka/diagnostic.hpp>

namespace zraka {

/// A shared library that is loaded when one of its functions is first asked for.
class LateLibrary {
 public:
  constexpr explicit LateLibrary(const char* file) : file_(file) {}
  /// Fails where the library is not installed. To be asked before the first call.
  Result<void> load() const;
  /// Ends the program where load() fails or the library lacks the function.
  void* function(const char* name) const;

 private:
  const char* file_;
};

template <class Function>
class LateFunction;

/// Called like the library's own function of the name.
template <class R, class... Args>
class LateFunction<R(Args...)> {
 public:
  using Pointer = R (*)(Args...);
  constexpr LateFunction(const LateLibrary& library, const char* name)
      : library_(library), name_(name) {}
  R operator()(Args... args) const { return pointer()(args...); }
  operator Pointer() const { return pointer(); }

 private:
  Pointer pointer() const {
    void* found = found_.load(std::memory_order_relaxed);
    if (found == nullptr) found_ = found = library_.function(name_);
    return reinterpret_cast<Pointer>(found);
  }
  const LateLibrary& library_;
  const char* name_;
  mutable std::atomic<void*> found_ = nullptr;
};

}  // namespace zraka

/// Inside of a namespace: calls of `name` there go to the library, whose header is included.
#define ZRAKA_LATE(library, name) \
  inline constinit const LateFunction<decltype(::name)> name(library, #name);
