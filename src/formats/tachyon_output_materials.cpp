// SPDX-License-Identifier: Apache-2.0
// Materials as Tachyon's textures: one colour, of which ambient and diffuse light take a share
// each.
#include <algorithm>
#include <cmath>

#include "formats/plain_material.hpp"
#include "formats/tachyon_output.hpp"
#include "formats/vectors.hpp"

namespace zraka {
namespace {

/// The factor that makes one colour of another, if there is one.
bool is_multiple(const Color& c, const Color& of, double& factor) {
  factor = mean(of) > 0 ? mean(c) / mean(of) : 0;
  const auto near = [&](double a, double b) {
    return std::fabs(a - factor * b) <= 1e-9 * std::fmax(std::fabs(a), 1e-300);
  };
  return near(c.r, of.r) && near(c.g, of.g) && near(c.b, of.b);
}

/// What no name of Tachyon's can have: it is a token, and TEXTURE begins a texture.
bool is_name(const std::string& name) {
  constexpr std::size_t kLongest = 64;
  return !name.empty() && name.size() <= kLongest && name.front() != '#' && name != "TEXTURE" &&
         std::all_of(name.begin(), name.end(), [](char c) {
           return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') ||
                  c == '_' || c == '-' || c == '.';
         });
}

}  // namespace

void TachyonWriter::name_materials() {
  std::set<std::string> taken;
  names_.assign(scene_.materials.size(), "");
  for (const auto& [index, name] : scene_.material_names)
    if (index < names_.size() && is_name(name) && taken.insert(name).second) names_[index] = name;
  for (std::size_t i = 0; i < names_.size(); ++i) {
    if (!names_[i].empty()) continue;
    names_[i] = fmt::format("material_{}", i + 1);
    while (!taken.insert(names_[i]).second) names_[i] += '_';
  }
}

/// Ambient light in units of the diffuse one.
double TachyonWriter::ambient_ratio(const Material& given) const {
  const Material m = without_textures(scene_, given);
  return mean(m.diffuse) > 0 ? mean(m.ambient * scene_.ambient_light) / mean(m.diffuse) : 0;
}

/// Light from all around falls on Tachyon's surfaces as diffuse light does. Where all materials
/// have at least as much ambient light as diffuse, the rest is AMBIENT; else it has a colour of its
/// own.
void TachyonWriter::choose_occlusion() {
  occlusion_color_ = scene_.ambient_occlusion.color;
  if (scene_.ambient_occlusion.samples == 0) return;
  double least = HUGE_VAL, most = 0;
  for (std::size_t i = 0; i < scene_.materials.size(); ++i) {
    const Material& m = scene_.materials[i];
    if (!used_[i]) continue;
    if (const double ratio = ambient_ratio(m); mean(without_textures(scene_, m).diffuse) > 0)
      least = std::min(least, ratio), most = std::max(most, ratio);
  }
  if (least >= 1) return;
  occlusion_ = most;
  occlusion_color_ = occlusion_color_ * most;
}

void TachyonWriter::count_lost(const Material& m) {
  losses_.count("materials: textures, of which the mean is kept", m.textures.size());
  losses_.count("materials: bumps and maps of normals", m.normals.kind != NormalUse::Kind::none);
  losses_.count("materials: colours of the shares of reflected and refracted rays",
                !m.reflection.is_grey() || !m.refraction.is_grey());
  losses_.count("materials: that refracted rays are bent", m.refraction.most() > 0 && m.ior != 1);
  losses_.count("materials: Fresnel's law", m.fresnel != Fresnel::off);
  losses_.count("materials: absorption", m.absorption != Color{});
  losses_.count("materials: priority", m.priority != 0);
  losses_.count("materials: dispersion", m.dispersion.kind != Dispersion::Kind::none);
}

void TachyonWriter::write_material(std::uint32_t index) {
  count_lost(scene_.materials[index]);
  const Material m = without_textures(scene_, scene_.materials[index]);
  const Color ambient = m.ambient * scene_.ambient_light;
  const bool is_lit = m.diffuse != Color{};
  const Color color = is_lit ? m.diffuse : ambient;
  double share = 1, strength = 0;
  if (is_lit)
    losses_.count("materials: another colour of ambient light than of diffuse light",
                  !is_multiple(ambient, m.diffuse, share));
  if (is_lit && scene_.ambient_occlusion.samples > 0) {
    losses_.count("materials: how much they have of the ambient light",
                  occlusion_ > 0 && std::fabs(share - occlusion_) > 1e-9 * occlusion_);
    share = occlusion_ > 0 ? 0 : share - 1;
  }
  // METAL has the surface's colour, whatever the lights'.
  Color light{};
  for (const Light& each : scene_.lights)
    light = {light.r + each.color.r, light.g + each.color.g, light.b + each.color.b};
  light = scene_.lights.empty() ? Color{1, 1, 1}
                                : light * (1 / static_cast<double>(scene_.lights.size()));
  const Color& ks = m.specular;
  const bool is_white = ks.r == ks.g && ks.g == ks.b;
  const bool is_metal = !is_white && is_multiple(ks * light, color, strength);
  if (!is_metal) strength = mean(ks);
  losses_.count("materials: the highlight's colour", !is_white && !is_metal);
  losses_.count(
      "materials: Phong's highlight, for which there is Blinn's of four times the exponent",
      strength > 0 && m.highlight == Highlight::phong);
  put("TEXDEF {} AMBIENT {} DIFFUSE {} SPECULAR {} OPACITY {} ", names_[index], share,
      is_lit ? 1 : 0, mean(m.reflection), 1 - mean(m.refraction));
  if (strength > 0)
    put("PHONG {} {} PHONG_SIZE {} ", is_metal ? "METAL" : "PLASTIC", strength,
        m.shininess * (m.highlight == Highlight::phong ? 4 : 1));
  put_value("COLOR", color);
  put("TEXFUNC 0\n");
}

}  // namespace zraka
