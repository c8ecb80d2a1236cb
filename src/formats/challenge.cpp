// SPDX-License-Identifier: Apache-2.0
#include "formats/challenge.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "core/text.hpp"
#include "formats/vectors.hpp"
#include "scene/view.hpp"

namespace zraka {
namespace {

/// Definitions that are made of definitions grow: so many nodes in all.
constexpr std::size_t kMostNodes = 1'000'000;
constexpr int kDeepest = 32;

std::size_t nodes_in(const yaml::Node& node) {
  std::size_t all = 1;
  for (const yaml::Node& item : node.items) all += nodes_in(item);
  for (const auto& [key, value] : node.members) all += nodes_in(value);
  return all;
}

}  // namespace

void ChallengeReader::fail(const Node& at, std::string message, std::string hint) {
  constexpr std::size_t kEnough = 100;
  if (errors_.size() < kEnough)
    errors_.push_back(
        {.file = name_, .line = at.line, .message = std::move(message), .hint = std::move(hint)});
}

void ChallengeReader::warn(const Node& at, std::string message) {
  constexpr std::size_t kMost = 100;
  for (const Diagnostic& said : read_.warnings)
    if (said.message == message) return;
  if (read_.warnings.size() < kMost)
    read_.warnings.push_back({.severity = Severity::warning,
                              .file = name_,
                              .line = at.line,
                              .message = std::move(message)});
}

std::optional<double> ChallengeReader::number(const Node& of, std::string_view key, double usual) {
  const Node* const node = of.find(key);
  if (node == nullptr) return usual;
  if (const std::optional<double> value = node->number()) return value;
  fail(*node, fmt::format("'{}' of {} is no finite number", shown(node->text), key));
  return std::nullopt;
}

bool ChallengeReader::flag(const Node& of, std::string_view key, bool usual) {
  const Node* const node = of.find(key);
  if (node == nullptr) return usual;
  if (node->text == "true" || node->text == "yes") return true;
  if (node->text == "false" || node->text == "no") return false;
  fail(*node, fmt::format("'{}' of {} is neither true nor false", shown(node->text), key));
  return usual;
}

std::optional<Vec3> ChallengeReader::vector(const Node& node, std::string_view what) {
  if (node.is_list() && node.items.size() == 3) {
    const auto x = node.items[0].number(), y = node.items[1].number(), z = node.items[2].number();
    if (x && y && z) return Vec3{*x, *y, *z};
  }
  fail(node, fmt::format("{} is no list of three finite numbers", what));
  return std::nullopt;
}

Vec3 ChallengeReader::vector(const Node& of, std::string_view key, const Vec3& usual) {
  const Node* const node = of.find(key);
  return node == nullptr ? usual : vector(*node, key).value_or(usual);
}

/// Maps are joined key by key, and all else is replaced.
ChallengeReader::Node ChallengeReader::merged(const Node& base, const Node& over) {
  if (!base.is_map() || !over.is_map()) return over;
  Node both = base;
  both.line = over.line;
  for (const auto& [key, value] : over.members) {
    const auto known = std::find_if(both.members.begin(), both.members.end(),
                                    [&](const auto& member) { return member.first == key; });
    if (known == both.members.end())
      both.members.emplace_back(key, value);
    else
      known->second = merged(known->second, value);
  }
  return both;
}

void ChallengeReader::define(const Node& item) {
  const Node& name = *item.find("define");
  const Node* const value = item.find("value");
  if (value == nullptr)
    return fail(item, fmt::format("'{}' is defined without a value", shown(name.text)));
  Node made = *value;
  if (const Node* const parent = item.find("extend")) {
    const auto known = definitions_.find(parent->text);
    if (known == definitions_.end())
      return fail(*parent, fmt::format("'{}' is not defined before this", shown(parent->text)));
    made = merged(known->second, made);
  }
  defined_ += nodes_in(made);
  if (defined_ > kMostNodes) return fail(item, "the definitions of this file become too many");
  definitions_.insert_or_assign(name.text, std::move(made));
}

ChallengeReader::Node ChallengeReader::expanded(const Node& item, int depth) {
  const std::string kind = kind_of(item);
  const auto known = definitions_.find(kind);
  if (known == definitions_.end()) return item;
  if (depth > kDeepest || defined_ > kMostNodes) {
    fail(item, fmt::format("'{}' is defined by itself, or too deep", shown(kind)));
    return item;
  }
  Node own = item;
  std::erase_if(own.members,
                [](const auto& member) { return member.first == "add" || member.first == "type"; });
  Node made = merged(known->second, own);
  made.line = item.line;
  defined_ += nodes_in(made);
  return expanded(made, depth + 1);
}

/// Left-handed: what is right of the view is up × view. The angle is that of the longer side.
void ChallengeReader::add_camera(const Node& item) {
  const auto width = number(item, "width", 100), height = number(item, "height", 100);
  const auto angle = number(item, "field-of-view", 1.0471975511965976);
  const Vec3 from = vector(item, "from", {0, 0, -5}), to = vector(item, "to", {0, 0, 0});
  const Vec3 up = vector(item, "up", {0, 1, 0});
  if (!width || !height || !angle) return;
  if (!(*width >= 1 && *height >= 1) || *width != std::floor(*width) ||
      *height != std::floor(*height) || *width * *height > static_cast<double>(kMaxPixels))
    return fail(item, fmt::format("the camera has {} by {} pixels: expected whole numbers, 1 or "
                                  "more, of at most {} pixels",
                                  *width, *height, kMaxPixels));
  if (!(*angle > 0 && *angle < 3.14))
    return fail(item,
                fmt::format("field-of-view is {}: expected radians between 0 and 3.14", *angle));
  const double aspect = *width / *height;
  const double tall = std::tan(*angle / 2) / std::max(aspect, 1.0);
  const double degrees = std::atan(tall) * 360 / 3.14159265358979323846;
  std::optional<Camera> camera = look_at(from, to, up, degrees, aspect);
  if (!camera) return fail(item, "the camera is where it looks at, or its up is along the view");
  camera->window_right = camera->window_right * -1;
  scene_.camera = *camera;
  scene_.resolution = {static_cast<std::uint32_t>(*width), static_cast<std::uint32_t>(*height)};
  has_camera_ = true;
}

void ChallengeReader::add_light(const Node& item) {
  Light light;
  const Vec3 c = vector(item, "intensity", {1, 1, 1});
  light.color = {std::max(c.x, 0.0), std::max(c.y, 0.0), std::max(c.z, 0.0)};
  light.position = vector(item, "at", {0, 0, 0});
  if (item.find("corner") != nullptr) {
    const auto u = number(item, "usteps", 4), v = number(item, "vsteps", 4);
    if (!u || !v) return;
    light.kind = LightKind::rectangle;
    light.position = vector(item, "corner", {});
    light.edge_u = vector(item, "uvec", {1, 0, 0});
    light.edge_v = vector(item, "vvec", {0, 1, 0});
    if (!spans_a_plane(light.edge_u, light.edge_v))
      return fail(item, "uvec and vvec of a light are parallel");
    light.samples = static_cast<int>(std::clamp(*u * *v, 1.0, static_cast<double>(kMaxSamples)));
  }
  scene_.lights.push_back(light);
}

void ChallengeReader::read_item(const Node& item) {
  if (!item.is_map()) return fail(item, "expected '- add: …' or '- define: …'");
  if (item.find("define") != nullptr) return define(item);
  if (item.find("add") == nullptr) return fail(item, "expected '- add: …' or '- define: …'");
  const Node whole = expanded(item);
  const std::string kind = kind_of(whole);
  if (kind == "camera") return add_camera(whole);
  if (kind == "light" || kind == "area_light") return add_light(whole);
  add_shape(whole, {});
}

Result<ReadScene> ChallengeReader::read(const Node& root) {
  // Light is stored as it is, and what reflects totally leaves the refracted share black.
  scene_.defaults = {.profile = ProfileName::tachyon, .max_depth = 5};
  scene_.materials = {};
  if (!root.is_list()) fail(root, "expected a list: '- add: camera' and so on");
  for (const Node& item : root.items) read_item(item);
  if (errors_.empty() && !has_camera_)
    fail(root, "the scene has no camera: expected '- add: camera'");
  if (!errors_.empty()) return tl::make_unexpected(std::move(errors_));
  // Each light brings its own ambient light.
  scene_.ambient_light = {};
  for (const Light& light : scene_.lights) {
    Color& sum = scene_.ambient_light;
    sum = {sum.r + light.color.r, sum.g + light.color.g, sum.b + light.color.b};
  }
  return std::move(read_);
}

Likeness likeness_to_challenge(std::string_view text) {
  constexpr int kMostLines = 200;
  for (int i = 0; i < kMostLines && !text.empty(); ++i) {
    const std::size_t end = std::min(text.find_first_of("\r\n"), text.size());
    const std::string_view line = trimmed(text.substr(0, end));
    text.remove_prefix(std::min(end + 1, text.size()));
    if (line.empty() || line.starts_with('#') || line == "---") continue;
    if (line == "-") return Likeness::possible;
    return line.starts_with("- add:") || line.starts_with("- define:") ? Likeness::sure
                                                                       : Likeness::none;
  }
  return Likeness::none;
}

Result<ReadScene> parse_challenge(std::string_view text, const std::string& name,
                                  const ReadOptions& options) {
  if (text.starts_with(kByteOrderMark)) text.remove_prefix(kByteOrderMark.size());
  const Result<yaml::Node> root = yaml::parse(text, name);
  if (!root) return tl::make_unexpected(root.error());
  return ChallengeReader(name, options).read(*root);
}

}  // namespace zraka
