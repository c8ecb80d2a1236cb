// SPDX-License-Identifier: Apache-2.0
// zraka for Python: scenes, pictures as NumPy arrays, explanations. The package around it is in
// zraka/.
#include <fmt/format.h>

#include <memory>
#include <optional>
#include <string>
#include <utility>

#include "explain/json.hpp"
#include "explain/sentence.hpp"
#include "explain/text.hpp"
#include "py_scene.hpp"
#include "renderer.hpp"
#include "rendering.hpp"
#include "scene/bulk.hpp"
#include "scene/view.hpp"

namespace zraka::python {
namespace {

Resolution resolution_of(const py::object& width, const py::object& height) {
  Resolution size;
  size.width = static_cast<std::uint32_t>(whole_of(width, "width", 1, 1 << 20));
  size.height = static_cast<std::uint32_t>(whole_of(height, "height", 1, 1 << 20));
  if (std::uint64_t{size.width} * size.height > kMaxPixels)
    throw py::value_error(fmt::format("width and height: {}×{} are more than {} pixels", size.width,
                                      size.height, kMaxPixels));
  return size;
}

std::uint32_t material_of(const PyScene& self, const py::object& material) {
  if (self.scene.materials.empty())
    throw py::value_error("material: the scene has none; make one by scene.material(color=…)");
  return static_cast<std::uint32_t>(
      whole_of(material, "material", 0, static_cast<long long>(self.scene.materials.size()) - 1));
}

/// Where nobody has made a material, the first one is grey.
void need_material(PyScene& self) {
  if (self.scene.materials.empty()) self.scene.materials.emplace_back();
}

/// One for each shape.
NumberArray<3> colors_of(const py::object& given, py::ssize_t count, py::array& kept) {
  if (given.is_none()) return {};
  kept = numbers_of(given, "colors", {count, 3});
  return items_of<3>(kept);
}

/// Radii: one for each shape, or one for all.
template <class Arrays>
void read_radii(const py::object& given, py::ssize_t count, py::array& kept, Arrays& arrays) {
  constexpr const char* kExpected = "a number greater than 0, or one for each shape";
  if (!py::hasattr(given, "__len__") ||
      (py::isinstance<py::array>(given) && py::reinterpret_borrow<py::array>(given).ndim() == 0)) {
    arrays.radius = number_of(given, "radii", kExpected, 0, true);
    return;
  }
  kept = numbers_of(given, "radii", {count});
  arrays.radii = items_of<1>(kept);
}

void add_spheres_of(PyScene& self, const py::object& centers, const py::object& radii,
                    const py::object& colors, const py::object& material) {
  need_material(self);
  const py::array points = numbers_of(centers, "centers", {-1, 3});
  py::array kept_radii, kept_colors;
  SphereArrays arrays;
  arrays.centers = items_of<3>(points);
  arrays.material = material_of(self, material);
  read_radii(radii, points.shape(0), kept_radii, arrays);
  arrays.colors = colors_of(colors, points.shape(0), kept_colors);
  if (const Result<void> good = check_spheres(self.scene, arrays); !good) raise(good.error());
  if (points.shape(0) >= kKeptFrom) return self.keep(arrays, points, kept_radii, kept_colors);
  if (const Result<void> added = add_checked_spheres(self.scene, arrays); !added)
    raise(added.error());
}

void add_cylinders_of(PyScene& self, const py::object& starts, const py::object& ends,
                      const py::object& radii, const py::object& colors,
                      const py::object& material) {
  need_material(self);
  const py::array from = numbers_of(starts, "starts", {-1, 3}),
                  to = numbers_of(ends, "ends", {from.shape(0), 3});
  py::array kept_radii, kept_colors;
  CylinderArrays arrays;
  arrays.starts = items_of<3>(from);
  arrays.ends = items_of<3>(to);
  arrays.material = material_of(self, material);
  read_radii(radii, from.shape(0), kept_radii, arrays);
  arrays.colors = colors_of(colors, from.shape(0), kept_colors);
  const Result<void> added = add_cylinders(self.scene, arrays);
  if (!added) raise(added.error());
}

void add_triangles_of(PyScene& self, const py::object& corners, const py::object& colors,
                      const py::object& material) {
  need_material(self);
  const py::array points = numbers_of(corners, "corners", {-1, 3, 3});
  py::array kept_colors;
  TriangleArrays arrays;
  NumberArray<3>* const places[] = {&arrays.a, &arrays.b, &arrays.c};
  for (int i = 0; i < 3; ++i) *places[i] = items_of<3>(points, i * points.strides(1));
  arrays.material = material_of(self, material);
  arrays.colors = colors_of(colors, points.shape(0), kept_colors);
  Result<void> added = add_triangles(self.scene, arrays);
  if (added) return;
  // a[i, k] is corners[i, 0, k].
  for (Diagnostic& problem : added.error())
    if (const std::size_t comma = problem.message.find(','); problem.message[1] == '[')
      problem.message = fmt::format("corners{}, {}{}", problem.message.substr(1, comma - 1),
                                    problem.message[0] - 'a', problem.message.substr(comma));
  raise(added.error());
}

int add_material(PyScene& self, const py::object& color, const py::object& ambient,
                 const py::object& specular, const py::object& shininess,
                 const py::object& reflection, const py::object& refraction,
                 const py::object& ior) {
  Material material;
  material.diffuse = color_of(color, "color");
  const Color& d = material.diffuse;
  material.ambient = ambient.is_none() ? d : color_of(ambient, "ambient");
  material.specular = color_of(specular, "specular");
  material.shininess = number_of(shininess, "shininess", "a number greater than 0", 0, true);
  material.reflection = color_of(reflection, "reflection");
  material.refraction = color_of(refraction, "refraction");
  material.ior = number_of(ior, "ior", "a number greater than 0", 0, true);
  self.scene.materials.push_back(std::move(material));
  return static_cast<int>(self.scene.materials.size()) - 1;
}

py::array render_scene(const PyScene& self, const Keywords& keywords) {
  const RenderOptions options = options_of(self.scene.defaults, keywords);
  const Picture picture = new_picture(self.scene.resolution, keywords, options.transparent);
  value_of(interruptible(options, keywords.progress, [&](const RenderOptions& wanted) {
    return self.with_whole(wanted.cancel, [&]<class SceneRef>(SceneRef&& scene) {
      return render_into(picture.buffer, std::forward<SceneRef>(scene), wanted);
    });
  }));
  return picture.array;
}

py::bytes png_of(const PyScene& self) {
  const RenderOptions options = zraka::options_of(self.scene.defaults);
  const Rendering rendering =
      value_of(interruptible(options, py::none(), [&](const RenderOptions& wanted) {
        return self.with_whole(wanted.cancel, [&]<class SceneRef>(SceneRef&& scene) {
          return render(std::forward<SceneRef>(scene), wanted);
        });
      }));
  return py::bytes(
      value_of(encode_png(rendering.image, {.transfer = options.profile.transfer, .threads = 0})));
}

/// Layers by the names of their channels, as arrays of height × width.
py::dict layers_of(const PyScene& self, const std::vector<std::string>& names) {
  RenderOptions options = zraka::options_of(self.scene.defaults);
  for (const std::string& name : names) {
    const std::optional<Layer> layer = layer_named(name);
    if (!layer)
      throw py::value_error(
          fmt::format("layers: '{}' is none of {}", name, fmt::join(kLayerNames, ", ")));
    options.layers.add(*layer);
  }
  const Rendering rendering =
      value_of(interruptible(options, py::none(), [&](const RenderOptions& wanted) {
        return self.with_whole(wanted.cancel, [&]<class SceneRef>(SceneRef&& scene) {
          return render(std::forward<SceneRef>(scene), wanted);
        });
      }));
  py::dict arrays;
  const std::vector<py::ssize_t> shape{rendering.layers.height, rendering.layers.width};
  for (const Channel& channel : rendering.layers.channels) {
    if (const std::vector<float>* floats = channel.floats())
      arrays[py::str(channel.name)] = py::array_t<float>(shape, floats->data());
    else
      arrays[py::str(channel.name)] = py::array_t<std::uint32_t>(shape, channel.ids()->data());
  }
  return arrays;
}

struct PyExplanation {
  std::string text, json;
};

PyExplanation explain_pixel(const PyScene& self, const py::object& x, const py::object& y) {
  const auto in_range = [](const py::object& given, const char* name, std::uint32_t size) {
    return static_cast<std::uint32_t>(whole_of(given, name, 0, std::int64_t{size} - 1));
  };
  const Resolution& size = self.scene.resolution;
  const std::uint32_t column = in_range(x, "x", size.width), row = in_range(y, "y", size.height);
  const Explanation explanation = value_of(
      interruptible(zraka::options_of(self.scene.defaults), py::none(), [&](const auto& wanted) {
        return self.with_whole(
            wanted.cancel, [&](const Scene& scene) { return explain(scene, wanted, column, row); });
      }));
  const ProfileName profile = self.scene.defaults.profile;
  TextOptions options;
  options.scene = "scene";
  options.profile = profile;
  return {to_text(explanation, options),
          to_json(explanation, "scene", std::string(name_of(profile)),
                  in_words(Language::english, explanation))};
}

std::string hash_of(const py::object& given) {
  const py::array array = numbers_of(given, "image", {-1, -1, 3});
  const py::array_t<float, py::array::c_style | py::array::forcecast> pixels(array);
  Image image(static_cast<std::uint32_t>(pixels.shape(1)),
              static_cast<std::uint32_t>(pixels.shape(0)));
  std::copy_n(pixels.data(), image.pixels.size(), image.pixels.data());
  return sha256(image);
}

PyScene read(const std::string& path) {
  Result<ReadScene> scene = [&] {
    const py::gil_scoped_release release;
    return read_scene(path);
  }();
  return {.scene = value_of(std::move(scene)).scene};
}

void add_scene(py::module_& module) {
  const py::object none = py::none();
  py::class_<PyScene>(module, "Scene",
                      "What a picture is of. Points are (x, y, z), right-handed with y up, in any "
                      "unit; colours are linear red, green and blue, 1 the brightest.")
      .def(py::init([](const py::object& width, const py::object& height,
                       const py::object& background, const py::object& ambient_light) {
             auto scene = std::make_unique<PyScene>();
             scene->scene.resolution = resolution_of(width, height);
             scene->scene.background = color_of(background, "background");
             scene->scene.ambient_light = color_of(ambient_light, "ambient_light");
             scene->scene.camera =
                 value_of(view_at({0, 0, 5}, {0, 0, 0}, scene->scene.resolution)).camera;
             return scene;
           }),
           py::arg("width") = 400, py::arg("height") = 400, py::kw_only(),
           py::arg("background") = 0, py::arg("ambient_light") = 0.2,
           "A scene without shapes, seen from (0, 0, 5) in a picture of width × height pixels.")
      .def(
          "camera",
          [](PyScene& self, const py::object& eye, const py::object& target, const py::object& fov,
             const py::object& up) {
            self.scene.camera = view_of(eye, target, fov, up, self.scene.resolution).camera;
          },
          py::arg("eye"), py::arg("target") = py::make_tuple(0, 0, 0), py::kw_only(),
          py::arg("fov") = 40, py::arg("up") = py::make_tuple(0, 1, 0),
          "Looks from eye to target; fov is in degrees, over the picture's height.")
      .def(
          "light",
          [](PyScene& self, const py::object& position, const py::object& color) {
            Light light;
            light.position = vector_of(position, "position");
            light.color = color_of(color, "color");
            self.scene.lights.push_back(light);
          },
          py::arg("position"), py::arg("color") = 1, "Adds a point light.")
      .def("material", &add_material, py::kw_only(), py::arg("color") = 0.7,
           py::arg("ambient") = none, py::arg("specular") = 0, py::arg("shininess") = 10,
           py::arg("reflection") = 0, py::arg("refraction") = 0, py::arg("ior") = 1,
           "Makes a material (Phong's, with shares of the reflected and refracted ray) and returns "
           "its number, for the material= of shapes. Without ambient it is the color, too.")
      .def(
          "sphere",
          [](PyScene& self, const py::object& center, const py::object& radius,
             const py::object& material) {
            need_material(self);
            const Vec3 at = vector_of(center, "center");
            const double r = number_of(radius, "radius", "a number greater than 0", 0, true);
            self.scene.spheres.push_back({{at, r}, material_of(self, material)});
          },
          py::arg("center"), py::arg("radius") = 1, py::kw_only(), py::arg("material") = 0,
          "Adds a sphere.")
      .def("spheres", &add_spheres_of, py::arg("centers"), py::arg("radii") = 1, py::kw_only(),
           py::arg("colors") = none, py::arg("material") = 0,
           "Adds n spheres: centers of shape (n, 3); radii of shape (n,), or one for all; colors "
           "of shape (n, 3), by which the material's ambient and diffuse colour are multiplied. "
           "float32 and float64 are read where they are, whatever their strides. Arrays of "
           "100 000 spheres or more are not copied but kept, and must not be changed afterwards.")
      .def("cylinders", &add_cylinders_of, py::arg("starts"), py::arg("ends"), py::arg("radii") = 1,
           py::kw_only(), py::arg("colors") = none, py::arg("material") = 0,
           "Adds n cylinders without caps: starts and ends of shape (n, 3); radii and colors as "
           "for spheres().")
      .def("triangles", &add_triangles_of, py::arg("corners"), py::kw_only(),
           py::arg("colors") = none, py::arg("material") = 0,
           "Adds n triangles, seen from both sides: corners of shape (n, 3, 3), which is "
           "vertices[faces] of a mesh; colors as for spheres().")
      .def(
          "render",
          [](const PyScene& self, const py::object& samples, const py::object& depth,
             const py::object& threads, const py::object& transparent, const py::object& outlines,
             const py::object& progress, const py::object& dtype) {
            return render_scene(self,
                                {samples, depth, threads, transparent, outlines, progress, dtype});
          },
          py::kw_only(), py::arg("samples") = none, py::arg("depth") = none,
          py::arg("threads") = none, py::arg("transparent") = false, py::arg("outlines") = 0,
          py::arg("progress") = none, py::arg("dtype") = "float32",
          "The picture as an array of shape (height, width, 3): linear light as float32, or sRGB "
          "as "
          "uint8. With transparent=True there is a fourth channel, alpha, by which the colours are "
          "multiplied. samples is the number of rays a pixel, depth of reflections in a row, "
          "outlines the width in pixels of black lines where another shape begins; "
          "progress(done, pixels) is called now and then. Ctrl-C ends it.")
      .def("layers", &layers_of, py::arg("names"),
           "What else is known of pixels, by channel: for names among depth, position, normal, uv, "
           "object-id, material-id, rays, tree-depth and cryptomatte.")
      .def("explain", &explain_pixel, py::arg("x"), py::arg("y"),
           "Why the pixel in column x, row y from the upper left has its colour.")
      .def("_repr_png_", &png_of)
      .def(
          "to_toml",
          [](const PyScene& self) {
            return value_of(
                self.with_whole(nullptr, [](const Scene& scene) { return write_toml(scene); }));
          },
          "The scene in the scene language, which load() and loads() read.")
      .def_property(
          "resolution",
          [](const PyScene& self) {
            return py::make_tuple(self.scene.resolution.width, self.scene.resolution.height);
          },
          [](PyScene& self, const py::object& size) {
            if (!py::isinstance<py::sequence>(size) || py::len(size) != 2)
              throw py::value_error("resolution: expected (width, height)");
            const auto pair = size.cast<py::sequence>();
            self.scene.resolution = resolution_of(pair[0], pair[1]);
          },
          "(width, height) in pixels.")
      .def("__len__", [](const PyScene& self) { return self.shape_count(); })
      .def("__repr__", [](const PyScene& self) {
        return fmt::format("<zraka.Scene: {} shapes, {} lights, {}×{} pixels>", self.shape_count(),
                           self.scene.lights.size(), self.scene.resolution.width,
                           self.scene.resolution.height);
      });
}

}  // namespace

PYBIND11_MODULE(_zraka, module) {
  module.doc() =
      "A Whitted ray tracer: exact to the bit, and able to say why each pixel has its colour.";
  module.attr("__version__") = ZRAKA_VERSION;
  add_scene(module);
  add_renderer(module);
  py::class_<PyExplanation>(module, "Explanation",
                            "Why a pixel has its colour: str() is the tree of its rays as text.")
      .def("__str__", [](const PyExplanation& self) { return self.text; })
      .def("__repr__", [](const PyExplanation& self) { return self.text; })
      .def_property_readonly(
          "data",
          [](const PyExplanation& self) {
            return py::module_::import("json").attr("loads")(self.json);
          },
          "The same as dicts and lists (docs/explain.md).");
  module.def("load", &read, py::arg("path"),
             "Reads a scene file of any format that zraka knows; a ValueError names all its "
             "problems with line and column.");
  module.def(
      "loads",
      [](const std::string& text) {
        return PyScene{.scene = value_of(parse_scene(text, "scene")).scene};
      },
      py::arg("text"), "Reads a scene from a string.");
  module.def("sha256", &hash_of, py::arg("image"),
             "The hash of a picture's float32 bits that zraka render --hash prints.");
  module.def(
      "write_image",
      [](const py::object& given, const std::string& path) {
        const py::array array = numbers_of(given, "image", {-1, -1, 3});
        const py::array_t<float, py::array::c_style | py::array::forcecast> pixels(array);
        Image image(static_cast<std::uint32_t>(pixels.shape(1)),
                    static_cast<std::uint32_t>(pixels.shape(0)));
        std::copy_n(pixels.data(), image.pixels.size(), image.pixels.data());
        const Result<void> written = write_image(image, {}, path, {});
        if (!written) raise(written.error());
      },
      py::arg("image"), py::arg("path"),
      "Writes linear light of shape (height, width, 3) to a file: .png, .exr, .hdr, .jpg and "
      "more.");
}

}  // namespace zraka::python
