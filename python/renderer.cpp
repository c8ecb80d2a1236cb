// SPDX-License-Identifier: Apache-2.0
#include "renderer.hpp"

#include <memory>
#include <utility>

#include "py_scene.hpp"
#include "rendering.hpp"

namespace zraka::python {
namespace {

/// Many pictures of one scene.
struct PyRenderer {
  Renderer renderer;
  RenderDefaults defaults;
};

}  // namespace

void add_renderer(py::module_& module) {
  const py::object none = py::none();
  py::class_<PyRenderer>(module, "Renderer",
                         "A scene that is ready for many pictures: another view costs no build. "
                         "It keeps a copy of the scene as it is now.")
      .def(py::init([](const PyScene& scene) {
             const RenderOptions options = zraka::options_of(scene.scene.defaults);
             Renderer made =
                 value_of(interruptible(options, py::none(), [&](const RenderOptions& wanted) {
                   return scene.with_whole(wanted.cancel, [&]<class SceneRef>(SceneRef&& whole) {
                     return Renderer::create(std::forward<SceneRef>(whole), wanted);
                   });
                 }));
             return std::make_unique<PyRenderer>(PyRenderer{std::move(made), scene.scene.defaults});
           }),
           py::arg("scene"))
      .def(
          "render",
          [](const PyRenderer& self, const py::object& eye, const py::object& target,
             const py::object& fov, const py::object& up, const py::object& samples,
             const py::object& depth, const py::object& threads, const py::object& transparent,
             const py::object& outlines, const py::object& progress, const py::object& dtype) {
            const Keywords keywords{samples,  depth,    threads, transparent,
                                    outlines, progress, dtype};
            const RenderOptions options = options_of(self.defaults, keywords);
            View view = self.renderer.view();
            if (!eye.is_none()) view = view_of(eye, target, fov, up, view.resolution);
            const Picture picture = new_picture(view.resolution, keywords, options.transparent);
            value_of(interruptible(options, progress, [&](const RenderOptions& wanted) {
              return self.renderer.render_into(picture.buffer, view, wanted);
            }));
            return picture.array;
          },
          py::arg("eye") = none, py::arg("target") = py::make_tuple(0, 0, 0), py::kw_only(),
          py::arg("fov") = 40, py::arg("up") = py::make_tuple(0, 1, 0), py::arg("samples") = none,
          py::arg("depth") = none, py::arg("threads") = none, py::arg("transparent") = false,
          py::arg("outlines") = 0, py::arg("progress") = none, py::arg("dtype") = "float32",
          "The picture from eye, or as the scene is seen, as Scene.render() returns it.");
}

}  // namespace zraka::python
