// SPDX-License-Identifier: Apache-2.0
// Reads Tachyon's scenes statement by statement, those of included files among them.
#pragma once

#include <array>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <unordered_map>
#include <vector>

#include "core/scene_folder.hpp"
#include "formats/tachyon.hpp"
#include "formats/tachyon_text.hpp"
#include "image/scene_images.hpp"

namespace zraka {

/// A texture in Tachyon's sense: a surface.
struct TachyonSurface {
  double ambient = 0.1, diffuse = 0.9, mirror = 0, opacity = 1, highlight = 0, shininess = 100;
  double metal = 0;  ///< 1: the highlight has the surface's colour
  double r = 1, g = 1, b = 1;
  double pattern = 0;  ///< one more than an index in the reader's patterns; 0: one colour
  double shines = 0;   ///< 1: a light's own sphere
  double cut = 0;      ///< the group of cuts that it stands in; 0: none
  friend auto operator<=>(const TachyonSurface&, const TachyonSurface&) = default;
};

class TachyonReader {
 public:
  TachyonReader(const ReadOptions& options, const TachyonSettings& settings);

  /// The whole file, from BEGIN_SCENE on.
  void read(std::string_view text, const std::string& name);
  Result<ReadScene> finish();

 private:
  static constexpr std::size_t kEnoughErrors = 100;
  static constexpr int kDeepest = 16;  ///< files that include each other
  static constexpr std::uint64_t kMostIncluded = std::uint64_t{1} << 32;  ///< bytes in all

  struct Statement {
    std::string_view keyword;
    bool (TachyonReader::*read)();
  };
  static const Statement* statement_of(std::string_view word);

  /// An image that the file holds, slice by slice.
  struct Definition {
    std::array<std::uint32_t, 3> size{};
    std::vector<unsigned char> texels;
  };
  /// Triangles with a colour at each corner, of one surface: they get a texture of their own.
  struct Painted {
    TachyonSurface surface;
    std::uint32_t material = 0;
    std::vector<float> colors;           ///< nine a triangle
    std::vector<std::size_t> triangles;  ///< indices among the smooth ones
  };
  struct InfiniteCylinder {
    Vec3 center, axis;
    double radius;
    std::uint32_t material;
  };
  struct SurfaceHash {
    std::size_t operator()(const TachyonSurface& s) const;
  };

  // What is said of the file (tachyon.cpp).
  bool fail(const char* at, std::string message, std::string hint = {});
  bool fail(std::string message) { return fail(in_->place(), std::move(message)); }
  void warn(const char* at, const std::string& message, const std::string& hint = {});
  bool has_enough() const { return errors_.size() >= kEnoughErrors; }

  // Values behind keywords (tachyon.cpp).
  bool expect(std::string_view keyword);
  bool number(double& value, std::string_view what);
  bool number_of(std::string_view keyword, double& value);
  bool vector(Vec3& v, std::string_view what);
  bool vector_of(std::string_view keyword, Vec3& v);
  bool color(Color& c, std::string_view what);
  bool color_of(std::string_view keyword, Color& c);
  /// A whole number; `least` bytes of the file stand for each of what it counts.
  bool count(std::size_t& n, std::string_view what, std::size_t least, double most);
  bool file_name(std::string_view what, std::string& name);
  std::optional<std::string> read_named(const char* at, const std::string& name);
  void read_statements();
  void skip_statement();
  bool read_comment();
  bool read_include();
  bool read_end();

  // tachyon_camera.cpp
  bool read_resolution();
  bool read_camera();
  bool read_shader_mode();
  bool read_background();
  bool read_gradient();
  bool read_fog();
  bool read_clip_group();
  bool end_clip_group();
  void set_camera();

  // tachyon_lights.cpp
  bool read_light();
  bool read_directional_light();
  bool read_spotlight();
  bool read_sky_light();
  bool read_attenuation(Light& light);
  bool read_occlusion(std::string_view samples);
  void add_light(const Light& light, double radius);

