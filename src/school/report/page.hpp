// SPDX-License-Identifier: Apache-2.0
// The report as a page for browsers and for paper.
#pragma once

#include <array>
#include <optional>
#include <string>

#include "core/words.hpp"
#include "school/report/facts.hpp"

namespace zraka {

/// A picture as PNG files; that of the page may be smaller.
struct ReportPicture {
  std::string picture, changes;
  double brightest = 0;  ///< difference that is white in the changes
};

struct ReportLetter {
  std::string text;
  std::uint64_t spheres = 0;
  RenderStats stats;
  std::string picture;
};

struct ReportOptions {
  Language language = Language::english;
  std::string scene{};   ///< its name
  std::string author{};  ///< "" if nobody signs
  ProfileName profile = ProfileName::physical;
};

/// A self-contained page: the method, the stages with what they changed and why, the letter, and a
/// table of rays and times.
std::string report_page(const SceneFacts& facts, const std::array<ReportPicture, 7>& pictures,
                        const std::optional<ReportLetter>& letter, const ReportOptions& options);

}  // namespace zraka
