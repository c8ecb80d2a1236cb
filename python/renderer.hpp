// SPDX-License-Identifier: Apache-2.0
// zraka.Renderer.
#pragma once

#include "arguments.hpp"

namespace zraka::python {

void add_renderer(py::module_& module);

}  // namespace zraka::python
