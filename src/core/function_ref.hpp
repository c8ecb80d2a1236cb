// SPDX-License-Identifier: Apache-2.0
// A function for whoever calls it before its maker goes on.
#pragma once

#include <type_traits>
#include <utility>

namespace zraka {

template <class Signature>
class FunctionRef;

/// Calls a function that somebody else keeps alive: what takes one need be no template.
template <class Result, class... Arguments>
class FunctionRef<Result(Arguments...)> {
 public:
  template <class Function>
    requires(!std::is_same_v<Function, FunctionRef>)
  FunctionRef(const Function& function)
      : function_(&function), call_([](const void* f, Arguments... arguments) -> Result {
          return (*static_cast<const Function*>(f))(std::forward<Arguments>(arguments)...);
        }) {}
  Result operator()(Arguments... arguments) const {
    return call_(function_, std::forward<Arguments>(arguments)...);
  }

 private:
  const void* function_;
  Result (*call_)(const void* function, Arguments... arguments);
};

}  // namespace zraka
