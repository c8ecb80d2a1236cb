// SPDX-License-Identifier: Apache-2.0
// Explains pixels: their ray trees, and what the depth cuts off.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <new>
#include <zraka/explain.hpp>

#include "explain/hit_reader.hpp"
#include "explain/tile_listeners.hpp"
#include "explain/tree_reader.hpp"
#include "render/corners.hpp"
#include "render/outlines.hpp"
#include "render/workspace.hpp"

namespace zraka {
namespace {

/// Into a transparent body and out of it.
constexpr int kLevelsBeyond = 2;

/// Finds out what the rays would bring that the depth cuts off.
void look_beyond(const Stand& stand, std::uint32_t x, std::uint32_t y, std::uint32_t sample,
                 RayTree& tree) {
  const auto is_cut = [](const ExplainedRay& ray, const Child& child, float share) {
    return child.absence == Absence::depth &&
           std::fabs(ray.weight * static_cast<double>(share)) >= kNotableWeight;
  };
  const bool any = std::any_of(tree.rays.begin(), tree.rays.end(), [&](const ExplainedRay& ray) {
    return ray.hit && (is_cut(ray, ray.hit->reflected, ray.hit->k1) ||
                       is_cut(ray, ray.hit->refracted, ray.hit->k2));
  });
  if (!any) return;
  TraceSettings settings = stand.settings;
  settings.max_depth += kLevelsBeyond;
  // Its first levels are the same rays in the same order. One that is too large says nothing.
  const Result<RayTree> deeper = read_tree(stand, settings, x, y, sample);
  if (!deeper) return;
  for (std::size_t r = 0; r < tree.rays.size(); ++r) {
    if (!tree.rays[r].hit) continue;
    const auto look = [&](Child& child, const Child& followed, float share) {
      if (is_cut(tree.rays[r], child, share) && followed.ray >= 0)
        child.beyond = deeper->rays[static_cast<std::size_t>(followed.ray)].color;
    };
    ExplainedHit& hit = *tree.rays[r].hit;
    look(hit.reflected, deeper->rays[r].hit->reflected, hit.k1);
    look(hit.refracted, deeper->rays[r].hit->refracted, hit.k2);
  }
}

/// The most samples that a pixel has.
std::uint32_t samples_of(const Sampling& sampling) {
  const auto count = static_cast<std::uint32_t>(
      sampling.kind == Sampling::Kind::adaptive ? sampling.most : sampling.count);
  return sampling.kind == Sampling::Kind::grid ? count * count : count;
}

/// Whether an outline goes over a pixel.
bool is_outlined(const Stand& stand, std::uint32_t x, std::uint32_t y) {
  if (stand.options.outlines == 0 || stand.variation.kernel != nullptr) return false;
  const TileRect pixel{static_cast<std::int32_t>(x), static_cast<std::int32_t>(y), 1, 1};
  const PictureJob<float> job{stand.frozen(),
                              *stand.kernel,
                              stand.settings,
                              stand.options,
                              stand.scene.resolution,
                              pixel,
                              std::min(stand.options.outlines + 1, kMaxTile),
                              1};
  std::vector<bool> lines;
  return find_outlines<float>({&stand.scene, stand.prepared, job}, pixel, lines) && lines[0];
}

/// All of a pixel: one tree, or those of its four corners and their mean; or one sample.
Result<Explanation> read_pixel(const Stand& stand, std::uint32_t x, std::uint32_t y,
                               std::uint32_t sample) {
  Explanation explanation{.x = x,
                          .y = y,
                          .resolution = stand.scene.resolution,
                          .terms = stand.options.terms,
                          .profile = stand.options.profile,
                          .max_depth = stand.options.max_depth,
                          .ambient_light = float3(stand.frozen().ambient_light),
                          .background = float3(stand.frozen().background),
                          .sky = stand.scene.sky.kind};
  for (std::size_t i = 0; i < stand.scene.lights.size(); ++i)
    explanation.lights.push_back({stand.scene.lights[i].position,
                                  float3(stand.frozen().lights[i].color), stand.scene.lights[i]});
  explanation.sample = sample;
  explanation.samples = samples_of(stand.options.sampling);
  explanation.general = stand.frozen().optics != nullptr;
  explanation.min_contribution = stand.settings.min_contribution;
  explanation.brightest = stand.settings.brightest;
  explanation.wavelengths = stand.settings.wavelengths.count;
  explanation.transparent_shadows = stand.settings.transparent_shadows;
  const std::uint32_t corners = has_corners(stand.frozen(), stand.options) ? 2 : 1;
  for (std::uint32_t j = 0; j < corners; ++j)
    for (std::uint32_t i = 0; i < corners; ++i) {
      Result<RayTree> tree = read_tree(stand, stand.settings, x + i, y + j, sample);
      if (!tree) return tl::make_unexpected(tree.error());
      look_beyond(stand, x + i, y + j, sample, *tree);
      explanation.trees.push_back(std::move(*tree));
    }
  explanation.color = explanation.trees[0].rays[0].color;
  if (corners > 1)
    for (std::size_t c = 0; c < 3; ++c) {
      const auto corner = [&](std::size_t i) { return explanation.trees[i].rays[0].color[c]; };
      explanation.color[c] = mean_of_corners(corner(0), corner(1), corner(2), corner(3));
    }
  explanation.outlined = is_outlined(stand, x, y);
  if (!stand.variation.rules.key.empty()) explanation.varied = stand.variation.rules;
  if (stand.variation.vary_image) {
    Image pixel(1, 1);
    std::copy(explanation.color.begin(), explanation.color.end(), pixel.pixels.begin());
    stand.variation.vary_image(pixel);
    std::copy_n(pixel.pixels.begin(), 3, explanation.color.begin());
  }
  return explanation;
}

Stand stand_for(const Scene& scene, RenderOptions options, Isa isa, const Variation& variation) {
  if (variation.vary_options) variation.vary_options(options);
  Scene varied;
  if (variation.vary_scene) variation.vary_scene(varied = scene);
  PreparedScene<float> prepared = variation.vary_scene ? prepare<float>(std::move(varied), options)
                                                       : prepare<float>(scene, options);
  const TraceSettings settings = settings_of(options, prepared, variation);
  return {scene,
          options,
          settings,
          std::move(prepared),
          variation.kernel == nullptr ? &kernel_of(isa) : &variation.kernel(isa),
          variation};
}

}  // namespace

struct Explainer::Impl {
  Stand stand;
};

Explainer::Explainer(std::unique_ptr<Impl> impl) : impl_(std::move(impl)) {}
Explainer::Explainer(Explainer&&) noexcept = default;
Explainer& Explainer::operator=(Explainer&&) noexcept = default;
Explainer::~Explainer() = default;

Result<Explainer> Explainer::create(const Scene& scene, const RenderOptions& options) {
  return varied_explainer(scene, options, {});
}

Result<Explainer> varied_explainer(const Scene& scene, const RenderOptions& options,
                                   const Variation& variation) {
  const Result<Isa> isa = isa_to_listen_to(scene, options);
  if (!isa) return tl::make_unexpected(isa.error());
  if (variation.kernel != nullptr && is_beyond_the_lab(scene, options)) return beyond_the_lab();
  RenderOptions asked = options;
  if (variation.kernel != nullptr) {
    asked.sampling = {};
    if (const Result<void> good = check_lesson(scene); !good)
      return tl::make_unexpected(good.error());
  }
  try {
    auto impl = std::unique_ptr<Explainer::Impl>(
        new Explainer::Impl{stand_for(scene, asked, *isa, variation)});
    if (is_cancelled(asked)) return failure("", "the explanation was cancelled");
    return Explainer(std::move(impl));
  } catch (const std::bad_alloc&) {
    return failure("", fmt::format("not enough memory for {} shapes", scene.shape_count()));
  }
}

Result<Explanation> Explainer::pixel(std::uint32_t x, std::uint32_t y, std::uint32_t sample) {
  const Resolution size = impl_->stand.scene.resolution;
  if (x >= size.width || y >= size.height)
    return failure("",
                   fmt::format("pixel ({}, {}) is outside of the picture of {}×{} pixels", x, y,
                               size.width, size.height),
                   fmt::format("columns go from 0 to {} from the left, rows from 0 to {} from the "
                               "top",
                               size.width - 1, size.height - 1));
  if (const std::uint32_t all = samples_of(impl_->stand.options.sampling); sample >= all)
    return failure("", all == 1
                           ? std::string("a pixel of this picture has one sample")
                           : fmt::format("a pixel of this picture has {} samples at most", all));
  try {
    return read_pixel(impl_->stand, x, y, sample);
  } catch (const std::bad_alloc&) {
    return failure("", fmt::format("not enough memory for the ray tree of pixel ({}, {})", x, y),
                   "ask for fewer levels with a smaller depth");
  }
}

Neighbourhood Explainer::around(std::uint32_t x, std::uint32_t y, std::uint32_t side) {
  const Stand& stand = impl_->stand;
  const Resolution size = stand.scene.resolution;
  const auto start = [&](std::uint32_t at, std::uint32_t all) {
    const std::uint32_t room = std::min(side, all);
    return std::min(at > room / 2 ? at - room / 2 : 0, all - room);
  };
  const std::uint32_t corner = stand.options.profile.average_corners ? 1 : 0;
  Neighbourhood found{start(x, size.width), start(y, size.height), {}};
  if (!stand.plain() || stand.options.outlines > 0) {
    RenderOptions options = stand.options;
    options.crop = {found.left, found.top, std::min(side, size.width), std::min(side, size.height)};
    options.progress = {};
    if (Result<Rendering> rendering = render(stand.scene, options))
      found.image = std::move(rendering->image);
    return found;
  }
  Image rays(std::min(side, size.width) + corner, std::min(side, size.height) + corner);
  const TileRect tile{static_cast<std::int32_t>(found.left), static_cast<std::int32_t>(found.top),
                      static_cast<std::int32_t>(rays.width),
                      static_cast<std::int32_t>(rays.height)};
  WorkspaceMemory<float> workspace(tile.width * tile.height, stand.settings.max_depth,
                                   stand.frozen().textures != nullptr);
  RayCounts counts;
  stand.kernel->trace_tile(stand.frozen(), stand.settings, tile, workspace.workspace(), counts,
                           rays.pixels.data(), rays.width);
  found.image = corner == 0 ? std::move(rays) : means_of_corners(std::move(rays));
  return found;
}

Result<Explanation> explain(const Scene& scene, const RenderOptions& options, std::uint32_t x,
                            std::uint32_t y) {
  Result<Explainer> explainer = Explainer::create(scene, options);
  if (!explainer) return tl::make_unexpected(explainer.error());
  return explainer->pixel(x, y);
}

}  // namespace zraka
