// SPDX-License-Identifier: Apache-2.0
// [image]: how large the picture is.
#include <fmt/format.h>

#include "language/sections.hpp"

namespace zraka::language {
namespace {

constexpr Range kPixels = from_to(1, static_cast<double>(kMaxPixels));
constexpr Field kImageFields[] = {
    field<&Resolution::width>("width",
                              {.text = "pixels in a row", .unit = Unit::pixels, .range = kPixels}),
    field<&Resolution::height>("height",
                               {.text = "rows of pixels", .unit = Unit::pixels, .range = kPixels}),
};
constexpr Table kImageTable = table_of<Resolution>("image", "The size of the picture.", kImageFields);

void read_image(const toml::Node& node, Input& input) {
  Resolution size;
  read_fields(node, kImageTable, "image", &size, input);
  if (std::uint64_t{size.width} * size.height > kMaxPixels) {
    input.problems.error(node.begin, fmt::format("an image of {}×{} pixels is too large: expected "
                                                 "{} pixels at most",
                                                 size.width, size.height, kMaxPixels));
    return;
  }
  input.scene.resolution = size;
}

void write_image(Output& output) {
  write_table("[image]", true, kImageTable, "image", &output.scene.resolution, output.text);
}

}  // namespace

constexpr Section section::image = {
    .key = "image", .text = kImageTable.text, .table = &kImageTable, .read = read_image, .write = write_image};

}  // namespace zraka::language
