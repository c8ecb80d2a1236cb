// SPDX-License-Identifier: Apache-2.0
// What follows from tables of fields: objects read from tables of TOML, and written.
#pragma once

#include <span>
#include <string>
#include <string_view>

#include "core/fields.hpp"
#include "language/problems.hpp"
#include "language/toml.hpp"

namespace zraka::language {

/// What a field's value has to be: "a number greater than 0".
std::string expected_of(const Field& field);

/// An object, and the table of its type.
struct Part {
  const Table* table;
  void* object;
};

/// Reads the keys of a table, in the order of the fields, into the objects that have them. `also`
/// may be there, too, for the caller; any other key is a problem, and so are those that are
/// missing. `what` names the object in messages: "sphere".
void read_fields(const toml::Node& node, std::string_view what, std::span<const Part> parts,
                 Problems& problems, std::string_view also = {});
void read_fields(const toml::Node& node, const Table& table, std::string_view what, void* object,
                 Problems& problems);

/// A single value, for fields that no table has: monostate, and the problem told, if it is none.
FieldValue read_value(const toml::Node& node, const Field& field, std::string_view what,
                      Problems& problems);

/// Appends "key = value", a line for every field that is required or differs from its default.
void write_fields(const Table& table, const void* object, std::string& out);

/// A value as TOML.
std::string text_of(const Field& field, const FieldValue& value);
std::string text_of(double number);
std::string text_of(const Vec3& v);
std::string quoted(std::string_view text);
/// As a key: bare where it may be.
std::string key_of(std::string_view name);

}  // namespace zraka::language
