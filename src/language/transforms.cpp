// SPDX-License-Identifier: Apache-2.0
#include "language/transforms.hpp"

#include <fmt/format.h>

#include <array>
#include <bit>
#include <cmath>
#include <vector>

#include "core/text.hpp"
#include "language/section.hpp"
#include "math/elementary.hpp"
#include "scene/bounds_of.hpp"

namespace zraka::language {
namespace {

using NodeKind = toml::Node::Kind;

struct SineAndCosine {
  double sin, cos;
};

/// Of an angle in degrees: brought between 0 and 45 first, which is exact.
SineAndCosine turn_by(double degrees) {
  constexpr double kPi = 3.14159265358979323846;
  const double whole = std::fmod(degrees, 360);
  double left = std::fabs(whole);
  int quarters = 0;
  for (; left > 45; left -= 90) ++quarters;
  const double radians = std::fabs(left) * (kPi / 180);
  double sin = std::fabs(left) == 30 ? 0.5 : elementary::sin(radians);
  const double cos = elementary::cos(radians);
  if (std::fabs(left) == 45) sin = cos;
  if (left < 0) sin = -sin;
  SineAndCosine turn{sin, cos};
  for (; quarters > 0; --quarters) turn = {turn.cos, 0 - turn.sin};
  return whole < 0 ? SineAndCosine{0 - turn.sin, turn.cos} : turn;
}

bool all_finite(const Transform& t) {
  for (const Vec3& v : {t.along_x, t.along_y, t.along_z, t.origin})
    if (!std::isfinite(v.x) || !std::isfinite(v.y) || !std::isfinite(v.z)) return false;
  return true;
}

/// One step of a list, or what is wrong with it.
class StepReader {
 public:
  StepReader(const toml::Node& node, std::string of, Problems& problems)
      : node_(node), of_(std::move(of)), problems_(problems) {}

  std::optional<Transform> read() {
    if (node_.kind != NodeKind::table || node_.children.empty())
      return fail(node_, fmt::format("a step of {} is {}: expected {}", of_,
                                     shown(problems_.source(node_)), kSteps));
    static constexpr std::string_view kKeys[] = {"scale", "rotate", "by_deg", "translate",
                                                 "matrix"};
    for (const toml::Node& child : node_.children)
      if (std::find(std::begin(kKeys), std::end(kKeys), child.key) == std::end(kKeys)) {
        problems_.unknown(child.key_begin,
                          fmt::format("unknown field '{}' of a step of {}", shown(child.key), of_),
                          child.key, kKeys, "fields of a step");
        return std::nullopt;
      }
    const toml::Node *const axis = node_.find("rotate"), *const angle = node_.find("by_deg");
    if (node_.children.size() > (axis != nullptr && angle != nullptr ? 2u : 1u))
      return fail(node_, fmt::format("a step of {} has {} and {}: expected one of them a step", of_,
                                     node_.children[0].key, node_.children.back().key));
    if (angle != nullptr && axis == nullptr)
      return fail(*angle, fmt::format("by_deg of {} has no rotate: expected the axis, {}", of_,
                                      kDirection));
    if (axis != nullptr && angle == nullptr)
      return fail(*axis, fmt::format("rotate of {} has no by_deg: expected the angle in degrees, "
                                     "a number",
                                     of_));
    if (axis != nullptr) return read_rotation(*axis, *angle);
    const toml::Node& only = node_.children.front();
    return only.key == "scale"       ? read_scale(only)
           : only.key == "translate" ? read_translation(only)
                                     : read_matrix(only);
  }

  static constexpr std::string_view kSteps =
      "{scale = …}, {rotate = [x, y, z], by_deg = …}, {translate = [x, y, z]} or "
      "{matrix = [[…], […], […]]}";

 private:
  static constexpr std::string_view kDirection = "a direction [x, y, z], not all 0";

  std::optional<Transform> fail(const toml::Node& where, std::string message) {
    problems_.error(where.begin, std::move(message));
    return std::nullopt;
  }
  std::optional<Transform> refuse(const toml::Node& value, std::string_view expected) {
    return fail(value, fmt::format("{} of {} is {}: expected {}", value.key, of_,
                                   shown(problems_.source(value)), expected));
  }

  std::optional<Vec3> vector_of(const toml::Node& value) const {
    const FieldValue v = value_as(FieldKind::vector, value);
    if (v.index() == 0) return std::nullopt;
    const Vec3& vector = std::get<Vec3>(v);
    if (!std::isfinite(vector.x) || !std::isfinite(vector.y) || !std::isfinite(vector.z))
      return std::nullopt;
    return vector;
  }

  std::optional<Transform> read_scale(const toml::Node& value) {
    std::optional<Vec3> by = vector_of(value);
    if (const FieldValue number = value_as(FieldKind::number, value); number.index() != 0) {
      const double each = std::get<double>(number);
      by = Vec3{each, each, each};
    }
    const Transform scale =
        by ? Transform{{by->x, 0, 0}, {0, by->y, 0}, {0, 0, by->z}, {}} : Transform{{}, {}, {}, {}};
    if (!by || by->x == 0 || by->y == 0 || by->z == 0 || !all_finite(scale))
      return refuse(value, "a number or [x, y, z], finite and none of them 0");
    return scale;
  }

  std::optional<Transform> read_translation(const toml::Node& value) {
    const std::optional<Vec3> by = vector_of(value);
    if (!by) return refuse(value, "[x, y, z], finite numbers");
    Transform translation;
    translation.origin = *by;
    return translation;
  }

