// SPDX-License-Identifier: Apache-2.0
// From a shape's name to the shape.
#include <fmt/format.h>

#include <algorithm>
#include <charconv>
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

std::vector<std::uint64_t> counts_of(const Scene& scene) {
  return {
#define ZRAKA_COUNT(Type, plural) scene.plural.size(),
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
  for (std::size_t kind = 0; kind < kinds; ++kind)
    for (const Language language : {Language::english, Language::croatian})
      if (noun == noun_of(language, static_cast<std::int32_t>(kind)))
        return ShapeId{static_cast<std::int32_t>(kind), number - 1};
  return std::nullopt;
}

std::string list_of(const std::vector<ShapeId>& shapes) {
  std::string list;
  for (std::size_t i = 0; i < shapes.size() && i < kMostNamed; ++i)
    list += fmt::format("{}{}", i == 0 ? "" : ", ", plain_name(shapes[i]));
  return shapes.size() > kMostNamed
             ? fmt::format("{} and {} more", list, shapes.size() - kMostNamed)
             : list;
}

/// What the scene has, for someone who asked for something else.
std::string what_is_there(const Scene& scene) {
  std::string text;
  const auto add = [&](const std::string& more) {
    text += fmt::format("{}{}", text.empty() ? "it has " : ", ", more);
  };
  const std::vector<std::uint64_t> counts = counts_of(scene);
  for (std::size_t kind = 0; kind < counts.size(); ++kind) {
    const auto id = static_cast<std::int32_t>(kind);
    if (counts[kind] == 1) add(plain_name({id, 0}));
    if (counts[kind] > 1)
      add(fmt::format("{} to {}", plain_name({id, 0}),
                      plain_name({id, static_cast<std::uint32_t>(counts[kind] - 1)})));
  }
  std::size_t named = 0;
  for (const auto& [id, name] : scene.names)
    if (named++ < kMostNamed)
      text += fmt::format("{}'{}'", named == 1 ? "; names are " : ", ", name);
  if (named > kMostNamed) text += fmt::format(" and {} more", named - kMostNamed);
  return text.empty() ? "it has no shapes" : text;
}

}  // namespace

Result<ShapeId> find_shape(const Scene& scene, const std::string& name) {
  const std::string wanted = small_letters(trimmed(name));
  std::vector<ShapeId> found, found_in_any_case;
  for (const auto& [id, own] : scene.names) {
    if (own == trimmed(name)) found.push_back(id);
    if (small_letters(own) == wanted) found_in_any_case.push_back(id);
  }
  if (found.empty()) found = std::move(found_in_any_case);
  if (found.size() == 1) return found.front();
  if (found.size() > 1)
    return failure("", fmt::format("{} shapes are called '{}'", found.size(), shown(name)),
                   fmt::format("say which: {}", list_of(found)));
  const std::vector<std::uint64_t> counts = counts_of(scene);
  const std::optional<ShapeId> numbered = by_number(wanted, counts.size());
  if (numbered && numbered->index < counts[static_cast<std::size_t>(numbered->kind)])
    return *numbered;
  return failure("", fmt::format("the scene has no shape '{}'", shown(name)), what_is_there(scene));
}

}  // namespace zraka
