// SPDX-License-Identifier: Apache-2.0
// As much of YAML as the Ray Tracer Challenge's scenes are written in: lists and maps by
// indentation or in brackets, words and numbers.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>
#include <zraka/diagnostic.hpp>

namespace zraka::yaml {

struct Node {
  enum class Kind { scalar, list, map } kind = Kind::scalar;
  std::string text{};  ///< of a scalar
  std::size_t line = 0;
  std::vector<Node> items{};                            ///< of a list
  std::vector<std::pair<std::string, Node>> members{};  ///< of a map, in their order

  bool is_list() const { return kind == Kind::list; }
  bool is_map() const { return kind == Kind::map; }
  const Node* find(std::string_view key) const;
  /// A finite number; none where it is something else.
  std::optional<double> number() const;
};

/// Fails with the line where it is none of this.
Result<Node> parse(std::string_view text, const std::string& file);

}  // namespace zraka::yaml
