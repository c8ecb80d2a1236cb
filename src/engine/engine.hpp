// SPDX-License-Identifier: Apache-2.0
// What render/ sees of the engine: settings and memory to give it, a function per instruction set
// to call.
#pragma once

#include <cstddef>
#include <cstdint>
#include <zraka/render.hpp>

#include "engine/hit_path.hpp"
#include "sampling/pixel_filter.hpp"
#include "sampling/sobol.hpp"
#include "scene/frozen.hpp"

namespace zraka {

/// Into what a ray splits that a dispersive body refracts: the middles of equal parts of the
/// visible spectrum, and how much of each channel comes from each part; of all together 1.
struct Wavelengths {
  int count = 0;
  double um[kMaxWavelengths];          ///< in micrometres
  float weight[kMaxWavelengths][3];
};

/// Everything besides the scene that a pixel's colour depends on.
struct TraceSettings {
  Terms terms;
  int max_depth = 4;
  bool clamp_levels = false;
  bool mirror_when_total = true;
  bool sky_beyond = false;  ///< Profile's
  /// For kernels whose rules vary: which of their variations, 0 for none.
  int variation = 0;
  float unit = 1;  ///< length of the engine's unit in the scene's
  // Of the general engine.
  bool transparent_shadows = false;
  bool filter_surfaces = false;  ///< Profile's
  double min_contribution = 0;
  // Of the general engine, for lessons on what these rules are for.
  bool filter_first_only = false;  ///< behind what filters a shadow ray first nothing counts
  bool cut_by_share = false;       ///< min_contribution is that of a ray's own share
  double brightest = 0;  ///< no ray brings more, by any channel
  std::uint32_t seed = 0;
  Wavelengths wavelengths{};
};

/// A rectangle of pixels: columns [x, x + width), rows [y, y + height).
struct TileRect {
  std::int32_t x, y, width, height;
};

/// Arrays start and end on cache lines, and have room for one store of any width past their last
/// value.
inline constexpr std::size_t kArrayPadding = 16;

/// Rays of one level, waiting for their colour. Structure of arrays, 2·batch values each.
template <class R>
struct RayArrays {
  R *ox, *oy, *oz;  ///< origin
  R *dx, *dy, *dz;  ///< direction, unit length
  R *r, *g, *b;     ///< colour, once it is known
  /// The cone around a ray that holds what its pixel sees (Amanatides, "Ray Tracing with Cones",
  /// 1984): how wide it is at the origin and how much it widens per unit, both with a sign; and how
  /// far the way from the eye to the origin is. nullptr where the scene has no textures.
  R *width, *spread, *travelled;
};

/// What the fold needs of the hits of one batch. Structure of arrays, batch values each.
template <class R>
struct HitArrays {
  std::int32_t* ray;                    ///< which ray of the level
  R *r, *g, *b;                         ///< local light
  R *reflection, *refraction;           ///< shares of the children
  std::int32_t *reflected, *refracted;  ///< which rays of the next level; -1: none
};

/// One level of the ray trees: its rays in batches, of which one at a time has children below.
template <class R>
struct Level {
  RayArrays<R> rays;
  HitArrays<R> hits;
  std::int32_t ray_count;
  std::int32_t done;       ///< rays whose colour is known
  std::int32_t in_batch;   ///< rays after those that are being traced
  std::int32_t hit_count;  ///< of the batch
};

/// What is computed for a batch and not needed for the fold. Structure of arrays, batch values
/// each.
template <class R>
struct Scratch {
  R* t;                ///< distance to the nearest hit, by ray
  std::int32_t* slot;  ///< its primitive, by ray; -1: none
  R *px, *py, *pz;     ///< the rest by hit: point
  R *nx, *ny, *nz;     ///< unit normal towards the viewer
  R *vx, *vy, *vz;     ///< unit direction to the viewer
  R* offset;           ///< how far along the normal the next rays start
  R* mirror_side;      ///< 1 where reflected rays start before the surface, -1 behind it
  R* inside;           ///< 1 where the ray hit the surface from inside, else 0
  std::int32_t* material;
  /// Rows of kMaterialReals, and by hit which one holds its coefficients: the materials', or where
  /// textures give some of them a row for each hit.
  const R* coefficients;
  const std::int32_t* row;
  R* own_rows;           ///< the rows for each hit; this and what follows is nullptr where the
  std::int32_t* own_row;  ///< scene has no textures: 0, 1, 2…
  HitPath* paths;
  HitCone* cones;
  TexturePoint* points;  ///< where they are for textures; kept for explanations alone
  /// Explanations read the points: all of them are found out, also what no texture asks for.
  bool explained;
  R *smooth_x, *smooth_y, *smooth_z;  ///< normals before textures bend them, where recorded
  R *lx, *ly, *lz;  ///< unit direction to the light at hand
  R* lit;           ///< 1 where the light at hand reaches the hit, else 0
  R* strength;      ///< what is left of the light at hand, where its light fades
  /// By shadow ray; in the general engine origins are by hit.
  R *sox, *soy, *soz, *sdx, *sdy, *sdz, *sdistance;
  std::int32_t* shadow_ray_hit;
  /// By shadow ray, for the general engine, else nullptr: which part of all directions it goes to,
  /// and whether it is blocked. And the order in which they are traced.
  std::int32_t *part, *blocked, *shadow_order;
};

/// Which sample of which pixel a ray of level 0 is.
struct CameraSample {
  std::int32_t x, y;
  std::uint32_t number;
};

/// One thread's memory, made once and used for tile after tile (render/workspace.hpp).
template <class R>
struct Workspace {
  Level<R>* levels;  ///< max_depth + 1
  Scratch<R> scratch;
  std::int32_t batch;  ///< at least the pixels of a tile
  CameraSample* samples;  ///< of level 0's rays, for trace_rays()
};

/// What the steps compute on their way and keep nowhere else, by hit. A vector or a colour takes
/// three.
enum class Quantity {
  // Once for each light. The diffuse and the specular term are those of the lit hits only.
  to_light,  ///< L, unit length
  light_distance = to_light + 3,
  l_n,                     ///< L·N
  strength,                ///< what is left of the light, if it is one that fades
  diffuse,                 ///< what is added: Ii·kd·(L·N)
  mirrored = diffuse + 3,  ///< R, the mirror of L about N
  r_v = mirrored + 3,      ///< R·V
  shines,                  ///< 1 where the specular term counts, else 0
  highlight,               ///< (R·V)^n
  specular,                ///< what is added: Ii·ks·(R·V)^n
  // Once for each hit, where rays are refracted (sheet 3.5).
  cosine = specular + 3,  ///< U·N, of all hits that may have children
  ratio,                  ///< b = n1/n2
  quarter_d,              ///< D/4; negative: total internal reflection
  along_normal,           ///< a
  // Once for each hit.
  unclamped,  ///< C before it is clamped
  count = unclamped + 3
};

/// Where a Record puts the terms, and whom it tells: one batch at a time, in the order of tracing.
template <class R>
struct Recording {
  R* terms[static_cast<int>(Quantity::count)];  ///< batch values each
  R* blocker_t;           ///< by shadow ray: distance to the nearest shape before the light
  std::int32_t* blocker;  ///< by shadow ray: its slot; -1: none
  HitPath* blocker_path;  ///< by shadow ray: the way to it, in scenes with bodies; nullptr: unasked
  bool stop = false;      ///< set by the reader: no more levels, the rest is not wanted

