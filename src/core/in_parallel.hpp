// SPDX-License-Identifier: Apache-2.0
// Work for all threads: parts of a long list, and pieces that come and go in order. No templates:
// what hands work to threads takes long to compile, and a call for each part no time.
#pragma once

#include <cstddef>
#include <memory>

#include "core/function_ref.hpp"

namespace zraka {

using PartFunction = FunctionRef<void(std::size_t begin, std::size_t end)>;

/// function(begin, end) for parts of [0, count), of at most so many each, by all threads.
void in_parallel(std::size_t count, PartFunction function, std::size_t most = 16384);

/// What next() makes, until it makes none, is given to work() by all threads and then to take() in
/// the order of its making. One thread at a time is in next(), and one in take().
using WorkPiece = std::shared_ptr<void>;
void in_order(std::size_t at_once, FunctionRef<WorkPiece()> next, FunctionRef<void(void*)> work,
              FunctionRef<void(void*)> take);

}  // namespace zraka
