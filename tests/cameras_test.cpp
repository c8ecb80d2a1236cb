// SPDX-License-Identifier: Apache-2.0
// Where cameras' rays go, by geometry.
#include "cameras/cameras.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>
#include <zraka/render.hpp>

#include "scene/freeze_camera.hpp"
#include "scenes.hpp"

namespace zraka {
namespace {

constexpr double kPi = 3.14159265358979323846;

/// At (1, 2, 3), looking to -z, up is y.
Camera camera_of(CameraKind kind) {
  Camera camera;
  camera.eye = {1, 2, 3};
  camera.window_center = {1, 2, -1};
  camera.window_right = {4, 0, 0};
  camera.window_up = {0, 2, 0};
  camera.kind = kind;
  return camera;
}

FrozenCamera<double> frozen(const Camera& camera, const Resolution& resolution) {
  Scene scene;
  scene.camera = camera;
  scene.resolution = resolution;
  return freeze_camera<double>(scene, profile_of(ProfileName::physical), Frame());
}

CameraRay ray_at(const FrozenCamera<double>& camera, double column, double row,
                 const Point2& lens = {0.5, 0.5}) {
  CameraRay ray{};
  EXPECT_TRUE(camera_ray(camera, {column, row, lens}, ray));
  return ray;
}

void expect_near(const V3<double>& v, const V3<double>& want, double within = 1e-12) {
  EXPECT_NEAR(v.x, want.x, within);
  EXPECT_NEAR(v.y, want.y, within);
  EXPECT_NEAR(v.z, want.z, within);
}

constexpr Resolution kSize{40, 20};
/// The middle of the picture, as a pixel's place.
constexpr double kMiddleColumn = 19.5, kMiddleRow = 9.5;

std::vector<Point2> lens_points() {
  std::vector<Point2> points;
  for (int i = 0; i <= 8; ++i)
    for (int j = 0; j <= 8; ++j) points.push_back({i / 8.0, j / 8.0});
  return points;
}

TEST(Cameras, LookAheadInTheMiddleAndKeepRightRightAndUpUp) {
  for (const CameraKind kind :
       {CameraKind::pinhole, CameraKind::orthographic, CameraKind::fisheye, CameraKind::panorama}) {
    const FrozenCamera<double> camera = frozen(camera_of(kind), kSize);
    const CameraRay middle = ray_at(camera, kMiddleColumn, kMiddleRow);
    expect_near(middle.origin, {1, 2, 3});
    expect_near(middle.direction, {0, 0, -1});
    const auto place = [&](double column, double row) {  // one unit along the ray
      const CameraRay ray = ray_at(camera, column, row);
      return ray.origin + ray.direction;
    };
    EXPECT_GT(place(25, kMiddleRow).x, 1.01);
    EXPECT_LT(place(14, kMiddleRow).x, 0.99);
    EXPECT_GT(place(kMiddleColumn, 5).y, 2.01);
    EXPECT_LT(place(kMiddleColumn, 14).y, 1.99);
  }
}

TEST(Cameras, HaveConesAsWideAsPixels) {
  // What neighbouring rays span at some distance, and the square of the cone's width there.
  for (const CameraKind kind :
       {CameraKind::pinhole, CameraKind::orthographic, CameraKind::fisheye, CameraKind::panorama}) {
    const FrozenCamera<double> camera = frozen(camera_of(kind), kSize);
    for (const double column : {3.0, 11.0, 19.0, 33.0})
      for (const double row : {2.0, 9.0, 15.0}) {
        constexpr double kAway = 7, kStep = 1e-4;
        const auto end = [&](double c, double r) {
          const CameraRay ray = ray_at(camera, c, r);
          return ray.origin + ray.direction * kAway;
        };
        const V3<double> across = end(column + kStep, row) - end(column - kStep, row);
        const V3<double> down = end(column, row + kStep) - end(column, row - kStep);
        const V3<double> spanned = cross(across, down);
        const double area = std::sqrt(dot(spanned, spanned)) / (4 * kStep * kStep);
        const CameraRay ray = ray_at(camera, column, row);
        const CameraCone cone = camera_cone(camera, {column, row, {}}, ray);
        const double width = cone.width + kAway * cone.spread;
        EXPECT_NEAR(width * width / area, 1, 1e-6)
            << static_cast<int>(kind) << ": " << column << ", " << row;
      }
  }
}

TEST(Lens, IsADiscOfItsDiameterAroundTheEye) {
  Camera camera = camera_of(CameraKind::pinhole);
  camera.aperture = 0.5;
  camera.focus_distance = 6;
  const FrozenCamera<double> lens = frozen(camera, kSize);
  double farthest = 0;
  for (const Point2& point : lens_points()) {
    const V3<double> aside = ray_at(lens, 5, 12, point).origin - V3<double>{1, 2, 3};
    EXPECT_NEAR(aside.z, 0, 1e-12);
    farthest = std::max(farthest, std::sqrt(dot(aside, aside)));
  }
  EXPECT_NEAR(farthest, 0.25, 1e-12);
}

TEST(Lens, BringsAllItsRaysTogetherInFocusAndNowhereElse) {
  Camera camera = camera_of(CameraKind::pinhole);
  camera.aperture = 0.5;
  camera.focus_distance = 6;
  const FrozenCamera<double> lens = frozen(camera, kSize);
  camera.aperture = 0;
  const FrozenCamera<double> pinhole = frozen(camera, kSize);
  for (const double column : {0.0, 19.5, 37.0})
    for (const double row : {1.0, 9.5})
      for (const double away : {1.0, 3.0, 6.0, 12.0, 60.0}) {
        // Where a ray meets the plane across the view at a distance.
        const auto at = [&](const CameraRay& ray) {
          return ray.origin + ray.direction * ((3 - away - ray.origin.z) / ray.direction.z);
        };
        const V3<double> sharp = at(ray_at(pinhole, column, row));
        double blur = 0;
        for (const Point2& point : lens_points()) {
          const V3<double> aside = at(ray_at(lens, column, row, point)) - sharp;
          blur = std::max(blur, std::sqrt(dot(aside, aside)));
        }
        // The circle of confusion: the lens' radius, seen from the plane in focus.
        EXPECT_NEAR(blur, 0.25 * std::fabs(1 - away / 6), 1e-9) << away;
      }
}

TEST(Orthographic, HasParallelRaysFromThePointsOfItsWindow) {
  const FrozenCamera<double> camera = frozen(camera_of(CameraKind::orthographic), kSize);
  for (const double column : {0.0, 7.0, 39.0})
    for (const double row : {0.0, 13.0}) {
      const CameraRay ray = ray_at(camera, column, row);
      expect_near(ray.direction, {0, 0, -1});
      expect_near(ray.origin, {1 + (column - 19.5) * 0.1, 2 - (row - 9.5) * 0.1, 3});
    }
}

TEST(Fisheye, TurnsInProportionToTheDistanceFromTheMiddle) {
  Camera camera = camera_of(CameraKind::fisheye);
  for (const double fov : {60.0, 180.0, 300.0}) {
    camera.fov_deg = fov;
    const FrozenCamera<double> fisheye = frozen(camera, kSize);
    for (const double column : {19.0, 25.0, 12.0})
      for (const double row : {9.0, 16.0, 3.0}) {
        const double away = std::hypot(column - kMiddleColumn, row - kMiddleRow);
        const CameraRay ray = ray_at(fisheye, column, row);
        EXPECT_NEAR(std::acos(-ray.direction.z), away * fov / 20 * kPi / 180, 1e-7);
        EXPECT_NEAR(std::atan2(ray.direction.y, ray.direction.x),
                    std::atan2(kMiddleRow - row, column - kMiddleColumn), 1e-9);
      }
  }
  // At the picture's upper edge it looks half the angle of view up.
  camera.fov_deg = 180;
  expect_near(ray_at(frozen(camera, kSize), kMiddleColumn, -0.5).direction, {0, 1, 0});
}

TEST(Fisheye, SeesNothingBeyondAHalfTurn) {
  Camera camera = camera_of(CameraKind::fisheye);
  camera.fov_deg = 360;
  const FrozenCamera<double> fisheye = frozen(camera, kSize);
  CameraRay ray{};
  EXPECT_TRUE(camera_ray(fisheye, {kMiddleColumn, -0.49, {}}, ray));
  expect_near(ray.direction, {0, 0, 1}, 0.01);
  EXPECT_FALSE(camera_ray(fisheye, {kMiddleColumn, -0.51, {}}, ray));
  EXPECT_FALSE(camera_ray(fisheye, {0, 0, {}}, ray));
}

TEST(Panorama, HasAllDirectionsWhereMapsHaveThem) {
  const FrozenCamera<double> camera = frozen(camera_of(CameraKind::panorama), kSize);
  expect_near(ray_at(camera, 29.5, kMiddleRow).direction, {1, 0, 0});  // three quarters: right
  expect_near(ray_at(camera, 9.5, kMiddleRow).direction, {-1, 0, 0});  // a quarter: left
  expect_near(ray_at(camera, -0.5, kMiddleRow).direction, {0, 0, 1});  // the left edge: behind
  expect_near(ray_at(camera, 39.5, kMiddleRow).direction, {0, 0, 1});  // the right edge as well
  for (const double column : {0.0, 13.0}) {
    expect_near(ray_at(camera, column, -0.5).direction, {0, 1, 0});  // above: up
    expect_near(ray_at(camera, column, 19.5).direction, {0, -1, 0});
  }
  expect_near(ray_at(camera, kMiddleColumn, 4.5).direction,
              {0, std::sqrt(0.5), -std::sqrt(0.5)});  // a quarter: 45° up
}

TEST(Panorama, MayShowAPart) {
  Camera part = camera_of(CameraKind::panorama);
  part.longitude_deg = 90, part.latitude_deg = 60, part.latitude_middle_deg = 30;
  const FrozenCamera<double> camera = frozen(part, kSize);
  expect_near(ray_at(camera, kMiddleColumn, 19.5).direction, {0, 0, -1});
  expect_near(ray_at(camera, kMiddleColumn, -0.5).direction, {0, std::sqrt(0.75), -0.5});
  expect_near(ray_at(camera, 39.5, 19.5).direction, {std::sqrt(0.5), 0, -std::sqrt(0.5)});
}

/// What render() says of a scene with this camera; "" if it renders.
std::string answer(const Camera& camera) {
  Scene scene = lab_scene(4);
  scene.camera = camera;
  const Result<Rendering> rendering = render(scene);
  return rendering ? "" : rendering.error().front().message;
}

TEST(Cameras, AreCheckedBeforeTheyAreUsed) {
  Camera camera = camera_of(CameraKind::fisheye);
  EXPECT_EQ(answer(camera), "");
  for (const double fov : {0.0, -10.0, 361.0}) {
    camera.fov_deg = fov;
    EXPECT_EQ(answer(camera), "the fisheye camera's angle of view is " + std::to_string(int(fov)) +
                                  "°: more than 0 and at most 360 are possible");
  }
  camera = camera_of(CameraKind::pinhole);
  camera.aperture = -1;
  EXPECT_EQ(answer(camera), "the lens' diameter is -1: 0 or more is possible");
  camera.aperture = 0.1;
  camera.focus_distance = 0;
  EXPECT_EQ(answer(camera), "the camera is in focus at the distance 0: it has to be more than 0");
  for (const CameraKind kind :
       {CameraKind::orthographic, CameraKind::fisheye, CameraKind::panorama}) {
    camera = camera_of(kind);
    camera.window_center = camera.eye;
    const char* const nowhere =
        "the camera looks nowhere, or straight up: its eye, its window's middle and up span no "
        "plane";
    EXPECT_EQ(answer(camera), nowhere);
    camera = camera_of(kind);
    camera.window_up = {0, 0, 5};
    EXPECT_EQ(answer(camera), nowhere);
  }
  camera = camera_of(CameraKind::orthographic);
  camera.window_right = {1e-9, 0, 0};
  camera.window_up = {0, 1e-9, 0};
  EXPECT_EQ(answer(camera),
            "the view is too narrow: floats cannot tell the rays of neighbouring pixels apart");
}

}  // namespace
}  // namespace zraka
