// SPDX-License-Identifier: Apache-2.0
// Files of other programs that people try, told apart so that they can be named.
#pragma once

#include <string_view>

namespace zraka {

/// What a file is that no reader takes: "a LAMMPS dump"; both empty where it may be anything.
struct ForeignFormat {
  std::string_view english, croatian;
};
ForeignFormat foreign_format_of(std::string_view text);

}  // namespace zraka
