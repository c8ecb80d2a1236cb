// SPDX-License-Identifier: Apache-2.0
// What a reader provides. The list of readers is in formats.cpp.
#pragma once

#include <cstdint>
#include <functional>
#include <string>
#include <string_view>
#include <zraka/formats.hpp>

namespace zraka {

/// A reader of large files calls it now and then with the place that it has come to.
using Passed = std::function<void(const char* at)>;

struct Format {
  const char* name;       ///< for people
  std::uint64_t largest;  ///< bytes that a file may have; the first format's is the largest of all
  bool (*looks_like)(std::string_view text);
  Result<ReadScene> (*parse)(std::string_view text, const std::string& name, const Passed& passed);
};

/// Does the text begin, comments aside, with a statement of NFF, whether or not it may stand first?
bool looks_like_nff(std::string_view text);
Result<ReadScene> parse_nff(std::string_view text, const std::string& name, const Passed& passed);
/// The same by blocks of about so many bytes, on all threads.
Result<ReadScene> parse_nff_by_blocks(std::string_view text, const std::string& name,
                                      const Passed& passed, std::size_t block);
Result<ReadScene> parse_lab_input(std::string_view text, const std::string& name, const Passed&);

}  // namespace zraka
