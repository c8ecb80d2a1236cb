// SPDX-License-Identifier: Apache-2.0
#include <algorithm>

#include "language/toml.hpp"

namespace zraka::toml {

const Node* Node::find(std::string_view name) const {
  if (index_) {
    const auto found = index_->find(name);
    return found == index_->end() ? nullptr : &children[found->second];
  }
  const auto found = std::find_if(children.begin(), children.end(),
                                  [&](const Node& child) { return child.key == name; });
  return found == children.end() ? nullptr : &*found;
}

Node* Node::find(std::string_view name) {
  return const_cast<Node*>(static_cast<const Node*>(this)->find(name));
}

Node& Node::add(std::string_view name) {
  constexpr std::size_t kMany = 32;
  Node& child = children.emplace_back();
  child.key = name;
  if (index_)
    index_->emplace(name, children.size() - 1);
  else if (children.size() > kMany) {
    index_ = std::make_unique<Index>();
    for (std::uint32_t i = 0; i < children.size(); ++i) index_->emplace(children[i].key, i);
  }
  return child;
}

}  // namespace zraka::toml
