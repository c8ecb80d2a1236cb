// SPDX-License-Identifier: Apache-2.0
// Embree 3 or 4, whichever is installed: the few calls that differ.
#pragma once

#ifdef ZRAKA_EMBREE_4
#include <embree4/rtcore.h>
#else
#include <embree3/rtcore.h>
#endif

namespace zraka::embree {

/// How rays of a batch go: beside each other, or anywhere.
enum class Going { together, apart };

#ifdef ZRAKA_EMBREE_4

inline RTCRayQueryFlags flags_of(Going going) {
  return going == Going::together ? RTC_RAY_QUERY_FLAG_COHERENT : RTC_RAY_QUERY_FLAG_INCOHERENT;
}
inline RTCIntersectArguments nearest_arguments(Going going) {
  RTCIntersectArguments arguments;
  rtcInitIntersectArguments(&arguments);
  arguments.flags = flags_of(going);
  return arguments;
}
inline RTCOccludedArguments any_arguments(Going going) {
  RTCOccludedArguments arguments;
  rtcInitOccludedArguments(&arguments);
  arguments.flags = flags_of(going);
  return arguments;
}
inline void nearest(RTCScene scene, Going going, const int* valid, RTCRayHit16& rays) {
  RTCIntersectArguments arguments = nearest_arguments(going);
  rtcIntersect16(valid, scene, &rays, &arguments);
}
inline void nearest(RTCScene scene, Going going, RTCRayHit& ray) {
  RTCIntersectArguments arguments = nearest_arguments(going);
  rtcIntersect1(scene, &ray, &arguments);
}
inline void any_hit(RTCScene scene, Going going, const int* valid, RTCRay16& rays) {
  RTCOccludedArguments arguments = any_arguments(going);
  rtcOccluded16(valid, scene, &rays, &arguments);
}
inline void any_hit(RTCScene scene, Going going, RTCRay& ray) {
  RTCOccludedArguments arguments = any_arguments(going);
  rtcOccluded1(scene, &ray, &arguments);
}

#else

inline RTCIntersectContext context_of(Going going) {
  RTCIntersectContext context;
  rtcInitIntersectContext(&context);
  context.flags = going == Going::together ? RTC_INTERSECT_CONTEXT_FLAG_COHERENT
                                           : RTC_INTERSECT_CONTEXT_FLAG_INCOHERENT;
  return context;
}
inline void nearest(RTCScene scene, Going going, const int* valid, RTCRayHit16& rays) {
  RTCIntersectContext context = context_of(going);
  rtcIntersect16(valid, scene, &context, &rays);
}
inline void nearest(RTCScene scene, Going going, RTCRayHit& ray) {
  RTCIntersectContext context = context_of(going);
  rtcIntersect1(scene, &context, &ray);
}
inline void any_hit(RTCScene scene, Going going, const int* valid, RTCRay16& rays) {
  RTCIntersectContext context = context_of(going);
  rtcOccluded16(valid, scene, &context, &rays);
}
inline void any_hit(RTCScene scene, Going going, RTCRay& ray) {
  RTCIntersectContext context = context_of(going);
  rtcOccluded1(scene, &context, &ray);
}

#endif

}  // namespace zraka::embree
