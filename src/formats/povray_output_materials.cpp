// SPDX-License-Identifier: Apache-2.0
// Materials as macros of POV-Ray, M0 for the first: texture, interior, and whether shadows are
// thrown.
#include <algorithm>
#include <cmath>

#include "core/text.hpp"
#include "formats/plain_material.hpp"
#include "formats/povray_output.hpp"
#include "formats/vectors.hpp"
#include "materials/dispersion.hpp"

namespace zraka {

/// The texture that gives the diffuse light; nullptr where there is none, or none for POV-Ray.
const Texture* PovrayWriter::painting_of(const Material& m) const {
  for (const TextureUse& use : m.textures) {
    const Texture& texture = scene_.textures[use.texture];
    if (use.coefficient == Coefficient::diffuse && is_pigment(texture)) return &texture;
  }
  return nullptr;
}

void PovrayWriter::count_lost(const Material& m) {
  const Texture* const painting = painting_of(m);
  for (const TextureUse& use : m.textures) {
    const bool is_ambient = use.coefficient == Coefficient::ambient;
    const bool is_painting = painting != nullptr && &scene_.textures[use.texture] == painting;
    losses_.count("materials: textures, of which the mean is kept",
                  !is_painting || !(is_ambient || use.coefficient == Coefficient::diffuse));
  }
  losses_.count("materials: pictures in smaller sizes for what is far away",
                painting != nullptr && painting->kind == TextureKind::image &&
                    painting->filter == TextureFilter::mip);
  losses_.count("materials: bumps and maps of normals", m.normals.kind != NormalUse::Kind::none);
  losses_.count("materials: the highlight's colour",
                m.specular.r != m.specular.g || m.specular.g != m.specular.b);
  losses_.count("materials: priority", m.priority != 0);
  losses_.count(
      "materials: that what is transparent throws a full shadow",
      m.refraction.most() > 0 && m.casts_shadow && scene_.defaults.shadows == Shadows::opaque);
  losses_.count("materials: shares of refracted rays that are more than 0.999",
                m.refraction.most() > 0.999 && (mean(m.diffuse) > 0 || mean(m.ambient) > 0));
}

void PovrayWriter::write_finish(const Material& m) {
  const double shininess = std::max(m.shininess, 1e-3);
  if (mean(m.specular) > 0 && m.highlight == Highlight::blinn)  // as POV-Ray's specular is
    put("specular {} roughness {} ", mean(m.specular), 1 / shininess);
  else if (mean(m.specular) > 0)
    put("phong {} phong_size {} ", mean(m.specular), shininess);
  if (m.fresnel != Fresnel::off)  // takes from k2 what it gives to k1, which is 0 here
    put("reflection {{ {} fresnel on }} conserve_energy ", words(Color(m.refraction)));
  else if (m.reflection.most() > 0)
    put("reflection {{ {} }} ", words(Color(m.reflection)));
}

void PovrayWriter::write_interior(const Material& m) {
  if (!(m.refraction.most() > 0)) return;
  double ior = m.ior;
  std::string dispersion;
  if (m.dispersion.kind != Dispersion::Kind::none && scene_.defaults.wavelengths > 1) {
    // POV-Ray's index at λ is ior·dispersion^((0.555 µm - λ)/0.35 µm): equal at the lines F and C
    // as a ratio, and at d.
    constexpr double kMiddle = 0.555, kWidth = 0.35;
    const auto index = [&m](double line) { return refractive_index(m.dispersion, m.ior, line); };
    const double ratio = std::pow(index(kLineF) / index(kLineC), kWidth / (kLineC - kLineF));
    ior = index(kLineD) * std::pow(ratio, (kLineD - kMiddle) / kWidth);
    dispersion =
        fmt::format("dispersion {} dispersion_samples {} ", ratio, scene_.defaults.wavelengths);
  }
  put(" interior {{ ior {} {}", ior, dispersion);
  // From a power of 1000 on it fades by exp(-(1 - color)·depth/distance).
  if (m.absorption != Color{})
    put("fade_power 1001 fade_distance 1 fade_color {} ",
        words(Color{1 - m.absorption.r, 1 - m.absorption.g, 1 - m.absorption.b}));
  put("}}");
}

/// Clear bodies, whose shares are per channel: what passes has the pigment's colour.
void PovrayWriter::write_clear(const Material& m) {
  put("texture {{ pigment {{ rgbf <{},{},{},1> }} finish {{ ambient 0 diffuse 0 ", m.refraction.r,
      m.refraction.g, m.refraction.b);
  write_finish(m);
  put("}} }}");
}

void PovrayWriter::write_material(std::uint32_t index) {
  const Material& given = scene_.materials[index];
  count_lost(given);
  const Material m = without_textures(scene_, given);
  const Texture* const painting = painting_of(given);
  const auto name = scene_.material_names.find(index);
  if (name != scene_.material_names.end()) put("// {}\n", shown(name->second));
  put("#macro M{}() ", index);
  if (m.refraction.most() > 0 && mean(m.diffuse) == 0 && mean(m.ambient) == 0) {
    write_clear(m);
  } else {
    // A share that is transmitted is taken from diffuse and ambient light; ours is not.
    const double through = std::min(mean(m.refraction), 0.999), rest = 1 / (1 - through);
    const bool is_lit = mean(m.diffuse) > 0;
    const auto share = [](double ka, double kd) { return kd > 0 ? ka / kd : 0; };
    const Color ambient =
        is_lit ? Color{share(m.ambient.r, m.diffuse.r), share(m.ambient.g, m.diffuse.g),
                       share(m.ambient.b, m.diffuse.b)}
               : Color{1, 1, 1};
    const Color color = is_lit ? m.diffuse : m.ambient;
    const std::string pigment =
        painting != nullptr ? pigment_of(*painting, through)
                            : fmt::format("rgbt <{},{},{},{}>", color.r, color.g, color.b, through);
    put("texture {{ pigment {{ {} }} finish {{ ambient {} diffuse {} ", pigment,
        words(ambient * rest), is_lit ? rest : 0);
    write_finish(m);
    put("}} }}");
  }
  write_interior(m);
  if (!m.casts_shadow) put(" no_shadow");
  put(" #end\n");
}

}  // namespace zraka
