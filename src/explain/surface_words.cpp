// SPDX-License-Identifier: Apache-2.0
#include "explain/surface_words.hpp"

#include <fmt/format.h>

#include "core/text.hpp"
#include "explain/formulas.hpp"
#include "explain/names.hpp"

namespace zraka {
namespace {

constexpr Word kOperations[] = {Word::csg_union, Word::csg_intersection, Word::csg_difference};

/// "'tiles' (checker)", or its number where it has no name.
std::string label_of(Language language, const ExplainedTexture& texture) {
  const std::string name = texture.name.empty()
                               ? fmt::format("{}", std::uint64_t{texture.index} + 1)
                               : fmt::format("'{}'", shown_line(texture.name));
  return fmt::format("{} ({})", name, noun_of(language, texture.kind));
}

/// "sphere 'bore'": members are counted by their position.
std::string label_of(Language language, const ExplainedMember& member) {
  const std::string_view noun = noun_of(language, member.kind);
  return member.name.empty() ? std::string(noun)
                             : fmt::format("{} '{}'", noun, shown_line(member.name));
}

std::string group_label(const ExplainedInstance& instance) {
  return instance.group_name.empty() ? fmt::format("{}", std::uint64_t{instance.group} + 1)
                                     : fmt::format("'{}'", shown_line(instance.group_name));
}

/// instance 1 'left' (group 'chair') → box 2 'seat'.
std::string way_line(Language language, const ExplainedPath& path) {
  std::string way;
  for (const ExplainedInstance& instance : path.instances)
    way +=
        say(language, Word::of_group, label_of(language, instance.shape), group_label(instance)) +
        " → ";
  return say(language, Word::way_to_shape, way + label_of(language, *path.inner));
}

std::string member_line(Language language, const ExplainedMember& member) {
  const std::string position = position_of(member);
  return say(language, Word::csg_surface,
             member.position.size() > 1
                 ? position
                 : say(language, Word::csg_position, position, member.operands),
             text_of(language, kOperations[static_cast<int>(member.operation)]),
             label_of(language, member));
}

void add_crossings(Language language, const ExplainedCrossings& crossings,
                   std::vector<std::string>& lines) {
  const auto where = [&](bool inside) {
    return text_of(language, inside ? Word::csg_inside : Word::csg_outside);
  };
  if (crossings.starts_inside) lines.push_back("  " + say(language, Word::csg_starts, where(true)));
  if (crossings.left_out > 0)
    lines.push_back("  " + say(language, Word::csg_left_out, crossings.left_out));
  for (const ExplainedCrossing& crossing : crossings.all) {
    const ExplainedMember& member = crossings.members[crossing.member];
    lines.push_back("  " + say(language, crossing.enters ? Word::csg_enters : Word::csg_leaves,
                               short_number(language, crossing.distance), position_of(member),
                               label_of(language, member), where(crossing.inside)));
  }
}

std::string own_line(Language language, const OwnPlace& own) {
  const std::string_view between = between_numbers(language);
  std::string line = say(language, Word::own_point, short_vector(language, own.point));
  if (own.uv)
    line += fmt::format("{0}u = {1}{0}v = {2}", between, short_number(language, (*own.uv)[0]),
                        short_number(language, (*own.uv)[1]));
  if (own.footprint)
    line += fmt::format("{}{}", between,
                        say(language, Word::own_footprint, short_number(language, *own.footprint)));
  return line;
}

}  // namespace

std::vector<std::string> place_lines(Language language, const ExplainedHit& hit) {
  std::vector<std::string> lines;
  if (hit.cap)
    lines.push_back(say(language, hit.cap->eye_only ? Word::cap_of_eye_cut : Word::cap_of_cut,
                        std::uint64_t{hit.cap->cut} + 1));
  if (hit.path.inner) lines.push_back(way_line(language, hit.path));
  if (hit.path.member) lines.push_back(member_line(language, *hit.path.member));
  if (hit.crossings) add_crossings(language, *hit.crossings, lines);
  if (const auto& t = hit.transform)
    lines.push_back(say(language, Word::transform_to_world, short_vector(language, t->along_x),
                        short_vector(language, t->along_y), short_vector(language, t->along_z),
                        short_vector(language, t->origin)));
  if (hit.own) lines.push_back(own_line(language, *hit.own));
  return lines;
}

std::string bent_line(Language language, const ExplainedHit& hit) {
  if (!hit.bent) return "";
  const TexturedNormal& bent = *hit.bent;
  const std::string texture = label_of(language, bent.texture);
  if (bent.smooth == hit.normal) return say(language, Word::not_bent, texture);
  return say(language, bent.kind == NormalUse::Kind::bump ? Word::bent_by_bumps : Word::bent_by_map,
             texture, short_vector(language, bent.smooth));
}

std::vector<TextureWords> texture_words(Language language, const ExplainedHit& hit) {
  std::vector<TextureWords> all;
  const TexturedCoefficient* before = nullptr;
  for (const TexturedCoefficient& one : hit.textures) {
    const bool same = before != nullptr && before->texture.index == one.texture.index &&
                      is_color(before->coefficient) == is_color(one.coefficient);
    if (!same)
      all.push_back({say(language, Word::texture, label_of(language, one.texture)),
                     {},
                     one.coefficient,
                     one.value});
    all.back().symbols.emplace_back(symbol_of(one.coefficient));
    before = &one;
  }
  return all;
}

std::string_view symbol_of(Coefficient coefficient) {
  constexpr std::string_view kSymbols[] = {"ka", "kd", "ks", "n", "k1", "k2"};
  return kSymbols[static_cast<std::size_t>(coefficient)];
}

bool is_color(Coefficient coefficient) {
  return coefficient <= Coefficient::specular;
}

}  // namespace zraka
