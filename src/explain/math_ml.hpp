// SPDX-License-Identifier: Apache-2.0
// Formulas for browsers, in MathML Core.
#pragma once

#include <fmt/format.h>

#include <initializer_list>
#include <string>
#include <string_view>
#include <zraka/explain.hpp>

#include "explain/formulas.hpp"

namespace zraka::math {

/// A symbol: I, k, α.
inline std::string symbol(std::string_view name) {
  return fmt::format("<mi>{}</mi>", name);
}
/// A symbol with an index: k₁.
inline std::string indexed(std::string_view name, std::string_view index) {
  return fmt::format("<msub><mi>{}</mi><mi>{}</mi></msub>", name, index);
}
inline std::string operation(std::string_view sign) {
  return fmt::format("<mo>{}</mo>", sign);
}
inline std::string number(Language language, double v) {
  const std::string text = short_number(language, v);
  return v < 0 ? fmt::format("<mrow><mo>−</mo><mn>{}</mn></mrow>", text.substr(1))
               : fmt::format("<mn>{}</mn>", text);
}
inline std::string number(Language language, float v) {
  return number(language, static_cast<double>(v));
}
/// Three numbers one below the other: a colour or a vector. Its brackets are borders (page.css):
/// not every system has a font whose brackets stretch.
inline std::string column(Language language, const Vec3& v) {
  return fmt::format(
      "<mtable><mtr><mtd>{}</mtd></mtr><mtr><mtd>{}</mtd></mtr><mtr><mtd>{}</mtd></mtr></mtable>",
      number(language, v.x), number(language, v.y), number(language, v.z));
}
inline std::string column(Language language, const Float3& v) {
  return column(language, Vec3{static_cast<double>(v[0]), static_cast<double>(v[1]),
                               static_cast<double>(v[2])});
}
inline std::string in_brackets(std::string_view inside) {
  return fmt::format("<mrow><mo>(</mo>{}<mo>)</mo></mrow>", inside);
}
inline std::string power(std::string_view base, std::string_view exponent) {
  return fmt::format("<msup>{}{}</msup>", base, exponent);
}
inline std::string root(std::string_view inside) {
  return fmt::format("<msqrt>{}</msqrt>", inside);
}
inline std::string fraction(std::string_view above, std::string_view below) {
  return fmt::format("<mfrac><mrow>{}</mrow><mrow>{}</mrow></mfrac>", above, below);
}
/// L·N
inline std::string dot(std::string_view a, std::string_view b) {
  return fmt::format("<mi>{}</mi><mo>·</mo><mi>{}</mi>", a, b);
}
inline std::string product(std::initializer_list<std::string> factors) {
  std::string text;
  for (const std::string& factor : factors)
    text += fmt::format("{}{}", text.empty() ? "" : "<mo>·</mo>", factor);
  return text;
}

/// Between the terms of a sum in steps(): the next term may stand on a line of its own.
inline constexpr const char* kPlus = "</mrow></math><math><mo form=\"infix\">+</mo><mrow>";

/// A formula in steps that may stand on lines of their own: a, = b, = c.
inline std::string steps(std::initializer_list<std::string> sides) {
  std::string text = "<div class=\"formula\">";
  bool first = true;
  for (const std::string& side : sides) {
    text += fmt::format("<math>{}<mrow>{}</mrow></math>", first ? "" : "<mo>=</mo>", side);
    first = false;
  }
  return text + "</div>";
}

}  // namespace zraka::math
