// SPDX-License-Identifier: Apache-2.0
// glTF's textures: pictures in files, buffers and data URIs, and how they lie on surfaces. Its v
// goes down from the picture's upper edge, ours goes up.
#include <fmt/format.h>

#include <cmath>

#include "formats/gltf_materials.hpp"
#include "image/readers.hpp"
#include "image/scene_images.hpp"
#include "scene/bounds_of.hpp"

namespace zraka {
namespace {

constexpr std::uint64_t kMostPixels = std::uint64_t{1} << 26;

bool same_place(const Texture& a, const Texture& b) {
  return a.transform == b.transform && a.wrap == b.wrap && a.filter == b.filter &&
         a.transfer == b.transfer;
}

}  // namespace

GltfMaterials::Picture GltfMaterials::read_picture(std::size_t index, Transfer transfer) {
  const Json* const image = file_.item("images", index);
  std::string owned;
  std::string_view bytes;
  if (const std::optional<std::size_t> at = file_.index(image, "bufferView", "bufferViews")) {
    if (const std::optional<std::string_view> view = file_.view(*at)) bytes = *view;
  } else if (GltfFile::member(image, "uri") != nullptr) {
    if (std::optional<std::string> read = file_.bytes_of_uri(file_.word(image, "uri", "")))
      owned = std::move(*read), bytes = owned;
  }
  if (!file_.good() || image == nullptr) return {};
  std::vector<float> alpha;
  Result<ReadImage> read =
      parse_image_with_alpha(bytes, fmt::format("image {}", index), kMostPixels, alpha);
  if (!read) {
    file_.warn(fmt::format("image {} is left out: {}", index, read.error()[0].message));
    return {};
  }
  Picture picture;
  if (read->alpha) picture.alpha = std::make_shared<const std::vector<float>>(std::move(alpha));
  picture.image = std::make_shared<const Image>(linear_image(std::move(*read), transfer));
  for (const float value : picture.image->pixels)
    if (!std::isfinite(value)) {
      file_.warn(fmt::format("image {} is left out: it has pixels that are not finite", index));
      return {};
    }
  return picture;
}

GltfMaterials::Picture GltfMaterials::picture(std::size_t index, Transfer transfer) {
  const auto key = std::make_pair(index, transfer);
  const auto known = pictures_.find(key);
  if (known != pictures_.end()) return known->second;
  return pictures_.emplace(key, read_picture(index, transfer)).first->second;
}

void GltfMaterials::read_sampler(const Json& texture, Texture& out) {
  constexpr double kClamp = 33071, kMirror = 33648, kRepeat = 10497, kNearest = 9728;
  const std::optional<std::size_t> index = file_.index(&texture, "sampler", "samplers");
  if (!index) return;
  const Json* const sampler = file_.item("samplers", *index);
  const double wrap = file_.number(sampler, "wrapS", kRepeat);
  out.wrap = wrap == kClamp    ? TextureWrap::clamp
             : wrap == kMirror ? TextureWrap::mirror
                               : TextureWrap::repeat;
  if (file_.number(sampler, "wrapT", kRepeat) != wrap)
    file_.warn("textures are repeated along v as along u, where the file says otherwise");
  if (file_.number(sampler, "magFilter", 0) == kNearest) out.filter = TextureFilter::nearest;
}

/// KHR_texture_transform moves u and v before the picture is looked up; false where it makes one
/// point of all.
bool GltfMaterials::read_transform(const Json* info, Map& map) {
  const Json* const moved = GltfFile::extension(info, "KHR_texture_transform");
  if (moved == nullptr) return true;
  double offset[2] = {0, 0}, scale[2] = {1, 1};
  file_.numbers(moved, "offset", 2, offset);
  file_.numbers(moved, "scale", 2, scale);
  const double turn = file_.number(moved, "rotation", 0);
  map.uv_set = static_cast<std::size_t>(
      std::fmax(0, file_.number(moved, "texCoord", static_cast<double>(map.uv_set))));
  const double c = std::cos(turn), s = std::sin(turn);
  const Transform lookup{{c * scale[0], s * scale[0], 0},
                         {-s * scale[1], c * scale[1], 0},
                         {0, 0, 1},
                         {s * scale[1] + offset[0], 1 - c * scale[1] - offset[1], 0}};
  const std::optional<Transform> back = inverse(lookup);
  if (back) map.texture.transform = *back;
  return back.has_value();
}

std::optional<GltfMaterials::Map> GltfMaterials::map_of(const Json* info, Transfer transfer) {
  if (info == nullptr) return std::nullopt;
  const std::optional<std::size_t> index = file_.index(info, "index", "textures");
  if (!index) return std::nullopt;
  const Json& texture = *file_.item("textures", *index);
  const std::optional<std::size_t> source = file_.index(&texture, "source", "images");
  if (!source) {
    file_.warn("textures without a picture in PNG or JPEG are left out");
    return std::nullopt;
  }
  const Picture found = picture(*source, transfer);
  if (found.image == nullptr) return std::nullopt;
  Map map;
  map.alpha = found.alpha;
  map.uv_set = static_cast<std::size_t>(std::fmax(0, file_.number(info, "texCoord", 0)));
  map.texture.kind = TextureKind::image;
  map.texture.mapping = TextureMapping::uv;
  map.texture.transfer = transfer;
  map.texture.image = found.image;
  // A file beside the scene can be named once more, when it is written.
  const std::string uri = file_.word(file_.item("images", *source), "uri", "");
  if (!uri.starts_with("data:")) map.texture.file = uri;
  read_sampler(texture, map.texture);
  if (!read_transform(info, map)) file_.warn("textures that are moved to a point are left as is");
  return map;
}

double GltfMaterials::mean_channel(const Map& map, std::size_t channel) const {
  const std::vector<float>& pixels = map.texture.image->pixels;
  double sum = 0;
  for (std::size_t i = channel; i < pixels.size(); i += 3) sum += static_cast<double>(pixels[i]);
  return pixels.empty() ? 1 : sum / (static_cast<double>(pixels.size()) / 3);
}

std::uint32_t GltfMaterials::scaled(const Texture& texture, const Color& factor) {
  for (const Scaled& known : scaled_)
    if (known.image == texture.image.get() && known.factor == factor &&
        same_place(known.texture, texture))
      return known.index;
  Texture own = texture;
  if (factor != Color{1, 1, 1}) {
    auto image = std::make_shared<Image>(*texture.image);
    const float by[3] = {static_cast<float>(factor.r), static_cast<float>(factor.g),
                         static_cast<float>(factor.b)};
    for (std::size_t i = 0; i < image->pixels.size(); ++i) image->pixels[i] *= by[i % 3];
    own.image = std::move(image);
    own.file.clear();
  }
  const auto index = static_cast<std::uint32_t>(scene_.textures.size());
  scene_.textures.push_back(std::move(own));
  scaled_.push_back({texture.image.get(), factor, texture, index});
  return index;
}

void GltfMaterials::use(const Texture& texture, const Color& factor, Coefficient coefficient,
                        Material& material) {
  if (factor == Color{}) return;
  material.textures.push_back({coefficient, scaled(texture, factor)});
}

}  // namespace zraka
