// SPDX-License-Identifier: Apache-2.0
// What commands that read a scene share: which files that may name.
#pragma once

#include "command.hpp"
#include "zraka/formats.hpp"

namespace zraka::app {

inline void add_allow_outside_to(Command& command, ReadOptions& options) {
  command.add("--allow-outside", &options.allow_outside,
              "let the scene name pictures and meshes outside of its folder");
}

}  // namespace zraka::app
