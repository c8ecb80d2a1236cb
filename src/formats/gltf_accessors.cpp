// SPDX-License-Identifier: Apache-2.0
// glTF's accessors: numbers of six types in buffers, some given one by one.
#include <fmt/format.h>

#include <cmath>
#include <cstring>
#include <limits>

#include "formats/gltf_file.hpp"

namespace zraka {
namespace {

constexpr int kByte = 5120, kUnsignedByte = 5121, kShort = 5122, kUnsignedShort = 5123,
              kUnsignedInt = 5125, kFloat = 5126;

std::size_t bytes_of(int type) {
  switch (type) {
    case kByte:
    case kUnsignedByte:
      return 1;
    case kShort:
    case kUnsignedShort:
      return 2;
    case kUnsignedInt:
    case kFloat:
      return 4;
    default:
      return 0;
  }
}

/// Little-endian, whatever the machine.
std::uint32_t bits_at(const char* p, std::size_t bytes) {
  std::uint32_t bits = 0;
  for (std::size_t i = 0; i < bytes; ++i)
    bits |= static_cast<std::uint32_t>(static_cast<unsigned char>(p[i])) << (8 * i);
  return bits;
}

double value_at(const char* p, int type, bool normalized) {
  const std::uint32_t bits = bits_at(p, bytes_of(type));
  switch (type) {
    case kByte: {
      const double value = static_cast<std::int8_t>(bits);
      return normalized ? std::fmax(value / 127, -1) : value;
    }
    case kUnsignedByte:
      return normalized ? bits / 255.0 : bits;
    case kShort: {
      const double value = static_cast<std::int16_t>(bits);
      return normalized ? std::fmax(value / 32767, -1) : value;
    }
    case kUnsignedShort:
      return normalized ? bits / 65535.0 : bits;
    case kFloat: {
      float value = 0;
      std::memcpy(&value, &bits, 4);
      return static_cast<double>(value);
    }
    default:
      return bits;
  }
}

}  // namespace

std::optional<GltfFile::Layout> GltfFile::layout_of(const Json& accessor, std::size_t index) {
  struct Kind {
    std::string_view name;
    std::size_t width;
  };
  constexpr Kind kKinds[] = {{"SCALAR", 1}, {"VEC2", 2}, {"VEC3", 3},
                             {"VEC4", 4},   {"MAT3", 9}, {"MAT4", 16}};
  Layout layout;
  const double type = number(&accessor, "componentType", 0);
  layout.type = type >= kByte && type <= kFloat ? static_cast<int>(type) : 0;
  layout.bytes = bytes_of(layout.type);
  layout.normalized = flag(&accessor, "normalized", false);
  layout.width = 0;
  const std::string kind = word(&accessor, "type", "");
  for (const Kind& known : kKinds)
    if (kind == known.name) layout.width = known.width;
  const double count = number(&accessor, "count", 0);
  if (layout.bytes == 0 || layout.width == 0 || !(count >= 0) || count != std::floor(count) ||
      count > 0xFFFFFFFE) {
    fail(fmt::format("accessor {} has no 'count', 'type' and 'componentType' of glTF", index));
    return std::nullopt;
  }
  layout.count = static_cast<std::size_t>(count);
  return layout;
}

bool GltfFile::read_elements(const Json& from, const Layout& layout, std::size_t index,
                             bool has_stride, std::vector<double>& values) {
  const std::optional<std::size_t> at = this->index(&from, "bufferView", "bufferViews");
  const std::optional<std::string_view> bytes = at ? view(*at) : std::nullopt;
  if (!bytes) {
    if (good()) fail(fmt::format("accessor {} has no bytes", index));
    return false;
  }
  const std::size_t own = layout.bytes * layout.width;
  double stride = static_cast<double>(own), offset = number(&from, "byteOffset", 0);
  if (has_stride) stride = number(item("bufferViews", *at), "byteStride", stride);
  const auto size = static_cast<double>(bytes->size());
  if (!(stride >= static_cast<double>(own)) || stride != std::floor(stride) || !(offset >= 0) ||
      offset != std::floor(offset) ||
      (layout.count > 0 &&
       offset + stride * static_cast<double>(layout.count - 1) + static_cast<double>(own) > size)) {
    fail(
        fmt::format("accessor {} has {} elements of {} bytes, more than its buffer view's {} bytes "
                    "hold",
                    index, layout.count, own, bytes->size()));
    return false;
  }
  values.resize(layout.count * layout.width);
  const char* p = bytes->data() + static_cast<std::size_t>(layout.count > 0 ? offset : 0);
  const auto step = static_cast<std::size_t>(layout.count > 0 ? stride : 0);
  for (std::size_t i = 0; i < layout.count; ++i, p += i < layout.count ? step : 0)
    for (std::size_t k = 0; k < layout.width; ++k)
      values[i * layout.width + k] = value_at(p + k * layout.bytes, layout.type, layout.normalized);
  return true;
}

/// Some elements by their indices.
bool GltfFile::read_sparse(const Json& accessor, const Layout& layout, std::size_t index,
                           std::vector<double>& values) {
  const Json* const sparse = member(&accessor, "sparse");
  const Json* const where = member(sparse, "indices");
  const Json* const what = member(sparse, "values");
  if (where == nullptr || what == nullptr)
    return fail(fmt::format("accessor {} is sparse without indices and values", index)), false;
  Layout few = layout, indices;
  const double count = number(sparse, "count", 0);
  if (!(count >= 0) || count != std::floor(count) || count > static_cast<double>(layout.count))
    return fail(fmt::format("accessor {} has {} elements, and {} others instead of them", index,
                            layout.count, count)),
           false;
  few.count = indices.count = static_cast<std::size_t>(count);
  const double type = number(where, "componentType", 0);
  indices.type = type >= kByte && type <= kFloat ? static_cast<int>(type) : 0;
  indices.bytes = bytes_of(indices.type);
  std::vector<double> places, others;
  if (indices.bytes == 0 || !read_elements(*where, indices, index, false, places) ||
      !read_elements(*what, few, index, false, others))
    return good() && (fail(fmt::format("accessor {} has indices of no type", index)), false);
  for (std::size_t i = 0; i < few.count; ++i) {
    if (!(places[i] >= 0) || !(places[i] < static_cast<double>(layout.count)) ||
        places[i] != std::floor(places[i]))
      return fail(fmt::format("accessor {} has no element {}", index, places[i])), false;
    for (std::size_t k = 0; k < layout.width; ++k)
      values[static_cast<std::size_t>(places[i]) * layout.width + k] = others[i * layout.width + k];
  }
  return true;
}

std::optional<std::vector<double>> GltfFile::read_accessor(std::size_t index, Layout& layout) {
  const Json* const accessor = item("accessors", index);
  const std::optional<Layout> found =
      accessor != nullptr ? layout_of(*accessor, index) : std::nullopt;
  if (!found) return std::nullopt;
  layout = *found;
  std::vector<double> values;
  const bool is_sparse = member(accessor, "sparse") != nullptr;
  if (member(accessor, "bufferView") != nullptr) {
    if (!read_elements(*accessor, layout, index, true, values)) return std::nullopt;
  } else {
    // All 0: no bytes stand for them.
    constexpr std::size_t kMostZeros = std::size_t{1} << 22;
    if (layout.count * layout.width > kMostZeros) {
      fail(fmt::format("accessor {} has {} elements without bytes", index, layout.count));
      return std::nullopt;
    }
    values.resize(layout.count * layout.width);
  }
  if (is_sparse && !read_sparse(*accessor, layout, index, values)) return std::nullopt;
  return values;
}

std::optional<GltfNumbers> GltfFile::read_numbers(std::size_t index) {
  Layout layout;
  const std::optional<std::vector<double>> values = read_accessor(index, layout);
  if (!values) return std::nullopt;
  GltfNumbers numbers{layout.count, layout.width, {}};
  numbers.values.reserve(values->size());
  for (const double value : *values) numbers.values.push_back(static_cast<float>(value));
  return numbers;
}

const GltfNumbers* GltfFile::accessor(std::size_t index, std::size_t width,
                                      std::size_t other_width) {
  auto known = accessors_.find(index);
  if (known == accessors_.end()) known = accessors_.emplace(index, read_numbers(index)).first;
  if (!known->second) return nullptr;
  const GltfNumbers& numbers = *known->second;
  if (numbers.width == width || numbers.width == other_width) return &numbers;
  fail(fmt::format("accessor {} has {} numbers an element: expected {}", index, numbers.width,
                   width));
  return nullptr;
}

std::optional<std::vector<std::uint32_t>> GltfFile::indices(std::size_t index) {
  Layout layout;
  const std::optional<std::vector<double>> values = read_accessor(index, layout);
  if (!values) return std::nullopt;
  if (layout.width != 1 || layout.type == kFloat || layout.normalized) {
    fail(fmt::format("accessor {} holds no indices: expected whole numbers", index));
    return std::nullopt;
  }
  std::vector<std::uint32_t> whole;
  whole.reserve(values->size());
  for (const double value : *values)
    whole.push_back(value < 0 ? 0xFFFFFFFF : static_cast<std::uint32_t>(value));
  return whole;
}

}  // namespace zraka
