// SPDX-License-Identifier: Apache-2.0
// Reader and writer of the scene language (docs/scene-language/).
#include <fmt/format.h>

#include <algorithm>
#include <set>

#include "core/text.hpp"
#include "formats/formats.hpp"
#include "formats/writers.hpp"
#include "language/facts.hpp"
#include "language/sections.hpp"
#include "scene/check_bodies.hpp"

namespace zraka {
namespace {

using language::header_of;
using language::Input;
using language::Section;
using Kind = toml::Node::Kind;

void read_section(const Section& section, const toml::Node& node, Input& input) {
  const auto refuse = [&](const toml::Node& wrong) {
    input.problems.error(wrong.key_begin,
                         fmt::format("'{}' is not written as a section: expected {}", section.key,
                                     header_of(section)));
  };
  if (section.form == Section::Form::one) {
    if (node.kind != Kind::table) return refuse(node);
    return section.read(node, input);
  }
  const Kind wanted = section.form == Section::Form::list ? Kind::array : Kind::table;
  if (node.kind != wanted) return refuse(node);
  for (const toml::Node& child : node.children)
    if (child.kind != Kind::table)
      refuse(wanted == Kind::array ? node : child);
    else
      section.read(child, input);
}

}  // namespace

Result<ReadScene> parse_toml(std::string_view text, const std::string& name,
                             const ReadOptions& options) {
  if (text.starts_with(kByteOrderMark)) text.remove_prefix(kByteOrderMark.size());
  toml::Document document = toml::parse(text);
  language::Problems problems(text, name);
  problems.take(std::move(document.problems));
  ReadScene read;
  Input input{read.scene, problems, options};

  const toml::Node none;
  for (const Section* section : language::kSections)
    if (const toml::Node* const node = document.root.find(section->key);
        node != nullptr && section->begin != nullptr)
      section->begin(*node, input);
  std::vector<std::string_view> known;
  for (const Section* section : language::kSections) {
    known.push_back(section->key);
    const toml::Node* const node = document.root.find(section->key);
    if (node != nullptr)
      read_section(*section, *node, input);
    else if (section->form == Section::Form::one)
      section->read(none, input);
  }
  for (const Section* section : language::kSections)
    if (section->end != nullptr) section->end(input);
  for (const toml::Node& child : document.root.children)
    if (std::find(known.begin(), known.end(), child.key) == known.end())
      problems.error(child.key_begin, fmt::format("unknown section '{}'", shown(child.key)),
                     language::hint_at_section(child.key, problems));
  const bool good = problems.errors() == 0;
  Diagnostics all = problems.finish();
  if (!good) return tl::make_unexpected(std::move(all));
  read.warnings = std::move(all);
  read.legends = std::move(input.legends);
  return read;
}

Likeness likeness_to_toml(std::string_view text) {
  while (!text.empty()) {
    const std::string_view line = trimmed(text.substr(0, text.find('\n')));
    if (!line.empty() && line.front() != '#') {
      if (line.front() == '[') return Likeness::sure;
      const std::size_t equals = line.find('=');
      const std::string_view key = trimmed(line.substr(0, equals));
      const bool is_key =
          !key.empty() &&
          key.find_first_not_of(
              "abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ0123456789_-.\"' ") ==
              std::string_view::npos;
      const bool is_arrow = equals + 1 < line.size() && line[equals + 1] == '>';  // of the lab's
      return equals != std::string_view::npos && is_key && !is_arrow ? Likeness::sure
                                                                     : Likeness::none;
    }
    text.remove_prefix(std::min(text.find('\n'), text.size() - 1) + 1);
  }
  return Likeness::none;
}

namespace {

/// Names of all things of a kind, of which some have one; the others get one that is free.
template <class NameOf>
std::vector<std::string> all_names(std::size_t count, const char* word, const NameOf& name_of) {
  std::set<std::string> taken, used;
  for (std::uint32_t i = 0; i < count; ++i)
    if (const std::string* const name = name_of(i)) taken.insert(*name);
  std::vector<std::string> names;
  for (std::uint32_t i = 0; i < count; ++i) {
    const std::string* const own = name_of(i);
    std::string name = own != nullptr ? *own : fmt::format("{}_{}", word, i + 1);
    while (used.contains(name) || (own == nullptr && taken.contains(name))) name += '_';
    used.insert(name);
    names.push_back(std::move(name));
  }
  return names;
}

std::vector<std::string> all_names(std::size_t count, const char* word,
                                   const std::map<std::uint32_t, std::string>& names) {
  return all_names(count, word, [&](std::uint32_t i) {
    const auto named = names.find(i);
    return named == names.end() ? nullptr : &named->second;
  });
}

/// What scenes of other formats have that the language has no keys for.
template <class Complain>
void refuse_what_has_no_keys(const Scene& scene, const Complain& complain) {
  const auto in_no_file = [](const Texture& t) {
    return t.kind == TextureKind::image && t.file.empty() && t.image != nullptr;
  };
  if (std::any_of(scene.textures.begin(), scene.textures.end(), in_no_file))
    complain("an image that is in no file of its own");
}

}  // namespace

Result<std::string> write_toml(const Scene& scene) {
  Diagnostics problems;
  const auto complain = [&](std::string message) {
    if (problems.size() < toml::kEnoughProblems)
      problems.push_back({.message = "the scene language cannot say this: " + std::move(message)});
  };
  check_references(scene, [&](std::string message, std::string) { complain(std::move(message)); });
  refuse_what_has_no_keys(scene, complain);
  if (!problems.empty()) return tl::make_unexpected(std::move(problems));
  language::Output output{scene};
  output.materials = all_names(scene.materials.size(), "material", scene.material_names);
  output.text.textures = all_names(scene.textures.size(), "texture", scene.texture_names);
  output.groups = all_names(scene.groups.size(), "group", [&](std::uint32_t i) {
    return scene.groups[i].name.empty() ? nullptr : &scene.groups[i].name;
  });
  for (const Section* section : language::kSections)
    if (section->write != nullptr) section->write(output);
  if (output.text.problems.empty()) return std::move(output.text.text);
  for (std::string& problem : output.text.problems) complain(std::move(problem));
  return tl::make_unexpected(std::move(problems));
}

Result<WrittenScene> write_toml_scene(const Scene& scene) {
  Result<std::string> text = write_toml(scene);
  if (!text) return tl::make_unexpected(text.error());
  return WrittenScene{std::move(*text), {}};
}

}  // namespace zraka
