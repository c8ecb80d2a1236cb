// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <cmath>
#include <utility>
#include <zraka/school/mistakes.hpp>

#include "render/variation.hpp"
#include "school/mistakes/mistaken_kernel.hpp"
#include "school/mistakes/names.hpp"

namespace zraka {

const std::vector<MistakeEntry>& all_mistakes() {
  static const std::vector<MistakeEntry> entries = {
#define ZRAKA_MISTAKE(name, key, allowed, stage, english, croatian) \
  {Mistake::name, key, allowed, stage, english, croatian},
#include <zraka/school/mistakes.def>
#undef ZRAKA_MISTAKE
  };
  return entries;
}

const MistakeEntry& entry_of(Mistake mistake) {
  return all_mistakes()[static_cast<std::size_t>(mistake) - 1];
}

std::optional<Mistake> mistake_named(std::string_view key) {
  for (const MistakeEntry& entry : all_mistakes())
    if (entry.key == key) return entry.mistake;
  return std::nullopt;
}

namespace {

/// The scene as somebody reads it who makes the mistake.
void misread(Scene& scene, Mistake mistake, const Terms& terms) {
  const auto negative = [](const Vec3& v) { return Vec3{-v.x, -v.y, -v.z}; };
  const auto each_material = [&](const auto& function) {
    for (Material& material : scene.materials) function(material);
  };
  const auto lights = static_cast<double>(scene.lights.size());
  switch (mistake) {
    case Mistake::y_down:
      scene.camera.window_up = negative(scene.camera.window_up);
      break;
    case Mistake::x_mirrored:
      scene.camera.window_right = negative(scene.camera.window_right);
      break;
    case Mistake::ambient_unscaled:
      scene.ambient_light = {1, 1, 1};
      break;
    case Mistake::ambient_per_light:
      if (terms.diffuse || terms.specular)
        scene.ambient_light = {scene.ambient_light.r * lights, scene.ambient_light.g * lights,
                               scene.ambient_light.b * lights};
      break;
    case Mistake::specular_is_diffuse:
      each_material([](Material& m) { m.specular = m.diffuse; });
      break;
    case Mistake::shares_swapped:
      each_material([](Material& m) { std::swap(m.reflection, m.refraction); });
      break;
    case Mistake::reflection_unweighted:
      each_material([](Material& m) { m.reflection = m.reflection.most() > 0 ? 1 : 0; });
      break;
    case Mistake::refraction_unweighted:
      each_material([](Material& m) { m.refraction = m.refraction.most() > 0 ? 1 : 0; });
      break;
    case Mistake::ratio_inverted:
      each_material([](Material& m) { m.ior = 1 / m.ior; });
      break;
    case Mistake::straight_through:
      each_material([](Material& m) { m.ior = 1; });
      break;
    default:
      break;
  }
}

/// Profile and depth as they become by the mistake.
void vary_options(RenderOptions& options, Mistake mistake) {
  switch (mistake) {
    case Mistake::pixel_center:
      options.profile.pixel_centers = !options.profile.pixel_centers;
      break;
    case Mistake::depth_less:
      options.max_depth = std::max(options.max_depth - 1, 0);
      break;
    case Mistake::depth_more:
      options.max_depth = std::min(options.max_depth + 1, kMaxDepth);
      break;
    case Mistake::clamp_at_end:
      options.profile.clamp_levels = false;
      break;
    case Mistake::total_mirrored:
      options.profile.mirror_when_total = true;
      break;
    default:
      break;
  }
}

/// The finished picture with the mistake.
void apply_mistake(Image& image, Mistake mistake) {
  if (mistake == Mistake::red_and_blue)
    for (std::size_t i = 0; i + 2 < image.pixels.size(); i += 3)
      std::swap(image.pixels[i], image.pixels[i + 2]);
  if (mistake == Mistake::gamma_applied)
    for (float& value : image.pixels)
      value = static_cast<float>(std::pow(std::max(static_cast<double>(value), 0.0), 1 / 2.2));
}

Variation variation_of(Mistake mistake, const RenderOptions& options) {
  if (mistake == Mistake::none) return {};
  const MistakeEntry& entry = entry_of(mistake);
  return {.number = static_cast<int>(mistake),
          .kernel = &isa_portable::kMistakenKernel,
          .record = isa_portable::record_mistaken_tile,
          .vary_scene = [mistake,
                         terms = options.terms](Scene& scene) { misread(scene, mistake, terms); },
          .vary_options = [mistake](RenderOptions& varied) { vary_options(varied, mistake); },
          .vary_image = [mistake](Image& image) { apply_mistake(image, mistake); },
          .rules = {.key = std::string(entry.key),
                    .english = std::string(entry.english),
                    .croatian = std::string(entry.croatian),
                    .white_when_total = mistake == Mistake::total_white}};
}

}  // namespace

std::string_view text_of(Language language, Mistake mistake) {
  const MistakeEntry& entry = entry_of(mistake);
  return language == Language::english ? entry.english : entry.croatian;
}

Result<Rendering> render_mistaken(const Scene& scene, const RenderOptions& options,
                                  Mistake mistake) {
  if (mistake == Mistake::none) return render(scene, options);
  return render_varied(scene, options, variation_of(mistake, options));
}

Result<Explainer> mistaken_explainer(const Scene& scene, const RenderOptions& options,
                                     Mistake mistake) {
  return varied_explainer(scene, options, variation_of(mistake, options));
}

Result<Explanation> explain_mistaken(const Scene& scene, const RenderOptions& options,
                                     Mistake mistake, std::uint32_t x, std::uint32_t y) {
  Result<Explainer> explainer = mistaken_explainer(scene, options, mistake);
  if (!explainer) return tl::make_unexpected(explainer.error());
  return explainer->pixel(x, y);
}

}  // namespace zraka
