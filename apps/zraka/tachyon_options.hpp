// SPDX-License-Identifier: Apache-2.0
// Tachyon's command line, as programs that call it write it.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "formats/tachyon.hpp"

namespace zraka::app {

struct TachyonArguments {
  std::string scene, output = "outfile.tga";
  std::string format = "TARGA";
  TachyonSettings settings;
  std::optional<int> depth{}, samples{};
  std::uint32_t width = 0, height = 0;  ///< 0: the scene's
  int threads = 0;
  double gamma = 0;  ///< 0: none
  bool normalize = false, save = true, verbose = false;
  bool help = false, version = false;
  std::vector<std::string> ignored;  ///< options that are understood and make no difference here

  /// What is wrong with the arguments after the program's name, or "".
  std::string read(const std::vector<std::string>& arguments);
};

/// For --help.
extern const char* const kTachyonHelp;

}  // namespace zraka::app
