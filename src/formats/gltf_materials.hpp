// SPDX-License-Identifier: Apache-2.0
// glTF's materials as ours: made when a mesh has them, with the pictures that they name.
#pragma once

#include <array>
#include <map>
#include <memory>
#include <optional>
#include <utility>
#include <vector>

#include "formats/gltf_file.hpp"

namespace zraka {

/// How much of the ambient light of a glTF scene there is.
inline constexpr double kGltfAmbient = 0.25;

class GltfMaterials {
 public:
  GltfMaterials(GltfFile& file, Scene& scene) : file_(file), scene_(scene) {}

  struct Look {
    std::uint32_t material = 0;
    std::optional<std::size_t> uv_set{};  ///< that its textures are on, none where there are none
  };
  /// The material of a primitive whose vertices all have one colour. None: the file's default.
  Look look(std::optional<std::size_t> index, const Color& vertices);
  /// The same with a texture of colours for the material's own.
  std::uint32_t painted(std::optional<std::size_t> index, const Texture& colors);

 private:
  struct Picture {
    std::shared_ptr<const Image> image;               ///< nullptr: cannot be read
    std::shared_ptr<const std::vector<float>> alpha;  ///< of each pixel; nullptr: all are opaque
  };
  /// A texture on a surface.
  struct Map {
    Texture texture;
    std::shared_ptr<const std::vector<float>> alpha;
    std::size_t uv_set = 0;
  };
  /// What a material of the file says.
  struct Surface {
    Color base{1, 1, 1}, emission{};
    double alpha = 1, metallic = 1, roughness = 1, transmission = 0, ior = 1.5, thickness = 0;
    double attenuation_distance = 0, dispersion = 0, cutoff = 0.5, normal_scale = 1;
    Color attenuation{1, 1, 1};
    enum class Alpha { opaque, mask, blend } alpha_mode = Alpha::opaque;
    bool is_unlit = false;
    std::optional<Map> base_map, emission_map, normal_map;
  };

  Surface surface_of(std::optional<std::size_t> index);
  void read_rough(const Json* json, Surface& surface);
  void read_glossy(const Json* json, Surface& surface);
  void read_optics(const Json* json, Surface& surface);
  std::uint32_t add(Surface surface, std::optional<std::size_t> index);
  void make_opaque(Surface& surface, Material& material);
  void make_clear(const Surface& surface, Material& material);
  void add_emission(const Surface& surface, Material& material);
  void drop_other_sets(Surface& surface);

  std::optional<Map> map_of(const Json* info, Transfer transfer);
  void read_sampler(const Json& texture, Texture& out);
  bool read_transform(const Json* info, Map& map);
  Picture picture(std::size_t image, Transfer transfer);
  Picture read_picture(std::size_t image, Transfer transfer);
  /// The mean of a channel of a map.
  double mean_channel(const Map& map, std::size_t channel) const;
  /// A coefficient is the map times a colour.
  void use(const Texture& texture, const Color& factor, Coefficient coefficient,
           Material& material);
  std::uint32_t scaled(const Texture& texture, const Color& factor);

  GltfFile& file_;
  Scene& scene_;
  std::map<std::pair<std::size_t, Transfer>, Picture> pictures_;
  std::map<std::pair<std::size_t, std::array<double, 3>>, Look> looks_;
  /// Textures of the scene by image, factor and where they lie.
  struct Scaled {
    const Image* image;
    Color factor;
    Texture texture;
    std::uint32_t index;
  };
  std::vector<Scaled> scaled_;
};

}  // namespace zraka
