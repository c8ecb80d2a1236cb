// SPDX-License-Identifier: Apache-2.0
// [group.NAME]: shapes that instances put into the scene.
#include <fmt/format.h>

#include <algorithm>

#include "core/text.hpp"
#include "language/sections.hpp"
#include "language/shapes.hpp"
#include "scene/check_bodies.hpp"

namespace zraka::language {
namespace {

struct GroupEntry {
  ShapeTables shape;
};

constexpr Field kGroupFields[] = {
    field<&GroupEntry::shape>("shape",
                              {.text = "its shapes, each as below [[shape]]", .required = true}),
};
constexpr Table kGroupTable = table_of<GroupEntry>(
    "group",
    "Shapes that are drawn where an instance of the group stands, and nowhere else. Instances of "
    "other groups may be among them.",
    kGroupFields);

/// Groups may be named before they are read.
void begin_group(const toml::Node& all, Input& input) {
  for (const toml::Node& child : all.children) {
    if (child.kind != toml::Node::Kind::table) continue;
    input.groups.emplace(child.key, static_cast<std::uint32_t>(input.scene.groups.size()));
    input.scene.groups.emplace_back().name = child.key;
  }
}

void read_group(const toml::Node& node, Input& input) {
  GroupEntry entry;
  read_fields(node, kGroupTable, fmt::format("group {}", key_of(node.key)), &entry, input);
  const toml::Node* const shapes = node.find("shape");
  if (shapes == nullptr || shapes->kind != toml::Node::Kind::array) return;
  const std::uint32_t index = input.groups.at(node.key);
  Group group;  // a mesh among them adds one to the scene's
  for (const toml::Node& shape : shapes->children)
    if (shape.kind == toml::Node::Kind::table)
      read_shape(shape, {.shapes = &group, .group = index}, input);
  group.name = node.key;
  input.scene.groups[index] = std::move(group);
}

/// Follows instances from group to group.
class Follower {
 public:
  explicit Follower(Input& input)
      : input_(input), uses_(input.scene.groups.size()), levels_(input.scene.groups.size(), 0) {
    for (const GroupUse& use : input.group_uses)
      if (use.in != GroupUse::kNoGroup) uses_[use.in].push_back(&use);
  }

  void follow_all() {
    for (std::uint32_t group = 0; group < uses_.size(); ++group) levels_of(group);
  }

 private:
  static constexpr int kOnTheWay = -1;
  static constexpr std::size_t kLongestWay = 1000;  ///< far beyond what is allowed

  /// Of groups in each other, this one counted.
  int levels_of(std::uint32_t group) {
    if (levels_[group] > 0) return levels_[group];
    levels_[group] = kOnTheWay;
    way_.push_back(group);
    int most = 0;
    for (const GroupUse* use : uses_[group]) {
      if (levels_[use->group] == kOnTheWay) {
        tell_cycle(*use);
        continue;
      }
      const int levels = way_.size() < kLongestWay ? levels_of(use->group) : kMostGroupLevels;
      if (levels == kMostGroupLevels) tell_depth(*use);
      most = std::max(most, levels);
    }
    way_.pop_back();
    return levels_[group] = most + 1;
  }

  void tell_cycle(const GroupUse& use) {
    std::string way;
    for (auto at = std::find(way_.begin(), way_.end(), use.group); at != way_.end(); ++at)
      way += name_of(*at) + " → ";
    input_.problems.error(use.position, fmt::format("group {} has itself in it: {}{}",
                                                    name_of(use.group), way, name_of(use.group)));
  }

  void tell_depth(const GroupUse& use) {
    input_.problems.error(
        use.position, fmt::format("groups are in each other more than {} deep", kMostGroupLevels));
  }

  std::string name_of(std::uint32_t group) const {
    return shown(key_of(input_.scene.groups[group].name));
  }

  Input& input_;
  std::vector<std::vector<const GroupUse*>> uses_;
  std::vector<int> levels_;  ///< 0: not known yet
  std::vector<std::uint32_t> way_;
};

void end_group(Input& input) {
  Follower(input).follow_all();
}

void write_group(Output& output) {
  std::string& text = output.text.text;
  for (std::size_t i = 0; i < output.scene.groups.size(); ++i) {
    const std::string key = key_of(output.groups[i]);
    const std::size_t before = text.size();
    write_shapes(output.scene.groups[i], true, fmt::format("[[group.{}.shape]]", key), output);
    if (text.size() == before)
      text += fmt::format("{}[group.{}]\nshape = []\n", text.empty() ? "" : "\n", key);
  }
}

}  // namespace

constexpr Section section::group = {.key = "group",
                                    .form = Section::Form::named,
                                    .text = kGroupTable.text,
                                    .table = &kGroupTable,
                                    .read = read_group,
                                    .write = write_group,
                                    .begin = begin_group,
                                    .end = end_group};

}  // namespace zraka::language
