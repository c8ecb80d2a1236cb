// SPDX-License-Identifier: Apache-2.0
// Whether two scenes are the same, to the bit.
#pragma once

#include <gtest/gtest.h>

#include <cstring>
#include <type_traits>
#include <zraka/zraka.hpp>

namespace zraka {

/// Of types that are nothing but doubles.
template <class T>
bool same_bits(const T& a, const T& b) {
  static_assert(std::is_trivially_copyable_v<T> && sizeof(T) % sizeof(double) == 0);
  return std::memcmp(&a, &b, sizeof(T)) == 0;
}

/// All but the reader's name and the materials' names, which other formats do not have.
inline void expect_equal(const Scene& a, const Scene& b) {
  EXPECT_TRUE(same_bits(a.camera, b.camera));
  EXPECT_EQ(a.resolution.width, b.resolution.width);
  EXPECT_EQ(a.resolution.height, b.resolution.height);
  EXPECT_TRUE(same_bits(a.background, b.background));
  EXPECT_TRUE(same_bits(a.ambient_light, b.ambient_light));
  ASSERT_EQ(a.lights.size(), b.lights.size());
  for (std::size_t i = 0; i < a.lights.size(); ++i)
    EXPECT_TRUE(same_bits(a.lights[i], b.lights[i])) << "light " << i;
  ASSERT_EQ(a.materials.size(), b.materials.size());
  for (std::size_t i = 0; i < a.materials.size(); ++i)
    EXPECT_EQ(a.materials[i], b.materials[i]) << "material " << i;
  const auto compare = [](const auto& left, const auto& right) {
    ASSERT_EQ(left.size(), right.size());
    for (std::size_t i = 0; i < left.size(); ++i) {
      EXPECT_TRUE(same_bits(left[i].shape, right[i].shape)) << "shape " << i;
      EXPECT_EQ(left[i].material, right[i].material) << "shape " << i;
    }
  };
#define ZRAKA_COMPARE(Type, plural) compare(a.plural, b.plural);
  ZRAKA_PRIMITIVES(ZRAKA_COMPARE)
#undef ZRAKA_COMPARE
  EXPECT_EQ(a.names, b.names);
  EXPECT_EQ(a.defaults, b.defaults);
}

}  // namespace zraka
