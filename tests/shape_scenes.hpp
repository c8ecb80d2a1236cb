// SPDX-License-Identifier: Apache-2.0
// Scenes of bodies, CSG, groups and textures, as the API puts them together.
#pragma once

#include <cmath>
#include <memory>
#include <type_traits>

#include "scenes.hpp"

namespace zraka {

/// A kind's index in the list of shapes, which grows.
template <class Shape>
constexpr std::int32_t kind_in_list() {
  std::int32_t kind = 0;
#define ZRAKA_IF(Type, plural)                  \
  if (std::is_same_v<Shape, Type>) return kind; \
  ++kind;
  ZRAKA_SHAPES(ZRAKA_IF)
#undef ZRAKA_IF
  return kind;
}

/// Turned about y, scaled and moved.
inline Transform placed(double by_deg, double scale, Vec3 to) {
  const double angle = by_deg * 3.14159265358979323846 / 180;
  const double c = scale * std::cos(angle), s = scale * std::sin(angle);
  return {{c, 0, -s}, {0, scale, 0}, {s, 0, c}, to};
}

inline std::uint32_t add_transform(Scene& scene, const Transform& transform) {
  scene.transforms.push_back(transform);
  return static_cast<std::uint32_t>(scene.transforms.size());
}

inline std::uint32_t add_material(Scene& scene, const Material& material) {
  scene.materials.push_back(material);
  return static_cast<std::uint32_t>(scene.materials.size() - 1);
}

/// A new texture, the scene's last one, to be filled in.
inline Texture& add_texture(Scene& scene, TextureKind kind, const std::string& name) {
  if (!name.empty()) scene.texture_names[static_cast<std::uint32_t>(scene.textures.size())] = name;
  Texture& texture = scene.textures.emplace_back();
  texture.kind = kind;
  return texture;
}

inline void add_checker(Scene& scene, double size, TextureMapping mapping,
                        const std::string& name) {
  Texture& texture = add_texture(scene, TextureKind::checker, name);
  texture.mapping = mapping;
  texture.colors[0] = {0.9, 0.8, 0.7};
  texture.colors[1] = {0.1, 0.2, 0.3};
  texture.size = size;
}

inline Material mirror() {
  return {.diffuse = {0.3, 0.3, 0.3}, .specular = {0.5, 0.5, 0.5}, .reflection = 0.5};
}
inline Material glass() {
  return {.diffuse = {0.1, 0.1, 0.1}, .reflection = 0.1, .refraction = 0.8, .ior = 1.4};
}

/// ((block, which is a box, and ball) without bore): a CSG shape in a CSG shape.
inline Csg drilled() {
  Csg rounded{CsgOperation::intersect, {}};
  rounded.of.push_back({Box{{-0.5, -0.5, -0.5}, {0.5, 0.5, 0.5}}, kMaterialOfWhole, 0, "block"});
  rounded.of.push_back({Ellipsoid{{0, 0, 0}, {0.65, 0.65, 0.65}}, kMaterialOfWhole, 0, "ball"});
  Csg whole{CsgOperation::subtract, {}};
  whole.of.push_back({rounded, kMaterialOfWhole, 0, ""});
  whole.of.push_back({Ellipsoid{{0, 0, 0}, {0.3, 0.3, 2}}, kMaterialOfWhole, 0, "bore"});
  return whole;
}

/// A mirror of a drilled block, a block of glass, a union that is turned, on a plane.
inline Scene csg_scene(std::uint32_t resolution = 100) {
  Scene scene = lab_scene(resolution);
  scene.background = {0.2, 0.3, 0.4};
  const std::uint32_t floor = add_material(scene, {.diffuse = {0.6, 0.6, 0.5}});
  const std::uint32_t shiny = add_material(scene, mirror());
  const std::uint32_t clear = add_material(scene, glass());
  const std::uint32_t red = add_material(scene, {.diffuse = {0.8, 0.2, 0.1}});
  scene.planes.push_back({{{0, -0.7, 0}, {0, 1, 0}}, floor});
  scene.csgs.push_back({drilled(), shiny, add_transform(scene, placed(30, 0.8, {-0.5, -0.2, -1}))});
  scene.csgs.push_back({drilled(), clear, add_transform(scene, placed(-20, 0.7, {0.5, 0, -0.6}))});
  Csg pair{CsgOperation::unite, {}};
  pair.of.push_back({Ellipsoid{{0, 0, 0}, {0.4, 0.2, 0.3}}, red, 0, ""});
  pair.of.push_back({Ellipsoid{{0.3, 0, 0}, {0.2, 0.4, 0.2}}, kMaterialOfWhole, 0, ""});
  scene.csgs.push_back({pair, shiny, add_transform(scene, placed(10, 1, {0, 0.5, -1.5}))});
  scene.names = {{{kind_in_list<Csg>(), 0}, "drilled"}};
  return scene;
}

/// Two chairs of a seat and two legs, which are instances themselves, of glass and of mirrors.
inline Scene chairs_scene(std::uint32_t resolution = 100) {
  Scene scene = lab_scene(resolution);
  scene.background = {0.1, 0.2, 0.3};
  const std::uint32_t plain = add_material(scene, {.diffuse = {0.5, 0.6, 0.7}});
  const std::uint32_t shiny = add_material(scene, mirror());
  const std::uint32_t clear = add_material(scene, glass());
  constexpr std::int32_t kEllipsoid = kind_in_list<Ellipsoid>(), kBox = kind_in_list<Box>(),
                         kInstance = kind_in_list<Instance>();
  scene.groups.resize(2);
  Group &leg = scene.groups[0], &chair = scene.groups[1];
  leg.name = "leg";
  leg.ellipsoids.push_back({{{0, -0.3, 0}, {0.1, 0.3, 0.1}}, kMaterialOfWhole});
  leg.spheres.push_back({{{0, -0.65, 0}, 0.12}, shiny});
  leg.names = {{{kEllipsoid, 0}, "shank"}, {{0, 0}, "foot"}};
  chair.name = "chair";
  chair.boxes.push_back({{{-0.4, 0, -0.4}, {0.4, 0.1, 0.4}}, kMaterialOfWhole});
  chair.instances.push_back(
      {{0}, kMaterialOfWhole, add_transform(scene, placed(0, 1, {-0.3, 0, 0}))});
  chair.instances.push_back({{0}, clear, add_transform(scene, placed(45, 1.2, {0.3, 0, 0}))});
  chair.csgs.push_back({drilled(), clear, add_transform(scene, placed(0, 0.4, {0, 0.3, 0}))});
  chair.names = {{{kBox, 0}, "seat"}, {{kInstance, 1}, "right leg"}};
  scene.spheres.push_back({{{0, -101, -1}, 100}, plain});
  scene.instances.push_back(
      {{1}, plain, add_transform(scene, placed(20, 0.9, {-0.45, -0.1, -0.9}))});
  scene.instances.push_back({{1}, shiny, add_transform(scene, placed(-50, 0.8, {0.55, 0, -1.3}))});
  scene.names = {{{kInstance, 0}, "left"}};
  return scene;
}

/// The drilled block in a group in a group, without a transform that computers may differ in.
inline Scene nested_scene() {
  Scene scene = lab_scene(100);
  const std::uint32_t grey = add_material(scene, {});
  scene.groups.resize(2);
  scene.groups[0].name = "part";
  scene.groups[0].csgs.push_back({drilled(), kMaterialOfWhole});
  scene.groups[0].names = {{{kind_in_list<Csg>(), 0}, "drilled"}};
  scene.groups[1].instances.push_back(
      {{0}, kMaterialOfWhole, add_transform(scene, {{0, 0, -2}, {0, 2, 0}, {2, 0, 0}, {}})});
  scene.instances.push_back(
      {{1}, grey, add_transform(scene, {{1, 0, 0}, {0, 1, 0}, {0, 0, 1}, {0.25, 0, -1}})});
  scene.names = {{{kind_in_list<Instance>(), 0}, "whole"}};
  return scene;
}

/// Textures of coefficients and normals, looked up in space and over surfaces, also by way of a
/// mirror and through glass.
inline Scene textured_scene(std::uint32_t resolution = 100) {
  Scene scene = lab_scene(resolution);
  scene.background = {0.3, 0.3, 0.4};
  constexpr std::uint32_t tiles = 0, wrapped = 1, rough = 2, dents = 3;
  add_checker(scene, 0.5, TextureMapping::solid, "tiles");
  add_checker(scene, 1, TextureMapping::uv, "wrapped");
  scene.textures[wrapped].transform = {{0.125, 0, 0}, {0, 0.25, 0}, {0, 0, 1}, {}};
  add_texture(scene, TextureKind::noise, "").size = 0.15;
  Texture& map = add_texture(scene, TextureKind::image, "dents");
  map.mapping = TextureMapping::uv;
  map.file = "dents.png";
  map.transfer = Transfer::linear;
  auto image = std::make_shared<Image>(4, 2);
  for (std::size_t i = 0; i < 8; ++i) {
    float* const pixel = image->pixels.data() + 3 * i;
    pixel[0] = i % 2 == 0 ? 0.7f : 0.3f, pixel[1] = i < 4 ? 0.6f : 0.5f, pixel[2] = 1;
  }
  map.image = image;

  Material floor{.specular = {0.2, 0.2, 0.2}};
  floor.textures = {{Coefficient::ambient, tiles}, {Coefficient::diffuse, tiles}};
  Material globe{.specular = {0.3, 0.3, 0.3}, .reflection = 0.2};
  globe.textures = {{Coefficient::diffuse, wrapped}, {Coefficient::reflection, wrapped}};
  Material bumpy = mirror();
  bumpy.normals = {NormalUse::Kind::bump, rough, 0.02};
  Material dented = glass();
  dented.normals = {NormalUse::Kind::normal_map, dents};
  dented.textures = {{Coefficient::shininess, rough}};
  scene.planes.push_back({{{0, -0.8, 0}, {0, 1, 0}}, add_material(scene, floor)});
  scene.ellipsoids.push_back({{{0, 0, 0}, {0.5, 0.4, 0.4}},
                              add_material(scene, globe),
                              add_transform(scene, placed(40, 0.9, {-0.5, 0.1, -1}))});
  scene.spheres.push_back({{{0.5, -0.2, -1.2}, 0.5}, add_material(scene, bumpy)});
  scene.boxes.push_back({{{-0.25, -0.2, -0.2}, {0.25, 0.3, 0.2}},
                         add_material(scene, dented),
                         add_transform(scene, placed(25, 1, {0.1, -0.4, -0.3}))});
  scene.spheres.push_back({{{0.4, 0.6, -1.5}, 0.3}, add_material(scene, mirror())});
  return scene;
}

/// All of it: textures in instances of groups with CSG, and enough shapes for a hierarchy.
inline Scene crowded_scene(std::uint32_t resolution = 100) {
  Scene scene = textured_scene(resolution);
  constexpr std::uint32_t kGlobe = 1, kDented = 3;
  scene.groups.resize(2);
  Group &bead = scene.groups[0], &string = scene.groups[1];
  bead.name = "bead";
  bead.csgs.push_back({drilled(), kMaterialOfWhole, add_transform(scene, placed(15, 0.2, {}))});
  bead.spheres.push_back({{{0, 0.15, 0}, 0.05}, kDented});
  string.name = "string";
  for (int i = 0; i < 20; ++i)
    string.instances.push_back(
        {{0},
         kMaterialOfWhole,
         add_transform(scene, placed(18 * i, 1, {0.2 * (i % 5), 0.3 * (i / 5), 0.1 * i}))});
  for (int i = 0; i < 3; ++i)
    scene.instances.push_back(
        {{1},
         kGlobe,
         add_transform(scene, placed(35 * i, 0.8, {-0.8 + 0.5 * i, -0.6 + 0.4 * i, -1.5}))});
  Csg pair{CsgOperation::unite, {}};
  pair.of.push_back({Ellipsoid{{0, 0, 0}, {0.3, 0.2, 0.2}}, kMaterialOfWhole, 0, ""});
  pair.of.push_back({Box{{-0.2, -0.2, -0.2}, {0.2, 0.2, 0.2}}, kMaterialOfWhole,
                     add_transform(scene, placed(30, 1.2, {0.3, 0.2, 0.1})), ""});
  scene.csgs.push_back({pair, kGlobe, add_transform(scene, placed(20, 0.9, {0.3, 0.5, -0.6}))});
  for (int i = 0; i < 20; ++i)
    scene.triangles.push_back(
        {{{-1, -1 + 0.1 * i, -3}, {1, -1 + 0.1 * i, -3}, {0, -0.92 + 0.1 * i, -2.9}}, 0});
  return scene;
}

inline std::vector<NamedScene> shape_scenes(std::uint32_t resolution = 100) {
  return {{"CSG", csg_scene(resolution)},
          {"chairs", chairs_scene(resolution)},
          {"textured", textured_scene(resolution)},
          {"crowded", crowded_scene(resolution)}};
}

}  // namespace zraka
