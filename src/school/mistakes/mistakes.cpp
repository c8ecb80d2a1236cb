// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <cmath>
#include <map>
#include <tuple>
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

std::span<const MistakeEntry> lab_mistakes() {
  static const std::size_t count = static_cast<std::size_t>(
      std::count_if(all_mistakes().begin(), all_mistakes().end(),
                    [](const MistakeEntry& entry) { return entry.first_stage < kAdvanced; }));
  return {all_mistakes().data(), count};
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

/// The images of textures, each changed by change(Image); what was shared stays shared.
template <class Change>
void change_textures(Scene& scene, const Change& change) {
  std::map<const Image*, std::shared_ptr<const Image>> changed;
  for (Texture& texture : scene.textures) {
    if (!texture.image) continue;
    std::shared_ptr<const Image>& image = changed[texture.image.get()];
    if (!image) image = std::make_shared<const Image>(change(*texture.image));
    texture.image = image;
  }
}

Image upside_down(const Image& image) {
  Image turned = image;
  for (std::uint32_t y = 0; y < image.height; ++y)
    std::copy_n(image.row(image.height - 1 - y), std::size_t{3} * image.width,
                turned.pixels.data() + std::size_t{3} * image.width * y);
  return turned;
}

/// u and v exchanged: the first row is at v = 1, so that this is a mirror image in the diagonal that
/// rises.
Image with_uv_swapped(const Image& image) {
  Image swapped(image.height, image.width);
  for (std::uint32_t y = 0; y < swapped.height; ++y)
    for (std::uint32_t x = 0; x < swapped.width; ++x)
      std::copy_n(image.row(image.height - 1 - x) + std::size_t{3} * (image.width - 1 - y), 3,
                  swapped.pixels.data() + 3 * (std::size_t{swapped.width} * y + x));
  return swapped;
}

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
    case Mistake::transposed:
      std::tie(scene.camera.window_right, scene.camera.window_up) =
          std::pair(negative(scene.camera.window_up), negative(scene.camera.window_right));
      break;
    case Mistake::shifted: {
      // A column and a row on.
      const auto on = [](Vec3& point, const Vec3& by, double share) {
        point = {point.x + share * by.x, point.y + share * by.y, point.z + share * by.z};
      };
      on(scene.camera.window_center, scene.camera.window_right, 1.0 / scene.resolution.width);
      on(scene.camera.window_center, scene.camera.window_up, -1.0 / scene.resolution.height);
      break;
    }
    case Mistake::view_narrow:
    case Mistake::view_wide: {
      const double by = mistake == Mistake::view_narrow ? 0.5 : 2;
      for (Vec3* side : {&scene.camera.window_right, &scene.camera.window_up})
        *side = {side->x * by, side->y * by, side->z * by};
      break;
    }
    case Mistake::eye_reversed:
      scene.camera.eye.z = -scene.camera.eye.z;
      break;
    case Mistake::light_z_reversed:
      for (Light& light : scene.lights) light.position.z = -light.position.z;
      break;
    case Mistake::exponent_halved:
      each_material([](Material& m) { m.shininess /= 2; });
      break;
    case Mistake::exponent_fourfold:
      each_material([](Material& m) { m.shininess *= 4; });
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
    case Mistake::texture_upside_down:
      change_textures(scene, upside_down);
      break;
    case Mistake::texture_transposed:
      change_textures(scene, with_uv_swapped);
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
    case Mistake::bytes_overflow:
      options.profile.clamp_levels = false;
      break;
    case Mistake::filter_per_surface:
      options.profile.filter_surfaces = true;
      break;
    case Mistake::total_mirrored:
      options.profile.mirror_when_total = true;
      break;
    default:
      break;
  }
}

