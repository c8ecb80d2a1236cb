// SPDX-License-Identifier: Apache-2.0
#include "mesh/ply_header.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <optional>

#include "core/text.hpp"
#include "mesh/mesh.hpp"

namespace zraka::ply {
namespace {

struct NamedType {
  std::string_view name, other_name;
};
/// In the order of Type.
constexpr NamedType kTypes[] = {{"char", "int8"},     {"uchar", "uint8"},   {"short", "int16"},
                                {"ushort", "uint16"}, {"int", "int32"},     {"uint", "uint32"},
                                {"float", "float32"}, {"double", "float64"}};

std::optional<Type> type_named(std::string_view name) {
  for (std::size_t i = 0; i < std::size(kTypes); ++i)
    if (kTypes[i].name == name || kTypes[i].other_name == name) return static_cast<Type>(i);
  return std::nullopt;
}

std::vector<std::string_view> words_of(std::string_view line) {
  std::vector<std::string_view> words;
  while (!(line = trimmed(line)).empty()) {
    const std::size_t end = std::min(line.find_first_of(" \t"), line.size());
    words.push_back(line.substr(0, end));
    line.remove_prefix(end);
  }
  return words;
}

class HeaderReader {
 public:
  HeaderReader(std::string_view bytes, const std::string& name) : bytes_(bytes), name_(name) {}

  Result<Header> read() {
    for (;;) {
      const std::size_t end = bytes_.find('\n', header_.end);
      if (end == std::string_view::npos)
        return mesh_failure(name_, 0, 0, "is cut off in its header");
      const std::string_view line = trimmed(bytes_.substr(header_.end, end - header_.end));
      header_.end = end + 1;
      ++number_;
      if (number_ == 1 && line != "ply") return fail("the first line of a PLY file is ply");
      if (line == "end_header") break;
      const std::string problem = number_ == 1 ? "" : problem_of(words_of(line), line);
      if (!problem.empty()) return fail(problem);
    }
    return check_room();
  }

 private:
  tl::unexpected<Diagnostics> fail(std::string message) const {
    return mesh_failure(name_, number_, 1, std::move(message));
  }

  /// Takes a line in; says what is wrong with it, or nothing.
  std::string problem_of(const std::vector<std::string_view>& words, std::string_view line) {
    if (words.empty() || words[0] == "comment" || words[0] == "obj_info") return "";
    if (words[0] == "format" && words.size() == 3) return take_format(words[1]);
    if (words[0] == "element" && words.size() == 3) return take_element(words[1], words[2]);
    if (words[0] == "property" && !header_.elements.empty()) return take_property(words);
    return fmt::format("'{}' is no line of a PLY header", shown(line));
  }

  std::string take_format(std::string_view encoding) {
    constexpr std::string_view kNames[] = {"ascii", "binary_little_endian", "binary_big_endian"};
    for (std::size_t i = 0; i < std::size(kNames); ++i)
      if (kNames[i] == encoding) {
        header_.encoding = static_cast<Encoding>(i);
        return "";
      }
    return fmt::format(
        "'{}' is no format of PLY: expected ascii, binary_little_endian or "
        "binary_big_endian",
        shown(encoding));
  }

  std::string take_element(std::string_view name, std::string_view digits) {
    Element element{name, 0, {}};
    const char* const end = digits.data() + digits.size();
    const auto read = std::from_chars(digits.data(), end, element.count);
    if (read.ptr != end || read.ec != std::errc())
      return fmt::format("'{}' is no number of elements", shown(digits));
    if (element.count > kMostInMesh)
      return fmt::format("{} of {} are too many: at most {} fit", digits, shown(name), kMostInMesh);
    header_.elements.push_back(std::move(element));
    return "";
  }

  std::string take_property(const std::vector<std::string_view>& words) {
    Property property;
    property.is_list = words.size() == 5 && words[1] == "list";
    if (words.size() != 3 && !property.is_list)
      return "expected property TYPE NAME or property list TYPE TYPE NAME";
    property.name = words.back();
    for (std::size_t i = property.is_list ? 2 : 1; i + 1 < words.size(); ++i) {
      const std::optional<Type> type = type_named(words[i]);
      if (!type) return fmt::format("'{}' is no type of PLY", shown(words[i]));
      (property.is_list && i == 2 ? property.count_type : property.type) = *type;
    }
    header_.elements.back().properties.push_back(property);
    return "";
  }

  Result<Header> check_room() {
    std::uint64_t room = bytes_.size() - header_.end;
    for (const Element& element : header_.elements) {
      const std::uint64_t least = element.least_bytes(header_.encoding) * element.count;
      // The last number of a text needs nothing behind it.
      if (least > room + 1)
        return mesh_failure(name_, 0, 0,
                            fmt::format("is cut off: {} of {} do not fit into the {} bytes that "
                                        "are left",
                                        element.count, shown(element.name), room));
      room -= std::min(room, least);
    }
    return std::move(header_);
  }

  std::string_view bytes_;
  const std::string& name_;
  Header header_;
  std::size_t number_ = 0;
};

}  // namespace

std::size_t size_of(Type type) {
  constexpr std::size_t kSizes[] = {1, 1, 2, 2, 4, 4, 4, 8};
  return kSizes[static_cast<std::size_t>(type)];
}

std::uint64_t Element::least_bytes(Encoding encoding) const {
  std::uint64_t bytes = 0;
  for (const Property& property : properties)
    bytes += encoding == Encoding::text
                 ? 2
                 : size_of(property.is_list ? property.count_type : property.type);
  return bytes;
}

Result<Header> read_header(std::string_view bytes, const std::string& name) {
  return HeaderReader(bytes, name).read();
}

}  // namespace zraka::ply
