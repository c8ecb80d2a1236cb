// SPDX-License-Identifier: Apache-2.0
// Pictures in archives, and in documents and archives that lie in those.
#pragma once

#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

#include "school/grade/submission.hpp"

namespace zraka {

/// Limits of a submission.
inline constexpr std::uint64_t kMostBytes = std::uint64_t{64} << 20;
inline constexpr std::uint64_t kMostBytesInAll = std::uint64_t{256} << 20;
inline constexpr std::size_t kMostPictures = 64;
inline constexpr std::size_t kMostEntries = 10000;

/// By their names; pictures of formats that cannot be read are told so.
bool is_picture(const std::string& file);
/// A zip archive, a document that is one, or a PDF.
bool is_archive(const std::string& file);
/// Is it of a system's or hidden from people?
bool is_hidden(const std::filesystem::path& path);

tl::unexpected<Diagnostics> too_many_pictures(const std::string& path);

/// Adds the pictures of an archive, called `within` in the submission unless that is "". Everything
/// stays in memory, so no name in an archive can lead anywhere; one that tries is refused all the
/// same.
Result<void> take_from_archive(const std::string& path, const std::string& within,
                               std::vector<SubmittedPicture>& pictures);

}  // namespace zraka
