// SPDX-License-Identifier: Apache-2.0
// [[shape]].
#include <fmt/format.h>

#include "core/text.hpp"
#include "language/sections.hpp"
#include "language/shapes.hpp"

namespace zraka::language {
namespace {

struct Common {
  std::string material = "default";
  std::string name;
};

constexpr Field kCommonFields[] = {
    field<&Common::material>("material", {.text = "its material", .unit = Unit::name_of_material}),
    field<&Common::name>("name", {.text = "what explain and influence call it"}),
    not_built("transform", "where it is moved to, and how it is turned and scaled"),
};

constexpr const Kind* kKinds[] = {
#define ZRAKA_ADDRESS(name) &shape::name,
    ZRAKA_SHAPE_KINDS(ZRAKA_ADDRESS)
#undef ZRAKA_ADDRESS
};
/// The index of a material by its name; the one called default need not be in the file.
std::uint32_t material_named(const std::string& name, const Item& item) {
  Input& input = item.input;
  if (const auto found = input.materials.find(name); found != input.materials.end())
    return found->second;
  if (name == "default") {
    const auto index = static_cast<std::uint32_t>(input.scene.materials.size());
    input.scene.materials.push_back({});
    input.scene.material_names.emplace(index, "default");
    input.materials.emplace("default", index);
    return index;
  }
  std::vector<std::string_view> known;
  if (!input.problems.enough())
    for (const auto& [index, each] : input.scene.material_names) known.push_back(each);
  if (const toml::Node* const node = item.node.find("material"))
    input.problems.unknown(node->begin, fmt::format("unknown material '{}'", shown(name)), name,
                           known, "materials");
  return 0;
}

void prepare(Item& item) {
  const Common& common = *static_cast<const Common*>(item.common);
  item.material = material_named(common.material, item);
  item.name = common.name;
}

constexpr Family kFamily = {
    .name = "shape",
    .default_kind = "",
    .kinds = kKinds,
    .not_built = kShapesNotBuilt,
    .common = table_of<Common>("shape", "What every shape has.", kCommonFields),
    .prepare = prepare};

void read(const toml::Node& node, Input& input) {
  Common common;
  read_item(node, kFamily, input, &common);
}

template <class Shape>
void write_all(const std::vector<Object<Shape>>& objects, ShapeList list, Output& output) {
  for (std::uint32_t i = 0; i < objects.size(); ++i) {
    const auto name = output.scene.names.find({list, i});
    ShapeOutput shape{output, output.materials[objects[i].material],
                      name == output.scene.names.end() ? std::string_view() : name->second};
    if constexpr (!is_body<Shape>) write_shape(objects[i].shape, shape);
  }
}

void write(Output& output) {
#define ZRAKA_WRITE(Type, plural) write_all(output.scene.plural, k##Type##List, output);
  ZRAKA_SHAPES(ZRAKA_WRITE)
#undef ZRAKA_WRITE
}

}  // namespace

void ShapeOutput::write(const Kind& kind, const void* entry) {
  const Common common{std::string(material), std::string(name)};
  write_table(fmt::format("[[shape]]\nkind = {}", in_quotes(kind.name)), true, kFamily.common,
              kind.table.name, &common, output.text);
  write_fields(kind.table, kind.table.name, entry, output.text);
}

constexpr Section section::shape = {.key = "shape",
                                    .form = Section::Form::list,
                                    .text = "What is seen.",
                                    .family = &kFamily,
                                    .read = read,
                                    .write = language::write};

}  // namespace zraka::language
