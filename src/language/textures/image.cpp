// SPDX-License-Identifier: Apache-2.0
// A picture on a surface.
#include "language/files.hpp"
#include "language/textures.hpp"

namespace zraka::language {
namespace {

constexpr Choice kFilters[] = {
    {"nearest", "the nearest pixel"},
    {"bilinear", "between the four pixels around"},
    {"mip", "the mean over what a pixel of the picture sees"},
    {"distance", "from a smaller picture the farther the eye is, as Tachyon does"},
};
constexpr Choice kTransfers[] = {
    {"linear", "they are light"},
    {"srgb", "by the sRGB curve, as in photographs"},
};
constexpr Field kImageFields[] = {
    field<&Texture::file>("file", {.text = "the picture: PNG, JPEG, BMP, TGA, PPM, PGM, PFM, HDR or OpenEXR",
                                   .unit = Unit::picture,
                                   .required = true}),
    field<&Texture::transfer>(
        "transfer",
        {.text = "how light became the numbers of a picture of 8 or 16 bits; those of a "
                 "normal_map are linear where nothing is said",
         .choices = kTransfers}),
    texture_fields::wrap("what is beyond its edge"),
    field<&Texture::filter>("filter", {.text = "how it is looked up", .choices = kFilters}),
    field<&Texture::reach>("reach", {.text = "with the filter distance: from where on the picture "
                                             "is a single pixel; of cylinder and sphere, in units "
                                             "of the distance from the texture's origin",
                                     .unit = Unit::length,
                                     .range = greater_than(0)}),
    texture_fields::mapping(),
    texture_fields::repeat_u(),
    texture_fields::repeat_v(),
    texture_fields::offset_u(),
    texture_fields::offset_v(),
    texture_fields::transform(),
};

void begin_image(Texture& texture) {
  texture.mapping = TextureMapping::uv;
}

void end_image(Texture& texture, Item& item) {
  texture.image =
      read_picture(*item.node.find("file"), "image texture", texture.transfer, item.input);
}

}  // namespace

constexpr Kind texture::image = texture_kind<TextureKind::image, begin_image, end_image>(
    "image", "image texture",
    "A picture: its lower left corner at u = 0, v = 0, its upper right one at 1, 1.", kImageFields);

}  // namespace zraka::language
