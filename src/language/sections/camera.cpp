// SPDX-License-Identifier: Apache-2.0
// [camera]: where the picture is seen from.
#include "language/sections.hpp"
#include "scene/view.hpp"

namespace zraka::language {
namespace {

struct Perspective {
  Vec3 eye{0, 0, 5}, look_at, up{0, 1, 0};
  double fov_deg = 40;
};

void put(Perspective& p, Item& item) {
  Scene& scene = item.input.scene;
  const double aspect = static_cast<double>(scene.resolution.width) / scene.resolution.height;
  const std::optional<Camera> camera = look_at(p.eye, p.look_at, p.up, p.fov_deg, aspect);
  if (camera && spans_a_plane(camera->window_right, camera->window_up))
    scene.camera = *camera;
  else if (camera)
    item.complain("fov_deg", "the angle of view is too small to be told from 0");
  else if (p.eye == p.look_at)
    item.complain("look_at", "the camera's eye is at the point that it looks at");
  else
    item.complain("up", "up of perspective camera is the direction of view",
                  "expected a direction that is not the one from eye to look_at");
}

constexpr Field kPerspectiveFields[] = {
    field<&Perspective::eye>("eye", {.text = "where the rays start", .unit = Unit::point}),
    field<&Perspective::look_at>(
        "look_at", {.text = "the point in the middle of the picture", .unit = Unit::point}),
    field<&Perspective::up>(
        "up", {.text = "which direction is up in the picture", .unit = Unit::direction}),
    field<&Perspective::fov_deg>("fov_deg", {.text = "the angle of view over the picture's height",
                                             .unit = Unit::degrees,
                                             .range = between(0, 180)}),
    not_built("aperture", "the lens' diameter"),
    not_built("focus", "a point in focus"),
    not_built("focus_distance", "how far from the eye all is in focus"),
};

struct Window {
  Vec3 center, right{2, 0, 0}, up{0, 2, 0};
};
struct WindowCamera {
  Vec3 eye{0, 0, 2};
  Window window;
};

void put(WindowCamera& w, Item& item) {
  const Camera camera{w.eye, w.window.center, w.window.right, w.window.up};
  if (spans_a_plane(camera.window_right, camera.window_up))
    item.input.scene.camera = camera;
  else
    item.complain("window", "right and up of the camera's window span no plane");
}

constexpr Field kWindowFields[] = {
    field<&Window::center>("center", {.text = "its middle", .unit = Unit::point, .required = true}),
    field<&Window::right>("right", {.text = "from its left edge to its right edge",
                                    .unit = Unit::direction,
                                    .required = true}),
    field<&Window::up>("up", {.text = "from its lower edge to its upper edge",
                              .unit = Unit::direction,
                              .required = true}),
};
constexpr Table kWindow =
    table_of<Window>("window", "A rectangle in space that the picture fills.", kWindowFields);
constexpr Field kWindowCameraFields[] = {
    field<&WindowCamera::eye>("eye", {.text = "where the rays start", .unit = Unit::point}),
    table_field<&WindowCamera::window>(
        "window", kWindow,
        {.text = "the rectangle that the rays go through, as in the lab", .required = true}),
};

constexpr Kind kPerspective = kind_of<Perspective, put>(
    "perspective", "perspective camera", "A pinhole that looks at a point.", kPerspectiveFields);
constexpr Kind kWindowKind = kind_of<WindowCamera, put>(
    "window", "window camera", "A pinhole that looks through a window, as in the lab.",
    kWindowCameraFields);
constexpr const Kind* kKinds[] = {&kPerspective, &kWindowKind};
constexpr std::string_view kNotBuilt[] = {"orthographic", "fisheye", "panorama"};
constexpr Family kFamily = {"camera", "perspective", kKinds, kNotBuilt};

void read(const toml::Node& node, Input& input) {
  read_item(node, kFamily, input);
}

void write(Output& output) {
  const Camera& camera = output.scene.camera;
  const WindowCamera entry{camera.eye,
                           {camera.window_center, camera.window_right, camera.window_up}};
  write_table("[camera]\nkind = \"window\"", true, kWindowKind.table, kWindowKind.table.name,
              &entry, output.text);
}

}  // namespace

constexpr Section section::camera = {.key = "camera",
                                     .text = "Where the picture is seen from.",
                                     .family = &kFamily,
                                     .read = read,
                                     .write = write};

}  // namespace zraka::language
