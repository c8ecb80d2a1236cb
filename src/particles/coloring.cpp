// SPDX-License-Identifier: Apache-2.0
#include "particles/coloring.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <atomic>
#include <bit>
#include <cmath>
#include <memory>
#include <mutex>

#include "core/in_parallel.hpp"
#include "image/transfer.hpp"
#include "particles/elements.hpp"

namespace zraka {
namespace {

constexpr std::size_t kColors = std::size_t{1} << 24, kMostMaterials = 65536;

std::uint32_t add_material(const Material& base, std::uint32_t rgb, Scene& scene) {
  Material material = base;
  material.ambient = material.diffuse = linear_color(rgb);
  scene.materials.push_back(std::move(material));
  return static_cast<std::uint32_t>(scene.materials.size() - 1);
}

/// The least and the most of a list that threads go through in parts; not finite if one number is
/// not.
struct Extent {
  float least = std::numeric_limits<float>::infinity();
  float most = -std::numeric_limits<float>::infinity();
  bool finite = true;
  void include(float value) {
    least = std::min(least, value);
    most = std::max(most, value);
    finite = finite && std::isfinite(value);
  }
};
template <class Include>
Extent extent_of(std::size_t count, const Include& include) {
  Extent all;
  std::mutex joining;
  in_parallel(count, [&](std::size_t begin, std::size_t end) {
    Extent part;
    for (std::size_t i = begin; i != end; ++i) include(part, i);
    const std::lock_guard lock(joining);
    all = {std::min(all.least, part.least), std::max(all.most, part.most),
           all.finite && part.finite};
  });
  return all;
}

/// Which of all 8-bit colours there are, and for each the material.
class ColorSet {
 public:
  ColorSet() : words_(new std::atomic<std::uint64_t>[kColors / 64]()) {}

  void add(std::uint32_t rgb) {
    std::atomic<std::uint64_t>& word = words_[rgb / 64];
    const std::uint64_t bit = std::uint64_t{1} << (rgb % 64);
    if ((word.load(std::memory_order_relaxed) & bit) == 0)
      word.fetch_or(bit, std::memory_order_relaxed);
  }
  std::size_t count() const {
    std::size_t all = 0;
    for (std::size_t i = 0; i < kColors / 64; ++i)
      all += static_cast<std::size_t>(std::popcount(words_[i].load(std::memory_order_relaxed)));
    return all;
  }
  /// Once all are in: the materials, in the order of the colours.
  void add_materials(const Material& base, Scene& scene) {
    ranks_.resize(kColors / 64);
    for (std::size_t i = 0; i < ranks_.size(); ++i) {
      ranks_[i] = static_cast<std::uint32_t>(scene.materials.size());
      for (std::uint64_t word = words_[i].load(std::memory_order_relaxed); word != 0;
           word &= word - 1)
        add_material(
            base,
            static_cast<std::uint32_t>(i * 64) + static_cast<std::uint32_t>(std::countr_zero(word)),
            scene);
    }
  }
  std::uint32_t material_of(std::uint32_t rgb) const {
    const std::uint64_t below =
        words_[rgb / 64].load(std::memory_order_relaxed) & ((std::uint64_t{1} << (rgb % 64)) - 1);
    return ranks_[rgb / 64] + static_cast<std::uint32_t>(std::popcount(below));
  }

