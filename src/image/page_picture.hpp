// SPDX-License-Identifier: Apache-2.0
// Pictures as pages for browsers hold them.
#pragma once

#include <string>
#include <zraka/image.hpp>

namespace zraka {

/// A picture of stored values as a page shows it: at most kPageSide pixels wide and high, as PNG.
inline constexpr std::uint32_t kPageSide = 800;
Result<std::string> png_for_page(const Image& stored);

}  // namespace zraka
