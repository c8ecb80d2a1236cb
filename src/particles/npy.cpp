// SPDX-License-Identifier: Apache-2.0
// Reader of NumPy's .npy (Kern, "A Simple File Format for NumPy Arrays", NEP 1) and .npz, which is
// a ZIP archive of them.
#include <fmt/format.h>

#include <algorithm>
#include <bit>
#include <charconv>
#include <cstring>
#include <deque>

#include "core/text.hpp"
#include "core/unpack.hpp"
#include "particles/arrays.hpp"

namespace zraka {
namespace {

std::uint64_t little(std::string_view bytes, std::size_t at, std::size_t count) {
  std::uint64_t value = 0;
  for (std::size_t i = count; i-- > 0;)
    value = value << 8 | (at + i < bytes.size() ? static_cast<unsigned char>(bytes[at + i]) : 0u);
  return value;
}

/// What follows upon a key of the header's dictionary.
std::string_view value_of(std::string_view header, std::string_view key) {
  const std::size_t at = header.find("'" + std::string(key) + "'");
  if (at == std::string_view::npos) return {};
  header.remove_prefix(at + key.size() + 2);
  const std::size_t colon = header.find(':');
  return colon == std::string_view::npos ? std::string_view() : trimmed(header.substr(colon + 1));
}

/// Whole numbers in a tuple, as (10, 3).
std::optional<std::vector<std::uint64_t>> tuple_of(std::string_view text) {
  std::vector<std::uint64_t> numbers;
  if (!text.starts_with('(')) return std::nullopt;
  text = text.substr(1, text.find(')') == std::string_view::npos ? 0 : text.find(')') - 1);
  while (!(text = trimmed(text)).empty()) {
    std::uint64_t number = 0;
    const auto [stop, error] = std::from_chars(text.data(), text.data() + text.size(), number);
    if (error != std::errc() || numbers.size() == 32) return std::nullopt;
    numbers.push_back(number);
    text.remove_prefix(static_cast<std::size_t>(stop - text.data()));
    if (text.starts_with('L')) text.remove_prefix(1);
    text = trimmed(text);
    if (text.starts_with(','))
      text.remove_prefix(1);
    else if (!text.empty())
      return std::nullopt;
  }
  return numbers;
}

/// The string in quotes that the text begins with, and what is behind it.
std::optional<std::string_view> quoted(std::string_view& text) {
  text = trimmed(text);
  if (text.empty() || (text.front() != '\'' && text.front() != '"')) return std::nullopt;
  const std::size_t end = text.find(text.front(), 1);
  if (end == std::string_view::npos) return std::nullopt;
  const std::string_view inner = text.substr(1, end - 1);
  text = trimmed(text.substr(end + 1));
  return inner;
}

/// A type as <f4; of what is no number, too, whose size is needed all the same.
std::optional<ArrayColumn> column_of(std::string_view type) {
  ArrayColumn column;
  if (type.size() < 3) return std::nullopt;
  column.swapped = (type[0] == '>') == (std::endian::native == std::endian::little) &&
                   (type[0] == '>' || type[0] == '<');
  column.type = type[1];
  const auto [stop, error] =
      std::from_chars(type.data() + 2, type.data() + type.size(), column.size);
  if (error != std::errc() || stop != type.data() + type.size() || column.size > 4096)
    return std::nullopt;
  if (column.type == 'U') column.size *= 4;
  return column;
}

bool is_number(const ArrayColumn& column) {
  const std::size_t s = column.size;
  if (column.type == 'f') return s == 2 || s == 4 || s == 8;
  if (column.type == 'b') return s == 1;
  return (column.type == 'i' || column.type == 'u') && (s == 1 || s == 2 || s == 4 || s == 8);
}

/// What the numbers of a row are called.
std::vector<std::string> names_of(const std::string& array, std::uint64_t count) {
  if (array.empty() && count == 3) return {"x", "y", "z"};
  if (array.empty() && count == 4) return {"x", "y", "z", "radius"};
  if (array.empty() && count == 6) return {"x", "y", "z", "red", "green", "blue"};
  if (array.empty() && count == 7) return {"x", "y", "z", "radius", "red", "green", "blue"};
  const auto is = [&](std::initializer_list<std::string_view> names) {
    return std::find(names.begin(), names.end(), array) != names.end();
  };
  if (is({"positions", "position", "pos", "xyz", "points", "coords", "coordinates"}) && count == 3)
    return {"x", "y", "z"};
  if (is({"colors", "color", "colours", "colour", "rgb"}) && (count == 3 || count == 4))
    return count == 3 ? std::vector<std::string>{"red", "green", "blue"}
                      : std::vector<std::string>{"red", "green", "blue", "alpha"};
  std::vector<std::string> names;
  constexpr std::string_view kAxes[] = {"_x", "_y", "_z"};
  for (std::uint64_t i = 0; i < count; ++i)
    names.push_back(array + (count == 3 ? std::string(kAxes[i]) : fmt::format("_{}", i + 1)));
  return names;
}

/// Names in the plural, as arrays have them, of one.
std::string singular(const std::string& name) {
  if (name == "radii") return "radius";
  if (name == "diameters") return "diameter";
  if (name == "types") return "type";
  return name;
}

struct ParsedHeader {
  std::string_view text, data;
};
Result<ParsedHeader> header_of(std::string_view bytes, const std::string& file) {
  const std::uint64_t version = little(bytes, 6, 1);
  const std::size_t length_size = version == 1 ? 2 : 4;
  const std::uint64_t begin = 8 + length_size, length = little(bytes, 8, length_size);
  if (!bytes.starts_with("\x93NUMPY") || version < 1 || version > 3)
    return failure(file, "is no array of NumPy: expected version 1, 2 or 3 of .npy");
  if (begin + length > bytes.size()) return failure(file, "is cut off within its header");
  return ParsedHeader{bytes.substr(begin, length), bytes.substr(begin + length)};
}

/// [('x', '<f4'), ('rgb', '|u1', (3,))]: the fields one behind the other, and the size of a row.
std::optional<std::size_t> add_fields(std::string_view text, Array& array) {
  std::size_t row = 0;
  text.remove_prefix(1);
  while ((text = trimmed(text)).starts_with('(')) {
    text.remove_prefix(1);
    const auto name = quoted(text);
    if (!name || !text.starts_with(',')) return std::nullopt;
    text.remove_prefix(1);
    const auto type = quoted(text);
    const auto column = type ? column_of(*type) : std::nullopt;
    if (!column) return std::nullopt;
    std::uint64_t count = 1;
    bool many = false;
    if (text.starts_with(',')) {
      const auto shape = tuple_of(text = trimmed(text.substr(1)));
      if (!shape) return std::nullopt;
      text.remove_prefix(text.find(')') + 1);
      for (const std::uint64_t side : *shape)
        count = side <= 4096 && count <= 4096 ? count * side : 1u << 30;
      many = true;
    }
    if (count > 4096 || array.columns.size() + count > 10000) return std::nullopt;
    const std::vector<std::string> names =
        many ? names_of(std::string(*name), count) : std::vector{singular(std::string(*name))};
    for (const std::string& each : names) {
      array.columns.push_back(*column);
      array.columns.back().name = each;
      array.columns.back().stride = row;  // its place in the row, until all of that is known
      row += column->size;
    }
    text = trimmed(text);
    if (!text.starts_with(')')) return std::nullopt;
    text = trimmed(text.substr(1));
    if (text.starts_with(',')) text.remove_prefix(1);
  }
  return text.starts_with(']') && row > 0 ? std::optional(row) : std::nullopt;
}

}  // namespace

Result<Array> array_of(std::string_view bytes, const std::string& name, const std::string& file) {
  const Result<ParsedHeader> header = header_of(bytes, file);
  if (!header) return tl::make_unexpected(header.error());
  std::string_view type = value_of(header->text, "descr");
  const auto shape = tuple_of(value_of(header->text, "shape"));
  const bool by_columns = value_of(header->text, "fortran_order").starts_with("True");
  const auto strange = [&] {
    return failure(file,
                   fmt::format("the array's header is not understood: {}", shown(header->text)));
  };
  if (!shape || type.empty()) return strange();
  Array array;
  if (shape->empty() || shape->size() > 2) return array;
  array.rows = (*shape)[0];
  const std::uint64_t wide = shape->size() == 2 ? (*shape)[1] : 1;
  if (array.rows > kMostParticles || wide > 4096) return array;
  std::size_t row = 0;
  if (type.starts_with('[')) {
    const auto size = add_fields(type, array);
    if (!size || shape->size() != 1) return strange();
    row = *size;
    for (ArrayColumn& column : array.columns) {
      column.data = header->data.data() + column.stride;
      column.stride = row;
    }
  } else {
    const auto kind = quoted(type);
    const auto column = kind ? column_of(*kind) : std::nullopt;
    if (!column) return strange();
    row = wide * column->size;
    const std::vector<std::string> names =
        shape->size() == 2 ? names_of(name, wide) : std::vector{singular(name)};
    for (std::size_t i = 0; i < names.size(); ++i) {
      array.columns.push_back(*column);
      ArrayColumn& added = array.columns.back();
      added.name = names[i];
      added.stride = by_columns ? column->size : row;
      added.data = header->data.data() + i * column->size * (by_columns ? array.rows : 1);
    }
  }
  if (row != 0 && array.rows > header->data.size() / row)
    return failure(file, fmt::format("is cut off: {} rows of {} bytes do not fit in the {} that "
                                     "follow upon the header",
                                     array.rows, row, header->data.size()));
  std::erase_if(array.columns, [](const ArrayColumn& column) { return !is_number(column); });
  return array;
}

bool is_npy(std::string_view bytes) {
  return bytes.starts_with("\x93NUMPY");
}

Result<Particles> parse_npy(std::string_view bytes, const std::string& file,
                            const ParticleOptions& options) {
  const Result<Array> array = array_of(bytes, "", file);
  if (!array) return tl::make_unexpected(array.error());
  const bool named = !array->columns.empty() && !array->columns[0].name.empty() &&
                     array->columns[0].name[0] != '_';
  if (!named)
    return failure(file, "is no array of particles",
                   "expected rows of x, y, z, then a radius, or red, green and blue, or all four; "
                   "or fields with names");
  return particles_of(array->columns, array->rows, file, options);
}

namespace {

struct Member {
  std::string_view name, data;
  std::uint64_t method = 0, packed = 0, size = 0;
};

/// The archive's directory, which stands at its end; sizes beyond 32 bits in an extra field.
Result<std::vector<Member>> members_of(std::string_view zip, const std::string& file) {
  const auto broken = [&](std::string_view what) {
    return failure(file, fmt::format("is a damaged archive: {}", what));
  };
  const std::size_t end = zip.rfind("PK\x05\x06");
  if (end == std::string_view::npos || end + 22 > zip.size()) return broken("it has no directory");
  const std::uint64_t count = little(zip, end + 10, 2);
  std::uint64_t at = little(zip, end + 16, 4);
  if (at == 0xFFFFFFFF) {
    const std::size_t large = zip.rfind(std::string_view("PK\x06\x06", 4));
    if (large == std::string_view::npos) return broken("it has no directory");
    at = little(zip, large + 48, 8);
  }
  std::vector<Member> members;
  for (std::uint64_t i = 0; i < count; ++i) {
    if (at > zip.size() || zip.size() - at < 46 ||
        zip.substr(at, 4) != std::string_view("PK\x01\x02", 4))
      return broken("its directory is cut off");
    Member member;
    member.method = little(zip, at + 10, 2);
    member.packed = little(zip, at + 20, 4);
    member.size = little(zip, at + 24, 4);
    std::uint64_t begin = little(zip, at + 42, 4);
    const std::size_t name = little(zip, at + 28, 2), extra = little(zip, at + 30, 2),
                      comment = little(zip, at + 32, 2);
    if (zip.size() - at < 46 + name + extra) return broken("its directory is cut off");
    member.name = zip.substr(at + 46, name);
    for (std::string_view rest = zip.substr(at + 46 + name, extra); rest.size() >= 4;) {
      const std::size_t size = little(rest, 2, 2);
      std::size_t field = 4;
      if (little(rest, 0, 2) == 1)
        for (std::uint64_t* const value : {&member.size, &member.packed, &begin})
          if (*value == 0xFFFFFFFF) {
            *value = little(rest, field, 8);
            field += 8;
          }
      rest.remove_prefix(std::min(rest.size(), size + 4));
    }
    if (begin > zip.size() || zip.size() - begin < 30) return broken("a member is not there");
    const std::uint64_t data = begin + 30 + little(zip, begin + 26, 2) + little(zip, begin + 28, 2);
    if (data > zip.size() || zip.size() - data < member.packed)
      return broken("a member is cut off");
    member.data = zip.substr(data, member.packed);
    members.push_back(member);
    at += 46 + name + extra + comment;
  }
  return members;
}

/// As numbers pack at most; what promises more would fill the memory.
constexpr std::uint64_t kMostUnpacked = std::uint64_t{1} << 26, kMostPacking = 20;

}  // namespace

bool is_npz(std::string_view bytes) {
  return bytes.starts_with("PK\x03\x04") && bytes.substr(0, 4096).find(".npy") < 300;
}

Result<Particles> parse_npz(std::string_view bytes, const std::string& file,
                            const ParticleOptions& options) {
  const Result<std::vector<Member>> members = members_of(bytes, file);
  if (!members) return tl::make_unexpected(members.error());
  std::deque<std::string> unpacked;  // whose bytes columns point into
  std::vector<Array> arrays;
  std::size_t rows = 0;
  std::uint64_t all = 0;
  for (const Member& member : *members) {
    if (!member.name.ends_with(".npy")) continue;
    std::string_view data = member.data;
    if (member.method != 0) {
      all += member.size;
      if (member.method != 8 ||
          all > std::max<std::uint64_t>(kMostUnpacked, kMostPacking * bytes.size()))
        return failure(file, fmt::format("its member '{}' cannot be unpacked", shown(member.name)),
                       "numpy.savez writes one that need not be");
      Result<std::string> content = inflated(data, member.size, file);
      if (!content) return tl::make_unexpected(content.error());
      unpacked.push_back(std::move(*content));
      data = unpacked.back();
    }
    const std::string name(member.name.substr(0, member.name.size() - 4));
    Result<Array> array = array_of(data, name == "arr_0" ? "" : name, file);
    if (!array) return tl::make_unexpected(array.error());
    if (array->columns.empty()) continue;
    const bool has_x = std::any_of(array->columns.begin(), array->columns.end(),
                                   [](const ArrayColumn& column) { return column.name == "x"; });
    if (has_x) rows = array->rows;
    arrays.push_back(std::move(*array));
  }
  std::vector<ArrayColumn> columns;  // of as many numbers as there are positions
  for (const Array& array : arrays)
    if (rows == 0 || array.rows == rows)
      columns.insert(columns.end(), array.columns.begin(), array.columns.end());
  return particles_of(columns, rows == 0 && !arrays.empty() ? arrays[0].rows : rows, file, options);
}

}  // namespace zraka
