// SPDX-License-Identifier: Apache-2.0
#include "arguments.hpp"

#include <fmt/format.h>

#include <cmath>
#include <limits>

namespace zraka::python {
namespace {

std::string shape_text(const py::array& array) {
  std::string text = "(";
  for (py::ssize_t i = 0; i < array.ndim(); ++i)
    text += fmt::format("{}{}", i > 0 ? ", " : "", array.shape(i));
  return text + (array.ndim() == 1 ? ",)" : ")");
}

std::string expected_shape(const std::vector<py::ssize_t>& shape) {
  std::string text = "(";
  for (std::size_t i = 0; i < shape.size(); ++i)
    text += (i > 0 ? ", " : "") + (shape[i] < 0 ? "n" : std::to_string(shape[i]));
  return text + (shape.size() == 1 ? ",)" : ")");
}

/// What came, in short.
std::string words_of(const py::object& given) {
  const std::string type = py::str(py::type::of(given).attr("__name__"));
  std::string text;
  try {
    text = py::repr(given);
  } catch (const py::error_already_set&) {
    return type;
  }
  return text.size() > 60 ? type : text;
}

[[noreturn]] void refuse(std::string_view name, std::string_view expected, const std::string& got) {
  throw py::value_error(fmt::format("{}: expected {}, got {}", name, expected, got));
}

/// As an array of NumPy's, whatever it holds.
py::array array_of(const py::object& given, std::string_view name, const std::string& expected) {
  try {
    return py::array::ensure(given) ? py::array(py::array::ensure(given)) : throw py::value_error();
  } catch (const std::exception&) {
    PyErr_Clear();
    refuse(name, expected, words_of(given));
  }
}

/// A Python number as a double; none for what is no number.
bool read(const py::object& given, double& value) {
  if (py::isinstance<py::bool_>(given) || py::isinstance<py::str>(given)) return false;
  value = PyFloat_AsDouble(given.ptr());
  if (PyErr_Occurred() == nullptr) return true;
  PyErr_Clear();
  return false;
}

}  // namespace

void raise(const Diagnostics& problems) {
  std::string text;
  for (const Diagnostic& problem : problems) {
    if (!text.empty()) text += '\n';
    if (!problem.file.empty()) {
      text += to_string(problem);
      while (!text.empty() && text.back() == '\n') text.pop_back();
      continue;
    }
    text += problem.message;
    if (!problem.hint.empty()) text += " (" + problem.hint + ")";
  }
  throw py::value_error(text);
}

py::array numbers_of(const py::object& given, std::string_view name,
                     const std::vector<py::ssize_t>& shape) {
  const std::string expected = fmt::format("numbers of shape {}", expected_shape(shape));
  py::array array = array_of(given, name, expected);
  const char kind = array.dtype().kind();
  const auto got = [&] {
    if (array.ndim() == 0 && !py::isinstance<py::array>(given)) return words_of(given);
    return fmt::format("shape {} of {}", shape_text(array), std::string(py::str(array.dtype())));
  };
  if (kind != 'f' && kind != 'i' && kind != 'u') refuse(name, expected, got());
  bool fits = array.ndim() == static_cast<py::ssize_t>(shape.size());
  for (std::size_t i = 0; fits && i < shape.size(); ++i)
    fits = shape[i] < 0 || array.shape(static_cast<py::ssize_t>(i)) == shape[i];
  if (!fits) refuse(name, expected, got());
  const char order = array.dtype().byteorder();
  if (kind == 'f' && (array.itemsize() == 4 || array.itemsize() == 8) && order != '>') return array;
  return py::array_t<double, py::array::forcecast>(array);
}

Vec3 vector_of(const py::object& given, std::string_view name) {
  const py::array array = numbers_of(given, name, {3});
  const py::array_t<double, py::array::forcecast> numbers(array);
  const Vec3 vector{numbers.at(0), numbers.at(1), numbers.at(2)};
  if (!(std::isfinite(vector.x) && std::isfinite(vector.y) && std::isfinite(vector.z)))
    refuse(name, "three finite numbers", words_of(given));
  return vector;
}

Color color_of(const py::object& given, std::string_view name) {
  constexpr std::string_view kExpected = "three finite numbers of 0 or more, or one for all";
  Color color;
  if (double grey = 0; read(given, grey) && !py::hasattr(given, "__len__")) {
    color = {grey, grey, grey};
  } else {
    const py::array array = array_of(given, name, std::string(kExpected));
    if (array.ndim() != 1 || array.shape(0) != 3) refuse(name, kExpected, words_of(given));
    const Vec3 v = vector_of(given, name);
    color = {v.x, v.y, v.z};
  }
  for (const double c : {color.r, color.g, color.b})
    if (!(c >= 0 && std::isfinite(c))) refuse(name, kExpected, words_of(given));
  return color;
}

double number_of(const py::object& given, std::string_view name, std::string_view expected,
                 double least, bool more) {
  double value = 0;
  if (!read(given, value) || !std::isfinite(value) || value < least || (more && value == least))
    refuse(name, expected, words_of(given));
  return value;
}

long long whole_of(const py::object& given, std::string_view name, long long least,
                   long long most) {
  long long value = 0;
  bool whole = py::hasattr(given, "__index__") && !py::isinstance<py::bool_>(given);
  if (whole) {
    const py::object index = py::reinterpret_steal<py::object>(PyNumber_Index(given.ptr()));
    value = index ? PyLong_AsLongLong(index.ptr()) : 0;
    whole = PyErr_Occurred() == nullptr;
    PyErr_Clear();
  }
  if (!whole || value < least || value > most)
    refuse(name, fmt::format("a whole number from {} to {}", least, most), words_of(given));
  return value;
}

}  // namespace zraka::python
