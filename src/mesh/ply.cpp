// SPDX-License-Identifier: Apache-2.0
// Reader of PLY.
#include <fmt/format.h>

#include <bit>
#include <cmath>
#include <cstring>
#include <optional>

#include "core/text.hpp"
#include "mesh/mesh.hpp"
#include "mesh/ply_header.hpp"

namespace zraka {
namespace {

using ply::Element;
using ply::Encoding;
using ply::Property;
using ply::Type;

template <class T>
double value_at(const char* bytes, bool swapped) {
  char own[sizeof(T)];
  for (std::size_t i = 0; i < sizeof(T); ++i) own[i] = bytes[swapped ? sizeof(T) - 1 - i : i];
  T value;
  std::memcpy(&value, own, sizeof(T));
  return static_cast<double>(value);
}

/// The numbers of a file, one after the other.
class Numbers {
 public:
  Numbers(std::string_view bytes, const ply::Header& header)
      : bytes_(bytes), at_(header.end), encoding_(header.encoding) {}

  /// None where the file ends, or in a text where no number stands.
  std::optional<double> next(Type type) {
    return encoding_ == Encoding::text ? next_of_text() : next_of_bytes(type);
  }
  std::size_t left() const { return bytes_.size() - at_; }
  bool is_text() const { return encoding_ == Encoding::text; }
  std::size_t position() const { return at_; }

 private:
  std::optional<double> next_of_text() {
    while (at_ < bytes_.size() && std::strchr(" \t\r\n", bytes_[at_]) != nullptr) ++at_;
    const char *const begin = bytes_.data() + at_, *const end = bytes_.data() + bytes_.size();
    double value = 0;
    const char* const behind = begin < end ? read_number(begin, end, value) : nullptr;
    if (behind == nullptr) return std::nullopt;
    at_ += static_cast<std::size_t>(behind - begin);
    return value;
  }

  std::optional<double> next_of_bytes(Type type) {
    const std::size_t size = ply::size_of(type);
    if (left() < size) return std::nullopt;
    const char* const bytes = bytes_.data() + at_;
    at_ += size;
    const bool swapped =
        (encoding_ == Encoding::big_endian) == (std::endian::native == std::endian::little);
    switch (type) {
      case Type::int8:
        return value_at<std::int8_t>(bytes, swapped);
      case Type::uint8:
        return value_at<std::uint8_t>(bytes, swapped);
      case Type::int16:
        return value_at<std::int16_t>(bytes, swapped);
      case Type::uint16:
        return value_at<std::uint16_t>(bytes, swapped);
      case Type::int32:
        return value_at<std::int32_t>(bytes, swapped);
      case Type::uint32:
        return value_at<std::uint32_t>(bytes, swapped);
      case Type::float32:
        return value_at<float>(bytes, swapped);
      case Type::float64:
        return value_at<double>(bytes, swapped);
    }
    return std::nullopt;
  }

  std::string_view bytes_;
  std::size_t at_;
  Encoding encoding_;
};

class PlyReader {
 public:
  PlyReader(std::string_view bytes, const std::string& name, const ply::Header& header)
      : bytes_(bytes), name_(name), header_(header), numbers_(bytes, header) {}

  Result<Mesh> read() {
    for (const Element& element : header_.elements) {
      std::string problem;
      for (std::uint64_t i = 0; i < element.count && problem.empty(); ++i)
        problem = element.name == "vertex" ? take_vertex(element)
                  : element.name == "face" ? take_face(element)
                                           : skip(element);
      if (!problem.empty()) return fail(std::move(problem));
    }
    if (mesh_.triangles.empty()) return mesh_failure(name_, 0, 0, "has no faces");
    return std::move(mesh_);
  }

 private:
  tl::unexpected<Diagnostics> fail(std::string message) const {
    if (!numbers_.is_text()) return mesh_failure(name_, 0, 0, std::move(message));
    const TextPosition at = TextPositions(bytes_).at(numbers_.position());
    return mesh_failure(name_, at.line, at.column, std::move(message));
  }

