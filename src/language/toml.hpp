// SPDX-License-Identifier: Apache-2.0
// TOML (toml.io, version 1.0) as a tree whose nodes know where they stand in the file. Dates have
// no meaning in scenes; inline tables may go over several lines, as in TOML 1.1.
#pragma once

#include <cstdint>
#include <deque>
#include <memory>
#include <string>
#include <string_view>
#include <unordered_map>
#include <vector>

namespace zraka::toml {

struct Node {
  enum class Kind : std::uint8_t { table, array, text, integer, number, boolean };
  /// How a table or an array came about, which decides what may still be added to it.
  enum class Made : std::uint8_t { in_passing, by_header, by_dots, by_value, by_headers };

  Kind kind = Kind::table;
  Made made = Made::in_passing;
  bool truth = false;
  std::uint32_t key_begin = 0;       ///< bytes of the file; of a table with a header, this
  std::uint32_t begin = 0, end = 0;  ///< of the value
  std::string_view key;              ///< in its table
  std::string_view text;
  double number = 0;  ///< of an integer, too
  std::int64_t integer = 0;
  std::vector<Node> children;  ///< of a table, in the order of the file; of an array

  /// A table's child, or nullptr.
  const Node* find(std::string_view name) const;
  Node* find(std::string_view name);
  Node& add(std::string_view name);

 private:
  using Index = std::unordered_map<std::string_view, std::uint32_t>;
  std::unique_ptr<Index> index_;  ///< of a table with many children
};

struct Problem {
  std::size_t position = 0;
  std::string message;
  std::string hint{};
};

struct Document {
  Node root;
  std::vector<Problem> problems;  ///< where it is no TOML; the rest has been read
  std::deque<std::string> texts;  ///< that are not in the file letter by letter
};

/// Most levels of tables and arrays in each other.
inline constexpr int kDeepest = 200;
/// A file with more problems than this is something else.
inline constexpr std::size_t kEnoughProblems = 100;

/// `text` has to outlive the document, and to be of less than 4 GB.
Document parse(std::string_view text);

}  // namespace zraka::toml
