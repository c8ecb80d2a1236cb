// SPDX-License-Identifier: Apache-2.0
// write_tachyon SCENE OUTPUT: a scene in the format of Tachyon.
//
// Its camera is left-handed, so z is turned round. A pixel's ray goes through its upper right
// corner; the frustum is moved so that a picture with a column and a row more has one ray for each
// corner of our pixels. What Tachyon cannot say: a cone becomes a cylinder of the mean radius, rays
// are not bent where they pass through, ambient light and highlights are white.
#include <cmath>

#include "scene_writer.hpp"

namespace {

using namespace zraka;
using namespace zraka::rivals;

void add_camera(const Scene& scene, Text& out) {
  const Camera& c = scene.camera;
  const Vec3 across = c.window_right * (1 / std::sqrt(dot(c.window_right, c.window_right)));
  const Vec3 up = c.window_up * (1 / std::sqrt(dot(c.window_up, c.window_up)));
  const Vec3 view = cross(up, across), to_window = c.window_center - c.eye;
  const double distance = dot(to_window, view);
  const double width = dot(c.window_right, across) / distance,
               height = dot(c.window_up, up) / distance;
  const double column = width / scene.resolution.width, row = height / scene.resolution.height;
  const double left = dot(to_window, across) / distance - width / 2 - column;
  const double bottom = dot(to_window, up) / distance - height / 2 - row;
  out.add("RESOLUTION {} {}\nSHADER_MODE FULL END_SHADER_MODE\n", scene.resolution.width + 1,
          scene.resolution.height + 1);
  out.add("CAMERA PROJECTION PERSPECTIVE ZOOM 1 ASPECTRATIO 1 ANTIALIASING 0 RAYDEPTH 5\n");
  out.add("CENTER {:.9g} {:.9g} {:.9g} ", c.eye.x, c.eye.y, -c.eye.z);
  out.add("VIEWDIR {:.9g} {:.9g} {:.9g} ", view.x, view.y, -view.z);
  out.add("UPDIR {:.9g} {:.9g} {:.9g}\n", up.x, up.y, -up.z);
  out.add("FRUSTUM {:.9g} {:.9g} {:.9g} {:.9g} END_CAMERA\n", left, left + width + column, bottom,
          bottom + height + row);
}

void add_material(const Material& m, double ambient_light, std::size_t number, Text& out) {
  // Its colour is multiplied by the ambient and diffuse factors.
  const double kd = mean(m.diffuse);
  const Color color = kd > 0 ? m.diffuse : m.ambient;
  const double ambient = ambient_light * (kd > 0 ? mean(m.ambient) / kd : 1);
  out.add("TEXDEF m{} AMBIENT {:.9g} DIFFUSE {} SPECULAR {:.9g} OPACITY {:.9g} ", number, ambient,
          kd > 0 ? 1 : 0, m.reflection.r, 1 - m.refraction.r);
  out.add("PHONG PLASTIC {:.9g} PHONG_SIZE {:.9g} ", mean(m.specular), m.shininess);
  out.add("COLOR {:.9g} {:.9g} {:.9g} TEXFUNC 0\n", color.r, color.g, color.b);
}

void add_point(const char* name, const Vec3& p, Text& out) {
  out.add("{} {:.9g} {:.9g} {:.9g} ", name, p.x, p.y, -p.z);
}

std::string translate(const Scene& scene) {
  Text out;
  out.add("BEGIN_SCENE\n");
  add_camera(scene, out);
  out.add("BACKGROUND {:.9g} {:.9g} {:.9g}\n", scene.background.r, scene.background.g,
          scene.background.b);
  for (const Light& light : scene.lights) {
    // Lights are spheres that rays see: too small for that.
    add_point("LIGHT CENTER", light.position, out);
    out.add("RAD 1e-6 COLOR {:.9g} {:.9g} {:.9g}\n", light.color.r, light.color.g, light.color.b);
  }
  for (std::size_t i = 0; i < scene.materials.size(); ++i)
    add_material(scene.materials[i], mean(scene.ambient_light), i, out);

  for (const auto& [s, material, transform] : scene.spheres) {
    add_point("SPHERE CENTER", s.center, out);
    out.add("RAD {:.9g} m{}\n", s.radius, material);
  }
  for (const auto& [s, material, transform] : scene.triangles) {
    add_point("TRI V0", s.a, out), add_point("V1", s.b, out), add_point("V2", s.c, out);
    out.add("m{}\n", material);
  }
  for (const auto& [s, material, transform] : scene.smooth_triangles) {
    // The mirrored corners go round the other way, which says where outside is.
    add_point("STRI V0", s.a, out), add_point("V1", s.c, out), add_point("V2", s.b, out);
    add_point("N0", s.normal_a, out), add_point("N1", s.normal_c, out);
    add_point("N2", s.normal_b, out);
    out.add("m{}\n", material);
  }
  for (const auto& [s, material, transform] : scene.cones) {
    add_point("FCYLINDER BASE", s.base, out), add_point("APEX", s.apex, out);
    out.add("RAD {:.9g} m{}\n", (s.base_radius + s.apex_radius) / 2, material);
  }
  out.add("END_SCENE\n");
  return out.str();
}

}  // namespace

int main(int argc, char** argv) {
  return translate_file(argc, argv, translate);
}
