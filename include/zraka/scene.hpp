// SPDX-License-Identifier: Apache-2.0
// What a picture is of: plain values, as a reader or a program writes them down.
#pragma once

#include <array>
#include <compare>
#include <cstdint>
#include <map>
#include <string>
#include <vector>
#include <zraka/api.hpp>
#include <zraka/cameras.hpp>
#include <zraka/lights.hpp>
#include <zraka/limits.hpp>
#include <zraka/optics.hpp>
#include <zraka/sampling.hpp>
#include <zraka/shapes.hpp>
#include <zraka/textures.hpp>
#include <zraka/values.hpp>

namespace zraka {

/// Phong's material with shares of the reflected and the refracted ray (lab sheet 3.3 and 3.6).
struct Material {
  Color ambient{0.1, 0.1, 0.1};  ///< ka
  Color diffuse{0.7, 0.7, 0.7};  ///< kd
  Color specular{};              ///< ks
  double shininess = 10;         ///< n, the exponent of the highlight
  Share reflection{};            ///< k1, share of the reflected ray
  Share refraction{};            ///< k2, share of the refracted ray
  /// ni. The lab profile takes it as n1/n2 on entry (sheet 3.5), the physical profile as the index
  /// of refraction of what is inside.
  double ior = 1;
  Highlight highlight = Highlight::phong;
  Fresnel fresnel = Fresnel::off;
  Color absorption{};  ///< of the inside, per unit of length: exp(-a·d) is left (Beer–Lambert)
  /// Where bodies overlap, the inside of the higher one counts (Schmidt and Budge 2002). If no
  /// material of a scene has one, what a ray leaves for is always the outside, as in the lab.
  int priority = 0;
  Dispersion dispersion{};
  bool casts_shadow = true;  ///< else shadow rays go through, whatever it is
  std::uint32_t cut_group = 0;  ///< of the cuts that concern it; see Cut
  std::vector<TextureUse> textures{};  ///< coefficients that textures give, each at most once
  NormalUse normals{};
  friend bool operator==(const Material&, const Material&) = default;
};

/// A half-space that is taken away of shapes: where normal·(p - point) is more than 0.
struct Cut {
  Vec3 point;
  Vec3 normal{0, 0, 1};  ///< of any length but 0
  /// Closed bodies are solid: where they are cut, a cap of their material closes them.
  bool caps = true;
  bool eye_only = false;    ///< rays other than those from the eye know nothing of it
  std::uint32_t group = 0;  ///< 0: of all materials; else of those that have it as cut_group
  friend bool operator==(const Cut&, const Cut&) = default;
};

/// A shape and the index of its material in Scene::materials.
template <class Shape>
struct Object {
  Shape shape;
  std::uint32_t material = 0;
  /// One more than the index in Scene::transforms of the map from the shape's space to the world;
  /// 0: none. Bodies are described in that space; primitives are in the world all the same, but
  /// textures and uv move with it.
  std::uint32_t transform = 0;
};

/// A shape of a scene: its kind, as its index in ZRAKA_SHAPES, and its index in Scene's list of
/// that kind.
struct ShapeId {
  std::int32_t kind = 0;
  std::uint32_t index = 0;
  friend auto operator<=>(const ShapeId&, const ShapeId&) = default;
};

struct Resolution {
  std::uint32_t width = 400;
  std::uint32_t height = 400;
};

/// Ways to make a picture of a scene (docs/profiles.md): the lab's, to the letter; optics'; the one
/// by which the Standard Procedural Databases count rays; and Tachyon's, which stores light as it
/// is.
enum class ProfileName { lab, physical, spd, tachyon };

/// What shadow rays do.
enum class Shadows {
  opaque,      ///< whatever they meet keeps the light away
  off,         ///< there are none
  transparent  ///< each body that they pass takes its share of the light (sheet 8.4)
};

/// How a scene is rendered where nobody says it.
struct RenderDefaults {
  ProfileName profile = ProfileName::physical;  ///< what the file's format is drawn with
  int max_depth = 4;
  Shadows shadows = Shadows::opaque;
  /// Children that can bring a pixel less than this are not traced (sheet 8.3); 0: all are.
  double min_contribution = 0;
  int wavelengths = 12;  ///< into how many a ray splits that a dispersive body refracts
  Sampling sampling{};
  friend bool operator==(const RenderDefaults&, const RenderDefaults&) = default;
};

/// Shapes by kind, and what some of them have besides.
struct ShapeLists {
#define ZRAKA_STORE(Type, plural) std::vector<Object<Type>> plural;
  ZRAKA_SHAPES(ZRAKA_STORE)
#undef ZRAKA_STORE
  /// Texture coordinates of the corners of triangles, of both kinds: empty, or as long as the list.
  std::vector<CornerUvs> triangle_uvs, smooth_triangle_uvs;
  std::map<ShapeId, std::string> names;  ///< of those shapes that the file gives one, UTF-8

  /// Number of shapes of all kinds; an instance is one.
  ZRAKA_API std::uint64_t shape_count() const;
};

/// Shapes that are drawn where instances of them stand, and nowhere else.
struct Group : ShapeLists {
  std::string name;  ///< UTF-8
};

struct Scene : ShapeLists {
  Camera camera;
  Resolution resolution;
  Color background;
  Color ambient_light{0.5, 0.5, 0.5};  ///< Ia
  AmbientOcclusion ambient_occlusion{};
  Sky sky{};
  Fog fog{};
  std::vector<Cut> cuts;
  std::vector<Light> lights;
  std::vector<Material> materials;
  std::vector<Transform> transforms;  ///< that shapes name
  std::vector<Group> groups;
  std::vector<Texture> textures;
  std::map<std::uint32_t, std::string> texture_names;   ///< of those textures that have one
  std::map<std::uint32_t, std::string> material_names;  ///< of those materials that have one
  RenderDefaults defaults;
  std::string
      format;  ///< the reader's name, for people; no part of what equal scenes have in common
};

}  // namespace zraka
