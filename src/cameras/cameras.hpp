// SPDX-License-Identifier: Apache-2.0
// The list of cameras.
#pragma once

#include "cameras/fisheye.hpp"
#include "cameras/orthographic.hpp"
#include "cameras/panorama.hpp"
#include "cameras/pinhole.hpp"

/// CameraKind and the struct with its functions.
#define ZRAKA_CAMERAS(X)              \
  X(pinhole, PinholeCamera)           \
  X(orthographic, OrthographicCamera) \
  X(fisheye, FisheyeCamera)           \
  X(panorama, PanoramaCamera)

namespace zraka {

/// False where a camera sees nothing: beyond a fisheye's half turn.
template <class R>
bool camera_ray(const FrozenCamera<R>& camera, const PicturePoint& at, CameraRay& ray) {
  switch (camera.kind) {
#define ZRAKA_CASE(kind, Type) \
  case CameraKind::kind:       \
    return Type::ray(camera, at, ray);
    ZRAKA_CAMERAS(ZRAKA_CASE)
#undef ZRAKA_CASE
  }
  return false;
}

/// What a pixel sees of a ray that camera_ray() made.
template <class R>
CameraCone camera_cone(const FrozenCamera<R>& camera, const PicturePoint& at,
                       const CameraRay& ray) {
  switch (camera.kind) {
#define ZRAKA_CASE(kind, Type) \
  case CameraKind::kind:       \
    return Type::cone(camera, at, ray);
    ZRAKA_CAMERAS(ZRAKA_CASE)
#undef ZRAKA_CASE
  }
  return {};
}

}  // namespace zraka
