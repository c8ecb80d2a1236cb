// SPDX-License-Identifier: Apache-2.0
// [camera]: where the picture is seen from.
#include <fmt/format.h>

#include <cmath>
#include <initializer_list>

#include "language/sections.hpp"
#include "scene/view.hpp"

namespace zraka::language {
namespace {

struct Window {
  Vec3 center, right{2, 0, 0}, up{0, 2, 0};
};
/// Of all kinds; each has fields for some of it.
struct CameraEntry {
  Vec3 eye{0, 0, 5}, look_at, up{0, 1, 0};
  std::optional<Window> window;
  double fov_deg = 40, height = 5;
  double longitude_deg = Camera{}.longitude_deg, latitude_deg = Camera{}.latitude_deg;
  double latitude_middle_deg = Camera{}.latitude_middle_deg;
  double aperture = 0;
  std::optional<Vec3> focus;
  std::optional<double> focus_distance;
};
struct WindowEntry : CameraEntry {
  WindowEntry() { eye = {0, 0, 2}; }
};
struct FisheyeEntry : CameraEntry {
  FisheyeEntry() { fov_deg = Camera{}.fov_deg; }
};

double aspect_of(const Scene& scene) {
  return static_cast<double>(scene.resolution.width) / scene.resolution.height;
}

bool is_finite(const Vec3& v) {
  return std::isfinite(v.x) && std::isfinite(v.y) && std::isfinite(v.z);
}

void complain(const Item& item, std::string_view key, std::string_view message,
              std::string hint = {}) {
  item.complain(key, std::string(message), std::move(hint));
}

/// By what `looking` makes of eye, look_at and up; or by the window, which says all that. None, and
/// the problem told, where that is no view. `others` are the keys besides that a window replaces.
template <class Looking>
std::optional<Camera> view_of(const CameraEntry& entry, std::initializer_list<std::string_view> others,
                              const Item& item, std::string_view what, const Looking& looking) {
  if (entry.window) {
    const Camera camera{entry.eye, entry.window->center, entry.window->right, entry.window->up};
    for (const std::string_view key : others)
      if (item.node.find(key) != nullptr)
        return complain(item, key,
                        fmt::format("{} has window and {}: expected one of them", what, key)),
               std::nullopt;
    if (spans_a_plane(camera.window_right, camera.window_up)) return camera;
    complain(item, "window", "right and up of the camera's window span no plane");
    return std::nullopt;
  }
  const std::optional<Camera> camera = looking();
  if (camera && is_finite(camera->window_center) && is_finite(camera->window_right) &&
      is_finite(camera->window_up))
    return camera;
  if (camera) {
    complain(item, "eye",
             fmt::format("what {} sees is too far away, or too large, for numbers", what));
    return std::nullopt;
  }
  if (entry.eye == entry.look_at)
    complain(item, "look_at", "the camera's eye is at the point that it looks at");
  else
    complain(item, "up", fmt::format("up of {} is the direction of view", what),
             "expected a direction that is not the one from eye to look_at");
  return std::nullopt;
}

/// The lens; it is in focus at `usual` where nothing is said.
bool set_lens(const CameraEntry& entry, double usual, const Item& item, std::string_view what,
              Camera& camera) {
  camera.aperture = entry.aperture;
  if (entry.focus && entry.focus_distance) {
    complain(item, "focus_distance",
             fmt::format("{} has focus and focus_distance: expected one of them", what));
    return false;
  }
  if (entry.aperture > 0) camera.focus_distance = usual;
  if (entry.focus_distance) camera.focus_distance = *entry.focus_distance;
  if (entry.focus) camera.focus_distance = depth_of(*entry.focus, camera);
  if (camera.focus_distance > 0 && std::isfinite(camera.focus_distance)) return true;
  const std::string_view key = entry.focus ? "focus" : entry.window ? "window" : "look_at";
  complain(item, key,
           fmt::format("{} of {} is not in front of the eye, or too far away", key, what));
  return false;
}

double distance(const Vec3& a, const Vec3& b) {
  return std::hypot(a.x - b.x, a.y - b.y, a.z - b.z);
}

void put_perspective(CameraEntry& entry, Item& item) {
  constexpr std::string_view kWhat = "perspective camera";
  const std::optional<Camera> view = view_of(entry, {"look_at", "up", "fov_deg"}, item, kWhat, [&] {
    return look_at(entry.eye, entry.look_at, entry.up, entry.fov_deg, aspect_of(item.input.scene));
  });
  if (!view) return;
  Camera camera = *view;
  if (!spans_a_plane(camera.window_right, camera.window_up))
    return complain(item, "fov_deg", "the angle of view is too small to be told from 0");
  const double usual =
      entry.window ? depth_of(camera.window_center, camera) : distance(entry.look_at, entry.eye);
  if (set_lens(entry, usual, item, kWhat, camera)) item.input.scene.camera = camera;
}

void put_window(WindowEntry& entry, Item& item) {
  constexpr std::string_view kWhat = "window camera";
  const std::optional<Camera> view =
      view_of(entry, {}, item, kWhat, [] { return std::optional<Camera>(); });
  if (!view) return;
  Camera camera = *view;
  if (set_lens(entry, depth_of(camera.window_center, camera), item, kWhat, camera))
    item.input.scene.camera = camera;
}

void put_orthographic(CameraEntry& entry, Item& item) {
  std::optional<Camera> camera =
      view_of(entry, {"look_at", "up", "height"}, item, "orthographic camera", [&] {
        return look_along(entry.eye, entry.look_at, entry.up, entry.height,
                          aspect_of(item.input.scene));
      });
  if (!camera) return;
  if (!spans_a_plane(camera->window_right, camera->window_up))
    return complain(item, "height", "the height is too small to be told from 0");
  camera->kind = CameraKind::orthographic;
  item.input.scene.camera = *camera;
}

/// Of these the window says directions alone.
void put_round(const CameraEntry& entry, CameraKind kind, std::string_view what, Item& item) {
  constexpr double kRightAngle = 90;
  std::optional<Camera> camera = view_of(entry, {"look_at", "up"}, item, what, [&] {
    return look_at(entry.eye, entry.look_at, entry.up, kRightAngle, aspect_of(item.input.scene));
  });
  if (!camera) return;
  camera->kind = kind;
  if (kind == CameraKind::fisheye) camera->fov_deg = entry.fov_deg;
  camera->longitude_deg = entry.longitude_deg;
  camera->latitude_deg = entry.latitude_deg;
  camera->latitude_middle_deg = entry.latitude_middle_deg;
  item.input.scene.camera = *camera;
}
void put_fisheye(FisheyeEntry& entry, Item& item) {
  put_round(entry, CameraKind::fisheye, "fisheye camera", item);
}
void put_panorama(CameraEntry& entry, Item& item) {
  put_round(entry, CameraKind::panorama, "panorama camera", item);
}

constexpr Field kWindowTableFields[] = {
    field<&Window::center>("center", {.text = "its middle", .unit = Unit::point, .required = true}),
    field<&Window::right>("right", {.text = "from its left edge to its right edge",
                                    .unit = Unit::direction,
                                    .required = true}),
    field<&Window::up>("up", {.text = "from its lower edge to its upper edge",
                              .unit = Unit::direction,
                              .required = true}),
};
constexpr Table kWindow =
    table_of<Window>("window", "A rectangle in space that the picture fills.", kWindowTableFields);

constexpr Field eye(std::string_view text) {
  return field<&CameraEntry::eye>("eye", {.text = text, .unit = Unit::point});
}
constexpr Field look_at_field() {
  return field<&CameraEntry::look_at>(
      "look_at", {.text = "the point in the middle of the picture", .unit = Unit::point});
}
constexpr Field up() {
  return field<&CameraEntry::up>(
      "up", {.text = "which direction is up in the picture", .unit = Unit::direction});
}
constexpr Field window(std::string_view text, bool required = false) {
  return table_field<&CameraEntry::window, kWindow>("window", {.text = text, .required = required});
}
constexpr Field aperture() {
  return field<&CameraEntry::aperture>(
      "aperture", {.text = "the diameter of a thin lens at the eye, which draws sharply what is in "
                           "focus alone; 0: a pinhole",
                   .unit = Unit::length,
                   .range = at_least(0)});
}
constexpr Field focus() {
  return field<&CameraEntry::focus>(
      "focus",
      {.text = "a point of the plane across the view that is in focus", .unit = Unit::point});
}
constexpr Field focus_distance(std::string_view text) {
  return field<&CameraEntry::focus_distance>(
      "focus_distance", {.text = text, .unit = Unit::length, .range = greater_than(0)});
}

constexpr Field kPerspectiveFields[] = {
    eye("where the rays start"),
    look_at_field(),
    up(),
    field<&CameraEntry::fov_deg>("fov_deg", {.text = "the angle of view over the picture's height",
                                       .unit = Unit::degrees,
                                       .range = between(0, 180)}),
    window("in the place of look_at, up and fov_deg, the rectangle that the rays go through"),
    aperture(),
    focus(),
    focus_distance("how far from the eye, along the view, that plane is; where nothing is said, "
                   "look_at is in it"),
};
constexpr Field kWindowFields[] = {
    eye("where the rays start"),
    window("the rectangle that the rays go through, as in the lab", true),
    aperture(),
    focus(),
    focus_distance(
        "how far from the eye that plane is; where nothing is said, as far as the window's"),
};
constexpr Field kOrthographicFields[] = {
    eye("in the middle of the plane where the rays start"),
    look_at_field(),
    up(),
    field<&CameraEntry::height>("height", {.text = "how much of the scene the picture's height shows",
                                     .unit = Unit::length,
                                     .range = greater_than(0)}),
    window("in the place of look_at, up and height: the rays start in a rectangle like this with "
           "its middle at the eye, and go towards its center"),
};
constexpr Field kFisheyeFields[] = {
    eye("where the rays start"),
    look_at_field(),
    up(),
    field<&CameraEntry::fov_deg>("fov_deg", {.text = "the angle of view over the picture's height",
                                       .unit = Unit::degrees,
                                       .range = {0, 360, true, false}}),
    window("in the place of look_at and up, a rectangle whose directions say where it looks"),
};
constexpr Field kPanoramaFields[] = {
    eye("where the rays start"),
    look_at_field(),
    up(),
    window("in the place of look_at and up, a rectangle whose directions say where it looks"),
    field<&CameraEntry::longitude_deg>(
        "longitude_deg",
        {.text = "how far round it sees", .unit = Unit::degrees, .range = {0, 360, true, false}}),
    field<&CameraEntry::latitude_deg>("latitude_deg", {.text = "how much it sees from below to above",
                                                 .unit = Unit::degrees,
                                                 .range = {0, 180, true, false}}),
    field<&CameraEntry::latitude_middle_deg>("latitude_middle_deg",
                                       {.text = "how far above the view the picture's middle is",
                                        .unit = Unit::degrees,
                                        .range = from_to(-90, 90)}),
};

constexpr Kind kPerspective = kind_of<CameraEntry, put_perspective>(
    "perspective", "perspective camera", "A pinhole, or a lens, that looks at a point.",
    kPerspectiveFields);
constexpr Kind kWindowKind = kind_of<WindowEntry, put_window>(
    "window", "window camera", "A pinhole, or a lens, that looks through a window, as in the lab.",
    kWindowFields);
constexpr Kind kOrthographic =
    kind_of<CameraEntry, put_orthographic>("orthographic", "orthographic camera",
                                     "Its rays are parallel: what is far is as large as "
                                     "what is near.",
                                     kOrthographicFields);
constexpr Kind kFisheye = kind_of<FisheyeEntry, put_fisheye>(
    "fisheye", "fisheye camera",
    "The angle to the view grows in proportion to the distance from the picture's middle.",
    kFisheyeFields);
constexpr Kind kPanorama = kind_of<CameraEntry, put_panorama>(
    "panorama", "panorama camera",
    "All round: columns are longitudes, rows latitudes; twice as wide as tall, it shows everything "
    "once without distortion.",
    kPanoramaFields);
constexpr const Kind* kCameraKinds[] = {&kPerspective, &kWindowKind, &kOrthographic, &kFisheye,
                                  &kPanorama};
constexpr Family kCameraFamily = {"camera", "perspective", kCameraKinds};

void read_camera(const toml::Node& node, Input& input) {
  read_item(node, kCameraFamily, input);
}

const Kind& kind_of_camera(CameraKind kind) {
  switch (kind) {
    case CameraKind::pinhole:
      break;
    case CameraKind::orthographic:
      return kOrthographic;
    case CameraKind::fisheye:
      return kFisheye;
    case CameraKind::panorama:
      return kPanorama;
  }
  return kWindowKind;
}

/// By their windows, which say what they are to the last digit.
void write_camera(Output& output) {
  const Camera& camera = output.scene.camera;
  const Kind& kind = kind_of_camera(camera.kind);
  CameraEntry entry;
  entry.eye = camera.eye;
  entry.window = Window{camera.window_center, camera.window_right, camera.window_up};
  entry.fov_deg = camera.fov_deg;
  entry.longitude_deg = camera.longitude_deg;
  entry.latitude_deg = camera.latitude_deg;
  entry.latitude_middle_deg = camera.latitude_middle_deg;
  entry.aperture = camera.aperture;
  if (camera.aperture > 0 || camera.focus_distance != Camera{}.focus_distance)
    entry.focus_distance = camera.focus_distance;
  write_table(fmt::format("[camera]\nkind = {}", in_quotes(kind.name)), true, kind.table,
              kind.table.name, &entry, output.text);
}

}  // namespace

constexpr Section section::camera = {.key = "camera",
                                     .text = "Where the picture is seen from.",
                                     .family = &kCameraFamily,
                                     .read = read_camera,
                                     .write = write_camera};

}  // namespace zraka::language
