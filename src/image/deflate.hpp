// SPDX-License-Identifier: Apache-2.0
// Rows of bytes into a zlib stream, by several threads side by side.
#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <vector>

namespace zraka {

struct Rows {
  std::uint32_t count;
  std::size_t bytes;  ///< of each
  /// Makes a row, from several threads at once.
  std::function<void(std::uint32_t row, unsigned char* out)> make;
};

/// Gives a zlib stream (RFC 1950) of the rows to `take`, part after part, until that returns false.
/// The stream is the same from any number of threads (0: one for each processor): every piece of
/// about 2^17 bytes is deflated for itself, which costs less than one byte in a hundred. True if
/// all went.
bool deflate_rows(const Rows& rows, int level, int threads,
                  const std::function<bool(const std::vector<unsigned char>& part)>& take);

}  // namespace zraka
