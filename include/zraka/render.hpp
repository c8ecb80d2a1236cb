// SPDX-License-Identifier: Apache-2.0
// From a scene to a picture: options, progress, statistics.
#pragma once

#include <array>
#include <atomic>
#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <string_view>
#include <vector>
#include <zraka/api.hpp>
#include <zraka/diagnostic.hpp>
#include <zraka/image.hpp>
#include <zraka/layers.hpp>
#include <zraka/limits.hpp>
#include <zraka/scene.hpp>

namespace zraka {

/// The lab's seven stages, each with everything of the ones before (lab sheet, section 7).
enum class Stage { silhouette = 1, ambient, diffuse, specular, shadows, reflection, refraction };

inline constexpr std::array<std::string_view, 7> kStageNames = {
    "silhouette", "ambient", "diffuse", "specular", "shadows", "reflection", "refraction"};

/// The terms of light that a picture has.
struct Terms {
  bool silhouette = false;  ///< white where a ray hits; no other term counts then
  bool ambient = true;
  bool diffuse = true;
  bool specular = true;
  bool shadows = true;
  bool reflection = true;
  bool refraction = true;
  friend bool operator==(const Terms&, const Terms&) = default;
};
ZRAKA_API Terms terms_of(Stage stage);
/// The stage that has just these terms.
ZRAKA_API std::optional<Stage> stage_of(const Terms& terms);

/// What the profiles differ in; profile_of() holds the only table.
struct Profile {
  bool pixel_centers = true;  ///< rays through pixel centres, else through upper left corners
  /// One ray more in each direction, and a pixel is the mean of its four corners.
  bool average_corners = false;
  bool clamp_levels = false;    ///< each component clamped to 0…1 at every level of the ray tree
  bool index_is_ratio = false;  ///< Material::ior is n1/n2 on entry, else the inside's index
  bool mirror_when_total =
      true;  ///< total internal reflection reflects k2's share, else it is black
  Transfer transfer = Transfer::srgb;
  /// Transparent shadows: every surface takes its share of the light, not every body.
  bool filter_surfaces = false;
  bool sky_beyond = false;  ///< rays too deep to be traced have the sky's colour, not black
};
ZRAKA_API Profile profile_of(ProfileName name);
ZRAKA_API std::string_view name_of(ProfileName name);
ZRAKA_API std::optional<ProfileName> profile_named(std::string_view name);

/// Ways to compute, all with the same bits; `oracle` computes in double, one ray at a time, for
/// tests: only builds that have these have it, and others fail where it is asked for.
enum class Isa { avx512, avx2, portable, oracle };
ZRAKA_API std::string_view name_of(Isa isa);
/// By its name in any case, with hyphens or without.
ZRAKA_API std::optional<Isa> isa_named(std::string_view name);
/// Those that this build and this machine have, the fastest first; never empty, never `oracle`.
ZRAKA_API std::vector<Isa> available_isas();

/// Columns [x, x + width), rows [y, y + height).
struct PixelRect {
  std::uint32_t x = 0, y = 0, width = 0, height = 0;
  friend bool operator==(const PixelRect&, const PixelRect&) = default;
};

struct RenderOptions {
  Terms terms{};
  Profile profile = profile_of(ProfileName::physical);
  int max_depth = 4;                  ///< levels of rays after the first: 0…kMaxDepth
  Shadows shadows = Shadows::opaque;  ///< off as without Terms::shadows
  double min_contribution = 0;        ///< RenderDefaults::min_contribution
  int wavelengths = 12;               ///< 1…kMaxWavelengths
  Sampling sampling{};
  /// Only this part of the picture, with the bits that the whole one has there.
  std::optional<PixelRect> crop{};
  /// What Rendering::layers shall hold besides: of one ray through each pixel, its centre, or its
  /// corner where the profile says so, however many samples the picture has.
  LayerSet layers{};
  /// No light comes from where a ray from the eye hits nothing: the picture's colours are
  /// multiplied by channel A of its layers, which says how much of each pixel is covered.
  bool transparent = false;
  /// Width in pixels, 0…kMaxOutlines, of black lines over what has been rendered, where one ray
  /// through each pixel finds another object, another depth or an edge next to it. 0: none.
  int outlines = 0;
  int threads = 0;  ///< 0: as many as the machine has
  /// May each thread, the caller's too, be bound to a processor while it works? Faster in a program
  /// that does nothing else meanwhile.
  bool bind_threads = false;
  int tile = 0;              ///< side of a tile in pixels, 1…kMaxTile; 0: chosen
  std::optional<Isa> isa{};  ///< none: ZRAKA_ISA from the environment, else the fastest
  /// Set from any thread, it ends the render early; the result is then a failure.
  const std::atomic<bool>* cancel = nullptr;
  /// Called from worker threads after each tile: (pixels done, pixels, rays so far). It must not
  /// throw.
  std::function<void(std::uint64_t, std::uint64_t, std::uint64_t)> progress{};
};

/// Rays of each kind and how many of them (shadow rays aside) hit a shape. Camera rays are those
/// that the picture asks for; where no shape can be seen, they are answered without being traced.
struct RayCounts {
  std::uint64_t camera = 0, shadow = 0, reflected = 0, refracted = 0, hits = 0;
  std::uint64_t cut = 0;  ///< rays not traced for their contribution
  std::uint64_t total() const { return camera + shadow + reflected + refracted; }
};

struct RenderStats {
  double build_seconds = 0;  ///< from scene to what the engine reads
  double render_seconds = 0;
  RayCounts rays;
  double samples_per_pixel = 1;  ///< on average
  std::uint64_t scene_bytes = 0;
  std::uint64_t accel_bytes = 0;
  int threads = 0;
  Isa isa = Isa::portable;
  /// What rays not traced can have taken from any pixel, at most, and from all in the mean.
  double most_cut = 0, mean_cut = 0;
};

struct Rendering {
  Image image;
  /// How many samples each pixel has had, row by row; empty where all have had as many.
  std::vector<std::uint32_t> samples;
  RenderStats stats;
  Layers layers;  ///< those that were asked for
};

/// Renders a scene. The bits of picture and layers depend on scene, terms, profile, depth and
/// sampling, and on nothing else; a crop has those of its part. Fails on options out of range, an
/// instruction set that is not there, a scene that is inconsistent (see check()), and on
/// cancellation.
ZRAKA_API Result<Rendering> render(const Scene& scene, const RenderOptions& options = {});
/// The same for a scene that nobody needs any more: its memory is free before the hierarchy's is
/// taken.
ZRAKA_API Result<Rendering> render(Scene&& scene, const RenderOptions& options = {});

/// Problems of a scene that a program, not a reader, has put together: unknown materials, radii of
/// 0 or less, values that are not finite, a picture without pixels. Empty when all is well.
ZRAKA_API Diagnostics check(const Scene& scene);

}  // namespace zraka
