// SPDX-License-Identifier: Apache-2.0
// A long list in parts, by all threads.
#pragma once

#include <cstddef>

namespace zraka {

/// Calls a function that somebody else keeps alive, for (begin, end) of a part.
class PartFunction {
 public:
  template <class Function>
  PartFunction(const Function& function)
      : function_(&function), call_([](const void* f, std::size_t begin, std::size_t end) {
          (*static_cast<const Function*>(f))(begin, end);
        }) {}
  void operator()(std::size_t begin, std::size_t end) const { call_(function_, begin, end); }

 private:
  const void* function_;
  void (*call_)(const void* function, std::size_t begin, std::size_t end);
};

/// function(begin, end) for parts of [0, count), of at most so many each, by all threads. No
/// template: what hands parts to threads takes long to compile, and a call for each part no time.
void in_parallel(std::size_t count, PartFunction function, std::size_t most = 16384);

}  // namespace zraka
