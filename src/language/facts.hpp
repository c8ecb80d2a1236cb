// SPDX-License-Identifier: Apache-2.0
// What people are told of sections, kinds and fields.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "language/sections.hpp"

namespace zraka::language {

/// One field, in words.
struct FieldFacts {
  std::string key;
  std::string meaning;  ///< "its radius"
  std::string value;    ///< "a number greater than 0, in scene units"
  std::string state;    ///< "required", "default 1", "not built yet"
};
FieldFacts facts_of(const Field& field, const Table& table);

/// Something that has a keyword: a section, or a kind of a section's things.
struct Topic {
  std::string_view keyword;
  const Section* section;
  const Kind* kind = nullptr;  ///< nullptr: the section itself

  /// Whether that is what it is called in full: a disc is a shape, the other one a disc light.
  bool is_called(std::string_view word) const {
    return word == (kind != nullptr ? kind->table.name : section->key);
  }
};
std::vector<Topic> topics();

/// A topic's tables of fields: its own, and what all kinds have.
std::vector<const Table*> tables_of(const Topic& topic);
/// How what it is about begins in a file: "[[shape]]\nkind = \"sphere\"\n".
std::string opening_of(const Topic& topic);

/// [image], [[light]], [material.NAME]
std::string header_of(const Section& section);

/// What to write instead of something at the top of a file that is no section: the section that it
/// is a kind or a field of, or whose name it is like.
std::string hint_at_section(std::string_view word, const Problems& problems);

}  // namespace zraka::language