  std::optional<Transform> read_rotation(const toml::Node& axis, const toml::Node& angle) {
    const std::optional<Vec3> round = vector_of(axis);
    const FieldValue by = value_as(FieldKind::number, angle);
    if (!round || *round == Vec3{}) return refuse(axis, kDirection);
    if (by.index() == 0 || !std::isfinite(std::get<double>(by))) return refuse(angle, "a number");
    return rotation(*round, std::get<double>(by));
  }

  std::optional<Transform> read_matrix(const toml::Node& value) {
    std::array<std::array<double, 4>, 3> m{};
    bool good = value.kind == NodeKind::array && value.children.size() == 3;
    for (std::size_t row = 0; good && row < 3; ++row) {
      const toml::Node& numbers = value.children[row];
      good = numbers.kind == NodeKind::array && numbers.children.size() == 4;
      for (std::size_t column = 0; good && column < 4; ++column) {
        const FieldValue number = value_as(FieldKind::number, numbers.children[column]);
        good = number.index() != 0 && std::isfinite(std::get<double>(number));
        if (good) m[row][column] = std::get<double>(number);
      }
    }
    if (!good) return refuse(value, "three rows of four finite numbers: [[…4], […4], […4]]");
    const auto column = [&](std::size_t k) { return Vec3{m[0][k], m[1][k], m[2][k]}; };
    const Transform matrix{column(0), column(1), column(2), column(3)};
    if (!inverse(matrix))
      return fail(value, fmt::format("matrix of {} makes all that it moves flat: expected one that "
                                     "has an inverse",
                                     of_));
    return matrix;
  }

  const toml::Node& node_;
  std::string of_;
  Problems& problems_;
};

}  // namespace

Transform rotation(const Vec3& axis, double degrees) {
  const double largest =
      std::fmax(std::fabs(axis.x), std::fmax(std::fabs(axis.y), std::fabs(axis.z)));
  Vec3 n{axis.x / largest, axis.y / largest, axis.z / largest};
  const double length = std::sqrt(n.x * n.x + n.y * n.y + n.z * n.z);
  n = {n.x / length, n.y / length, n.z / length};
  const auto [s, c] = turn_by(degrees);
  const double xx = n.x * n.x, yy = n.y * n.y, zz = n.z * n.z, rest = 1 - c;
  const double xy = n.x * n.y * rest, yz = n.y * n.z * rest, zx = n.z * n.x * rest;
  // Rodrigues' formula, in a form that is exact for the axes x, y and z.
  return {{xx + c * (yy + zz), xy + n.z * s, zx - n.y * s},
          {xy - n.z * s, yy + c * (zz + xx), yz + n.x * s},
          {zx + n.y * s, yz - n.x * s, zz + c * (xx + yy)},
          {}};
}

std::optional<Transform> read_transform(const toml::Node& node, std::string_view key,
                                        std::string_view what, Problems& problems) {
  const std::string of = fmt::format("{} of {}", key, what);
  if (node.kind != NodeKind::array) {
    problems.error(node.begin, fmt::format("{} is {}: expected {}", of,
                                           shown(problems.source(node)), expected_transform()));
    return std::nullopt;
  }
  std::optional<Transform> all = Transform{};
  for (std::size_t i = 0; i < node.children.size(); ++i) {
    const std::optional<Transform> step = StepReader(node.children[i], of, problems).read();
    if (!step || !all)
      all = std::nullopt;
    else
      all = i == 0 ? *step : then(*all, *step);
  }
  if (!all || is_readable(*all)) return all;
  problems.error(node.begin, fmt::format("{}: its steps together are too large or too small for "
                                         "numbers",
                                         of));
  return std::nullopt;
}

std::string expected_transform() {
  return fmt::format("a list of steps: {}", StepReader::kSteps);
}

bool is_readable(const Transform& transform) {
  if (!all_finite(transform)) return false;
  const std::optional<Transform> back = inverse(transform);
  return back && all_finite(*back);
}

std::string text_of(const Transform& t) {
  if (t == Transform{}) return "[]";
  const auto written = [](std::initializer_list<double> numbers) {
    std::string text;
    for (const double number : numbers) text += (text.empty() ? "" : ", ") + text_of(number);
    return "[" + text + "]";
  };
  const auto same = [](const Vec3& a, const Vec3& b) {
    return std::bit_cast<std::array<std::uint64_t, 3>>(a) ==
           std::bit_cast<std::array<std::uint64_t, 3>>(b);
  };
  const Transform none;
  if (same(t.along_x, none.along_x) && same(t.along_y, none.along_y) &&
      same(t.along_z, none.along_z))
    return fmt::format("[{{translate = {}}}]", text_of(t.origin));
  const double x = t.along_x.x, y = t.along_y.y, z = t.along_z.z;
  if (same(t.along_x, {x, 0, 0}) && same(t.along_y, {0, y, 0}) && same(t.along_z, {0, 0, z}) &&
      same(t.origin, {}))
    return fmt::format("[{{scale = {}}}]", x == y && y == z ? text_of(x) : written({x, y, z}));
  return fmt::format("[{{matrix = [{}, {}, {}]}}]",
                     written({t.along_x.x, t.along_y.x, t.along_z.x, t.origin.x}),
                     written({t.along_x.y, t.along_y.y, t.along_z.y, t.origin.y}),
                     written({t.along_x.z, t.along_y.z, t.along_z.z, t.origin.z}));
}

std::uint32_t index_of(const Transform& transform, Input& input) {
  if (transform == Transform{}) return 0;
  const auto bits = std::bit_cast<TransformBits>(transform);
  const auto [place, added] = input.transforms.try_emplace(
      bits, static_cast<std::uint32_t>(input.scene.transforms.size() + 1));
  if (added) input.scene.transforms.push_back(transform);
  return place->second;
}

}  // namespace zraka::language
