// SPDX-License-Identifier: Apache-2.0
// From Python's objects to what the library takes, with errors that name the argument.
#pragma once

#include <pybind11/numpy.h>
#include <pybind11/pybind11.h>
#include <pybind11/stl.h>

#include <string>
#include <string_view>
#include <vector>
#include <zraka/zraka.hpp>

namespace zraka::python {

namespace py = pybind11;

/// Raises a ValueError with all that is wrong.
[[noreturn]] void raise(const Diagnostics& problems);

/// The value, or a ValueError.
template <class T>
T value_of(Result<T>&& result) {
  if (!result) raise(result.error());
  return std::move(*result);
}

/// A float64 or float32 array as it is, whatever its strides; other numbers as float64. `shape` is
/// of as many dimensions, -1 stands for any number, which expected() calls n.
py::array numbers_of(const py::object& given, std::string_view name,
                     const std::vector<py::ssize_t>& shape);

/// Three finite numbers.
Vec3 vector_of(const py::object& given, std::string_view name);
/// Three finite numbers of 0 or more; or one, for all three.
Color color_of(const py::object& given, std::string_view name);
double number_of(const py::object& given, std::string_view name, std::string_view expected,
                 double least, bool more);
/// A whole number in a range.
long long whole_of(const py::object& given, std::string_view name, long long least, long long most);

/// Items of an array of two dimensions, or of one for N = 1; the array has to outlive them.
template <int N>
NumberArray<N> items_of(const py::array& array, py::ssize_t offset = 0) {
  const auto* data = static_cast<const char*>(array.data()) + offset;
  NumberArray<N> numbers;
  numbers.data = data;
  numbers.count = static_cast<std::size_t>(array.shape(0));
  numbers.is_double = array.itemsize() == 8;
  numbers.stride = array.strides(0);
  numbers.step = N == 1 ? 0 : array.strides(array.ndim() - 1);
  return numbers;
}

}  // namespace zraka::python
