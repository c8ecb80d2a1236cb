// SPDX-License-Identifier: Apache-2.0
// Numbers as people read them in their language.
#pragma once

#include <fmt/format.h>

#include <string>
#include <string_view>
#include <zraka/explain.hpp>

#include "core/counted.hpp"

namespace zraka {

inline std::string short_number(Language language, double v) {
  return with_comma(language, fmt::format("{:.4g}", v == 0 ? 0.0 : v));
}
inline std::string short_number(Language language, float v) {
  return short_number(language, static_cast<double>(v));
}
/// What stands between numbers in a row: a comma, unless it stands within them.
inline std::string_view between_numbers(Language language) {
  return language == Language::croatian ? "; " : ", ";
}
/// (0.5, 1, 0); where a comma stands in the numbers, (0,5; 1; 0).
inline std::string short_vector(Language language, const Vec3& v) {
  const std::string_view between = between_numbers(language);
  return fmt::format("({}{}{}{}{})", short_number(language, v.x), between,
                     short_number(language, v.y), between, short_number(language, v.z));
}
inline std::string short_vector(Language language, const Float3& v) {
  return short_vector(language, Vec3{static_cast<double>(v[0]), static_cast<double>(v[1]),
                                     static_cast<double>(v[2])});
}

}  // namespace zraka
