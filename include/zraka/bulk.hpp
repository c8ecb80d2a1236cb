// SPDX-License-Identifier: Apache-2.0
// Many shapes at once, from arrays in a caller's memory.
#pragma once

#include <cstddef>
#include <cstdint>
#include <zraka/api.hpp>
#include <zraka/diagnostic.hpp>
#include <zraka/scene.hpp>

namespace zraka {

/// `count` items of N numbers each in a caller's memory. All functions here copy what they read:
/// the memory is free when they return.
template <int N>
struct NumberArray {
  const void* data = nullptr;
  std::size_t count = 0;
  bool is_double = false;
  std::ptrdiff_t stride = 0;  ///< bytes from an item to the next
  std::ptrdiff_t step = 0;    ///< bytes from a number to the next of its item

  NumberArray() = default;
  NumberArray(const float* first, std::size_t items, std::ptrdiff_t from_item_to_item = N * 4,
          std::ptrdiff_t from_number_to_number = 4)
      : data(first), count(items), stride(from_item_to_item), step(from_number_to_number) {}
  NumberArray(const double* first, std::size_t items, std::ptrdiff_t from_item_to_item = N * 8,
          std::ptrdiff_t from_number_to_number = 8)
      : data(first),
        count(items),
        is_double(true),
        stride(from_item_to_item),
        step(from_number_to_number) {}
};

/// What all arrays of shapes have.
struct BulkMaterial {
  std::uint32_t material = 0;  ///< index in Scene::materials
  /// As many as shapes, linear red, green and blue, each 0 or more: the material's ambient and
  /// diffuse colours are multiplied by them. None: the material as it is. Each colour that differs
  /// becomes a material of its own in the scene.
  NumberArray<3> colors{};
};

struct SphereArrays : BulkMaterial {
  NumberArray<3> centers;
  NumberArray<1> radii{};  ///< as many; none: all have `radius`
  double radius = 1;
};

/// Without caps.
struct CylinderArrays : BulkMaterial {
  NumberArray<3> starts, ends;
  NumberArray<1> radii{};  ///< as many; none: all have `radius`
  double radius = 1;
};

struct TriangleArrays : BulkMaterial {
  NumberArray<3> a, b, c;  ///< corners
};

/// Adds shapes to the scene's, in the arrays' order. Fails, and adds nothing, on arrays of
/// different lengths, numbers that are not finite, radii and colours out of range, and a material
/// that the scene does not have: the message names the array and the index.
ZRAKA_API Result<void> add_spheres(Scene& scene, const SphereArrays& arrays);
ZRAKA_API Result<void> add_cylinders(Scene& scene, const CylinderArrays& arrays);
ZRAKA_API Result<void> add_triangles(Scene& scene, const TriangleArrays& arrays);

}  // namespace zraka
