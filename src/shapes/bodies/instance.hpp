// SPDX-License-Identifier: Apache-2.0
// A group of shapes, once more (accel/bodies.cpp has the rays).
#pragma once

#include "shapes/bodies/body.hpp"

namespace zraka {

template <>
struct ShapeTraits<Instance> {
  static constexpr const char* kName = "instance";
  static constexpr const char* kNouns[2][4] = {
      {"instance", "instance", "instance", "instance"},
      {"primjerak", "primjerak", "primjerka", "primjerku"}};
  static constexpr bool kClosed = false, kComposed = true;
};

}  // namespace zraka
