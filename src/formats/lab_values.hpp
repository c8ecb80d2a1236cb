// SPDX-License-Identifier: Apache-2.0
// The values of the course's input.txt, in their order: what each is called, and which belong
// together.
#pragma once

#include <array>
#include <cstddef>
#include <string>

namespace zraka::lab {

/// A run of values that stands behind one label in the course's file.
struct Field {
  const char* names[3];  ///< of each value
  std::size_t size;
};

inline constexpr std::array kHead = {
    Field{{"x of the eye", "y of the eye", "z of the eye"}, 3},
    Field{{"size of the window"}, 1},
    Field{{"resolution of the window"}, 1},
    Field{{"x of the light", "y of the light", "z of the light"}, 3},
    Field{{"number of spheres"}, 1},
};
inline constexpr std::array kSphere = {
    Field{{"x of the centre", "y of the centre", "z of the centre"}, 3},
    Field{{"radius"}, 1},
    Field{{"k1 (share of the reflected ray)"}, 1},
    Field{{"k2 (share of the refracted ray)"}, 1},
    Field{{"red of ka", "green of ka", "blue of ka"}, 3},
    Field{{"red of kd", "green of kd", "blue of kd"}, 3},
    Field{{"red of ks", "green of ks", "blue of ks"}, 3},
    Field{{"n (shininess)"}, 1},
    Field{{"ni (refraction factor)"}, 1},
};

/// TextPositions of values among those of the head.
enum Head { kEye = 0, kSize = 3, kResolution = 4, kLight = 5, kCount = 8, kHeadValues = 9 };
/// TextPositions of values among those of a sphere.
enum SphereValue {
  kCenter = 0,
  kRadius = 3,
  kK1 = 4,
  kK2 = 5,
  kKa = 6,
  kKd = 9,
  kKs = 12,
  kN = 15,
  kNi = 16,
  kSphereValues = 17
};

/// The field that value `index` of a list of fields belongs to, and its number in it.
template <std::size_t N>
std::pair<const Field&, std::size_t> field_at(const std::array<Field, N>& fields,
                                              std::size_t index) {
  std::size_t f = 0;
  while (index >= fields[f].size) index -= fields[f++].size;
  return {fields[f], index};
}

}  // namespace zraka::lab
