// SPDX-License-Identifier: Apache-2.0
// Reader of STL.
#include <fmt/format.h>

#include <algorithm>
#include <bit>
#include <cmath>
#include <unordered_map>

#include "core/text.hpp"
#include "mesh/mesh.hpp"

namespace zraka {
namespace {

/// Every facet has its own points: equal ones become one again.
class Points {
 public:
  explicit Points(Mesh& mesh) : mesh_(mesh) {}

  std::uint32_t index_of(const Vec3& point) {
    const Key key = {std::bit_cast<std::uint64_t>(point.x + 0.0),  // -0 is 0
                     std::bit_cast<std::uint64_t>(point.y + 0.0),
                     std::bit_cast<std::uint64_t>(point.z + 0.0)};
    const auto [found, added] =
        indices_.try_emplace(key, static_cast<std::uint32_t>(mesh_.points.size()));
    if (added) mesh_.points.push_back(point);
    return found->second;
  }

 private:
  using Key = std::array<std::uint64_t, 3>;
  struct Hash {
    std::size_t operator()(const Key& key) const {
      std::uint64_t hash = 0;
      for (const std::uint64_t part : key) {
        hash = (hash ^ part) * 0x9E3779B97F4A7C15u;
        hash ^= hash >> 32;
      }
      return static_cast<std::size_t>(hash);
    }
  };
  Mesh& mesh_;
  std::unordered_map<Key, std::uint32_t, Hash> indices_;
};

constexpr std::size_t kBinaryHeader = 84, kBinaryFacet = 50;

std::uint32_t word_at(std::string_view bytes, std::size_t at) {
  std::uint32_t word = 0;
  for (std::size_t i = 4; i-- > 0;) word = word << 8 | static_cast<unsigned char>(bytes[at + i]);
  return word;
}

Result<Mesh> parse_binary(std::string_view bytes, const std::string& name) {
  const std::uint64_t count = word_at(bytes, 80);
  if (count > kMostInMesh)
    return mesh_failure(
        name, 0, 0, fmt::format("{} triangles are too many: at most {} fit", count, kMostInMesh));
  if (bytes.size() < kBinaryHeader + kBinaryFacet * count)
    return mesh_failure(name, 0, 0,
                        fmt::format("is cut off: {} triangles take {} bytes, but it has {}", count,
                                    kBinaryHeader + kBinaryFacet * count, bytes.size()));
  Mesh mesh;
  Points points(mesh);
  for (std::uint64_t i = 0; i < count; ++i) {
    Mesh::Triangle triangle;
    for (std::size_t corner = 0; corner < 3; ++corner) {
      double v[3];
      for (std::size_t axis = 0; axis < 3; ++axis)
        v[axis] = static_cast<double>(std::bit_cast<float>(
            word_at(bytes, kBinaryHeader + kBinaryFacet * i + 12 * (corner + 1) + 4 * axis)));
      if (!std::isfinite(v[0]) || !std::isfinite(v[1]) || !std::isfinite(v[2]))
        return mesh_failure(name, 0, 0, fmt::format("a corner of triangle {} is not finite", i));
      triangle[corner].point = points.index_of({v[0], v[1], v[2]});
    }
    mesh.triangles.push_back(triangle);
  }
  if (mesh.triangles.empty()) return mesh_failure(name, 0, 0, "has no triangles");
  return mesh;
}

class TextReader {
 public:
  TextReader(std::string_view text, const std::string& name) : text_(text), name_(name) {}

  Result<Mesh> read() {
    for (std::string_view keyword = word(); !keyword.empty(); keyword = word()) {
      if (keyword == "solid" || keyword == "facet" || keyword == "endsolid") {
        ended_ = keyword == "endsolid";
        at_ = std::min(text_.find('\n', at_), text_.size());
      } else if (keyword == "vertex") {
        if (corners_ == 3) return fail(keyword, "a facet has more than 3 corners");
        if (!read_corner()) return tl::make_unexpected(std::move(problems_));
      } else if (keyword == "endfacet") {
        if (corners_ != 3)
          return fail(keyword, fmt::format("a facet has {} corners: expected 3", corners_));
        mesh_.triangles.push_back(triangle_);
        corners_ = 0;
      } else if (keyword != "outer" && keyword != "loop" && keyword != "endloop") {
        return fail(keyword, fmt::format("'{}' is no keyword of STL", shown(keyword)));
      }
    }
    if (!ended_) return mesh_failure(name_, 0, 0, "is cut off: it does not end with endsolid");
    if (mesh_.triangles.empty()) return mesh_failure(name_, 0, 0, "has no triangles");
    return std::move(mesh_);
  }

 private:
  static constexpr std::string_view kSpace = " \t\r\n";

  std::string_view word() {
    at_ = std::min(text_.find_first_not_of(kSpace, at_), text_.size());
    const std::size_t end = std::min(text_.find_first_of(kSpace, at_), text_.size());
    const std::string_view found = text_.substr(at_, end - at_);
    at_ = end;
    return found;
  }

  tl::unexpected<Diagnostics> fail(std::string_view word, std::string message) const {
    const TextPosition at =
        TextPositions(text_).at(static_cast<std::size_t>(word.data() - text_.data()));
    return mesh_failure(name_, at.line, at.column, std::move(message));
  }

  bool read_corner() {
    double v[3];
    for (double& number : v) {
      const std::string_view digits = word();
      const std::optional<double> read = parse_number(digits);
      if (!read || !std::isfinite(*read)) {
        problems_ = fail(digits, fmt::format("'{}' is no number: expected x, y and z of a corner",
                                             shown(digits)))
                        .value();
        return false;
      }
      number = *read;
    }
    triangle_[corners_++] = {points_.index_of({v[0], v[1], v[2]})};
    return true;
  }

  std::string_view text_;
  const std::string& name_;
  std::size_t at_ = 0, corners_ = 0;
  bool ended_ = false;
  Mesh mesh_;
  Points points_{mesh_};
  Mesh::Triangle triangle_;
  Diagnostics problems_;
};

}  // namespace

Result<Mesh> parse_stl(std::string_view bytes, const std::string& name) {
  // Binary files may begin with "solid", too: their size tells.
  const bool fits =
      bytes.size() >= kBinaryHeader &&
      bytes.size() == kBinaryHeader + kBinaryFacet * std::uint64_t{word_at(bytes, 80)};
  const std::size_t first = std::min(bytes.find_first_not_of(" \t\r\n"), bytes.size());
  const bool is_text = !fits && bytes.substr(first).starts_with("solid") &&
                       bytes.substr(0, 1000).find('\0') == std::string_view::npos;
  if (is_text) return TextReader(bytes, name).read();
  if (bytes.size() < kBinaryHeader)
    return mesh_failure(name, 0, 0,
                        "is no STL file: it neither begins with solid nor has a header");
  return parse_binary(bytes, name);
}

}  // namespace zraka
