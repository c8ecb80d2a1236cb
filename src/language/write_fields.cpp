// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include <algorithm>
#include <bit>
#include <cmath>

#include "core/text.hpp"
#include "language/fields.hpp"
#include "language/transforms.hpp"

namespace zraka::language {
namespace {

/// -0 is another number than 0 here.
bool same(double a, double b) {
  return std::bit_cast<std::uint64_t>(a) == std::bit_cast<std::uint64_t>(b);
}

bool same(const FieldValue& a, const FieldValue& b) {
  if (a.index() != b.index()) return false;
  if (const double* const number = std::get_if<double>(&a))
    return same(*number, std::get<double>(b));
  if (const Vec3* const v = std::get_if<Vec3>(&a)) {
    const Vec3& w = std::get<Vec3>(b);
    return same(v->x, w.x) && same(v->y, w.y) && same(v->z, w.z);
  }
  if (const Color* const c = std::get_if<Color>(&a)) {
    const Color& d = std::get<Color>(b);
    return same(c->r, d.r) && same(c->g, d.g) && same(c->b, d.b);
  }
  return a == b;
}

bool is_bare(char c) {
  return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') || c == '_' ||
         c == '-';
}

/// As a double that reads as this float: its few digits do where they are enough.
std::string text_of_float(float number) {
  const std::string few = fmt::format("{}", number);
  const double read = parse_number(few).value_or(number);
  return static_cast<float>(read) == number ? text_of(read) : text_of(static_cast<double>(number));
}

/// A texture's name; a problem where it has none, which is not there.
std::string name_of(const TextureIndex& texture, Text& out) {
  if (texture.index < out.textures.size()) return in_quotes(out.textures[texture.index]);
  out.problems.push_back(fmt::format("texture {} of {}", texture.index, out.textures.size()));
  return "\"\"";
}

}  // namespace

std::string text_of(double number) {
  const std::string text = fmt::format("{}", number);
  return text == "-0" ? "-0.0" : text;  // a whole number has no -0
}

std::string text_of(const Vec3& v) {
  return fmt::format("[{}, {}, {}]", text_of(v.x), text_of(v.y), text_of(v.z));
}

std::string in_quotes(std::string_view text) {
  // Controls of two bytes, and what turns the direction of text, would steer a terminal.
  std::string out = "\"";
  for (std::size_t i = 0; i < text.size(); ++i) {
    const char c = text[i];
    const auto next = [&](std::size_t k) {
      return i + k < text.size() ? static_cast<unsigned char>(text[i + k]) : 0u;
    };
    if (next(0) == 0xC2 && next(1) >= 0x80 && next(1) < 0xA0) {
      out += fmt::format("\\u{:04X}", next(1));
      ++i;
      continue;
    }
    if (next(0) == 0xE2 && ((next(1) == 0x80 && (next(2) == 0x8E || next(2) == 0x8F ||
                                                 (next(2) >= 0xA8 && next(2) <= 0xAE))) ||
                            (next(1) == 0x81 && next(2) >= 0xA6 && next(2) <= 0xA9))) {
      out += fmt::format("\\u{:04X}", 0x2000 + ((next(1) & 0x3F) << 6) + (next(2) & 0x3F));
      i += 2;
      continue;
    }
    const auto code = static_cast<unsigned char>(c);
    if (c == '"' || c == '\\')
      out += '\\', out += c;
    else if (code < 0x20 || code == 0x7F)
      out += fmt::format("\\u{:04X}", code);
    else
      out += c;
  }
  return out + "\"";
}

std::string key_of(std::string_view name) {
  const bool bare = !name.empty() && std::all_of(name.begin(), name.end(), is_bare);
  return bare ? std::string(name) : in_quotes(name);
}

namespace {

struct Writer {
  const Field& field;

  std::string operator()(std::monostate) const { return ""; }
  std::string operator()(double number) const { return text_of(number); }
  std::string operator()(std::int64_t number) const { return std::to_string(number); }
  std::string operator()(bool truth) const { return truth ? "true" : "false"; }
  std::string operator()(const Vec3& v) const { return text_of(v); }
  std::string operator()(const Color& c) const {
    return same(c.r, c.g) && same(c.g, c.b) ? text_of(c.r) : text_of(Vec3{c.r, c.g, c.b});
  }
  std::string operator()(const std::string& text) const { return in_quotes(text); }
  std::string operator()(const Chosen& chosen) const {
    return in_quotes(field.about.choices[static_cast<std::size_t>(chosen.index)].name);
  }
  template <class T>
  std::string operator()(const std::vector<T>& values) const {
    std::string text;
    for (const T& value : values) text += (text.empty() ? "" : ", ") + (*this)(value);
    return "[" + text + "]";
  }
  std::string operator()(const CornerUvs& uvs) const {
    std::string text;
    for (const auto& [u, v] : uvs)
      text +=
          fmt::format("{}[{}, {}]", text.empty() ? "" : ", ", text_of_float(u), text_of_float(v));
    return "[" + text + "]";
  }
  std::string operator()(const Transform& transform) const { return text_of(transform); }
  std::string operator()(const TextureIndex&) const { return ""; }
  std::string operator()(const ShapeTables& shapes) const { return shapes.text; }
};

}  // namespace

std::string text_of(const Field& field, const FieldValue& value) {
  return std::visit(Writer{field}, value);
}

namespace {

/// Whether it is a field of tables, or holds one in the place of a value.
bool write_inner(const Field& field, std::string_view what, const void* object,
                 std::vector<std::string>& pairs, Text& out) {
  for (std::size_t i = 0; i < field.tables.size(); ++i) {
    const void* const inside = field.look_inside(object, i);
    if (inside == nullptr) continue;
    const Table& table = *field.tables[i];
    std::vector<std::string> inner =
        pairs_of(table, fmt::format("{} of {}", field.key, what), inside, out);
    if (field.about.by_kind)
      inner.insert(inner.begin(), fmt::format("kind = {}", in_quotes(table.name)));
    pairs.push_back(fmt::format("{} = {{{}}}", field.key, fmt::join(inner, ", ")));
    return true;
  }
  return field.kind == FieldKind::table;
}

}  // namespace

std::vector<std::string> pairs_of(const Table& table, std::string_view what, const void* object,
                                  Text& out) {
  std::vector<std::string> pairs;
  for (const Field& field : table.fields) {
    if (write_inner(field, what, object, pairs, out)) continue;
    const FieldValue value = field.get(object);
    if (value.index() == 0 || (!field.about.required && same(value, field.get(table.defaults()))))
      continue;
    const TextureIndex* const texture = std::get_if<TextureIndex>(&value);
    const std::string written = texture != nullptr ? name_of(*texture, out) : text_of(field, value);
    pairs.push_back(fmt::format("{} = {}", field.key, written));
    if (!allowed(field, value))
      out.problems.push_back(
          fmt::format("{} of {} is {}: expected {}", field.key, what, written, expected_of(field)));
  }
  return pairs;
}

void write_fields(const Table& table, std::string_view what, const void* object, Text& out) {
  for (const std::string& pair : pairs_of(table, what, object, out)) out.text += pair + "\n";
}

void write_table(std::string_view header, bool needed, const Table& table, std::string_view what,
                 const void* object, Text& out) {
  const std::string opening = fmt::format("{}{}\n", out.text.empty() ? "" : "\n", header);
  out.text += opening;
  const std::size_t before = out.text.size();
  write_fields(table, what, object, out);
  if (out.text.size() == before && !needed) out.text.resize(before - opening.size());
}

}  // namespace zraka::language
