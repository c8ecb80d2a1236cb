// SPDX-License-Identifier: Apache-2.0
// Reader of Wavefront OBJ.
#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <map>
#include <optional>

#include "core/text.hpp"
#include "mesh/mesh.hpp"

namespace zraka {
namespace {

class ObjReader {
 public:
  ObjReader(std::string_view text, const std::string& name) : text_(text), name_(name) {}

  Result<Mesh> read() {
    while (!text_.empty() && problems_.empty()) {
      number_ += 1 + further_lines_;
      take_line();
      rest_ = line_;
      const std::string_view keyword = word();
      if (keyword == "v")
        read_point();
      else if (keyword == "vn")
        read_normal();
      else if (keyword == "vt")
        read_uv();
      else if (keyword == "f")
        read_face();
      else if (keyword == "usemtl")
        use_material();
      else if (keyword == "mtllib" && !trimmed(rest_).empty())
        mesh_.material_files.emplace_back(trimmed(rest_));
    }
    if (problems_.empty() && mesh_.triangles.empty())
      fail(0, "has no faces: no line begins with f");
    if (!problems_.empty()) return tl::make_unexpected(std::move(problems_));
    return std::move(mesh_);
  }

 private:
  /// The next line, put together where a \ ends one that goes on.
  void take_line() {
    const std::size_t end = std::min(text_.find('\n'), text_.size());
    line_ = text_.substr(0, end);
    text_.remove_prefix(std::min(end + 1, text_.size()));
    if (!line_.empty() && line_.back() == '\r') line_.remove_suffix(1);
    joined_.clear();
    further_lines_ = 0;
    while (!line_.empty() && line_.back() == '\\' && !text_.empty()) {
      if (joined_.empty()) joined_ = line_;
      joined_.back() = ' ';
      const std::size_t next = std::min(text_.find('\n'), text_.size());
      joined_ += text_.substr(0, next);
      text_.remove_prefix(std::min(next + 1, text_.size()));
      if (!joined_.empty() && joined_.back() == '\r') joined_.pop_back();
      ++further_lines_;
      line_ = joined_;
    }
    line_ = line_.substr(0, line_.find('#'));
  }

  std::string_view word() {
    while (!rest_.empty() && (rest_.front() == ' ' || rest_.front() == '\t'))
      rest_.remove_prefix(1);
    const std::size_t end = std::min(rest_.find_first_of(" \t"), rest_.size());
    const std::string_view found = rest_.substr(0, end);
    rest_.remove_prefix(end);
    return found;
  }

  void fail(std::size_t column, std::string message) {
    if (problems_.empty())
      problems_ =
          mesh_failure(name_, column == 0 ? 0 : number_, column, std::move(message)).value();
  }
  void fail_at(std::string_view word, std::string message) {
    fail(static_cast<std::size_t>(word.data() - line_.data()) + 1, std::move(message));
  }

  std::optional<double> number(std::string_view what) {
    std::string_view digits = word();
    const std::string_view as_written = digits;
    if (digits.empty()) {
      fail(line_.size() + 1, fmt::format("the line ends: expected {}", what));
      return std::nullopt;
    }
    if (digits.front() == '+') digits.remove_prefix(1);
    double value = 0;
    const char* const end = digits.data() + digits.size();
    if (read_number(digits.data(), end, value) == end && std::isfinite(value)) return value;
    fail_at(as_written, fmt::format("'{}' is no number: expected {}", shown(as_written), what));
    return std::nullopt;
  }

  std::optional<Vec3> vector(std::string_view what) {
    const std::optional<double> x = number(what), y = x ? number(what) : x,
                                z = y ? number(what) : y;
    return z ? std::optional(Vec3{*x, *y, *z}) : std::nullopt;
  }

