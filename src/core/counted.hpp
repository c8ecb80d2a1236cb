// SPDX-License-Identifier: Apache-2.0
// Numbers of things in words.
#pragma once

#include <cstdint>
#include <string>

#include "core/words.hpp"

namespace zraka {

/// Things that are counted: "1 pixel", "2 pixels", "5 piksela".
enum class Counted {
  pixel,
  ray,
  eye_ray,
  shadow_ray,
  reflected,
  refracted,
  color,
  point,
  sphere,
  time
};
std::string counted(Language language, Counted what, std::uint64_t number);

/// A number's point is a comma in Croatian.
std::string with_comma(Language language, std::string number);
/// A number with so many digits after the point.
std::string decimal(Language language, double value, int digits);

/// How many in a hundred a part is of a whole: "12.3", and "< 0.1" or "> 99.9" rather
/// than none or all where that is not so.
std::string percentage(Language language, std::uint64_t part, std::uint64_t whole);

}  // namespace zraka
