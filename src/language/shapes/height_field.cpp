// SPDX-License-Identifier: Apache-2.0
// A landscape: a picture whose brightness is the height.
#include <fmt/format.h>

#include "language/files.hpp"
#include "language/meshes.hpp"

namespace zraka::language {
namespace {

/// Each is two triangles.
constexpr std::uint64_t kMostPixels = std::uint64_t{1} << 22;

struct HeightField {
  std::string file;
  Vec3 size{1, 1, 1};
  bool smooth = false;
};

constexpr Field kHeightFieldFields[] = {
    field<&HeightField::file>("file", {.text = "the picture, of 2 × 2 pixels or more; its numbers "
                                               "are heights, no curve undone",
                                       .unit = Unit::picture,
                                       .required = true}),
    field<&HeightField::size>(
        "size", {.text = "how far it reaches from the origin: x to the picture's right edge, y to "
                         "the height of white, z to the lower edge",
                 .unit = Unit::length,
                 .range = greater_than(0),
                 .required = true}),
    field<&HeightField::smooth>("smooth", {.text = "whether normals are blended between corners"}),
};

/// A point above each pixel's centre, those of the edges on the edges of the field.
Mesh mesh_of(const Image& image, const Vec3& size) {
  Mesh mesh;
  const double right = image.width - 1, down = image.height - 1;
  for (std::uint32_t row = 0; row < image.height; ++row)
    for (std::uint32_t column = 0; column < image.width; ++column) {
      const float* const rgb = image.row(row) + std::size_t{3} * column;
      const double height = (static_cast<double>(rgb[0]) + static_cast<double>(rgb[1]) +
                             static_cast<double>(rgb[2])) /
                            3;
      const double u = column / right, v = 1 - row / down;
      mesh.points.push_back({u * size.x, height * size.y, row / down * size.z});
      mesh.uvs.push_back({static_cast<float>(u), static_cast<float>(v)});
    }
  const auto corner = [&](std::uint32_t column, std::uint32_t row) {
    const std::uint32_t index = row * image.width + column;
    return Mesh::Corner{index, Mesh::kNone, index};
  };
  for (std::uint32_t row = 0; row + 1 < image.height; ++row)
    for (std::uint32_t column = 0; column + 1 < image.width; ++column) {
      const Mesh::Corner lower = corner(column, row + 1), upper_right = corner(column + 1, row);
      mesh.triangles.push_back({corner(column, row), lower, upper_right});
      mesh.triangles.push_back({upper_right, lower, corner(column + 1, row + 1)});
    }
  return mesh;
}

void put(HeightField& field, Item& item) {
  const toml::Node& file = *item.node.find("file");
  const std::optional<std::string> path = path_of(file, "height_field", item.input);
  if (!path) return;
  const Result<ReadImage> read = read_image(*path, kMostPixels);
  if (!read) return tell(read.error(), file, "height_field", item.input);
  const Image& image = read->image;
  if (image.width < 2 || image.height < 2)
    return item.complain("file", fmt::format("file of height_field is a picture of {}×{} pixels: "
                                             "expected 2×2 or more",
                                             image.width, image.height));
  Mesh mesh = mesh_of(image, field.size);
  if (field.smooth) mesh.add_normals();
  if (const auto group = add_group(mesh, field.smooth, item)) add_instance(*group, item);
}

}  // namespace

constexpr Kind shape::height_field = kind_of<HeightField, put>(
    "height_field", "height_field",
    "A landscape whose heights are a picture's brightness, seen from both sides. The picture's "
    "upper left corner is at the origin.",
    kHeightFieldFields);

}  // namespace zraka::language
