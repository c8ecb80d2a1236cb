// SPDX-License-Identifier: Apache-2.0
// Pixels of one sample go straight into the picture, and are what a film makes of them.
#include <gtest/gtest.h>

#include "optics_scenes.hpp"
#include "picture_of.hpp"

namespace zraka {
namespace {

/// Around a room that has no way out, so that a film with coverage keeps all colours.
Scene closed_room(CameraKind kind) {
  Scene scene = room_with_glass(40);
  scene.camera.kind = kind;
  scene.materials[1].refraction = 0.5;
  scene.boxes.push_back({Box{{-9, -9, -9}, {9, 9, 9}}, 3});
  return scene;
}

TEST(SingleSamples, AreWhatAFilmMakesOfThem) {
  for (const CameraKind kind : {CameraKind::pinhole, CameraKind::orthographic, CameraKind::fisheye,
                                CameraKind::panorama})
    for (const int tile : {7, 32})
      for (const Isa isa : {available_isas().front(), Isa::oracle}) {
        RenderOptions options{.profile = profile_of(ProfileName::physical)};
        options.tile = tile, options.isa = isa;
        const Scene scene = closed_room(kind);
        const Image straight = picture_of(scene, options);
        options.transparent = true;
        EXPECT_EQ(picture_of(scene, options).pixels, straight.pixels) << static_cast<int>(kind);
      }
}

TEST(SingleSamples, LeaveTheBackgroundWhereNothingIs) {
  Scene scene = room_with_glass(40);
  scene.planes.clear();
  scene.background = {0.25, 0.5, -0.0};
  scene.camera.eye.z = 60, scene.camera.window_center.z = 50;
  const Image image = picture_of(scene);
  const float* const corner = image.row(0);
  EXPECT_EQ(corner[0], 0.25f);
  EXPECT_EQ(corner[1], 0.5f);
  EXPECT_EQ(corner[2], 0.0f);
}

}  // namespace
}  // namespace zraka
