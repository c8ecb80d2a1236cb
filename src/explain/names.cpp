// SPDX-License-Identifier: Apache-2.0
#include "explain/names.hpp"

#include <iterator>

#include "core/text.hpp"
#include "shapes/shapes.hpp"
#include "textures/kinds.hpp"

namespace zraka {
namespace {

using Nouns = const char* [2][4];  // by language and case
constexpr const Nouns* kNouns[] = {
#define ZRAKA_NOUNS(Type, plural) &ShapeTraits<Type>::kNouns,
    ZRAKA_SHAPES(ZRAKA_NOUNS)
#undef ZRAKA_NOUNS
};

constexpr const char* kPlainNames[] = {
#define ZRAKA_NAME(Type, plural) ShapeTraits<Type>::kName,
    ZRAKA_SHAPES(ZRAKA_NAME)
#undef ZRAKA_NAME
};

constexpr const TextureCode* kTextures[] = {
#define ZRAKA_ADDRESS(kind) &texture_kinds::kind,
    ZRAKA_TEXTURES(ZRAKA_ADDRESS)
#undef ZRAKA_ADDRESS
};

std::string label_of(Language language, const NamedShape& shape, const ExplainedPath& path,
                     Case form) {
  if (!path.inner) return label_of(language, shape, form);
  return say(language, Word::shape_in_instance, label_of(language, *path.inner, form),
             label_of(language, shape, Case::locative));
}

}  // namespace

std::string plain_name(const ShapeId& id) {
  return fmt::format("{} {}", kPlainNames[id.kind], std::uint64_t{id.index} + 1);
}

std::string_view noun_of(Language language, std::int32_t kind, Case form) {
  return (*kNouns[kind])[static_cast<int>(language)][static_cast<int>(form)];
}

std::string label_of(Language language, const NamedShape& shape, Case form) {
  std::string label = fmt::format("{} {}", noun_of(language, shape.id.kind, form),
                                  std::uint64_t{shape.id.index} + 1);
  if (!shape.name.empty()) label += fmt::format(" '{}'", shown_line(shape.name));
  return label;
}

std::string label_of(Language language, const ExplainedHit& hit, Case form) {
  return label_of(language, hit.shape, hit.path, form);
}

std::string label_of(Language language, const Blocker& blocker, Case form) {
  return label_of(language, blocker.shape, blocker.path, form);
}

std::string position_of(const ExplainedMember& member) {
  return fmt::format("{}", fmt::join(member.position, "."));
}

std::string_view noun_of(Language language, TextureKind kind) {
  return kTextures[static_cast<int>(kind)]->nouns[static_cast<int>(language)];
}

Word word_of(ProfileName profile) {
  switch (profile) {
    case ProfileName::lab:
      return Word::profile_lab;
    case ProfileName::physical:
      return Word::profile_physical;
    case ProfileName::spd:
      return Word::profile_spd;
    case ProfileName::tachyon:
      return Word::profile_tachyon;
  }
  return Word::profile_physical;
}

std::string_view text_of(Language language, Stage stage) {
  return text_of(language, static_cast<Word>(static_cast<int>(Word::stage_silhouette) +
                                             static_cast<int>(stage) - 1));
}

std::string_view text_of(Language language, const VariedRules& rules) {
  return language == Language::english ? rules.english : rules.croatian;
}

Word after_total_reflection(const Explanation& explanation) {
  if (explanation.varied && explanation.varied->white_when_total) return Word::total_white;
  return explanation.profile.mirror_when_total ? Word::total_mirrored : Word::total_black;
}

}  // namespace zraka
