// SPDX-License-Identifier: Apache-2.0
// write_povray SCENE OUTPUT: a scene in the language of POV-Ray 3.7.
//
// The camera's vectors say where pixels' rays go, whatever the hand; they are stretched so that a
// picture with a column and a row more has a ray for each corner of our pixels. What POV-Ray does
// otherwise: light shines through what refracts, total internal reflection mirrors, highlights are
// white.
#include <algorithm>

#include "povray_bodies.hpp"

namespace {

using namespace zraka;
using namespace zraka::rivals;

std::string vector(const Vec3& v) {
  return fmt::format("<{:.9g},{:.9g},{:.9g}>", v.x, v.y, v.z);
}

void add_camera(const Scene& scene, Text& out) {
  const Camera& c = scene.camera;
  // Pictures that are compared pixel by pixel look through centres, as POV-Ray does.
  const bool corners = scene.defaults.profile != ProfileName::physical || scene.format == "NFF";
  const auto more = [&](std::uint32_t pixels) { return corners ? (pixels + 1.0) / pixels : 1; };
  out.add("camera {{ perspective location {} direction {} right {} up {} }}\n", vector(c.eye),
          vector(c.window_center - c.eye), vector(c.window_right * more(scene.resolution.width)),
          vector(c.window_up * more(scene.resolution.height)));
}

/// A checker that gives the diffuse light, and maybe the ambient; nullptr where there is none.
const Texture* checker_of(const Scene& scene, const Material& m) {
  for (const TextureUse& use : m.textures)
    if (use.coefficient == Coefficient::diffuse &&
        scene.textures[use.texture].kind == TextureKind::checker)
      return &scene.textures[use.texture];
  return nullptr;
}

std::string rgb(const Share& share) {
  return fmt::format("rgb <{:.9g},{:.9g},{:.9g}>", share.r, share.g, share.b);
}

void add_highlight_and_mirror(const Material& m, Text& out) {
  const double shininess = std::max(m.shininess, 1e-3);
  if (mean(m.specular) > 0 && m.highlight == Highlight::blinn)  // as POV-Ray's specular is
    out.add("specular {:.9g} roughness {:.9g} ", mean(m.specular), 1 / shininess);
  else if (mean(m.specular) > 0)
    out.add("phong {:.9g} phong_size {:.9g} ", mean(m.specular), shininess);
  if (m.fresnel != Fresnel::off)  // takes from k2 what it gives to k1, which is 0 here
    out.add("reflection {{ {} fresnel on }} conserve_energy ", rgb(m.refraction));
  else if (m.reflection.most() > 0)
    out.add("reflection {{ {} }} ", rgb(m.reflection));
}

void add_interior(const Material& m, Text& out) {
  if (!(m.refraction.most() > 0)) return;
  out.add(" interior {{ ior {:.9g} ", m.ior);
  // From a power of 1000 on it fades by exp(-(1 - color)·depth/distance).
  if (m.absorption.r > 0 || m.absorption.g > 0 || m.absorption.b > 0)
    out.add("fade_power 1001 fade_distance 1 fade_color <{:.9g},{:.9g},{:.9g}> ",
            1 - m.absorption.r, 1 - m.absorption.g, 1 - m.absorption.b);
  out.add("}}");
}

/// Clear bodies, whose shares are per channel: what passes has the pigment's colour.
std::string clear_texture(const Material& m) {
  Text out;
  out.add("texture {{ pigment {{ rgbf <{:.9g},{:.9g},{:.9g},1> }} finish {{ ambient 0 diffuse 0 ",
          m.refraction.r, m.refraction.g, m.refraction.b);
  add_highlight_and_mirror(m, out);
  out.add("}} }}");
  add_interior(m, out);
  return out.str();
}

void add_light(const Scene& scene, const Light& light, Text& out) {
  const bool directional = light.kind == LightKind::directional;
  // Far enough that it makes no difference to a byte.
  const Vec3 from = directional ? light.direction * -1e6 : light.position;
  out.add("light_source {{ {} rgb <{:.9g},{:.9g},{:.9g}> ", vector(from), light.color.r,
          light.color.g, light.color.b);
  if (directional) out.add("parallel point_at <0,0,0> ");
  if (light.kind == LightKind::spot)
    out.add("spotlight radius {:.9g} falloff {:.9g} tightness 0 point_at {} ", light.inner_deg,
            light.outer_deg, vector(light.position + light.direction));
  out.add("{}}}\n", scene.defaults.shadows == Shadows::off ? "shadowless " : "");
}

std::string texture(const Scene& scene, const Material& m) {
  if (m.refraction.most() > 0 && mean(m.diffuse) == 0 && mean(m.ambient) == 0)
    return clear_texture(m);
  // A share that is transmitted is taken from diffuse and ambient light; ours is not.
  const double through = std::min(m.refraction.r, 0.999), rest = 1 / (1 - through);
  const auto share = [](double ka, double kd) { return kd > 0 ? ka / kd : 0; };
  const double kd = mean(m.diffuse);
  const Color pigment = kd > 0 ? m.diffuse : m.ambient;
  const Color ambient =
      kd > 0 ? Color{share(m.ambient.r, m.diffuse.r), share(m.ambient.g, m.diffuse.g),
                     share(m.ambient.b, m.diffuse.b)}
             : Color{1, 1, 1};
  Text out;
  const auto color = [&](const Color& c) {
    return fmt::format("rgbt <{:.9g},{:.9g},{:.9g},{:.9g}>", c.r, c.g, c.b, through);
  };
  if (const Texture* const checker = checker_of(scene, m)) {
    const bool lights_up = m.textures.size() > 1;  // color = gives ambient and diffuse light
    out.add("texture {{ pigment {{ checker {}, {} scale {:.9g} }} ", color(checker->colors[0]),
            color(checker->colors[1]), checker->size);
    out.add("finish {{ ambient {:.9g} diffuse {:.9g} ", lights_up ? rest : 0, rest);
  } else {
    out.add("texture {{ pigment {{ {} }} ", color(pigment));
    out.add("finish {{ ambient rgb <{:.9g},{:.9g},{:.9g}> diffuse {:.9g} ", ambient.r * rest,
            ambient.g * rest, ambient.b * rest, kd > 0 ? rest : 0);
  }
  add_highlight_and_mirror(m, out);
  out.add("}} }}");
  add_interior(m, out);
  return out.str();
}

/// The triangles of each material as a mesh, which has a bounding hierarchy of its own.
template <class Shape, class Write>
void add_meshes(const std::vector<Object<Shape>>& objects, std::size_t materials,
                const Write& write, Text& out) {
  std::vector<std::vector<const Shape*>> of(materials);
  for (const Object<Shape>& object : objects) of[object.material].push_back(&object.shape);
  for (std::size_t m = 0; m < materials; ++m) {
    if (of[m].empty()) continue;
    out.add("mesh {{\n");
    for (const Shape* shape : of[m]) write(*shape);
    out.add("M{}() }}\n", m);
  }
}

std::string translate(const Scene& scene) {
  Text out;
  out.add("#version 3.7;\nglobal_settings {{ assumed_gamma 1 max_trace_level 5 adc_bailout 0 ");
  out.add("ambient_light rgb <{:.9g},{:.9g},{:.9g}> }}\n", scene.ambient_light.r,
          scene.ambient_light.g, scene.ambient_light.b);
  add_camera(scene, out);
  out.add("background {{ rgb <{:.9g},{:.9g},{:.9g}> }}\n", scene.background.r, scene.background.g,
          scene.background.b);
  for (const Light& light : scene.lights) add_light(scene, light, out);
  for (std::size_t i = 0; i < scene.materials.size(); ++i)
    out.add("#macro M{}() {} #end\n", i, texture(scene, scene.materials[i]));

  for (const auto& [s, material, transform] : scene.spheres)
    out.add("sphere {{ {}, {:.9g} M{}() }}\n", vector(s.center), s.radius, material);
  for (const auto& [s, material, transform] : scene.cones)
    out.add("cone {{ {}, {:.9g}, {}, {:.9g} open M{}() }}\n", vector(s.base), s.base_radius,
            vector(s.apex), s.apex_radius, material);
  add_meshes(
      scene.triangles, scene.materials.size(),
      [&](const Triangle& s) {
        out.add("triangle {{ {}, {}, {} }}\n", vector(s.a), vector(s.b), vector(s.c));
      },
      out);
  add_meshes(
      scene.smooth_triangles, scene.materials.size(),
      [&](const SmoothTriangle& s) {
        out.add("smooth_triangle {{ {}, {}, {}, {}, {}, {} }}\n", vector(s.a), vector(s.normal_a),
                vector(s.b), vector(s.normal_b), vector(s.c), vector(s.normal_c));
      },
      out);
  add_bodies(scene, [](std::uint32_t material) { return fmt::format("M{}()", material); }, out);
  return out.str();
}

}  // namespace

int main(int argc, char** argv) {
  return translate_file(argc, argv, translate);
}
