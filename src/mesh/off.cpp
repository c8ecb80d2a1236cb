// SPDX-License-Identifier: Apache-2.0
// Reader of OFF, the Object File Format of Geomview, as text.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <optional>

#include "core/text.hpp"
#include "mesh/mesh.hpp"

namespace zraka {
namespace {

class OffReader {
 public:
  OffReader(std::string_view text, const std::string& name) : text_(text), name_(name) {}

  Result<Mesh> read() {
    // STOFF, COFF, NOFF: with texture coordinates, colours, normals behind each point.
    const std::string_view header = word();
    if (!header.ends_with("OFF") || header.size() > 6 || header.starts_with("4"))
      return fail(fmt::format("'{}' is no header of OFF in three dimensions", shown(header)));
    const std::optional<double> points = number(), faces = number(), edges = number();
    if (!points || !faces || !edges) return fail("the header ends: expected three counts");
    // A point has three numbers at least, a face four, each with a space.
    const auto most = static_cast<double>(text_.size()) + 1;
    if (!(*points >= 0 && *points * 6 <= most && *faces >= 0 && *faces * 8 <= most) ||
        *points > static_cast<double>(kMostInMesh))
      return fail(
          fmt::format("{} points and {} faces are more than the file holds", *points, *faces));
    for (double i = 0; i < *points; ++i) {
      const std::optional<double> x = number(), y = number(), z = number();
      if (!x || !y || !z) return fail(fmt::format("point {} has no three finite numbers", i));
      mesh_.points.push_back({*x, *y, *z});
      skip_line();
    }
    for (double i = 0; i < *faces; ++i)
      if (!read_face(i)) return tl::make_unexpected(std::move(problems_));
    if (mesh_.triangles.empty()) return fail("has no faces");
    return std::move(mesh_);
  }

 private:
  tl::unexpected<Diagnostics> fail(std::string message) {
    return mesh_failure(name_, line_, 0, std::move(message));
  }

  void skip_line() {
    const std::size_t end = std::min(text_.find('\n'), text_.size());
    text_.remove_prefix(end);
  }

  std::string_view word() {
    while (!text_.empty()) {
      if (text_.front() == '#') {
        skip_line();
      } else if (text_.front() == '\n') {
        ++line_;
        text_.remove_prefix(1);
      } else if (text_.front() == ' ' || text_.front() == '\t' || text_.front() == '\r') {
        text_.remove_prefix(1);
      } else {
        break;
      }
    }
    const std::size_t end = std::min(text_.find_first_of(" \t\r\n#"), text_.size());
    const std::string_view found = text_.substr(0, end);
    text_.remove_prefix(end);
    return found;
  }

  std::optional<double> number() {
    const std::string_view digits = word();
    double value = 0;
    const char* const end = digits.data() + digits.size();
    if (digits.empty() || read_number(digits.data(), end, value) != end || !std::isfinite(value))
      return std::nullopt;
    return value;
  }

  bool read_face(double which) {
    const std::optional<double> corners = number();
    const auto refuse = [&](std::string message) {
      problems_ = fail(fmt::format("face {}: {}", which, message)).value();
      return false;
    };
    if (!corners || !(*corners >= 3) || *corners * 2 > static_cast<double>(text_.size()) + 2)
      return refuse("expected the number of its corners, 3 or more");
    corners_.clear();
    for (double i = 0; i < *corners; ++i) {
      const std::optional<double> at = number();
      if (!at || !(*at >= 0) || !(*at < static_cast<double>(mesh_.points.size())) ||
          *at != std::floor(*at))
        return refuse(fmt::format("expected indices of points, less than {}", mesh_.points.size()));
      corners_.push_back({static_cast<std::uint32_t>(*at)});
    }
    skip_line();  // its colour
    mesh_.add_face(corners_);
    return mesh_.triangles.size() <= kMostInMesh ||
           refuse(fmt::format("there are more than {} triangles", kMostInMesh));
  }

  std::string_view text_;
  const std::string& name_;
  std::size_t line_ = 1;
  std::vector<Mesh::Corner> corners_;
  Mesh mesh_;
  Diagnostics problems_;
};

}  // namespace

Result<Mesh> parse_off(std::string_view text, const std::string& name) {
  return OffReader(text, name).read();
}

}  // namespace zraka