  // tachyon_shapes.cpp
  bool read_sphere();
  bool read_plane();
  bool read_cylinder();
  bool read_fcylinder();
  bool read_polycylinder();
  bool read_ring();
  bool read_box();
  bool read_triangle();
  bool read_smooth_triangle();
  bool read_painted_triangle();
  bool read_vertex_array();
  bool read_scape();
  bool read_volume();
  bool read_polygon_file();
  bool read_mgf();
  void add_sphere(const Vec3& center, double radius, std::uint32_t material, const char* at);
  void add_cylinder(const Vec3& base, const Vec3& apex, double radius, std::uint32_t material,
                    const char* at);
  void add_smooth(const std::array<Vec3, 6>& corners, std::uint32_t material);
  void add_painted(const std::array<Vec3, 6>& corners, const std::array<Color, 3>& colors,
                   const TachyonSurface& surface);
  void add_infinite_cylinders();

  // tachyon_images.cpp
  bool read_imagedef();
  /// The first row is where v is 0.
  std::shared_ptr<const Image> image_named(const char* at, const std::string& name, int slice);
  static bool is_targa(const std::string& name);
  Result<Image> read_picture(const std::string& name);
  Result<Image> read_targa(const std::string& name);

  // tachyon_textures.cpp
  bool read_texdef();
  bool read_texalias();
  bool surface(std::uint32_t& material);
  bool surface_body(TachyonSurface& surface, bool painted);
  bool read_pattern(int function, TachyonSurface& surface);
  bool read_image_pattern(int function, TachyonSurface& surface);
  std::uint32_t material_of(TachyonSurface surface);

  // tachyon_materials.cpp: from surfaces to materials, once all is known.
  void set_materials();
  Color mean_light() const;
  Material material_from(const TachyonSurface& surface);
  void add_texture(Material& material, Coefficient coefficient, const Texture& pattern,
                   double factor);
  void paint();
  void set_defaults();

  ReadOptions options_;
  TachyonSettings settings_;
  SceneImages images_;
  TachyonText* in_ = nullptr;
  std::string_view statement_;  ///< the one that is being read
  int includes_ = 0;
  std::uint64_t included_ = 0;
  bool ended_ = false;
  std::uint32_t cut_group_ = 0;  ///< that shapes are read into
  std::map<std::vector<double>, std::uint32_t> cut_groups_;  ///< by the numbers of their planes
  Scene scene_;
  Diagnostics errors_;
  std::vector<std::pair<Diagnostic, std::uint64_t>> warnings_;  ///< and how often

  Vec3 center_, view_{0, 0, 1}, up_{0, 1, 0};
  double zoom_ = 1, aspect_ = 1, focal_length_ = 1, aperture_ = 0;
  double samples_ = 0, depth_ = 6;
  std::optional<std::array<double, 4>> frustum_;
  std::string_view projection_ = "PERSPECTIVE";
  bool has_camera_ = false;

  TachyonMode mode_ = TachyonMode::full;
  bool shadow_filter_ = true, trans_vmd_ = false, fog_vmd_ = false;
  double light_scale_ = 1;

  std::map<std::string, TachyonSurface, std::less<>> names_;
  std::map<std::string, Definition, std::less<>> definitions_;
  std::vector<TachyonSurface> surfaces_;  ///< in the order of the scene's materials
  std::unordered_map<TachyonSurface, std::uint32_t, SurfaceHash> materials_;
  TachyonSurface last_{.shines = -1};
  std::uint32_t last_material_ = 0;
  std::vector<Texture> patterns_;
  std::map<std::vector<double>, std::size_t> pattern_of_;
  std::map<std::pair<std::string, int>, std::shared_ptr<const Image>> cut_images_;
  std::map<std::pair<const Image*, double>, std::shared_ptr<const Image>> scaled_images_;
  std::vector<Painted> painted_;
  std::vector<InfiniteCylinder> cylinders_;
};

}  // namespace zraka
