// SPDX-License-Identifier: Apache-2.0
// What gzip, zstd and deflate have made smaller, as it was before.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <zraka/diagnostic.hpp>

namespace zraka {

/// Whether bytes begin as gzip or zstd write them.
bool is_packed(std::string_view bytes);

/// A whole file of gzip or zstd. Fails where it is damaged or cut off, or becomes more than 64 MB
/// and 20 times as large as it was: text and numbers do not, and what does would fill the memory.
Result<std::string> unpacked(std::string_view bytes, const std::string& name);

/// What a stream of deflate without header holds, exactly `size` bytes.
Result<std::string> inflated(std::string_view bytes, std::uint64_t size, const std::string& name);

/// How much the zlib stream that bytes begin with becomes, counted no farther than about `most`; what
/// is damaged counts up to there.
std::uint64_t inflated_size(std::string_view bytes, std::uint64_t most);

}  // namespace zraka
