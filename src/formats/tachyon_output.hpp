// SPDX-License-Identifier: Apache-2.0
// Writes Tachyon's scenes, and counts what is lost by that.
#pragma once

#include <fmt/format.h>

#include <set>
#include <string>
#include <vector>

#include "core/append.hpp"
#include "formats/losses.hpp"
#include "formats/writers.hpp"

namespace zraka {

class TachyonWriter {
 public:
  explicit TachyonWriter(const Scene& scene);

  Result<WrittenScene> write();

 private:
  /// Where shapes of a list go: into the world, and what is made of kMaterialOfWhole.
  struct Place {
    Transform transform;
    std::uint32_t material = 0;
  };

  template <class... Values>
  void put(fmt::format_string<Values...> format, Values&&... values) {
    append(text_, format, std::forward<Values>(values)...);
  }
  void put_value(const char* keyword, const Vec3& v) {
    put("{} {} {} {} ", keyword, v.x, v.y, v.z);
  }
  void put_value(const char* keyword, const Color& c) {
    put("{} {} {} {} ", keyword, c.r, c.g, c.b);
  }

  // tachyon_output.cpp
  Result<void> write_camera();
  void write_shader();
  void write_surroundings();
  void write_light(const Light& light);
  double seen_radius(const Light& light) const;

  // tachyon_output_materials.cpp
  void name_materials();
  void write_material(std::uint32_t index);
  void count_lost(const Material& material);
  double ambient_ratio(const Material& material) const;
  void choose_occlusion();

  // tachyon_output_shapes.cpp
  double count_shapes(const ShapeLists& shapes);
  void write_shapes(const ShapeLists& shapes, const Place& place);
  template <class Shape>
  void write_all(const std::vector<Object<Shape>>& objects, const Place& place);
  void write(const Sphere& s, const Place& place);
  void write(const Triangle& s, const Place& place);
  void write(const SmoothTriangle& s, const Place& place);
  void write(const Cone& s, const Place& place);
  void write(const Plane& s, const Place& place);
  void write(const Box& s, const Place& place);
  void write(const Frustum& s, const Place& place);
  void write(const Disc& s, const Place& place);
  void write(const Parallelogram& s, const Place& place);
  void write(const Capsule& s, const Place& place);
  void write(const Instance& s, const Place& place);
  template <class Body>
  void write(const Body& body, const Place& place);
  void write_cylinder(const Vec3& base, const Vec3& top, double radius, const Place& place);
  void write_ring(const Vec3& center, const Vec3& normal, double inner, double outer,
                  const Place& place);
  void write_triangles(const AnyBody& body, const Place& place);
  void clip(std::vector<const Cut*> planes);
  std::vector<const Cut*> planes_of(const Material& material) const;
  void end(const Place& place) { put("{}\n", names_[place.material]); }

  const Scene& scene_;
  std::string text_;
  Losses losses_;
  std::vector<bool> used_;            ///< materials that shapes have
  std::vector<std::string> names_;    ///< of materials
  std::vector<bool> shines_;          ///< materials of lights' own spheres
  std::vector<double> group_shapes_;  ///< in each group, with its instances' own; -1: not counted
  std::vector<const Cut*> clipped_;   ///< the planes of the clip group that is open
  double occlusion_ = 0;  ///< the ambient share that AMBIENT_COLOR has, 0: materials' own
  Color occlusion_color_{1, 1, 1};
};

}  // namespace zraka
