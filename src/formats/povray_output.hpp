// SPDX-License-Identifier: Apache-2.0
// Writes scenes in the language of POV-Ray 3.7, and counts what is lost by that.
#pragma once

#include <fmt/format.h>

#include <string>
#include <utility>
#include <vector>

#include "core/append.hpp"
#include "formats/losses.hpp"
#include "formats/plain_material.hpp"
#include "formats/writers.hpp"

namespace zraka {

class PovrayWriter {
 public:
  explicit PovrayWriter(const Scene& scene) : scene_(scene), used_(used_materials(scene)) {}

  Result<WrittenScene> write();

 private:
  template <class... Values>
  void put(fmt::format_string<Values...> format, Values&&... values) {
    append(text_, format, std::forward<Values>(values)...);
  }
  static std::string words(const Vec3& v) { return fmt::format("<{},{},{}>", v.x, v.y, v.z); }
  static std::string words(const Color& c) { return fmt::format("rgb <{},{},{}>", c.r, c.g, c.b); }
  static std::string words(const Transform& t);

  // povray_output.cpp
  void write_settings();
  void write_camera();
  void write_surroundings();
  void write_light(const Light& light);
  void write_fading(const Light& light, Color& color);

  // povray_output_materials.cpp
  void write_material(std::uint32_t index);
  void count_lost(const Material& material);
  const Texture* painting_of(const Material& material) const;
  void write_clear(const Material& material);
  void write_finish(const Material& material);
  void write_interior(const Material& material);

  // povray_output_textures.cpp
  static bool is_pigment(const Texture& texture);
  /// `through` is the share of light that it lets through.
  static std::string pigment_of(const Texture& texture, double through);

  // povray_output_shapes.cpp
  /// What stands between an object's numbers and its closing brace.
  std::string ending(std::uint32_t material, std::uint32_t transform) const;
  void write_groups();
  void write_shapes(const ShapeLists& shapes);
  template <class Shape>
  void write_all(const std::vector<Object<Shape>>& objects);
  void write_meshes(const ShapeLists& shapes);
  void write(const Sphere& s, const std::string& end);
  void write(const Cone& s, const std::string& end);
  void write(const Triangle& s, const std::string& end);
  void write(const SmoothTriangle& s, const std::string& end);
  void write(const Ellipsoid& s, const std::string& end);
  void write(const Plane& s, const std::string& end);
  void write(const Box& s, const std::string& end);
  void write(const Frustum& s, const std::string& end);
  void write(const Torus& s, const std::string& end);
  void write(const Disc& s, const std::string& end);
  void write(const Parallelogram& s, const std::string& end);
  void write(const Capsule& s, const std::string& end);
  void write(const Quadric& s, const std::string& end);
  void write(const Superellipsoid& s, const std::string& end);
  void write(const Csg& s, const std::string& end);
  void write(const Instance& s, const std::string& end);

  const Scene& scene_;
  std::string text_;
  Losses losses_;
  std::vector<bool> used_;  ///< materials that shapes have
};

}  // namespace zraka
