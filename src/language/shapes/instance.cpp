// SPDX-License-Identifier: Apache-2.0
// A group of shapes, once more.
#include <fmt/format.h>

#include "core/text.hpp"
#include "language/shapes.hpp"

namespace zraka::language {
namespace {

struct InstanceEntry {
  std::string of;
};

constexpr Field kInstanceFields[] = {
    field<&InstanceEntry::of>(
        "of", {.text = "the group's name", .unit = Unit::name_of_group, .required = true}),
};

void put(InstanceEntry& entry, Item& item) {
  Input& input = item.input;
  const toml::Node& of = *item.node.find("of");
  const auto group = input.groups.find(entry.of);
  if (group == input.groups.end()) {
    std::vector<std::string_view> known;
    for (const Group& each : input.scene.groups)
      if (!each.name.empty()) known.push_back(each.name);
    return input.problems.unknown(of.begin, fmt::format("unknown group '{}'", shown(entry.of)),
                                  entry.of, known, "groups");
  }
  input.group_uses.push_back({common_of(item).place.group, group->second, of.begin});
  add_shape(item, Instance{group->second});
}

}  // namespace

constexpr Kind shape::instance = kind_of<InstanceEntry, put>(
    "instance", "instance",
    "A group's shapes, moved by the transform. The material is that of shapes which name none.",
    kInstanceFields);

void write_shape(const Instance& instance, ShapeOutput& output) {
  const InstanceEntry entry{output.output.groups[instance.group]};
  output.write(shape::instance, &entry);
}

}  // namespace zraka::language
