// SPDX-License-Identifier: Apache-2.0
// Unions, intersections and differences of closed bodies.
#include <fmt/format.h>

#include "language/shapes.hpp"
#include "scene/csg_size.hpp"

namespace zraka::language {
namespace {

struct CsgEntry {
  ShapeTables of;
};

constexpr Field kCsgFields[] = {
    field<&CsgEntry::of>(
        "of", {.text = "closed bodies, and unions, intersections and differences of them; each may "
                       "have a material, a name and a transform of its own",
               .required = true,
               .fewest = 1,
               .closed = true}),
};

/// The kinds that may be members: "sphere, …".
std::string closed_kinds() {
  std::vector<std::string_view> names;
  for (const Kind* kind : kShapeFamily.kinds)
    if (kind->closed) names.push_back(kind->name);
  return fmt::format("{}", fmt::join(names, ", "));
}

void read_member(const toml::Node& node, std::string_view what, const Place& place, Input& input) {
  const Kind* const kind = kind_of_node(node, kShapeFamily, input.problems);
  if (kind == nullptr) return;
  if (kind->closed) return read_shape(node, place, input);
  input.problems.error(
      node.find("kind")->begin,
      fmt::format("{} is no closed body, and {} is of such", kind->table.name, what),
      fmt::format("closed bodies: {}", closed_kinds()));
}

/// Whatever else is wrong with it, members have their own problems.
template <CsgOperation operation>
void read_csg(const Kind& kind, Item& item) {
  CsgEntry entry;
  const Part parts[] = {{&kind.table, &entry}, {&item.family.common, item.common}};
  Problems& problems = item.input.problems;
  const std::size_t before = problems.errors();
  read_fields(item.node, kind.table.name, parts, item.input, "kind");
  item.family.prepare(item);
  Csg csg{operation, {}};
  const int depth = common_of(item).place.depth + 1;
  const toml::Node* const of = item.node.find("of");
  if (depth > kMostCsgDepth) return item.complain("of", problem_of_size({.depth = depth}));
  if (of != nullptr && of->kind == toml::Node::Kind::array)
    for (const toml::Node& member : of->children)
      if (member.kind == toml::Node::Kind::table)
        read_member(member, kind.table.name, {.members = &csg.of, .depth = depth}, item.input);
  if (problems.errors() != before) return;
  // A part of another is counted with that.
  const std::string problem = depth == 1 ? problem_of_size(size_of(csg)) : "";
  if (!problem.empty())
    return item.complain("of", fmt::format("{}: {}", kind.table.name, problem), kHintAtSize);
  add_shape(item, csg);
}

template <CsgOperation operation>
constexpr Kind csg_kind(std::string_view name, std::string_view text) {
  return {name, table_of<CsgEntry>(name, text, kCsgFields), read_csg<operation>, true};
}

}  // namespace

constexpr Kind shape::union_ =
    csg_kind<CsgOperation::unite>("union", "Whatever is in any of them.");
constexpr Kind shape::intersection =
    csg_kind<CsgOperation::intersect>("intersection", "Whatever is in all of them.");
constexpr Kind shape::difference = csg_kind<CsgOperation::subtract>(
    "difference", "Whatever is in the first, but in none of the others.");

void write_shape(const Csg& csg, ShapeOutput& output) {
  const bool inside = output.header.empty();
  std::string members;
  for (const CsgMember& member : csg.of) {
    if (inside && !members.empty()) members += ", ";
    members += fmt::format("{}{}{}", inside ? "" : "  ", text_of(member, output.output),
                           inside ? "" : ",\n");
  }
  const CsgEntry entry{{inside ? "[" + members + "]" : "[\n" + members + "]"}};
  const Kind* const kinds[] = {&shape::union_, &shape::intersection, &shape::difference};
  output.write(*kinds[static_cast<std::size_t>(csg.operation)], &entry);
}

}  // namespace zraka::language
