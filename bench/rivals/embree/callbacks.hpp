// SPDX-License-Identifier: Apache-2.0
// A user geometry of any of our shapes: what Embree calls for one ray, or for as many as its
// instruction set has in a packet, into which it cuts the sixteen that it was given.
#pragma once

#include <cstdlib>
#include <vector>

#include "shapes.hpp"

namespace zraka::embree {

template <class Shape>
class Callbacks {
 public:
  /// Not committed yet. The shapes have to stay where they are.
  static RTCGeometry geometry_of(RTCDevice device, const std::vector<Shape>& shapes) {
    const RTCGeometry geometry = rtcNewGeometry(device, RTC_GEOMETRY_TYPE_USER);
    rtcSetGeometryUserPrimitiveCount(geometry, static_cast<unsigned>(shapes.size()));
    rtcSetGeometryUserData(geometry, const_cast<Shape*>(shapes.data()));
    rtcSetGeometryBoundsFunction(geometry, bounds, nullptr);
    rtcSetGeometryIntersectFunction(geometry, intersect);
    rtcSetGeometryOccludedFunction(geometry, occluded);
    return geometry;
  }

 private:
  static const Shape& shape_of(void* shapes, unsigned primitive) {
    return static_cast<const Shape*>(shapes)[primitive];
  }

  static void bounds(const RTCBoundsFunctionArguments* arguments) {
    *arguments->bounds_o = shape_of(arguments->geometryUserPtr, arguments->primID).bounds();
  }

  static float meet(const Shape& shape, const RTCRay& ray) {
    return shape.template meet<float>({ray.org_x, ray.org_y, ray.org_z},
                                      {ray.dir_x, ray.dir_y, ray.dir_z}, ray.tnear, ray.tfar);
  }

  template <int N>
  static auto meet(const Shape& shape, const RTCRayNt<N>& ray, const int* valid) {
    using F = typename Packed<N>::Float;
    const F t = shape.template meet<F>({load<F>(ray.org_x), load<F>(ray.org_y), load<F>(ray.org_z)},
                                       {load<F>(ray.dir_x), load<F>(ray.dir_y), load<F>(ray.dir_z)},
                                       load<F>(ray.tnear), load<F>(ray.tfar));
    return choose(load<typename Packed<N>::Int>(valid) != 0, t, F{} + kNever);
  }

  static void intersect(const RTCIntersectFunctionNArguments* arguments) {
    switch (arguments->N) {
      case 1:
        return intersect_one(*arguments);
      case 4:
        return intersect_packet<4>(*arguments);
      case 8:
        return intersect_packet<8>(*arguments);
      case 16:
        return intersect_packet<16>(*arguments);
      default:
        std::abort();  // Embree has no other packets
    }
  }

  static void intersect_one(const RTCIntersectFunctionNArguments& arguments) {
    const Shape& shape = shape_of(arguments.geometryUserPtr, arguments.primID);
    auto& [ray, hit] = *reinterpret_cast<RTCRayHit*>(arguments.rayhit);
    const float t = meet(shape, ray);
    if (!(t < kNever)) return;
    const Vec n = shape.normal_at(
        {ray.org_x + ray.dir_x * t, ray.org_y + ray.dir_y * t, ray.org_z + ray.dir_z * t});
    ray.tfar = t;
    hit.Ng_x = n.x, hit.Ng_y = n.y, hit.Ng_z = n.z;
    hit.primID = arguments.primID, hit.geomID = arguments.geomID;
  }

  template <int N>
  static void intersect_packet(const RTCIntersectFunctionNArguments& arguments) {
    const Shape& shape = shape_of(arguments.geometryUserPtr, arguments.primID);
    auto& [ray, hit] = *reinterpret_cast<RTCRayHitNt<N>*>(arguments.rayhit);
    const auto t = meet<N>(shape, ray, arguments.valid);
    each_bit(bits(t < kNever), [&](int i) {
      const Vec n =
          shape.normal_at({ray.org_x[i] + ray.dir_x[i] * t[i], ray.org_y[i] + ray.dir_y[i] * t[i],
                           ray.org_z[i] + ray.dir_z[i] * t[i]});
      ray.tfar[i] = t[i];
      hit.Ng_x[i] = n.x, hit.Ng_y[i] = n.y, hit.Ng_z[i] = n.z;
      hit.primID[i] = arguments.primID, hit.geomID[i] = arguments.geomID;
    });
  }

  static void occluded(const RTCOccludedFunctionNArguments* arguments) {
    switch (arguments->N) {
      case 1:
        return occluded_one(*arguments);
      case 4:
        return occluded_packet<4>(*arguments);
      case 8:
        return occluded_packet<8>(*arguments);
      case 16:
        return occluded_packet<16>(*arguments);
      default:
        std::abort();
    }
  }

  static void occluded_one(const RTCOccludedFunctionNArguments& arguments) {
    auto& ray = *reinterpret_cast<RTCRay*>(arguments.ray);
    if (meet(shape_of(arguments.geometryUserPtr, arguments.primID), ray) < kNever)
      ray.tfar = -kNever;
  }

  template <int N>
  static void occluded_packet(const RTCOccludedFunctionNArguments& arguments) {
    using F = typename Packed<N>::Float;
    auto& ray = *reinterpret_cast<RTCRayNt<N>*>(arguments.ray);
    const F t =
        meet<N>(shape_of(arguments.geometryUserPtr, arguments.primID), ray, arguments.valid);
    store(choose(t < kNever, F{} - kNever, load<F>(ray.tfar)), ray.tfar);
  }
};

}  // namespace zraka::embree
