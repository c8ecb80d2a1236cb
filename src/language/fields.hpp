// SPDX-License-Identifier: Apache-2.0
// What follows from tables of fields: objects read from tables of TOML, and written.
#pragma once

#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "core/fields.hpp"
#include "language/problems.hpp"
#include "language/toml.hpp"

namespace zraka::language {

struct Input;

/// What a field's value has to be: "a number greater than 0".
std::string expected_of(const Field& field);

/// One of the tables that a field may be: {grid = …}.
std::string form_of(const Field& field, const Table& table);

/// An object, and the table of its type.
struct Part {
  const Table* table;
  void* object;
};

/// Reads the keys of a table, in the order of the fields, into the objects that have them. `also`
/// may be there, too, for the caller; any other key is a problem, and so are those that are
/// missing. `what` names the object in messages: "sphere".
void read_fields(const toml::Node& node, std::string_view what, std::span<const Part> parts,
                 Input& input, std::string_view also = {});
void read_fields(const toml::Node& node, const Table& table, std::string_view what, void* object,
                 Input& input);

/// A node as a value of a kind; monostate if it is none, or of a kind that has words of its own for
/// what is wrong.
FieldValue value_as(FieldKind kind, const toml::Node& node);

/// Whether a field may have a value of its kind: what is out of its range it may not.
bool allowed(const Field& field, const FieldValue& value);

/// TOML while it is written, and what it cannot say.
struct Text {
  std::string text{};
  std::vector<std::string> problems{};
  std::vector<std::string> textures{};  ///< names
};

/// "key = value" for every field that is required or differs from its default.
std::vector<std::string> pairs_of(const Table& table, std::string_view what, const void* object,
                                  Text& out);
/// Appends these, a line each.
void write_fields(const Table& table, std::string_view what, const void* object, Text& out);
/// The same below a header, which stands there for nothing only if it is `needed`.
void write_table(std::string_view header, bool needed, const Table& table, std::string_view what,
                 const void* object, Text& out);

/// A value as TOML; "" of a texture, whose name is elsewhere.
std::string text_of(const Field& field, const FieldValue& value);
std::string text_of(double number);
std::string text_of(const Vec3& v);
std::string in_quotes(std::string_view text);
/// As a key: bare where it may be.
std::string key_of(std::string_view name);

}  // namespace zraka::language
