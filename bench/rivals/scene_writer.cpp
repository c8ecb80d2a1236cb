// SPDX-License-Identifier: Apache-2.0
#include "scene_writer.hpp"

#include <algorithm>
#include <cstdlib>

namespace zraka::rivals {
namespace {

int fail(const Diagnostics& problems) {
  for (const Diagnostic& problem : problems) fmt::print(stderr, "{}", to_string(problem));
  return 1;
}

}  // namespace

int translate_file(int argc, char** argv, std::string (*translate)(const Scene& scene)) {
  const int width = argc == 4 ? std::atoi(argv[3]) : 0;
  if (argc < 3 || argc > 4 || width < 0) {
    fmt::print(stderr, "usage: {} SCENE OUTPUT [WIDTH]\n", argv[0]);
    return 2;
  }
  Result<ReadScene> read = read_scene(argv[1]);
  if (!read) return fail(read.error());
  if (width > 0) {
    Resolution& r = read->scene.resolution;
    const auto columns = static_cast<std::uint32_t>(width);
    r = {columns, std::max(1u, columns * r.height / r.width)};
  }
  const Result<void> written = write_text_file(argv[2], translate(read->scene));
  return written ? 0 : fail(written.error());
}

}  // namespace zraka::rivals
