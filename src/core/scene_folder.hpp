// SPDX-License-Identifier: Apache-2.0
// Where the files are that a scene names: a scene of somebody else's must not read what it likes.
#pragma once

#include <string>
#include <zraka/diagnostic.hpp>

namespace zraka {

struct SceneFolder {
  std::string folder{};        ///< the scene file's; "" is the current one
  bool allow_outside = false;  ///< names may lead out of it

  /// The path of a file that the scene names, from the folder on if the name is a relative one. By
  /// where links lead, it lies in the folder or in one inside; else this fails.
  Result<std::string> path_of(const std::string& name) const;
};

}  // namespace zraka
