// SPDX-License-Identifier: Apache-2.0
// A user geometry of any of our shapes: what Embree calls for one ray or for sixteen.
#pragma once

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

  static Float16 meet(const Shape& shape, const RTCRay16& ray, const int* valid) {
    const Float16 t = shape.template meet<Float16>(
        {load(ray.org_x), load(ray.org_y), load(ray.org_z)},
        {load(ray.dir_x), load(ray.dir_y), load(ray.dir_z)}, load(ray.tnear), load(ray.tfar));
    return load(valid) != 0 ? t : all(kNever);
  }

  static void intersect(const RTCIntersectFunctionNArguments* arguments) {
    const Shape& shape = shape_of(arguments->geometryUserPtr, arguments->primID);
    if (arguments->N == 1) {
      auto& [ray, hit] = *reinterpret_cast<RTCRayHit*>(arguments->rayhit);
      const float t = meet(shape, ray);
      if (!(t < kNever)) return;
      const Vec n = shape.normal_at(
          {ray.org_x + ray.dir_x * t, ray.org_y + ray.dir_y * t, ray.org_z + ray.dir_z * t});
      ray.tfar = t;
      hit.Ng_x = n.x, hit.Ng_y = n.y, hit.Ng_z = n.z;
      hit.primID = arguments->primID, hit.geomID = arguments->geomID;
      return;
    }
    auto& [ray, hit] = *reinterpret_cast<RTCRayHit16*>(arguments->rayhit);
    const Float16 t = meet(shape, ray, arguments->valid);
    each_bit(bits(t < kNever), [&](int i) {
      const Vec n =
          shape.normal_at({ray.org_x[i] + ray.dir_x[i] * t[i], ray.org_y[i] + ray.dir_y[i] * t[i],
                           ray.org_z[i] + ray.dir_z[i] * t[i]});
      ray.tfar[i] = t[i];
      hit.Ng_x[i] = n.x, hit.Ng_y[i] = n.y, hit.Ng_z[i] = n.z;
      hit.primID[i] = arguments->primID, hit.geomID[i] = arguments->geomID;
    });
  }

  static void occluded(const RTCOccludedFunctionNArguments* arguments) {
    const Shape& shape = shape_of(arguments->geometryUserPtr, arguments->primID);
    if (arguments->N == 1) {
      auto& ray = *reinterpret_cast<RTCRay*>(arguments->ray);
      if (meet(shape, ray) < kNever) ray.tfar = -kNever;
      return;
    }
    auto& ray = *reinterpret_cast<RTCRay16*>(arguments->ray);
    const Float16 t = meet(shape, ray, arguments->valid);
    store(t < kNever ? all(-kNever) : load(ray.tfar), ray.tfar);
  }
};

}  // namespace zraka::embree
