// SPDX-License-Identifier: Apache-2.0
// Whether two scenes are the same, to the bit.
#pragma once

#include <gtest/gtest.h>

#include <algorithm>
#include <cstring>
#include <type_traits>
#include <variant>
#include <zraka/zraka.hpp>

namespace zraka {

/// Of types that are nothing but doubles.
template <class T>
bool same_bits(const T& a, const T& b) {
  static_assert(std::is_trivially_copyable_v<T> && sizeof(T) % sizeof(double) == 0);
  return std::memcmp(&a, &b, sizeof(T)) == 0;
}

/// The lists of two scenes, or of groups of theirs.
class ListsComparison {
 public:
  ListsComparison(const Scene& a, const Scene& b) : a_(a), b_(b) {}

  void expect_equal(const ShapeLists& a, const ShapeLists& b) const {
#define ZRAKA_COMPARE(Type, plural) compare(a.plural, b.plural, #plural);
    ZRAKA_SHAPES(ZRAKA_COMPARE)
#undef ZRAKA_COMPARE
    EXPECT_EQ(a.names, b.names);
    compare_uvs(a.triangle_uvs, b.triangle_uvs, a.triangles.size());
    compare_uvs(a.smooth_triangle_uvs, b.smooth_triangle_uvs, a.smooth_triangles.size());
  }

 private:
  template <class Shape>
  void compare(const std::vector<Object<Shape>>& a, const std::vector<Object<Shape>>& b,
               const char* list) const {
    ASSERT_EQ(a.size(), b.size()) << list;
    for (std::size_t i = 0; i < a.size(); ++i) {
      EXPECT_TRUE(same(a[i].shape, b[i].shape)) << list << " " << i;
      EXPECT_EQ(a[i].material, b[i].material) << list << " " << i;
      EXPECT_TRUE(same_transform(a[i].transform, b[i].transform)) << list << " " << i;
    }
  }

  /// Scenes may number the same transforms differently.
  bool same_transform(std::uint32_t a, std::uint32_t b) const {
    const auto of = [](const Scene& scene, std::uint32_t index) {
      return index == 0 ? Transform{} : scene.transforms.at(index - 1);
    };
    return of(a_, a) == of(b_, b);
  }

  template <class Shape>
  bool same(const Shape& a, const Shape& b) const {
    if constexpr (std::is_same_v<Shape, Csg>)
      return a.operation == b.operation &&
             std::equal(a.of.begin(), a.of.end(), b.of.begin(), b.of.end(),
                        [&](const auto& one, const auto& other) { return same(one, other); });
    else if constexpr (requires { a == b; })
      return a == b;
    else
      return same_bits(a, b);
  }
  bool same(const CsgMember& a, const CsgMember& b) const {
    return a.material == b.material && same_transform(a.transform, b.transform) &&
           a.name == b.name &&
           std::visit(
               [&]<class One, class Other>(const One& one, const Other& other) {
                 if constexpr (std::is_same_v<One, Other>)
                   return same(one, other);
                 else
                   return false;
               },
               a.body, b.body);
  }

  /// Those that nobody gives are (0, 0), (1, 0) and (0, 1).
  static void compare_uvs(std::vector<CornerUvs> a, std::vector<CornerUvs> b, std::size_t count) {
    a.resize(count, {{{0, 0}, {1, 0}, {0, 1}}});
    b.resize(count, {{{0, 0}, {1, 0}, {0, 1}}});
    EXPECT_EQ(a, b);
  }

  const Scene &a_, &b_;
};

/// What a coefficient is that a texture gives does not matter.
inline Material without_hidden(Material m) {
  std::sort(m.textures.begin(), m.textures.end(),
            [](const TextureUse& a, const TextureUse& b) { return a.coefficient < b.coefficient; });
  const Material none;
  for (const TextureUse& use : m.textures) switch (use.coefficient) {
      case Coefficient::ambient:
        m.ambient = none.ambient;
        break;
      case Coefficient::diffuse:
        m.diffuse = none.diffuse;
        break;
      case Coefficient::specular:
        m.specular = none.specular;
        break;
      case Coefficient::shininess:
        m.shininess = none.shininess;
        break;
      case Coefficient::reflection:
        m.reflection = none.reflection;
        break;
      case Coefficient::refraction:
        m.refraction = none.refraction;
        break;
    }
  if (m.normals.kind == NormalUse::Kind::none) m.normals = {};
  if (m.normals.kind == NormalUse::Kind::normal_map) m.normals.height = NormalUse{}.height;
  return m;
}

inline void expect_equal(const Texture& a, const Texture& b) {
  EXPECT_EQ(a.kind, b.kind);
  EXPECT_EQ(a.mapping, b.mapping);
  EXPECT_EQ(a.transform, b.transform);
  EXPECT_EQ(a.colors, b.colors);
  EXPECT_EQ(a.size, b.size);
  EXPECT_EQ(a.direction, b.direction);
  EXPECT_EQ(a.turbulence, b.turbulence);
  EXPECT_EQ(a.octaves, b.octaves);
  EXPECT_EQ(a.seed, b.seed);
  EXPECT_EQ(a.file, b.file);
  EXPECT_EQ(a.wrap, b.wrap);
  EXPECT_EQ(a.filter, b.filter);
  ASSERT_EQ(a.image == nullptr, b.image == nullptr);
  if (a.image == nullptr) return;
  EXPECT_EQ(a.image->pixels, b.image->pixels);
}

/// All but the reader's name, and the names of materials, textures and groups, which other formats
/// do not have.
inline void expect_equal(const Scene& a, const Scene& b) {
  EXPECT_EQ(a.camera, b.camera);
  EXPECT_EQ(a.resolution.width, b.resolution.width);
  EXPECT_EQ(a.resolution.height, b.resolution.height);
  EXPECT_TRUE(same_bits(a.background, b.background));
  EXPECT_TRUE(same_bits(a.ambient_light, b.ambient_light));
  ASSERT_EQ(a.lights.size(), b.lights.size());
  for (std::size_t i = 0; i < a.lights.size(); ++i)
    EXPECT_EQ(a.lights[i], b.lights[i]) << "light " << i;
  EXPECT_EQ(a.sky, b.sky);
  EXPECT_EQ(a.cuts, b.cuts);
  EXPECT_EQ(a.ambient_occlusion, b.ambient_occlusion);
  ASSERT_EQ(a.materials.size(), b.materials.size());
  for (std::size_t i = 0; i < a.materials.size(); ++i)
    EXPECT_EQ(without_hidden(a.materials[i]), without_hidden(b.materials[i])) << "material " << i;
  ASSERT_EQ(a.textures.size(), b.textures.size());
  for (std::size_t i = 0; i < a.textures.size(); ++i) {
    SCOPED_TRACE(i);
    expect_equal(a.textures[i], b.textures[i]);
  }
  const ListsComparison lists(a, b);
  lists.expect_equal(a, b);
  ASSERT_EQ(a.groups.size(), b.groups.size());
  for (std::size_t i = 0; i < a.groups.size(); ++i) {
    SCOPED_TRACE(i);
    lists.expect_equal(a.groups[i], b.groups[i]);
  }
  EXPECT_EQ(a.defaults, b.defaults);
}

}  // namespace zraka