/// The engine's settings as they become by the mistake.
void vary_settings(TraceSettings& settings, Mistake mistake) {
  Wavelengths& waves = settings.wavelengths;
  switch (mistake) {
    case Mistake::wavelengths_by_number:
      // The brightest of each channel is 1.
      for (int c = 0; c < 3; ++c) {
        float most = 0;
        for (int i = 0; i < waves.count; ++i) most = std::max(most, waves.weight[i][c]);
        for (int i = 0; i < waves.count; ++i)
          waves.weight[i][c] /= most * static_cast<float>(waves.count);
      }
      break;
    case Mistake::dispersion_reversed:
      std::reverse(waves.um, waves.um + waves.count);
      break;
    case Mistake::cut_by_share:
      settings.cut_by_share = true;
      break;
    case Mistake::filter_first_only:
      settings.filter_first_only = true;
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
  if (mistake == Mistake::bytes_overflow)
    for (float& value : image.pixels) {
      const double byte = std::floor(std::clamp(static_cast<double>(value), 0.0, 1e6) * 255 + 0.5);
      value = static_cast<float>(std::fmod(byte, 256) / 255);
    }
  if (mistake == Mistake::gamma_applied)
    for (float& value : image.pixels)
      value = static_cast<float>(std::pow(std::max(static_cast<double>(value), 0.0), 1 / 2.2));
}

const Kernel<float>& mistaken_kernel_of([[maybe_unused]] Isa isa) {
#if defined(ZRAKA_HAVE_X86)
  if (isa == Isa::avx2 || isa == Isa::avx512) return isa_avx2::kMistakenKernel;
#endif
  return isa_portable::kMistakenKernel;
}

Variation variation_of(const MistakenBy& by, const RenderOptions& options) {
  if (by == MistakenBy{}) return {};
  const Mistake one = by.first != Mistake::none ? by.first : by.second,
                other = one == by.first ? by.second : Mistake::none;
  VariedRules rules;
  for (const Mistake mistake : {one, other}) {
    if (mistake == Mistake::none) continue;
    const MistakeEntry& entry = entry_of(mistake);
    const auto add = [](std::string& to, const char* between, std::string_view more) {
      to += (to.empty() ? "" : between) + std::string(more);
    };
    add(rules.key, "+", entry.key);
    add(rules.english, "; ", entry.english);
    add(rules.croatian, "; ", entry.croatian);
    rules.white_when_total = rules.white_when_total || mistake == Mistake::total_white;
  }
  // The lab's rules are the lean engine's; others are settings of the general one.
  const bool of_the_lab = entry_of(one).first_stage < kAdvanced ||
                          (other != Mistake::none && entry_of(other).first_stage < kAdvanced);
  return {.number = number_of(one, other),
          .kernel = of_the_lab ? mistaken_kernel_of : nullptr,
          .record = of_the_lab ? isa_portable::record_mistaken_tile : nullptr,
          .vary_scene =
              [one, other, terms = options.terms](Scene& scene) {
                misread(scene, one, terms);
                misread(scene, other, terms);
              },
          .vary_options =
              [one, other](RenderOptions& varied) {
                vary_options(varied, one);
                vary_options(varied, other);
              },
          .vary_settings =
              [one, other](TraceSettings& settings) {
                vary_settings(settings, one);
                vary_settings(settings, other);
              },
          .vary_image =
              [one, other](Image& image) {
                apply_mistake(image, one);
                apply_mistake(image, other);
              },
          .rules = rules};
}

}  // namespace

std::string_view text_of(Language language, Mistake mistake) {
  const MistakeEntry& entry = entry_of(mistake);
  return language == Language::english ? entry.english : entry.croatian;
}

Result<Rendering> render_mistaken(const Scene& scene, const RenderOptions& options,
                                  const MistakenBy& by) {
  if (by == MistakenBy{}) return render(scene, options);
  return render_varied(scene, options, variation_of(by, options));
}

Result<Explainer> mistaken_explainer(const Scene& scene, const RenderOptions& options,
                                     const MistakenBy& by) {
  return varied_explainer(scene, options, variation_of(by, options));
}

Result<Explanation> explain_mistaken(const Scene& scene, const RenderOptions& options,
                                     const MistakenBy& by, std::uint32_t x, std::uint32_t y) {
  Result<Explainer> explainer = mistaken_explainer(scene, options, by);
  if (!explainer) return tl::make_unexpected(explainer.error());
  return explainer->pixel(x, y);
}

}  // namespace zraka
