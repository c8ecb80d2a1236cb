// SPDX-License-Identifier: Apache-2.0
// The beginning of a PLY file: what elements there are, and of what properties.
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>
#include <zraka/diagnostic.hpp>

namespace zraka::ply {

enum class Encoding : std::uint8_t { text, little_endian, big_endian };

enum class Type : std::uint8_t { int8, uint8, int16, uint16, int32, uint32, float32, float64 };
std::size_t size_of(Type type);

struct Property {
  std::string_view name;
  Type type = Type::float32;
  bool is_list = false;
  Type count_type = Type::uint8;  ///< of a list
};

struct Element {
  std::string_view name;
  std::uint64_t count = 0;
  std::vector<Property> properties;
  /// That one of them takes at least in this encoding.
  std::uint64_t least_bytes(Encoding encoding) const;
};

struct Header {
  Encoding encoding = Encoding::text;
  std::vector<Element> elements;
  std::size_t end = 0;  ///< where the elements begin in the file
};

/// Fails where it is none, or has more elements than the file has room for.
Result<Header> read_header(std::string_view bytes, const std::string& name);

}  // namespace zraka::ply