  void* reader;
  /// Nearest hits and surfaces of the level's batch are known; level.hits has the ambient terms.
  void (*at_hits)(void* reader, const Level<R>& level, const Scratch<R>& scratch);
  /// So are a light's terms; scratch.lit and the shadow rays are that light's.
  void (*at_light)(void* reader, std::int32_t light, std::size_t shadow_rays, const Level<R>& level,
                   const Scratch<R>& scratch);
  /// Shares and indices of the children in `next` are known. Not called where a batch has none.
  void (*at_children)(void* reader, const Level<R>& level, const Level<R>& next);
  /// The level's batch has its colours: the rays [done - in_batch, done).
  void (*at_fold)(void* reader, const Level<R>& level);
};

/// What samples are drawn from, an array each: Sobol2's keys, and which point of the sequence.
struct SampleKeys {
  const std::uint32_t *shuffle, *u, *v, *number;
};

/// Samples of one pixel, `count` of them from number `first` of its sequence on, for the places
/// from `begin` on.
struct SampleRun {
  double column, row;  ///< of the pixel
  std::uint32_t shuffle, u, v, first, count, begin;
};

/// Samples that have been drawn, run by run, and room for what each of them is drawn from.
struct SampleRuns {
  const SampleRun* runs;
  std::size_t count;
  std::uint32_t *shuffle, *u, *v, *number;
};

/// What arrives at hits from a light that is no surface, a number each; directions to it stand in
/// Scratch::lx, ly and lz.
struct ArrivingLight {
  double *distance, *strength;
  double* l_n;     ///< L·N
  double* cosine;  ///< of a spot: between its axis and the way from it
  double* highlight = nullptr;  ///< HitServices::find_shines()
};

/// What arrives of many samples of a light that is a surface: places for a number each, and for
/// kArrayPadding more.
template <class R>
struct ArrivingSamples {
  R *dx, *dy, *dz;  ///< unit direction to the light
  R* distance;      ///< at most kFarthest
  R* strength;
  double* l_n;  ///< L·N
};

/// As far as shadow rays of no end go.
inline constexpr double kFarthest = 0x1p100;

/// No highlight: (1 - x)·n is so large that x^n is below 2^-40, for ln x ≤ x - 1.
inline constexpr double kNoHighlight = 27.73;
/// In place of a highlight: R·V or N·H is below 0; or it is to be asked for by itself.
inline constexpr double kFacesAway = -1, kUnknownHighlight = -2;

template <class R>
struct HitServices;
struct HitsOfMaterial;
/// Finds what the textures of hits give (engine/texturing.hpp): writes it into scratch.own_rows,
/// which has the material's coefficients, and the widths of cones into scratch.cones.
template <class R>
using ColorHits = void(const HitsOfMaterial& hits, const Level<R>& level, Scratch<R>& scratch);

/// What is asked of an instruction set beside whole tiles.
template <class R>
struct Services {
  /// The hits of a level's batch and their surfaces, as the kernel finds them.
  void (*find_hits)(const FrozenScene<R>& scene, Level<R>& level, Scratch<R>& scratch);
  /// Which of the first n shadow rays meet a shape before their end: scratch.blocked, 1 or 0.
  void (*find_blocked)(const FrozenScene<R>& scene, std::size_t n, Scratch<R>& scratch);
  /// The same of rays that go the same way as those in front of them.
  void (*find_blocked_as_listed)(const FrozenScene<R>& scene, std::size_t n, Scratch<R>& scratch);
  /// The same for rays of which many begin at each hit, one hit's after the other's, and which all
  /// look equally far.
  void (*find_blocked_from_points)(const FrozenScene<R>& scene, std::size_t n,
                                   Scratch<R>& scratch);
  /// So many rays over the hemisphere around a normal, by the cosine: points of a sequence from
  /// `first` on. To the directions of shadow rays from number `at` on.
  void (*make_hemisphere)(const Sobol2& points, std::uint32_t first, std::size_t count,
                          const V3<R>& normal, std::size_t at, Scratch<R>& scratch);
  /// Of n hits, what arrives from a light that is no surface.
  void (*find_arriving)(const OpticalLight& light, std::size_t n, Scratch<R>& scratch,
                        const ArrivingLight& arriving);
  /// What arrives of n samples of a light that is a surface, each at a hit of the scratch's. The
  /// arrays that are read have kArrayPadding more places, with any values.
  void (*sample_light)(const OpticalLight& light, const SampleKeys& keys, const std::int32_t* hit,
                       std::size_t n, const Scratch<R>& scratch, const ArrivingSamples<R>& to);
  /// Of the first n shadow rays, (R·V)^n or (N·H)^n at their hits.
  void (*find_highlights)(std::size_t n, const Scratch<R>& scratch, double* highlights);
  /// Rays from the eye through n places in the picture: with a filter those of the runs' samples,
  /// else those that stand where their directions will, columns in x and rows in y.
  void (*make_window_rays)(const FrozenCamera<R>& camera, const InverseFilter* filter,
                           const SampleRuns& runs, std::size_t n, RayArrays<R>& rays,
                           std::uint8_t* negative);
  /// Of the first n hits in the list in scratch.shadow_ray_hit, takes those out whose way to the
  /// light the scene blocks, and puts them into another; scratch.lit is 0 there. Returns how many
  /// are left. Rays go from scratch.sox along scratch.lx as far as scratch.sdistance, by hit.
  std::size_t (*drop_blocked)(const FrozenScene<R>& scene, std::size_t n, Scratch<R>& scratch,
                              std::int32_t* blocked_hits);
  const HitServices<R>* hits;  ///< engine/hit_services.hpp
  ColorHits<R>* color_hits;
};

/// One way to compute, for render/ to pick.
template <class R>
struct Kernel {
  /// Traces a tile; the linear colours go to pixels[(row·stride + column)·3], counted from the
  /// tile's upper left corner.
  void (*trace_tile)(const FrozenScene<R>& scene, const TraceSettings& settings,
                     const TileRect& tile, Workspace<R>& workspace, RayCounts& counts,
                     float* pixels, std::size_t stride);
  /// Traces the rays that stand in level 0: at most a batch of them, with their origins, unit
  /// directions and samples, in textured scenes their cones' widths and spreads, too. Their colours
  /// are there afterwards.
  void (*trace_rays)(const FrozenScene<R>& scene, const TraceSettings& settings,
                     Workspace<R>& workspace, RayCounts& counts);
  const Services<R>* services;
  int lanes;
};

/// trace_tile() of a Kernel by the same steps, which tell their terms.
template <class R>
using RecordTile = void(const FrozenScene<R>& scene, const TraceSettings& settings,
                        const TileRect& tile, Workspace<R>& workspace, RayCounts& counts,
                        float* pixels, std::size_t stride, Recording<R>& recording);

/// trace_rays() of a Kernel that tells its terms, too.
template <class R>
using RecordRays = void(const FrozenScene<R>& scene, const TraceSettings& settings,
                        Workspace<R>& workspace, RayCounts& counts, Recording<R>& recording);

// Defined by kernel.cpp, once per instruction set that the build has; and by record_kernel.cpp.
namespace isa_avx512 {
extern const Services<float> kServices;
extern const Kernel<float> kKernel;
}
namespace isa_avx2 {
extern const Services<float> kServices;
extern const Kernel<float> kKernel;
}
namespace isa_portable {
extern const Services<float> kServices;
extern const Kernel<float> kKernel;
RecordTile<float> record_tile;
RecordRays<float> record_rays;
}  // namespace isa_portable
namespace isa_oracle {
extern const Services<double> kServices;
extern const Kernel<double> kKernel;
}

}  // namespace zraka
