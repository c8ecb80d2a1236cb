// SPDX-License-Identifier: Apache-2.0
// What a file of the scene language consists of: sections, and kinds of things in some of them. One
// file each, and a line in sections.hpp or in a list of kinds.
#pragma once

#include <array>
#include <cstdint>
#include <map>
#include <span>
#include <string>
#include <string_view>
#include <unordered_map>
#include <utility>
#include <vector>
#include <zraka/formats.hpp>
#include <zraka/scene.hpp>

#include "core/fields.hpp"
#include "core/scene_folder.hpp"
#include "image/scene_images.hpp"
#include "language/fields.hpp"

namespace zraka::language {

/// Of the numbers of a transform.
using TransformBits = std::array<std::uint64_t, 12>;

/// An instance in a group, or in the scene itself, names a group.
struct GroupUse {
  std::uint32_t in = kNoGroup, group = 0;
  std::size_t position = 0;  ///< in the file
  static constexpr std::uint32_t kNoGroup = 0xFFFFFFFF;
};

/// A scene while it is read.
struct Input {
  using Names = std::unordered_map<std::string_view, std::uint32_t>;

  Scene& scene;
  Problems& problems;
  const ReadOptions& options;
  Names materials{}, textures{}, groups{};
  std::map<TransformBits, std::uint32_t> transforms{};  ///< Object::transform by what it is
  SceneImages images{SceneFolder{options.folder.value_or(""), options.allow_outside}};
  /// Textures of pictures that do not say how light became numbers, and the nodes of their files.
  std::map<std::uint32_t, const toml::Node*> open_transfers{};
  std::vector<GroupUse> group_uses{};
  /// Groups by the path of their mesh, and whether that is smooth: 1 no, 2 yes, 0 as the file has
  /// it.
  std::map<std::pair<std::string, int>, std::uint32_t> meshes{};
  std::vector<ColorLegend> legends{};  ///< of particles
};

/// A scene while it is written.
struct Output {
  const Scene& scene;
  Text text{};
  std::vector<std::string> materials{}, groups{};  ///< names
};

struct Family;

/// A thing of a family while it is read.
struct Item {
  Input& input;
  const toml::Node& node;
  const Family& family;
  void* common;  ///< its fields of the family, and what the family needs besides

  /// A problem with a key, or where it is not there, with the thing.
  void complain(std::string_view key, std::string message, std::string hint = {}) const;
};

/// One kind of shape, of light, of camera.
struct Kind {
  std::string_view name;  ///< the value of `kind`
  Table table;
  void (*read)(const Kind& kind, Item& item);
  bool closed = false;  ///< of shapes: may be a member of CSG
};

/// Kinds of one thing.
struct Family {
  std::string_view name;          ///< "shape"
  std::string_view default_kind;  ///< "": it has to be said
  std::span<const Kind* const> kinds;
  Table common{};                         ///< fields that all of them have
  void (*prepare)(Item& item) = nullptr;  ///< once the common fields have been read
};

/// A kind that is read into an Entry, which put() takes into the scene if all of it is right.
template <class Entry, void (*put)(Entry&, Item&)>
constexpr Kind kind_of(std::string_view name, std::string_view called, std::string_view text,
                       std::span<const Field> fields, bool closed = false) {
  return {name, table_of<Entry>(called, text, fields),
          [](const Kind& kind, Item& item) {
            Entry entry{};
            const Part parts[] = {{&kind.table, &entry}, {&item.family.common, item.common}};
            Problems& problems = item.input.problems;
            const std::size_t before = problems.errors();
            read_fields(item.node, kind.table.name, parts, item.input, "kind");
            if (item.family.prepare != nullptr) item.family.prepare(item);
            if (problems.errors() == before) put(entry, item);
          },
          closed};
}

/// The kind that a table says it is of; nullptr, and the problem told, if it is none.
const Kind* kind_of_node(const toml::Node& node, const Family& family, Problems& problems);

/// Reads a thing of the kind that its table says.
void read_item(const toml::Node& node, const Family& family, Input& input, void* common = nullptr);

struct Section {
  enum class Form : std::uint8_t { one, list, named };  ///< [image], [[light]], [material.NAME]

  std::string_view key;
  Form form = Form::one;
  std::string_view text;           ///< what it is for: a sentence
  const Table* table = nullptr;    ///< of what has no kinds
  const Family* family = nullptr;  ///< of what has
  /// Once for each table of the section, in the order of the file; of a single one that is not
  /// there, with an empty one.
  void (*read)(const toml::Node& node, Input& input) = nullptr;
  void (*write)(Output& output) = nullptr;
  /// Before anything is read, with all of the section; and when all of the file has been read.
  void (*begin)(const toml::Node& all, Input& input) = nullptr;
  void (*end)(Input& input) = nullptr;
};

}  // namespace zraka::language
