// SPDX-License-Identifier: Apache-2.0
// The Challenge's materials, patterns and transforms.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "core/text.hpp"
#include "formats/challenge.hpp"
#include "formats/vectors.hpp"
#include "language/transforms.hpp"
#include "scene/bounds_of.hpp"

namespace zraka {
namespace {

constexpr double kDegrees = 180 / 3.14159265358979323846;

Color color_of(const Vec3& v) {
  return {std::max(v.x, 0.0), std::max(v.y, 0.0), std::max(v.z, 0.0)};
}

}  // namespace

std::optional<Transform> ChallengeReader::step_of(const Node& step) {
  std::vector<double> n;
  for (std::size_t i = 1; i < step.items.size(); ++i) {
    const std::optional<double> value = step.items[i].number();
    if (!value) return std::nullopt;
    n.push_back(*value);
  }
  const std::string& word = step.items[0].text;
  if (word == "translate" && n.size() == 3)
    return Transform{{1, 0, 0}, {0, 1, 0}, {0, 0, 1}, {n[0], n[1], n[2]}};
  if (word == "scale" && n.size() == 3)
    return Transform{{n[0], 0, 0}, {0, n[1], 0}, {0, 0, n[2]}, {}};
  if (word == "shear" && n.size() == 6)
    return Transform{{1, n[2], n[4]}, {n[0], 1, n[5]}, {n[1], n[3], 1}, {}};
  if (n.size() != 1) return std::nullopt;
  if (word == "rotate-x") return language::rotation({1, 0, 0}, n[0] * kDegrees);
  if (word == "rotate-y") return language::rotation({0, 1, 0}, n[0] * kDegrees);
  if (word == "rotate-z") return language::rotation({0, 0, 1}, n[0] * kDegrees);
  return std::nullopt;
}

/// Steps in their order; a name stands for the steps that it is defined as.
void ChallengeReader::add_steps(const Node& list, Transform& transform, int depth) {
  constexpr int kDeepestPattern = 32;
  if (!list.is_list() || depth > kDeepestPattern)
    return fail(list, "a transform is no list of steps, as [translate, 1, 2, 3]");
  for (const Node& step : list.items) {
    if (!step.is_list()) {
      const auto known = definitions_.find(step.text);
      if (known == definitions_.end())
        fail(step, fmt::format("'{}' is no step of a transform, and not defined before this",
                               shown(step.text)));
      else
        add_steps(known->second, transform, depth + 1);
    } else if (const std::optional<Transform> made =
                   step.items.empty() ? std::nullopt : step_of(step)) {
      transform = then(transform, *made);
    } else {
      fail(step,
           "this is no step of a transform: expected [translate, x, y, z], [scale, x, y, z], "
           "[rotate-x, radians] or the like, or [shear, six numbers]");
    }
    if (!errors_.empty()) return;
  }
}

Transform ChallengeReader::transform_of(const Node* node) {
  Transform transform;
  if (node == nullptr) return transform;
  if (!node->is_list() && definitions_.contains(node->text))
    add_steps(definitions_.find(node->text)->second, transform, 0);
  else
    add_steps(*node, transform, 0);
  return transform;
}

std::optional<std::uint32_t> ChallengeReader::pattern_of(const Node& pattern) {
  const Node* const type = pattern.find("type");
  const std::string kind = type == nullptr ? "" : type->text;
  Texture texture;
  if (kind == "stripes" || kind == "stripe") {
    texture.kind = TextureKind::stripes;
  } else if (kind == "gradient") {
    texture.kind = TextureKind::gradient;
  } else if (kind == "rings" || kind == "ring") {
    texture.kind = TextureKind::rings;
    texture.direction = {0, 1, 0};
  } else if (kind == "checkers" || kind == "checker") {
    texture.kind = TextureKind::checker;
  } else {
    warn(pattern, fmt::format("patterns of type '{}' are left out: white is drawn", shown(kind)));
    return std::nullopt;
  }
  texture.colors.clear();
  if (const Node* const colors = pattern.find("colors"))
    for (const Node& color : colors->items)
      if (const std::optional<Vec3> v = vector(color, "a colour of a pattern"))
        texture.colors.push_back(color_of(*v));
  if (texture.colors.size() < 2) {
    if (errors_.empty()) fail(pattern, "a pattern has two colours: colors: [[r, g, b], [r, g, b]]");
    return std::nullopt;
  }
  texture.transform = transform_of(pattern.find("transform"));
  if (!inverse(texture.transform)) {
    fail(pattern, "the transform of a pattern makes it flat");
    return std::nullopt;
  }
  scene_.textures.push_back(std::move(texture));
  return static_cast<std::uint32_t>(scene_.textures.size() - 1);
}

std::uint32_t ChallengeReader::texture_times(std::uint32_t texture, double factor) {
  if (factor == 1) return texture;
  Texture own = scene_.textures[texture];
  for (Color& color : own.colors) color = color * factor;
  scene_.textures.push_back(std::move(own));
  return static_cast<std::uint32_t>(scene_.textures.size() - 1);
}

/// Phong's, as the book has it: highlights have the light's colour.
std::uint32_t ChallengeReader::material_of(const Node& shape, const Place& place) {
  const Node* given = shape.find("material");
  const bool has_shadow = flag(shape, "shadow", true) && place.has_shadow;
  if (given == nullptr && place.depth > 0 && has_shadow == place.has_shadow) return place.material;
  static const Node kNone{Node::Kind::map};
  if (given != nullptr && !given->is_map()) {
    const auto known = definitions_.find(given->text);
    if (known == definitions_.end()) {
      fail(*given, fmt::format("the material '{}' is not defined before this", shown(given->text)));
      return 0;
    }
    given = &known->second;
  }
  const Node& from = given == nullptr ? kNone : *given;
  const Color color = color_of(vector(from, "color", {1, 1, 1}));
  const auto share = [&](std::string_view key, double usual) {
    return std::max(number(from, key, usual).value_or(usual), 0.0);
  };
  const double ambient = share("ambient", 0.1), diffuse = share("diffuse", 0.9);
  const double specular = share("specular", 0.9), mirror = std::min(share("reflective", 0), 1.0);
  const double clear = std::min(share("transparency", 0), 1.0);
  Material m;
  m.ambient = color * ambient;
  m.diffuse = color * diffuse;
  m.specular = {specular, specular, specular};
  m.shininess = share("shininess", 200);
  m.reflection = mirror;
  m.refraction = clear;
  m.ior = std::clamp(share("refractive-index", 1), 0.1, 10.0);
  m.casts_shadow = has_shadow;
  if (mirror > 0 && clear > 0) {
    // By Schlick, of what comes back and what passes: the two shares are mostly the same.
    m.fresnel = Fresnel::schlick;
    m.reflection = 0;
    if (mirror != clear)
      warn(from, "materials that are reflective and transparent mirror as much as they let pass");
  }
  const Node* const pattern = from.find("pattern");
  if (const std::optional<std::uint32_t> texture =
          pattern == nullptr ? std::nullopt : pattern_of(*pattern)) {
    if (ambient > 0) m.textures.push_back({Coefficient::ambient, texture_times(*texture, ambient)});
    if (diffuse > 0) m.textures.push_back({Coefficient::diffuse, texture_times(*texture, diffuse)});
  }
  if (!scene_.materials.empty() && scene_.materials.back() == m)
    return static_cast<std::uint32_t>(scene_.materials.size() - 1);
  scene_.materials.push_back(std::move(m));
  return static_cast<std::uint32_t>(scene_.materials.size() - 1);
}

}  // namespace zraka
