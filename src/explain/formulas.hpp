// SPDX-License-Identifier: Apache-2.0
// Numbers as people read them.
#pragma once

#include <fmt/format.h>

#include <string>
#include <zraka/explain.hpp>

namespace zraka {

inline std::string short_number(double v) {
  return fmt::format("{:.4g}", v == 0 ? 0.0 : v);
}
inline std::string short_number(float v) {
  return short_number(static_cast<double>(v));
}
inline std::string short_vector(const Float3& v) {
  return fmt::format("({}, {}, {})", short_number(v[0]), short_number(v[1]), short_number(v[2]));
}
inline std::string short_vector(const Vec3& v) {
  return fmt::format("({}, {}, {})", short_number(v.x), short_number(v.y), short_number(v.z));
}

}  // namespace zraka
