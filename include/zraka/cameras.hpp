// SPDX-License-Identifier: Apache-2.0
// Where a picture is seen from.
#pragma once

#include <cstdint>
#include <zraka/values.hpp>

namespace zraka {

enum class CameraKind : std::uint8_t {
  pinhole,       ///< rays go from the eye through points of the window
  orthographic,  ///< parallel rays from points of the window, moved so that the eye is its middle
  fisheye,       ///< the angle to the view grows in proportion to the distance from the middle
  panorama       ///< all round: columns are longitudes, rows latitudes (equirectangular)
};

/// A pinhole looking through a window: rays go from the eye through points of a rectangle. Other
/// kinds take from the same vectors where they look and what is up.
struct Camera {
  Vec3 eye{0, 0, 2};
  Vec3 window_center;
  Vec3 window_right{2, 0, 0};  ///< from the window's left edge to its right edge
  Vec3 window_up{0, 2, 0};     ///< from the window's lower edge to its upper edge
  CameraKind kind = CameraKind::pinhole;
  /// pinhole: the diameter of a thin lens in its place, 0: none; and how far from the eye along the
  /// view all is in focus.
  double aperture = 0, focus_distance = 1;
  double fov_deg = 180;  ///< fisheye: the angle of view over the picture's height
  /// panorama: the degrees of longitude and of latitude that it shows, around the view.
  double longitude_deg = 360, latitude_deg = 180;
  double latitude_middle_deg = 0;  ///< panorama: the latitude of its middle row, up from the view
  friend bool operator==(const Camera&, const Camera&) = default;
};

}  // namespace zraka
