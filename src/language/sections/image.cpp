// SPDX-License-Identifier: Apache-2.0
// [image]: how large the picture is.
#include <fmt/format.h>

#include "language/sections.hpp"

namespace zraka::language {
namespace {

constexpr Range kPixels = from_to(1, static_cast<double>(kMaxPixels));
constexpr Field kFields[] = {
    field<&Resolution::width>("width",
                              {.text = "pixels in a row", .unit = Unit::pixels, .range = kPixels}),
    field<&Resolution::height>("height",
                               {.text = "rows of pixels", .unit = Unit::pixels, .range = kPixels}),
};
constexpr Table kTable = table_of<Resolution>("image", "The size of the picture.", kFields);

void read(const toml::Node& node, Input& input) {
  Resolution size;
  read_fields(node, kTable, "image", &size, input);
  if (std::uint64_t{size.width} * size.height > kMaxPixels) {
    input.problems.error(node.begin, fmt::format("an image of {}×{} pixels is too large: expected "
                                                 "{} pixels at most",
                                                 size.width, size.height, kMaxPixels));
    return;
  }
  input.scene.resolution = size;
}

void write(Output& output) {
  write_table("[image]", true, kTable, "image", &output.scene.resolution, output.text);
}

}  // namespace

constexpr Section section::image = {
    .key = "image", .text = kTable.text, .table = &kTable, .read = read, .write = write};

}  // namespace zraka::language
