// SPDX-License-Identifier: Apache-2.0
#include "formats/losses.hpp"

#include <fmt/format.h>

#include <algorithm>

namespace zraka {

void Losses::count(std::string_view what, std::uint64_t times) {
  if (times == 0) return;
  const auto found = std::find_if(counts_.begin(), counts_.end(),
                                  [&](const auto& count) { return count.first == what; });
  if (found == counts_.end())
    counts_.emplace_back(what, times);
  else
    found->second += times;
}

void Losses::defaults(const Scene& scene, const RenderDefaults& of_format) {
  count("the profile", scene.defaults.profile != of_format.profile);
  count("the depth of rays", scene.defaults.max_depth != of_format.max_depth);
  if (scene.defaults.shadows != of_format.shadows)
    count(scene.defaults.shadows == Shadows::off ? "that there are no shadows"
                                                 : "that shadows are transparent",
          1);
  const Sampling &own = scene.defaults.sampling, &other = of_format.sampling;
  count("the least contribution", scene.defaults.min_contribution != of_format.min_contribution);
  count("the samples of pixels", own.kind != other.kind || own.count != other.count);
  count("the filter of samples", own.filter != other.filter);
  count("the seed", own.seed != other.seed);
  count("the number of wavelengths", scene.defaults.wavelengths != of_format.wavelengths);
}

void Losses::material(const Material& material) {
  count("materials: textures", material.textures.size());
  count("materials: bumps and maps of normals", material.normals.kind != NormalUse::Kind::none);
  count("materials: Blinn's highlight", material.highlight != Highlight::phong);
  count("materials: colours of the shares of reflected and refracted rays",
        !material.reflection.is_grey() || !material.refraction.is_grey());
  count("materials: Fresnel's law", material.fresnel != Fresnel::off);
  count("materials: absorption", material.absorption != Color{});
  count("materials: priority", material.priority != 0);
  count("materials: that they cast no shadow", !material.casts_shadow);
  count("materials: dispersion", material.dispersion.kind != Dispersion::Kind::none);
}

void Losses::light(const Light& light) {
  count("lights: directional ones", light.kind == LightKind::directional);
  count("lights: the cones of spots", light.kind == LightKind::spot);
  count("lights: the size of rectangles, discs and spheres", light.is_surface());
  count("lights: attenuation",
        light.kind != LightKind::directional && light.attenuation != Light{}.attenuation);
}

void Losses::surroundings(const Scene& scene) {
  count("the camera's lens", scene.camera.aperture > 0);
  count("the sky's gradient", scene.sky.kind == Sky::Kind::gradient);
  count("the sky's picture", scene.sky.kind == Sky::Kind::image);
  count("cuts", scene.cuts.size());
  count("fog", scene.fog.kind != Fog::Kind::none);
  count("ambient occlusion", scene.ambient_occlusion.samples > 0);
}

Diagnostics Losses::diagnostics(std::string_view format) const {
  Diagnostics all;
  for (const auto& [what, times] : counts_)
    all.push_back({.severity = Severity::warning,
                   .message = times == 1
                                  ? fmt::format("lost in {}: {}", format, what)
                                  : fmt::format("lost in {}: {} ({} times)", format, what, times)});
  return all;
}

}  // namespace zraka
