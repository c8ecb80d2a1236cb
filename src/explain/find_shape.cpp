// SPDX-License-Identifier: Apache-2.0
// From a shape's name to the shape.
#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <type_traits>
#include <zraka/influence.hpp>

#include "core/text.hpp"
#include "explain/names.hpp"
#include "shapes/shapes.hpp"

namespace zraka {
namespace {

constexpr std::size_t kMostNamed = 10;

std::string small_letters(std::string_view text) {
  std::string small(text);
  for (char& c : small)
    if (c >= 'A' && c <= 'Z') c = static_cast<char>(c + 32);
  return small;
}

std::vector<std::uint64_t> counts_of(const ShapeLists& shapes) {
  return {
#define ZRAKA_COUNT(Type, plural) shapes.plural.size(),
      ZRAKA_SHAPES(ZRAKA_COUNT)
#undef ZRAKA_COUNT
  };
}

/// "sphere 3", "sphere3", "kugla 3": the kind's name in any language, and a number.
std::optional<ShapeId> by_number(const std::string& text, std::size_t kinds) {
  const std::size_t digits = text.find_first_of("0123456789");
  if (digits == std::string::npos) return std::nullopt;
  std::uint32_t number = 0;
  const char* const end = text.data() + text.size();
  const auto [stop, error] = std::from_chars(text.data() + digits, end, number);
  if (stop != end || error != std::errc() || number == 0) return std::nullopt;
  const std::string_view noun = trimmed(std::string_view(text).substr(0, digits));
  for (std::size_t kind = 0; kind < kinds; ++kind) {
    const ShapeId id{static_cast<std::int32_t>(kind), number - 1};
    if (plain_name(id) == fmt::format("{} {}", noun, number)) return id;
    for (const Language language : {Language::english, Language::croatian})
      if (noun == noun_of(language, id.kind)) return id;
  }
  return std::nullopt;
}

/// What a group is called, in messages and before the names of what is in it.
std::string name_of_group(const Scene& scene, std::int32_t group) {
  const std::string& name = scene.groups[static_cast<std::size_t>(group)].name;
  return name.empty() ? fmt::format("group {}", group + 1) : name;
}

/// "box 2", "chair/box 2".
std::string path_of(const Scene& scene, const ShapeInScene& shape) {
  return shape.group < 0
             ? plain_name(shape.id)
             : fmt::format("{}/{}", shown(name_of_group(scene, shape.group)), plain_name(shape.id));
}

std::string list_of(const Scene& scene, const std::vector<ShapeInScene>& shapes) {
  std::string list;
  for (std::size_t i = 0; i < shapes.size() && i < kMostNamed; ++i)
    list += fmt::format("{}{}", i == 0 ? "" : ", ", path_of(scene, shapes[i]));
  return shapes.size() > kMostNamed
             ? fmt::format("{} and {} more", list, shapes.size() - kMostNamed)
             : list;
}

/// What the scene or a group has, for someone who asked for something else.
std::string what_is_there(const ShapeLists& shapes) {
  std::string text;
  const auto add = [&](const std::string& more) {
    text += fmt::format("{}{}", text.empty() ? "it has " : ", ", more);
  };
  const std::vector<std::uint64_t> counts = counts_of(shapes);
  for (std::size_t kind = 0; kind < counts.size(); ++kind) {
    const auto id = static_cast<std::int32_t>(kind);
    if (counts[kind] == 1) add(plain_name({id, 0}));
    if (counts[kind] > 1)
      add(fmt::format("{} to {}", plain_name({id, 0}),
                      plain_name({id, static_cast<std::uint32_t>(counts[kind] - 1)})));
  }
  std::size_t named = 0;
  for (const auto& [id, name] : shapes.names)
    if (named++ < kMostNamed)
      text += fmt::format("{}'{}'", named == 1 ? "; names are " : ", ", name);
  if (named > kMostNamed) text += fmt::format(" and {} more", named - kMostNamed);
  return text.empty() ? "it has no shapes" : text;
}

std::string groups_that_are_there(const Scene& scene) {
  std::string text;
  for (std::size_t i = 0; i < scene.groups.size() && i < kMostNamed; ++i)
    text += fmt::format("{}'{}'", i == 0 ? "; groups are " : ", ",
                        shown(name_of_group(scene, static_cast<std::int32_t>(i))));
  if (scene.groups.size() > kMostNamed)
    text += fmt::format(" and {} more", scene.groups.size() - kMostNamed);
  return text.empty() ? text : text + ": say GROUP/NAME for a shape in one";
}

bool has_member(const Csg& csg, const auto& is_wanted) {
  return std::any_of(csg.of.begin(), csg.of.end(), [&](const CsgMember& member) {
    const Csg* const inner = std::get_if<Csg>(&member.body);
    return is_wanted(member.name) || (inner != nullptr && has_member(*inner, is_wanted));
  });
}

/// Looks for one name in the lists of the scene and of groups.
class Search {
 public:
  explicit Search(std::string_view name) : name_(trimmed(name)), small_(small_letters(name_)) {}

