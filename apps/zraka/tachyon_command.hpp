// SPDX-License-Identifier: Apache-2.0
// The program as one that is called like Tachyon.
#pragma once

namespace zraka::app {

/// Whether the program goes by the name of zraka-tachyon.
bool is_called_tachyon(const char* program);

/// What it then does; the exit code.
int run_tachyon(int argc, char** argv);

}  // namespace zraka::app
