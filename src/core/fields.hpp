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
using Integers = std::vector<std::int64_t>;
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
using FieldValue = std::variant<std::monostate, double, std::int64_t, bool, Vec3, Color,
                                std::string, Chosen, Points, Colors, Numbers, Integers, CornerUvs,
                                Transform, TextureIndex, ShapeTables>;

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
  integers,
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
  attenuation,  ///< c, l and q in c + l·d + q·d²
  pixels,
  name_of_material,
  name_of_group,
  name_of_glass,
  picture,
  mesh,
  particles
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
  bool textured = false;      ///< a texture may stand in the place of the value
  bool closed = false;        ///< of shapes: closed bodies alone
  std::string_view also{};    ///< another key that means the same
  /// Of several tables: their names are the values of a key `kind`. Otherwise each is known by its
  /// first key, which it needs.
  bool by_kind = false;
};

struct Field {
  std::string_view key;
  FieldKind kind = FieldKind::number;
  About about{};
  FieldValue (*get)(const void* object) = nullptr;
  void (*set)(void* object, FieldValue&& value) = nullptr;
  /// Of a field that is a table itself: those that it may be, in the place of a value if its kind
  /// is not `table`.
  std::span<const Table* const> tables{};
  /// The object of one of the tables, which the member then holds.
  void* (*inside)(void* object, std::size_t table) = nullptr;
  /// The same for reading only; nullptr where the member holds something else, or nothing.
  const void* (*look_inside)(const void* object, std::size_t table) = nullptr;
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
template <class T>
constexpr std::size_t integers_of = 0;
template <std::size_t N>
constexpr std::size_t integers_of<std::array<int, N>> = N;

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
  else if constexpr (integers_of<M> != 0)
    return FieldKind::integers;
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
  else if constexpr (integers_of<M> != 0)
    return Integers(member.begin(), member.end());
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
  else if constexpr (integers_of<M> != 0)
    std::transform(std::get<Integers>(value).begin(), std::get<Integers>(value).end(),
                   member.begin(), [](std::int64_t one) { return static_cast<int>(one); });
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
  if constexpr (fields::integers_of<Member> != 0)
    made.about.fewest = made.about.most = fields::integers_of<Member>;
  made.get = [](const void* object) {
    return fields::value_of(static_cast<const Object*>(object)->*member);
  };
  made.set = [](void* object, FieldValue&& value) {
    fields::put_into(static_cast<Object*>(object)->*member, std::move(value));
  };
  return made;
}

namespace fields {

template <const Table&... tables>
inline constexpr const Table* kTables[] = {&tables...};

/// What a member holds that is nothing, a value or the object of a table.
template <class M>
struct Holder {
  static constexpr bool kHasValue = false;
  static void* begin(M& member, std::size_t) {
    if constexpr (is_optional<M>)
      return &member.emplace();
    else
      return &member;
  }
  static const void* look(const M& member, std::size_t) {
    if constexpr (is_optional<M>)
      return member ? &*member : nullptr;
    else
      return &member;
  }
};
/// The first is nothing or the value, the others the objects of the tables.
template <class First, class... Objects>
struct Holder<std::variant<First, Objects...>> {
  using Member = std::variant<First, Objects...>;
  static constexpr bool kHasValue = !std::is_same_v<First, std::monostate>;
  using Value = First;

  static void* begin(Member& member, std::size_t table) {
    void* found = nullptr;
    std::size_t i = 0;
    ((i++ == table ? static_cast<void>(found = &member.template emplace<Objects>()) : void()), ...);
    return found;
  }
  static const void* look(const Member& member, std::size_t table) {
    const void* found = nullptr;
    if (member.index() == table + 1)
      std::visit([&](const auto& object) { found = &object; }, member);
    return found;
  }
};

}  // namespace fields

/// A field whose value is a table of fields itself; where the member is optional it may be missing.
/// A variant is one of several tables; or, if it begins with something else than monostate, that.
template <auto member, const Table&... tables>
constexpr Field table_field(std::string_view key, const About& about) {
  using Object = typename fields::MemberOf<decltype(member)>::Object;
  using Member = typename fields::MemberOf<decltype(member)>::Member;
  using Holder = fields::Holder<Member>;
  Field made{.key = key, .kind = FieldKind::table, .about = about};
  made.tables = fields::kTables<tables...>;
  made.inside = [](void* object, std::size_t table) {
    return Holder::begin(static_cast<Object*>(object)->*member, table);
  };
  made.look_inside = [](const void* object, std::size_t table) {
    return Holder::look(static_cast<const Object*>(object)->*member, table);
  };
  if constexpr (Holder::kHasValue) {
    made.kind = fields::kind_of<typename Holder::Value>();
    made.get = [](const void* object) {
      const Member& held = static_cast<const Object*>(object)->*member;
      return held.index() == 0 ? fields::value_of(std::get<0>(held)) : FieldValue();
    };
    made.set = [](void* object, FieldValue&& value) {
      Member& held = static_cast<Object*>(object)->*member;
      fields::put_into(held.template emplace<0>(), std::move(value));
    };
  }
  return made;
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
