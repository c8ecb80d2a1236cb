// SPDX-License-Identifier: Apache-2.0
// Textures as pigments of POV-Ray: those that it has to the point. Of others their mean is kept.
#include <algorithm>

#include "formats/povray_output.hpp"
#include "formats/vectors.hpp"

namespace zraka {
namespace {

/// What POV-Ray calls the format of a file of this name; none that it reads otherwise.
std::string_view image_type_of(const std::string& file) {
  const std::size_t dot = file.rfind('.');
  std::string end = dot == std::string::npos ? "" : file.substr(dot + 1);
  std::transform(end.begin(), end.end(), end.begin(),
                 [](char c) { return c >= 'A' && c <= 'Z' ? static_cast<char>(c + 32) : c; });
  for (const std::string_view type : {"png", "ppm", "pgm", "tga", "hdr", "exr"})
    if (end == type) return type;
  return end == "jpg" || end == "jpeg" ? "jpeg" : "";
}

/// POV-Ray's strings know no way to write these.
bool can_be_quoted(const std::string& file) {
  return file.find_first_of("\"\\\n\r") == std::string::npos;
}

/// Turns z to a direction.
Transform with_z_along(const Vec3& direction) {
  const Vec3 z = unit(direction), x = any_across(z);
  Transform turned;
  turned.along_x = x, turned.along_y = cross(z, x), turned.along_z = z;
  return turned;
}

}  // namespace

bool PovrayWriter::is_pigment(const Texture& t) {
  if (t.mapping != TextureMapping::solid) return false;
  switch (t.kind) {
    case TextureKind::checker:
    case TextureKind::stripes:
      return true;
    case TextureKind::gradient:
      return t.wrap == TextureWrap::repeat;
    case TextureKind::rings:
      return t.turbulence == 0;
    case TextureKind::image:
      return t.wrap == TextureWrap::repeat && t.filter != TextureFilter::distance &&
             t.image != nullptr && !image_type_of(t.file).empty() && can_be_quoted(t.file);
    default:
      return false;
  }
}

std::string PovrayWriter::pigment_of(const Texture& t, double through) {
  const auto clear = [&](const Color& c) {
    return fmt::format("rgbt <{},{},{},{}>", c.r, c.g, c.b, through);
  };
  // Colours one after the other from 0 to 1, each as wide as any other.
  const auto in_turn = [&] {
    std::string map = "color_map {";
    const auto n = static_cast<double>(t.colors.size());
    for (std::size_t i = 0; i < t.colors.size(); ++i)
      for (const std::size_t end : {i, i + 1})
        append(map, " [{} {}]", static_cast<double>(end) / n, clear(t.colors[i]));
    append(map, " }} scale {}", t.size * n);
    return map;
  };
  std::string text;
  switch (t.kind) {
    case TextureKind::checker:
      text = fmt::format("checker {}, {} scale {}", clear(t.colors[0]), clear(t.colors[1]), t.size);
      break;
    case TextureKind::stripes:
      text = fmt::format("gradient {} {}", words(unit(t.direction)), in_turn());
      break;
    case TextureKind::rings:
      text = fmt::format("wood ramp_wave {} {}", in_turn(), words(with_z_along(t.direction)));
      break;
    case TextureKind::gradient: {
      text = fmt::format("gradient {} color_map {{", words(unit(t.direction)));
      const auto parts = static_cast<double>(t.colors.size() - 1);
      for (std::size_t i = 0; i < t.colors.size(); ++i)
        append(text, " [{} {}]", static_cast<double>(i) / parts, clear(t.colors[i]));
      append(text, " }} scale {}", t.size);
      break;
    }
    default: {
      const std::string_view type = image_type_of(t.file);
      const bool is_light = type == "hdr" || type == "exr";
      text = fmt::format("image_map {{ {} \"{}\"{} map_type 0", type, t.file,
                         is_light                       ? ""
                         : t.transfer == Transfer::srgb ? " gamma srgb"
                                                        : " gamma 1.0");
      if (t.filter != TextureFilter::nearest) text += " interpolate 2";
      if (through > 0) append(text, " transmit all {}", through);
      text += " }";
    }
  }
  if (t.transform != Transform{}) text += " " + words(t.transform);
  return text;
}

}  // namespace zraka
