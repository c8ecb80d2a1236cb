// SPDX-License-Identifier: Apache-2.0
#include "rendering.hpp"

#include "scene/view.hpp"

namespace zraka::python {

View view_of(const py::object& eye, const py::object& target, const py::object& fov,
             const py::object& up, const Resolution& size) {
  return value_of(
      view_at(vector_of(eye, "eye"), vector_of(target, "target"), size,
              number_of(fov, "fov", "degrees of more than 0 and less than 180", 0, true),
              vector_of(up, "up")));
}

RenderOptions options_of(const RenderDefaults& defaults, const Keywords& keywords) {
  RenderOptions options = zraka::options_of(defaults);
  if (!keywords.samples.is_none()) {
    options.sampling.kind = Sampling::Kind::sobol;
    options.sampling.count =
        static_cast<int>(whole_of(keywords.samples, "samples", 1, kMaxSamples));
  }
  if (!keywords.depth.is_none())
    options.max_depth = static_cast<int>(whole_of(keywords.depth, "depth", 0, kMaxDepth));
  if (!keywords.threads.is_none())
    options.threads = static_cast<int>(whole_of(keywords.threads, "threads", 0, kMaxThreads));
  if (!py::isinstance<py::bool_>(keywords.transparent))
    throw py::value_error("transparent: expected True or False");
  options.transparent = keywords.transparent.cast<bool>();
  options.outlines = static_cast<int>(whole_of(keywords.outlines, "outlines", 0, kMaxOutlines));
  if (!keywords.progress.is_none() && PyCallable_Check(keywords.progress.ptr()) == 0)
    throw py::value_error("progress: expected a function of two numbers: pixels done, and in all");
  return options;
}

Picture new_picture(const Resolution& size, const Keywords& keywords, bool transparent) {
  bool bytes = false;
  try {
    const py::dtype type = py::dtype::from_args(keywords.dtype);
    bytes = type.is(py::dtype::of<std::uint8_t>());
    if (!bytes && !type.is(py::dtype::of<float>())) throw py::value_error();
  } catch (const std::exception&) {
    PyErr_Clear();
    throw py::value_error("dtype: expected \"float32\" or \"uint8\"");
  }
  Picture picture;
  picture.buffer.channels = transparent ? 4 : 3;
  picture.buffer.type = bytes ? PixelBuffer::Type::uint8 : PixelBuffer::Type::float32;
  const std::vector<py::ssize_t> shape{size.height, size.width, picture.buffer.channels};
  if (bytes)
    picture.array = py::array_t<std::uint8_t>(shape);
  else
    picture.array = py::array_t<float>(shape);
  picture.buffer.data = picture.array.mutable_data();
  return picture;
}

}  // namespace zraka::python