 private:
  std::unique_ptr<std::atomic<std::uint64_t>[]> words_;
  std::vector<std::uint32_t> ranks_;  ///< the material of a word's first colour
};

/// The nearest of 32 × 64 × 32 colours.
std::uint32_t rounded(std::uint32_t rgb) {
  const auto level = [&](int shift, std::uint32_t most) {
    const std::uint32_t channel = (rgb >> shift) & 255;
    return (channel * most + 127) / 255 * 255 / most;
  };
  return level(16, 31) << 16 | level(8, 63) << 8 | level(0, 31);
}

MaterialOf by_own_colors(const Particles& particles, const Material& base, Scene& scene) {
  const auto& colors = particles.colors;
  const Extent extent = extent_of(colors.size(), [&](Extent& part, std::size_t i) {
    for (const std::uint16_t channel : colors[i]) part.include(channel);
  });
  const double factor = (static_cast<double>(extent.most) > kColorUnit ? 1 : 255) / kColorUnit;
  const auto rgb_of = [&colors, factor](std::size_t i) {
    std::uint32_t rgb = 0;
    for (const std::uint16_t channel : colors[i])
      rgb = rgb << 8 | static_cast<std::uint32_t>(channel * factor + 0.5);
    return rgb;
  };
  const auto collect = [&](const auto& color_of) {
    auto set = std::make_shared<ColorSet>();
    in_parallel(colors.size(), [&](std::size_t begin, std::size_t end) {
      for (std::size_t i = begin; i != end; ++i) set->add(color_of(i));
    });
    return set;
  };
  auto set = collect(rgb_of);
  if (set->count() <= kMostMaterials) {
    set->add_materials(base, scene);
    return MaterialOf(
        [set, rgb_of](std::size_t i, std::uint32_t) { return set->material_of(rgb_of(i)); });
  }
  set = collect([&](std::size_t i) { return rounded(rgb_of(i)); });
  set->add_materials(base, scene);
  return MaterialOf(
      [set, rgb_of](std::size_t i, std::uint32_t) { return set->material_of(rounded(rgb_of(i))); });
}

Result<MaterialOf> by_column(const Particles& particles, const ParticleStyle& style,
                             const Material& base, const std::string& name, Scene& scene,
                             std::optional<ColorLegend>& legend) {
  constexpr std::uint32_t kSteps = 256;
  const std::vector<float>& values = particles.values;
  const Extent extent =
      extent_of(values.size(), [&](Extent& part, std::size_t i) { part.include(values[i]); });
  if (!extent.finite)
    return failure(name,
                   fmt::format("its column '{}' has numbers that are not finite", style.color_by));
  const std::array<double, 2> range = style.range.value_or(
      std::array{static_cast<double>(extent.least), static_cast<double>(extent.most)});
  const auto first = static_cast<std::uint32_t>(scene.materials.size());
  legend = {style.color_by, range[0], range[1], {}};
  for (std::uint32_t i = 0; i < kSteps; ++i) {
    legend->colors.push_back(color_at(style.color_map, i / (kSteps - 1.0)));
    add_material(base, legend->colors.back(), scene);
  }
  const double factor = range[1] > range[0] ? (kSteps - 1) / (range[1] - range[0]) : 0;
  return MaterialOf([&values, first, factor, range](std::size_t i, std::uint32_t) {
    const double step = (static_cast<double>(values[i]) - range[0]) * factor;
    return first + static_cast<std::uint32_t>(std::clamp(step, 0.0, kSteps - 1.0) + 0.5);
  });
}

MaterialOf by_species(const Particles& particles, const Material& base, Scene& scene) {
  std::vector<std::uint32_t> materials;
  std::size_t kinds = 0;
  for (const std::string& species : particles.species) {
    const Element* element = element_of_symbol(species);
    if (element == nullptr && particles.in_angstrom) element = element_of_label(species);
    materials.push_back(
        add_material(base, element != nullptr ? element->rgb : color_of_kind(kinds++), scene));
  }
  return MaterialOf([materials](std::size_t, std::uint32_t species) { return materials[species]; });
}

}  // namespace

Color linear_color(std::uint32_t rgb) {
  const auto channel = [&](int shift) { return decode_srgb(((rgb >> shift) & 255) / 255.0); };
  return {channel(16), channel(8), channel(0)};
}

Result<MaterialOf> color_particles(const Particles& particles, const ParticleStyle& style,
                                   const Material& base, std::uint32_t base_index,
                                   const std::string& name, Scene& scene,
                                   std::optional<ColorLegend>& legend) {
  if (style.one_material)
    return MaterialOf([base_index](std::size_t, std::uint32_t) { return base_index; });
  if (has_column(style)) return by_column(particles, style, base, name, scene, legend);
  if (style.color_by.empty() && !particles.colors.empty())
    return by_own_colors(particles, base, scene);
  return by_species(particles, base, scene);
}

}  // namespace zraka
