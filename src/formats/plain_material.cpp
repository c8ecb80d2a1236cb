// SPDX-License-Identifier: Apache-2.0
#include "formats/plain_material.hpp"

#include <type_traits>
#include <variant>

#include "formats/vectors.hpp"

namespace zraka {
namespace {

void mark(std::uint32_t material, std::vector<bool>& used) {
  if (material < used.size()) used[material] = true;
}

template <class Shape>
void mark_members(const Shape& shape, std::vector<bool>& used) {
  if constexpr (std::is_same_v<Shape, Csg>)
    for (const CsgMember& member : shape.of) {
      mark(member.material, used);
      std::visit([&](const auto& body) { mark_members(body, used); }, member.body);
    }
}

void mark_all(const ShapeLists& shapes, std::vector<bool>& used) {
#define ZRAKA_MARK(Type, plural)             \
  for (const auto& object : shapes.plural) { \
    mark(object.material, used);             \
    mark_members(object.shape, used);        \
  }
  ZRAKA_SHAPES(ZRAKA_MARK)
#undef ZRAKA_MARK
}

}  // namespace

std::vector<bool> used_materials(const Scene& scene) {
  std::vector<bool> used(scene.materials.size());
  mark_all(scene, used);
  for (const Group& group : scene.groups) mark_all(group, used);
  return used;
}

Color mean_of(const Texture& texture) {
  Color sum;
  double n = 0;
  const auto add = [&](double r, double g, double b) {
    sum = {sum.r + r, sum.g + g, sum.b + b};
    ++n;
  };
  if (texture.kind == TextureKind::image && texture.image != nullptr)
    for (std::size_t i = 0; i + 2 < texture.image->pixels.size(); i += 3)
      add(texture.image->pixels[i], texture.image->pixels[i + 1], texture.image->pixels[i + 2]);
  else if (texture.kind != TextureKind::image)
    for (const Color& color : texture.colors) add(color.r, color.g, color.b);
  return n > 0 ? sum * (1 / n) : Color{};
}

Material without_textures(const Scene& scene, Material m) {
  for (const TextureUse& use : m.textures) {
    const Color color = mean_of(scene.textures[use.texture]);
    switch (use.coefficient) {
      case Coefficient::ambient:
        m.ambient = color;
        break;
      case Coefficient::diffuse:
        m.diffuse = color;
        break;
      case Coefficient::specular:
        m.specular = color;
        break;
      case Coefficient::shininess:
        m.shininess = mean(color);
        break;
      case Coefficient::reflection:
        m.reflection = color;
        break;
      case Coefficient::refraction:
        m.refraction = color;
        break;
    }
  }
  m.textures.clear();
  return m;
}

Camera with_central_rays(const Scene& scene) {
  Camera c = scene.camera;
  if (scene.defaults.profile != ProfileName::lab) return c;  // spd's corners lie around the middle
  // The lab's rays go through the upper left corners.
  const Vec3 aside = c.window_up * (0.5 / scene.resolution.height) -
                     c.window_right * (0.5 / scene.resolution.width);
  if (c.kind == CameraKind::pinhole) c.window_center = c.window_center + aside;
  if (c.kind == CameraKind::orthographic)
    c.window_center = c.window_center + aside, c.eye = c.eye + aside;
  return c;
}

}  // namespace zraka
