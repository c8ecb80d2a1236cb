// SPDX-License-Identifier: Apache-2.0
// The style that pages for browsers share.
#pragma once

#include <string_view>

namespace zraka {

inline constexpr std::string_view kSharedCss =
#include "core/page.css.inc"
    ;

}  // namespace zraka