  const std::string& small() const { return small_; }

  /// Those with this name exactly; if there are none, in any case; then those with such a member.
  std::vector<ShapeInScene> in(const ShapeLists& shapes, std::int32_t group) const {
    for (const bool members : {false, true})
      for (const bool any_case : {false, true})
        if (std::vector<ShapeInScene> found = in(shapes, group, members, any_case); !found.empty())
          return found;
    return {};
  }

  std::optional<ShapeInScene> numbered(const ShapeLists& shapes, std::int32_t group) const {
    const std::vector<std::uint64_t> counts = counts_of(shapes);
    const std::optional<ShapeId> id = by_number(small_, counts.size());
    if (!id || id->index >= counts[static_cast<std::size_t>(id->kind)]) return std::nullopt;
    return ShapeInScene(*id, group);
  }

 private:
  std::vector<ShapeInScene> in(const ShapeLists& shapes, std::int32_t group, bool members,
                               bool any_case) const {
    std::vector<ShapeInScene> found;
    const auto is_wanted = [&](const std::string& own) {
      return !own.empty() && (any_case ? small_letters(own) == small_ : own == name_);
    };
    if (!members) {
      for (const auto& [id, own] : shapes.names)
        if (is_wanted(own)) found.push_back({id, group});
      return found;
    }
    for (std::uint32_t i = 0; i < shapes.csgs.size(); ++i)
      if (has_member(shapes.csgs[i].shape, is_wanted)) found.push_back({{kind_of_csg(), i}, group});
    return found;
  }

  static std::int32_t kind_of_csg() {
    std::int32_t kind = 0;
#define ZRAKA_IF(Type, plural)                \
  if (std::is_same_v<Type, Csg>) return kind; \
  ++kind;
    ZRAKA_SHAPES(ZRAKA_IF)
#undef ZRAKA_IF
    return kind;
  }

  std::string name_, small_;
};

/// One of what was found, or what to say.
Result<ShapeInScene> only_one(const Scene& scene, const std::string& name,
                              const std::vector<ShapeInScene>& found) {
  if (found.size() == 1) return found.front();
  return failure("", fmt::format("{} shapes are called '{}'", found.size(), shown(name)),
                 fmt::format("say which: {}", list_of(scene, found)));
}

/// "chair/leg"; none where no group is called so.
std::optional<Result<ShapeInScene>> in_named_group(const Scene& scene, const std::string& name) {
  for (std::size_t at = name.find('/'); at != std::string::npos; at = name.find('/', at + 1))
    for (std::size_t i = 0; i < scene.groups.size(); ++i) {
      const auto group = static_cast<std::int32_t>(i);
      if (small_letters(trimmed(name.substr(0, at))) != small_letters(name_of_group(scene, group)))
        continue;
      const std::string inner = name.substr(at + 1);
      const Search search(inner);
      const std::vector<ShapeInScene> found = search.in(scene.groups[i], group);
      if (!found.empty()) return only_one(scene, name, found);
      if (const auto numbered = search.numbered(scene.groups[i], group)) return *numbered;
      return failure("",
                     fmt::format("group '{}' has no shape '{}'", shown(name_of_group(scene, group)),
                                 shown(inner)),
                     what_is_there(scene.groups[i]));
    }
  return std::nullopt;
}

}  // namespace

Result<ShapeInScene> find_shape(const Scene& scene, const std::string& name) {
  const Search search(name);
  std::vector<ShapeInScene> found = search.in(scene, -1);
  if (!found.empty()) return only_one(scene, name, found);
  if (const auto numbered = search.numbered(scene, -1)) return *numbered;
  if (const auto in_group = in_named_group(scene, name)) return *in_group;
  for (std::size_t i = 0; i < scene.groups.size(); ++i)
    for (const ShapeInScene& shape : search.in(scene.groups[i], static_cast<std::int32_t>(i)))
      found.push_back(shape);
  if (!found.empty()) return only_one(scene, name, found);
  return failure("", fmt::format("the scene has no shape '{}'", shown(name)),
                 what_is_there(scene) + groups_that_are_there(scene));
}

}  // namespace zraka
