// SPDX-License-Identifier: Apache-2.0
// Tachyon's camera, shaders, backgrounds and fog. Its world is left-handed: what is right of the
// view is up × view, and the window of our camera is put there.
#include <fmt/format.h>

#include <cmath>

#include "formats/tachyon_reader.hpp"
#include "formats/vectors.hpp"

namespace zraka {
namespace {

constexpr double kPerRadian = 180 / 3.14159265358979323846;

}  // namespace

bool TachyonReader::read_resolution() {
  const char* const at = in_->place();
  double width = 0, height = 0;
  if (!number(width, "the width") || !number(height, "the height")) return false;
  if (width < 1 || height < 1 || width != std::floor(width) || height != std::floor(height))
    return fail(
        at, fmt::format("RESOLUTION is {} {}: expected whole numbers, 1 or more", width, height));
  if (width * height > static_cast<double>(kMaxPixels))
    return fail(at, fmt::format("RESOLUTION is {} {}: expected {} pixels at most", width, height,
                                kMaxPixels));
  scene_.resolution = {static_cast<std::uint32_t>(width), static_cast<std::uint32_t>(height)};
  return true;
}

bool TachyonReader::read_camera() {
  const char* const at = in_->place();
  projection_ = "PERSPECTIVE";
  focal_length_ = 1;
  aperture_ = 0;
  frustum_.reset();
  if (in_->take_keyword("PROJECTION")) {
    constexpr std::string_view kProjections[] = {"PERSPECTIVE", "PERSPECTIVE_DOF", "ORTHOGRAPHIC",
                                                 "FISHEYE"};
    const char* const place = in_->place();
    const std::string_view word = in_->take();
    projection_ = "";
    for (const std::string_view known : kProjections)
      if (is_keyword(word, known)) projection_ = known;
    if (projection_.empty())
      return fail(place,
                  fmt::format("'{}' is no projection: expected PERSPECTIVE, PERSPECTIVE_DOF, "
                              "ORTHOGRAPHIC or FISHEYE",
                              shown(word)));
    if (projection_ == "PERSPECTIVE_DOF") {
      // VMD of late says FOCALDIST.
      if (!in_->take_keyword("FOCALDIST") && !expect("FOCALLENGTH")) return false;
      const char* const length = in_->place();
      if (!number(focal_length_, "FOCALLENGTH") || !number_of("APERTURE", aperture_)) return false;
      if (!(focal_length_ > 0))
        return fail(length, fmt::format("FOCALLENGTH is {}: expected more than 0", focal_length_));
      aperture_ = std::fabs(aperture_);
    }
  }
  const char* const zoom = in_->place();
  if (!number_of("ZOOM", zoom_) || !number_of("ASPECTRATIO", aspect_) ||
      !number_of("ANTIALIASING", samples_) || !number_of("RAYDEPTH", depth_) ||
      !vector_of("CENTER", center_) || !vector_of("VIEWDIR", view_) || !vector_of("UPDIR", up_))
    return false;
  if (in_->take_keyword("FRUSTUM")) {
    frustum_.emplace();
    for (double& side : *frustum_)
      if (!number(side, "left, right, bottom and top of FRUSTUM")) return false;
    if ((*frustum_)[0] == (*frustum_)[1] || (*frustum_)[2] == (*frustum_)[3])
      return fail(at, "FRUSTUM has no width or no height");
  }
  if (!expect("END_CAMERA")) return false;
  if (!(zoom_ > 0) || !(aspect_ > 0))
    return fail(zoom,
                fmt::format("ZOOM is {} and ASPECTRATIO {}: expected more than 0", zoom_, aspect_));
  if (is_zero(view_)) return fail(at, "VIEWDIR of CAMERA is 0 0 0");
  if (is_zero(unit(cross(unit(up_), unit(view_)))))
    return fail(at, "UPDIR of CAMERA is 0 or along VIEWDIR");
  has_camera_ = true;
  return true;
}

/// A ray goes through the upper right corner of a pixel, so the window is moved by half of one.
void TachyonReader::set_camera() {
  scene_.resolution = settings_.resolution.value_or(scene_.resolution);
  samples_ = settings_.samples.value_or(samples_);
  const double columns = scene_.resolution.width, rows = scene_.resolution.height;
  const double height = 1 / zoom_, width = columns / rows / aspect_ / zoom_;
  std::array<double, 4> sides{-width / 2, width / 2, -height / 2, height / 2};
  if (frustum_) sides = *frustum_;
  const auto [left, other, bottom, top] = sides;
  const Vec3 view = unit(view_), right = unit(cross(unit(up_), view)), up = cross(view, right);
  const double across = (left + other) / 2 + (other - left) / columns / 2;
  const double above = (bottom + top) / 2 + (top - bottom) / rows / 2;
  Camera& camera = scene_.camera;
  camera.eye = center_;
  const Vec3 aside = right * across + up * above;
  camera.window_center = center_ + view + aside;
  camera.window_right = right * (other - left);
  camera.window_up = up * (top - bottom);
  // Without more samples Tachyon looks through the lens' middle alone.
  if (projection_ == "PERSPECTIVE_DOF" && samples_ > 0) {
    camera.aperture = aperture_ * std::sqrt(std::fabs((other - left) * (top - bottom)));
    camera.focus_distance = focal_length_;
  }
  if (projection_ == "ORTHOGRAPHIC") {
    camera.kind = CameraKind::orthographic;
    camera.eye = center_ + aside;
    camera.window_center = camera.eye + view;
  }
  if (projection_ == "FISHEYE") {
    // Sides are angles of longitude and latitude.
    camera.kind = CameraKind::panorama;
    camera.longitude_deg = std::fabs(other - left) * kPerRadian;
    camera.latitude_deg = std::fabs(top - bottom) * kPerRadian;
    camera.latitude_middle_deg = above * kPerRadian;
    const double turn = across;
    const Vec3 ahead = view * std::cos(turn) + right * std::sin(turn);
    camera.window_center = center_ + ahead;
    camera.window_right = unit(right * std::cos(turn) + view * -std::sin(turn));
    camera.window_up = up;
    // Sides that are swapped turn the picture round.
    if (other < left) camera.window_right = camera.window_right * -1;
    if (top < bottom) {
      camera.window_up = camera.window_up * -1;
      camera.latitude_middle_deg = -camera.latitude_middle_deg;
    }
  }
}

bool TachyonReader::read_shader_mode() {
  const char* const at = in_->place();
  const std::string_view word = in_->take();
  if (is_keyword(word, "FULL"))
    mode_ = TachyonMode::full;
  else if (is_keyword(word, "MEDIUM"))
    mode_ = TachyonMode::medium;
  else if (is_keyword(word, "LOW"))
    mode_ = TachyonMode::low;
  else if (is_keyword(word, "LOWEST"))
    mode_ = TachyonMode::lowest;
  else
    return fail(
        at, fmt::format("'{}' is no shader: expected FULL, MEDIUM, LOW or LOWEST", shown(word)));
  for (;;) {
    const char* const place = in_->place();
    double ignored = 0;
    if (in_->take_keyword("END_SHADER_MODE")) return true;
    if (in_->take_keyword("SHADOW_FILTER_ON")) {
      shadow_filter_ = true;
    } else if (in_->take_keyword("SHADOW_FILTER_OFF")) {
      shadow_filter_ = false;
    } else if (in_->take_keyword("TRANS_ORIG")) {
      trans_vmd_ = false;
    } else if (in_->take_keyword("TRANS_VMD")) {
      trans_vmd_ = true;
    } else if (in_->take_keyword("FOG_VMD")) {
      fog_vmd_ = true;
    } else if (in_->take_keyword("TRANS_RASTER3D")) {
      warn(place, "TRANS_RASTER3D is left out: opacity does not change with the angle");
    } else if (in_->take_keyword("TRANS_MAX_SURFACES")) {
      if (!number(ignored, "TRANS_MAX_SURFACES")) return false;
      warn(place, "TRANS_MAX_SURFACES is left out: all transparent surfaces are drawn");
    } else if (in_->take_keyword("AMBIENT_OCCLUSION")) {
      if (!color_of("AMBIENT_COLOR", scene_.ambient_occlusion.color) ||
          !number_of("RESCALE_DIRECT", light_scale_) || !read_occlusion("SAMPLES"))
        return false;
    } else {
      return expect("END_SHADER_MODE");
    }
  }
}

bool TachyonReader::read_background() {
  scene_.sky.kind = Sky::Kind::flat;
  return color(scene_.background, "a colour");
}

bool TachyonReader::read_gradient() {
  const char* const at = in_->place();
  const bool plane = in_->take_keyword("SKY_ORTHO_PLANE");
  if (!plane && !expect("SKY_SPHERE")) return false;
  Sky& sky = scene_.sky;
  double top = 0, bottom = 0;
  if (!vector_of("UPDIR", sky.up) || !number_of("TOPVAL", top) || !number_of("BOTTOMVAL", bottom) ||
      !color_of("TOPCOLOR", sky.top) || !color_of("BOTTOMCOLOR", sky.bottom))
    return false;
  const double length = std::sqrt(sky.up.x * sky.up.x + sky.up.y * sky.up.y + sky.up.z * sky.up.z);
  if (!(length > 0)) return fail(at, "UPDIR of BACKGROUND_GRADIENT is 0 0 0");
  if (!(top != bottom)) return fail(at, "TOPVAL and BOTTOMVAL of BACKGROUND_GRADIENT are equal");
  if (plane) {
    warn(at, "SKY_ORTHO_PLANE is left out: the background has the mean of its colours");
    const auto mean = [](double a, double b) { return (a + b) / 2; };
    scene_.background = {mean(sky.top.r, sky.bottom.r), mean(sky.top.g, sky.bottom.g),
                         mean(sky.top.b, sky.bottom.b)};
    sky = {};
    return true;
  }
  sky.kind = Sky::Kind::gradient;
  sky.high = top / length;
  sky.low = bottom / length;
  return true;
}

bool TachyonReader::read_fog() {
  const char* const at = in_->place();
  const std::string_view word = in_->take();
  Fog& fog = scene_.fog;
  if (is_keyword(word, "LINEAR"))
    fog.kind = Fog::Kind::linear;
  else if (is_keyword(word, "EXP"))
    fog.kind = Fog::Kind::exponential;
  else if (is_keyword(word, "EXP2"))
    fog.kind = Fog::Kind::squared;
  else if (is_keyword(word, "OFF"))
    fog.kind = Fog::Kind::none;
  else
    return fail(at, fmt::format("'{}' is no fog: expected LINEAR, EXP, EXP2 or OFF", shown(word)));
  return number_of("START", fog.start) && number_of("END", fog.end) &&
         number_of("DENSITY", fog.density) && color_of("COLOR", fog.color);
}

bool TachyonReader::read_clip_group() {
  const char* const at = in_->place();
  std::size_t planes = 0;
  if (!expect("NUMPLANES") || !count(planes, "NUMPLANES", 8, 1e6)) return false;
  std::vector<Cut> cuts;
  for (std::size_t i = 0; i < planes; ++i) {
    Cut cut;
    cut.caps = false;
    double distance = 0;
    if (!number(cut.normal.x, "a plane") || !number(cut.normal.y, "a plane") ||
        !number(cut.normal.z, "a plane") || !number(distance, "a plane"))
      return false;
    const auto& [x, y, z] = cut.normal;
    const double square = x * x + y * y + z * z;
    if (!(square > 0)) {
      warn(at, "a plane of START_CLIPGROUP has no normal: it cuts nothing off");
      continue;
    }
    cut.point = cut.normal * (distance / square);
    cuts.push_back(cut);
  }
  cut_group_ = 0;
  if (cuts.empty()) return true;
  // Programs repeat the same planes for one group of shapes after the other.
  std::vector<double> numbers;
  for (const Cut& cut : cuts)
    numbers.insert(numbers.end(), {cut.normal.x, cut.normal.y, cut.normal.z, cut.point.x,
                                   cut.point.y, cut.point.z});
  const auto [known, fresh] = cut_groups_.try_emplace(
      std::move(numbers), static_cast<std::uint32_t>(cut_groups_.size() + 1));
  cut_group_ = known->second;
  for (Cut& cut : cuts) cut.group = cut_group_;
  if (fresh) scene_.cuts.insert(scene_.cuts.end(), cuts.begin(), cuts.end());
  return true;
}

bool TachyonReader::end_clip_group() {
  cut_group_ = 0;
  return true;
}

}  // namespace zraka
