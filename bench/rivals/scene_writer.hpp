// SPDX-License-Identifier: Apache-2.0
// What the programs that translate scenes for rivals share: arguments in, a file and a word about
// it out.
#pragma once

#include <fmt/format.h>

#include <iterator>
#include <string>
#include <zraka/formats.hpp>

namespace zraka::rivals {

/// Text that grows.
class Text {
 public:
  template <class... Values>
  void add(fmt::format_string<Values...> format, Values&&... values) {
    fmt::format_to(std::back_inserter(text_), format, std::forward<Values>(values)...);
  }
  const std::string& str() const { return text_; }

 private:
  std::string text_;
};

inline Vec3 operator+(const Vec3& a, const Vec3& b) {
  return {a.x + b.x, a.y + b.y, a.z + b.z};
}
inline Vec3 operator-(const Vec3& a, const Vec3& b) {
  return {a.x - b.x, a.y - b.y, a.z - b.z};
}
inline Vec3 operator*(const Vec3& a, double s) {
  return {a.x * s, a.y * s, a.z * s};
}
inline double dot(const Vec3& a, const Vec3& b) {
  return a.x * b.x + a.y * b.y + a.z * b.z;
}
inline Vec3 cross(const Vec3& a, const Vec3& b) {
  return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
}
inline double mean(const Color& c) {
  return (c.r + c.g + c.b) / 3;
}

/// main() of a translator: `program SCENE OUTPUT [WIDTH]`. `translate` gives the rival's text.
int translate_file(int argc, char** argv, std::string (*translate)(const Scene& scene));

}  // namespace zraka::rivals