  std::string no_number(const Element& element) const {
    return numbers_.left() == 0 || !numbers_.is_text()
               ? fmt::format("is cut off among its elements '{}'", shown(element.name))
               : fmt::format("expected a number of an element '{}'", shown(element.name));
  }

  /// Values of a property into list_; of one that is no list, one.
  bool take(const Property& property) {
    list_.clear();
    std::size_t count = 1;
    if (property.is_list) {
      const std::optional<double> read = numbers_.next(property.count_type);
      if (!read || !(*read >= 0 && *read <= static_cast<double>(kMostInMesh)) ||
          *read != std::floor(*read))
        return false;
      count = static_cast<std::size_t>(*read);
    }
    for (; count > 0; --count) {
      const std::optional<double> value = numbers_.next(property.type);
      if (!value) return false;
      list_.push_back(*value);
    }
    return true;
  }

  std::string skip(const Element& element) {
    for (const Property& property : element.properties)
      if (!take(property)) return no_number(element);
    return "";
  }

  std::string take_vertex(const Element& element) {
    Vec3 point, normal;
    double u = 0, v = 0;
    bool has_normal = false, has_uv = false;
    for (const Property& property : element.properties) {
      if (!take(property)) return no_number(element);
      if (property.is_list) continue;
      const double value = list_.front();
      const auto is = [&](std::string_view name) { return property.name == name; };
      double* const into = is("x")                                 ? &point.x
                           : is("y")                               ? &point.y
                           : is("z")                               ? &point.z
                           : is("nx")                              ? &normal.x
                           : is("ny")                              ? &normal.y
                           : is("nz")                              ? &normal.z
                           : is("u") || is("s") || is("texture_u") ? &u
                           : is("v") || is("t") || is("texture_v") ? &v
                                                                   : nullptr;
      if (into == nullptr) continue;
      *into = value;
      has_normal = has_normal || is("nx");
      has_uv = has_uv || into == &u;
      if (!std::isfinite(value) || ((into == &u || into == &v) && !fits_float(value)))
        return fmt::format("{} of point {} is not finite", property.name, mesh_.points.size());
    }
    mesh_.points.push_back(point);
    if (has_normal) mesh_.normals.push_back(normal);
    if (has_uv) mesh_.uvs.push_back({static_cast<float>(u), static_cast<float>(v)});
    return "";
  }

  std::string take_face(const Element& element) {
    corners_.clear();
    for (const Property& property : element.properties) {
      if (!take(property)) return no_number(element);
      if (property.name != "vertex_indices" && property.name != "vertex_index") continue;
      for (const double index : list_) {
        if (!(index >= 0 && index < static_cast<double>(mesh_.points.size())) ||
            index != std::floor(index))
          return fmt::format("point {} of face {} is not there: there are {}", index, faces_,
                             mesh_.points.size());
        const auto point = static_cast<std::uint32_t>(index);
        corners_.push_back({point, point < mesh_.normals.size() ? point : Mesh::kNone,
                            point < mesh_.uvs.size() ? point : Mesh::kNone});
      }
    }
    if (corners_.size() < 3)
      return fmt::format("face {} has {} corners: expected 3 or more", faces_, corners_.size());
    ++faces_;
    mesh_.add_face(corners_);
    return mesh_.triangles.size() > kMostInMesh
               ? fmt::format("there are more than {} triangles", kMostInMesh)
               : "";
  }

  std::string_view bytes_;
  const std::string& name_;
  const ply::Header& header_;
  Numbers numbers_;
  std::vector<double> list_;
  std::vector<Mesh::Corner> corners_;
  std::uint64_t faces_ = 0;
  Mesh mesh_;
};

}  // namespace

Result<Mesh> parse_ply(std::string_view bytes, const std::string& name) {
  const Result<ply::Header> header = ply::read_header(bytes, name);
  if (!header) return tl::make_unexpected(header.error());
  return PlyReader(bytes, name, *header).read();
}

}  // namespace zraka
