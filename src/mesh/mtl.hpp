// SPDX-License-Identifier: Apache-2.0
// Materials of OBJ.
#pragma once

#include <string>
#include <string_view>
#include <vector>
#include <zraka/values.hpp>

namespace zraka {

/// What a material of a .mtl file says, of that which is used here.
struct MtlMaterial {
  std::string name{};
  Color diffuse{0.8, 0.8, 0.8}, specular{}, emission{};
  double shininess = 10, opacity = 1, ior = 1;
  int illumination = 2;       ///< 3 and above mirror, 6 and 7 bend rays
  std::string diffuse_map{};  ///< a picture's name
};

/// Lines that it has no use for, and numbers that are none, are passed over: such files are often
/// written by hand.
std::vector<MtlMaterial> parse_mtl(std::string_view text);

}  // namespace zraka
