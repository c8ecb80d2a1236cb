// SPDX-License-Identifier: Apache-2.0
// The values of the course's input.txt, in their order: what each is called, and which belong
// together.
#pragma once

#include <array>
#include <cstddef>
#include <utility>

#include "core/words.hpp"

namespace zraka::lab {

/// A run of values that stands behind one label in the course's file.
struct Field {
  Word names[3];  ///< of each value
  std::size_t size;
};

inline constexpr std::array kHead = {
    Field{{Word::lab_eye_x, Word::lab_eye_y, Word::lab_eye_z}, 3},
    Field{{Word::lab_size}, 1},
    Field{{Word::lab_resolution}, 1},
    Field{{Word::lab_light_x, Word::lab_light_y, Word::lab_light_z}, 3},
    Field{{Word::lab_count}, 1},
};
inline constexpr std::array kSphere = {
    Field{{Word::lab_center_x, Word::lab_center_y, Word::lab_center_z}, 3},
    Field{{Word::lab_radius}, 1},
    Field{{Word::lab_k1}, 1},
    Field{{Word::lab_k2}, 1},
    Field{{Word::lab_ka_red, Word::lab_ka_green, Word::lab_ka_blue}, 3},
    Field{{Word::lab_kd_red, Word::lab_kd_green, Word::lab_kd_blue}, 3},
    Field{{Word::lab_ks_red, Word::lab_ks_green, Word::lab_ks_blue}, 3},
    Field{{Word::lab_n}, 1},
    Field{{Word::lab_ni}, 1},
};

/// Indices of values among those of the head.
enum Head { kEye = 0, kSize = 3, kResolution = 4, kLight = 5, kCount = 8, kHeadValues = 9 };
/// Indices of values among those of a sphere.
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
