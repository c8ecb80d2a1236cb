// SPDX-License-Identifier: Apache-2.0
// Tables of fields: a type says once what its fields are called, mean and may be. Reading, writing,
// checking, help, documentation and schema are derived from them (language/).
#pragma once

#include <algorithm>
#include <array>
#include <cstdint>
#include <limits>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <type_traits>
#include <utility>
#include <variant>
#include <vector>
#include <zraka/scene.hpp>

namespace zraka {

/// A value of a field, whatever the type of the member that holds it.
using Points = std::vector<Vec3>;
using Colors = std::vector<Color>;
using Numbers = std::vector<double>;
/// A texture, as its index in Scene::textures; of many fields in the place of a value.
struct TextureIndex {
  std::uint32_t index = 0;
  friend bool operator==(const TextureIndex&, const TextureIndex&) = default;
};
/// Shapes in a list. Whoever has the field reads them himself; to be written they are text already.
struct ShapeTables {
  std::string text;
  friend bool operator==(const ShapeTables&, const ShapeTables&) = default;
};
struct Chosen {
  int index = 0;  ///< among the field's choices
  friend bool operator==(const Chosen&, const Chosen&) = default;
};
/// monostate: an optional member that holds nothing.
using FieldValue =
    std::variant<std::monostate, double, std::int64_t, bool, Vec3, Color, std::string, Chosen,
                 Points, Colors, Numbers, CornerUvs, Transform, TextureIndex, ShapeTables>;

enum class FieldKind {
  number,
  integer,
  boolean,
  vector,
  color,
  text,
  choice,
  points,
  colors,
  numbers,
  uvs,
  transform,
  texture,
  shapes,
  table
};

enum class Unit {
  none,
  length,
  degrees,
  point,
  direction,
  pixels,
  name_of_material,
  name_of_group,
  picture,
  mesh
};

/// The numbers that a field may be, each component of a vector or a colour.
struct Range {
  double least = -std::numeric_limits<double>::infinity();
  double most = std::numeric_limits<double>::infinity();
  bool above = false;  ///< least itself is too small
  bool below = false;  ///< most itself is too large
};
constexpr Range at_least(double least) {
  return {.least = least};
}
constexpr Range greater_than(double bound) {
  return {.least = bound, .above = true};
}
constexpr Range from_to(double least, double most) {
  return {.least = least, .most = most};
}
constexpr Range between(double least, double most) {
  return {least, most, true, true};
}

struct Choice {
  std::string_view name;
  std::string_view text;  ///< what it means, without a full stop
  bool built = true;
};

struct Table;

/// What a table says of a field besides its key and its member.
struct About {
  std::string_view text;  ///< what it is, without a full stop
  Unit unit = Unit::none;
  Range range{};
  bool required = false;
  std::span<const Choice> choices{};  ///< in the order of the member's enumerators
  std::size_t fewest = 0;             ///< points, colours, numbers, shapes
  std::size_t most = std::numeric_limits<std::size_t>::max();
  std::string_view symbol{};  ///< the lab sheet's
  /// What the language names for it besides, but is not built yet: "a texture".
  std::string_view later{};
  bool textured = false;  ///< a texture may stand in the place of the value
  bool closed = false;    ///< of shapes: closed bodies alone
};

struct Field {
  std::string_view key;
  FieldKind kind = FieldKind::number;
  About about{};
  FieldValue (*get)(const void* object) = nullptr;
  void (*set)(void* object, FieldValue&& value) = nullptr;
  /// Of a field that is a table itself.
  const Table* table = nullptr;
  void* (*inside)(void* object) = nullptr;
  /// The same for reading only; nullptr where an optional member holds nothing.
  const void* (*look_inside)(const void* object) = nullptr;
  /// Not built yet; of some, the value that means what is built is taken: a number, a word or a
  /// vector.
  bool built = true;
  std::optional<double> only_number{};
  std::string_view only_word{};
  std::optional<Vec3> only_vector{};
};

/// The fields of a type.
struct Table {
  std::string_view name;  ///< "sphere"
  std::string_view text;  ///< what it is: a sentence
  std::span<const Field> fields;
  const void* (*defaults)();  ///< an object as it is where nothing is said
};

namespace fields {

template <class T>
struct MemberOf;
template <class T, class M>
struct MemberOf<M T::*> {
  using Object = T;
  using Member = M;
};

template <class T>
constexpr bool is_optional = false;
template <class T>
constexpr bool is_optional<std::optional<T>> = true;

template <class T>
constexpr std::size_t numbers_of = 0;
template <std::size_t N>
constexpr std::size_t numbers_of<std::array<double, N>> = N;

template <class M>
constexpr FieldKind kind_of() {
  if constexpr (is_optional<M>)
    return kind_of<typename M::value_type>();
  else if constexpr (std::is_same_v<M, bool>)
    return FieldKind::boolean;
  else if constexpr (std::is_floating_point_v<M>)
    return FieldKind::number;
  else if constexpr (std::is_integral_v<M>)
    return FieldKind::integer;
  else if constexpr (std::is_enum_v<M>)
    return FieldKind::choice;
  else if constexpr (std::is_same_v<M, Vec3>)
    return FieldKind::vector;
  else if constexpr (std::is_same_v<M, Color> || std::is_same_v<M, Share>)
    return FieldKind::color;
  else if constexpr (std::is_same_v<M, std::string>)
    return FieldKind::text;
  else if constexpr (std::is_same_v<M, Points>)
    return FieldKind::points;
  else if constexpr (std::is_same_v<M, Colors>)
    return FieldKind::colors;
  else if constexpr (numbers_of<M> != 0)
    return FieldKind::numbers;
  else if constexpr (std::is_same_v<M, CornerUvs>)
    return FieldKind::uvs;
  else if constexpr (std::is_same_v<M, Transform>)
    return FieldKind::transform;
  else if constexpr (std::is_same_v<M, TextureIndex>)
    return FieldKind::texture;
  else if constexpr (std::is_same_v<M, ShapeTables>)
    return FieldKind::shapes;
  else
    return FieldKind::table;
}

template <class M>
FieldValue value_of(const M& member) {
  if constexpr (is_optional<M>)
    return member ? value_of(*member) : FieldValue();
  else if constexpr (std::is_same_v<M, bool>)
    return member;
  else if constexpr (std::is_integral_v<M>)
    return static_cast<std::int64_t>(member);
  else if constexpr (std::is_enum_v<M>)
    return Chosen{static_cast<int>(member)};
  else if constexpr (numbers_of<M> != 0)
    return Numbers(member.begin(), member.end());
  else if constexpr (std::is_same_v<M, Share>)
    return static_cast<const Color&>(member);
  else
    return member;
}

template <class M>
void put_into(M& member, FieldValue&& value) {
  if constexpr (is_optional<M>)
    put_into(member.emplace(), std::move(value));
  else if constexpr (std::is_same_v<M, bool>)
    member = std::get<bool>(value);
  else if constexpr (std::is_integral_v<M>)
    member = static_cast<M>(std::get<std::int64_t>(value));
  else if constexpr (std::is_enum_v<M>)
    member = static_cast<M>(std::get<Chosen>(value).index);
  else if constexpr (numbers_of<M> != 0)
    std::copy_n(std::get<Numbers>(value).begin(), numbers_of<M>, member.begin());
  else if constexpr (std::is_same_v<M, Share>)
    member = std::get<Color>(value);
  else
    member = std::get<M>(std::move(value));
}

}  // namespace fields

/// A field that is kept in a member: field<&Sphere::radius>("radius", {.text = …}). The objects are
/// of the type that has the member, or of one derived from it.
template <auto member, class Of = typename fields::MemberOf<decltype(member)>::Object>
constexpr Field field(std::string_view key, const About& about) {
  using Object = Of;
  using Member = typename fields::MemberOf<decltype(member)>::Member;
  Field made{.key = key, .kind = fields::kind_of<Member>(), .about = about};
  if constexpr (fields::numbers_of<Member> != 0)
    made.about.fewest = made.about.most = fields::numbers_of<Member>;
  made.get = [](const void* object) {
    return fields::value_of(static_cast<const Object*>(object)->*member);
  };
  made.set = [](void* object, FieldValue&& value) {
    fields::put_into(static_cast<Object*>(object)->*member, std::move(value));
  };
  return made;
}

/// A field whose value is a table of fields itself; where the member is optional it may be missing.
template <auto member>
constexpr Field table_field(std::string_view key, const Table& table, const About& about) {
  using Object = typename fields::MemberOf<decltype(member)>::Object;
  using Member = typename fields::MemberOf<decltype(member)>::Member;
  Field made{.key = key, .kind = FieldKind::table, .about = about, .table = &table};
  made.inside = [](void* object) -> void* {
    Member& inside = static_cast<Object*>(object)->*member;
    if constexpr (fields::is_optional<Member>)
      return &inside.emplace();
    else
      return &inside;
  };
  made.look_inside = [](const void* object) -> const void* {
    const Member& inside = static_cast<const Object*>(object)->*member;
    if constexpr (fields::is_optional<Member>)
      return inside ? &*inside : nullptr;
    else
      return &inside;
  };
  return made;
}

/// A field that the language has, but nothing does anything with yet.
constexpr Field not_built(std::string_view key, std::string_view text) {
  return {.key = key, .about = {.text = text}, .built = false};
}
/// The same, where one value says what happens now.
constexpr Field only(std::string_view key, double value, std::string_view text) {
  return {.key = key, .about = {.text = text}, .built = false, .only_number = value};
}
constexpr Field only(std::string_view key, std::string_view word, std::string_view text) {
  return {.key = key, .about = {.text = text}, .built = false, .only_word = word};
}
constexpr Field only(std::string_view key, const Vec3& v, std::string_view text) {
  return {.key = key, .about = {.text = text}, .built = false, .only_vector = v};
}

/// The table of a type whose objects begin as T().
template <class T>
constexpr Table table_of(std::string_view name, std::string_view text,
                         std::span<const Field> fields) {
  return {name, text, fields, []() -> const void* {
            static const T object;
            return &object;
          }};
}

}  // namespace zraka
