// SPDX-License-Identifier: Apache-2.0
#include "language/section.hpp"

#include <fmt/format.h>

#include "core/text.hpp"

namespace zraka::language {

void Item::complain(std::string_view key, std::string message, std::string hint) const {
  const toml::Node* const child = node.find(key);
  input.problems.error(child != nullptr ? child->begin : node.begin, std::move(message),
                       std::move(hint));
}

const Kind* kind_of_node(const toml::Node& node, const Family& family, Problems& problems) {
  std::string_view name = family.default_kind;
  const toml::Node* const kind = node.find("kind");
  const auto known = [&] {
    std::vector<std::string_view> names;
    for (const Kind* each : family.kinds) names.push_back(each->name);
    return names;
  };
  if (kind == nullptr && name.empty()) {
    problems.missing(node.begin, fmt::format("{} has no kind", family.name),
                     fmt::format("kinds of {}: {}", family.name, fmt::join(known(), ", ")));
    return nullptr;
  }
  if (kind != nullptr) {
    if (kind->kind != toml::Node::Kind::text) {
      problems.error(kind->begin, fmt::format("kind of {} is {}: expected a text in quotes",
                                              family.name, shown(problems.source(*kind))));
      return nullptr;
    }
    name = kind->text;
  }
  for (const Kind* each : family.kinds)
    if (each->name == name) return each;
  problems.unknown(kind->begin, fmt::format("unknown kind '{}' of {}", shown(name), family.name),
                   name, known(), fmt::format("kinds of {}", family.name));
  return nullptr;
}

void read_item(const toml::Node& node, const Family& family, Input& input, void* common) {
  Item item{input, node, family, common};
  if (const Kind* const kind = kind_of_node(node, family, input.problems)) kind->read(*kind, item);
}

}  // namespace zraka::language