  void read_point() {
    if (const auto v = vector("x, y and z of a point")) mesh_.points.push_back(*v);
  }
  void read_normal() {
    if (const auto v = vector("x, y and z of a normal")) mesh_.normals.push_back(*v);
  }
  void read_uv() {
    const std::optional<double> u = number("u and v");
    if (!u) return;
    const std::string_view before = rest_;
    const bool has_v = !word().empty();
    rest_ = before;
    const std::optional<double> v = has_v ? number("u and v") : 0;
    if (!v) return;
    if (!fits_float(*u) || !fits_float(*v)) return fail(1, "u and v are too large");
    mesh_.uvs.push_back({static_cast<float>(*u), static_cast<float>(*v)});
  }

  /// Indices count from 1, or backwards from the last one.
  std::optional<std::uint32_t> index(std::string_view digits, std::size_t count,
                                     std::string_view what) {
    std::int64_t value = 0;
    const char* const end = digits.data() + digits.size();
    const auto [behind, error] = std::from_chars(digits.data(), end, value);
    if (behind != end || error != std::errc()) {
      fail_at(digits, fmt::format("'{}' is no index of a {}", shown(digits), what));
      return std::nullopt;
    }
    const auto all = static_cast<std::int64_t>(count);
    if (value == 0 || value > all || value < -all) {
      fail_at(digits, fmt::format("{} {} is not there: so far there are {}", what, value, count));
      return std::nullopt;
    }
    return static_cast<std::uint32_t>(value > 0 ? value - 1 : all + value);
  }

  std::optional<Mesh::Corner> corner(std::string_view word) {
    Mesh::Corner made;
    std::string_view parts[3];
    for (std::string_view& part : parts) {
      const std::size_t end = std::min(word.find('/'), word.size());
      part = word.substr(0, end);
      word.remove_prefix(std::min(end + 1, word.size()));
    }
    const auto point = index(parts[0], mesh_.points.size(), "point");
    if (!point) return std::nullopt;
    made.point = *point;
    if (!parts[1].empty()) {
      const auto uv = index(parts[1], mesh_.uvs.size(), "uv");
      if (!uv) return std::nullopt;
      made.uv = *uv;
    }
    if (!parts[2].empty()) {
      const auto normal = index(parts[2], mesh_.normals.size(), "normal");
      if (!normal) return std::nullopt;
      made.normal = *normal;
    }
    return made;
  }

  /// Of the faces that follow.
  void use_material() {
    if (mesh_.material_names.empty()) mesh_.materials.resize(mesh_.triangles.size(), Mesh::kNone);
    const auto [known, added] = materials_.try_emplace(
        std::string(trimmed(rest_)), static_cast<std::uint32_t>(mesh_.material_names.size()));
    if (added) mesh_.material_names.push_back(known->first);
    material_ = known->second;
  }

  void read_face() {
    corners_.clear();
    for (std::string_view each = word(); !each.empty(); each = word()) {
      const std::optional<Mesh::Corner> found = corner(each);
      if (!found) return;
      corners_.push_back(*found);
    }
    if (corners_.size() < 3)
      return fail(1, fmt::format("a face has {} corners: expected 3 or more", corners_.size()));
    mesh_.add_face(corners_);
    if (!mesh_.material_names.empty()) mesh_.materials.resize(mesh_.triangles.size(), material_);
    if (mesh_.triangles.size() > kMostInMesh)
      fail(1, fmt::format("there are more than {} triangles", kMostInMesh));
  }

  std::string_view text_, line_, rest_;
  std::string joined_;
  const std::string& name_;
  std::size_t number_ = 0, further_lines_ = 0;
  std::vector<Mesh::Corner> corners_;
  std::map<std::string, std::uint32_t> materials_;
  std::uint32_t material_ = Mesh::kNone;
  Mesh mesh_;
  Diagnostics problems_;
};

}  // namespace

Result<Mesh> parse_obj(std::string_view text, const std::string& name) {
  return ObjReader(text, name).read();
}

}  // namespace zraka
