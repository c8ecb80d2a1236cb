// SPDX-License-Identifier: Apache-2.0
// The general engine: everything that scenes can have beyond the lab's: other lights, soft and
// transparent shadows, Fresnel, absorption, nested glass, dispersion, cut-off by contribution. The
// same flow as engine/trace_tile.hpp, level by level; rays find their hits in lanes, by the
// services of an instruction set, and what follows is computed hit by hit, here, once for all
// instruction sets. Geometry is computed in double, colours in the engine's own numbers: what is
// recorded of them folds to the picture's bits.
#pragma once

#include <cstdint>
#include <utility>
#include <vector>

#include "engine/engine.hpp"
#include "engine/hit_services.hpp"

namespace zraka::general {

/// A body that a ray is inside of.
struct Medium {
  std::uint64_t body;
  std::int32_t material;
};

/// The bodies that a ray is inside of, in the order of entering. What would be one too many is
/// forgotten.
struct Inside {
  static constexpr int kMost = 8;
  std::int32_t count;  ///< beside the first of them
  Medium list[kMost];  ///< no values beyond `count`: rays are made by the million

  Inside() : count(0) {}
  Inside(const Inside& other) : count(0) { *this = other; }
  Inside& operator=(const Inside& other) {
    count = other.count;
    for (std::int32_t i = 0; i < count; ++i) list[i] = other.list[i];
    return *this;
  }

  bool has(std::uint64_t body) const {
    for (std::int32_t i = 0; i < count; ++i)
      if (list[i].body == body) return true;
    return false;
  }
  void enter(const Medium& medium) {
    if (count < kMost && !has(medium.body)) list[count++] = medium;
  }
  void leave(std::uint64_t body) {
    std::int32_t kept = 0;
    for (std::int32_t i = 0; i < count; ++i)
      if (list[i].body != body) list[kept++] = list[i];
    count = kept;
  }
};

enum class RayKind : std::uint8_t { camera, reflected, refracted };

/// What a ray carries besides origin and direction.
template <class R>
struct RayState {
  V3<R> share;   ///< of its colour in its parent's
  V3<R> weight;  ///< in the pixel's: the product of the shares on the way
  R cut;         ///< at most so much is missing of its colour, for children that were not traced
  std::uint32_t key;        ///< of its random numbers
  std::uint32_t sample;     ///< of its pixel
  std::int32_t wavelength;  ///< which of TraceSettings::wavelengths; -1: all
  RayKind kind;
  bool sees_cuts;  ///< those for the eye only, too
};

/// What the fold needs of a hit that may have children, and what explanations say of all.
template <class R>
struct HitState {
  V3<R> transmittance;  ///< of the way from the ray's origin, through what it is inside of
  V3<R> missing;  ///< per channel, at most: the shares of children not traced, times their most
  std::int32_t first_child, child_count;
  std::uint64_t body;
  bool enclosing;    ///< has an inside that rays can be in
  std::int32_t cap;  ///< the cut whose plane it lies in, where that has opened its body; -1: none
  R clear;           ///< what fog leaves of its colour over that length
  V3<R> beyond_reflected, beyond_refracted;  ///< the sky's, in place of children that are too deep
  // For explanations.
  V3<R> sum;  ///< local light and children, before clamping and transmittance
  std::int32_t material;
  double cosine, ratio, quarter_d, fresnel;
  std::int32_t medium;           ///< whose inside the ray came through: a material; -1: none
  double n1, n2;                 ///< what ratio is the quotient of; 1 where unknown
  V3<R> k1, k2;                  ///< before Fresnel
  V3<R> reflection, refraction;  ///< the children's shares
  bool refracts, total, reflected_cut, refracted_cut, split;
};

/// One light's terms at a hit, the sums over its samples.
template <class R>
struct LightTerms {
  V3<R> diffuse, specular;
  std::int32_t samples;
};

/// For explanations: one light's effect on a hit, all samples together.
template <class R>
struct LightSum {
  V3<R> diffuse, specular;
  std::int32_t samples, facing, lit;  ///< all, those that face it, and are not wholly blocked
  // Of the first sample.
  V3<double> to_light;
  double distance, l_n, cosine, highlight;  ///< cosine: R·V or N·H
  V3<R> radiance;                           ///< what arrives without shadows
  V3<R> filter;                             ///< what shadows leave of it
};

/// A body that a shadow ray passes, or that stops it.
template <class R>
struct Passed {
  std::int32_t hit, sample;
  std::int32_t slot;  ///< -1: none, it is the light itself that is reached
  const HitPath* path;
  double distance;      ///< from the hit to where it is met
  V3<R> share;          ///< k2; 0 stops it
  double length;        ///< inside of what absorbs
  V3<R> transmittance;  ///< of that length
};

template <class R>
struct GeneralWorkspace;

/// Who explains is told what the steps compute.
template <class R>
class Listener {
 public:
  virtual ~Listener() = default;
  virtual void at_hits(const Level<R>& level, const Scratch<R>& scratch,
                       const GeneralWorkspace<R>& workspace, const V3<R>* occlusion) = 0;
  virtual void at_passed(const Passed<R>& passed) = 0;
  virtual void at_light(std::int32_t light, const Level<R>& level, const LightSum<R>* sums) = 0;
  virtual void at_children(const Level<R>& level, const Level<R>& next,
                           const GeneralWorkspace<R>& workspace) = 0;
  virtual void at_fold(const Level<R>& level, const GeneralWorkspace<R>& workspace) = 0;
  bool stop = false;  ///< no more levels, the rest is not wanted
};

/// What waits for its shadow ray, which stands in the scratch's arrays under the same number.
template <class R>
struct Waiting {
  std::vector<double> l_n;
  std::vector<R> strength;           ///< what distance and cone leave of the light
  std::vector<double> highlight;     ///< where its hit shines at all
  std::vector<std::int32_t> sample;  ///< of a light's; where somebody listens
  /// What SampleKeys points to, of samples that have not been drawn yet.
  std::vector<std::uint32_t> shuffle, u, v, number;

  void resize(std::size_t size) {
    l_n.resize(size), strength.resize(size), highlight.resize(size), sample.resize(size);
    shuffle.resize(size), u.resize(size), v.resize(size), number.resize(size);
  }
};

/// A shadow ray on its way through what it may pass.
template <class R>
struct Walk {
  V3<R> origin;
  std::size_t entry;    ///< among those that wait
  double left, walked;  ///< how far to the light, and from the hit
};

/// What a walk remembers of its way, where that matters.
struct WalkHistory {
  Inside inside;
  std::vector<std::uint64_t> passed;  ///< that have taken their share, and triangles in front of it
  // Where there are cuts.
  V3<double> start, direction;
  bool sees_cuts = false;  ///< those for the eye only, too: it comes from a cap of such a one
  std::vector<std::pair<std::uint64_t, double>> entered;  ///< bodies, and how far from the hit
};

/// What the fold needs of all hits of a level's batch.
template <class R>
struct FoldColumns {
  std::vector<R> transmittance[3];    ///< HitState's, in scenes with media
  std::vector<R> clear;               ///< and with fog
  std::vector<std::int32_t> parents;  ///< hits that may have children: those with a HitState
};

/// Of hits whose children are found together, what Bends and GoingOn point to.
struct Spawning {
  static constexpr int kMost = 128;  ///< bends, and hits; they all stay near the processor
  static constexpr int kMostChildren = 2 * kMost;  ///< a reflected one a hit
  static constexpr int kPadding = static_cast<int>(kArrayPadding);
  static_assert(kMost >= kMaxWavelengths);
  std::int32_t hit[kMost + kPadding] = {};
  double n1[kMost + kPadding] = {}, n2[kMost + kPadding] = {}, by[kMost + kPadding] = {};
  double ratio[kMost + kPadding] = {}, quarter_d[kMost + kPadding] = {};
  double fresnel[kMost + kPadding] = {};
  std::int32_t child_hit[kMostChildren + kPadding] = {};
  double child_ratio[kMostChildren + kPadding] = {};
  double child_quarter_d[kMostChildren + kPadding] = {};
};

/// One thread's memory beside its Workspace.
template <class R>
struct GeneralWorkspace {
  std::vector<std::vector<RayState<R>>> rays;  ///< by level
  std::vector<std::vector<HitState<R>>> hits;
  std::vector<std::vector<Inside>> insides;  ///< of the rays, in scenes with media
  std::vector<FoldColumns<R>> columns;
  std::vector<LightTerms<R>> lit;
  std::vector<LightSum<R>> sums;  ///< where somebody listens
  /// What ArrivingLight points to, and by shadow ray what is in the light's direction.
  std::vector<double> distance, strength, l_n, cosine, highlight;
  std::vector<std::int32_t> blocked_hits;  ///< Services::drop_blocked()
  std::vector<std::int32_t> absorbed;      ///< hits that rays come to through what absorbs
  std::vector<std::uint8_t> in_absorber;   ///< by hit, whether it is one of these
  std::vector<double> exponents, powers;   ///< of what media and fog leave
  Spawning spawning;
  std::vector<V3<R>> occlusion;
  std::vector<std::int32_t> samples;  ///< of occlusion, by hit
  std::vector<std::int32_t> caps;     ///< HitState::cap while hits are found
  std::size_t waiting = 0;            ///< shadow rays
  Waiting<R> of_waiting;              ///< of a light's
  bool by_highlight = false;          ///< some of them count only if their highlight does
  std::vector<V3<R>> filter;          ///< what shadows leave of each that waits; empty: all of it
  bool maybe_blocked = false;         ///< and nothing where Scratch::blocked says so
  std::vector<Walk<R>> walks;
  std::vector<WalkHistory> histories;     ///< of walks; as many as there have ever been at a time
  std::vector<std::int32_t> hit_of_walk;  ///< of a batch of walks; -1: none
  /// Rays on their way through what is transparent, and what they hit there.
  Level<R> through;
  Scratch<R> through_scratch;
  std::int32_t room;        ///< for rays on their way through
  std::size_t shadow_room;  ///< for what waits
  Inside at_eye;            ///< what the eye is inside of
  bool knows_eye = false;
  bool draws = false;       ///< anything at random: rays have keys
  bool has_groups = false;  ///< ways to hits lead through instances
  Listener<R>* listener = nullptr;
};

/// Traces the rays in level 0, as Kernel::trace_rays() does.
template <class R>
void trace_rays(const FrozenScene<R>& scene, const TraceSettings& settings,
                const Services<R>& services, Workspace<R>& workspace, GeneralWorkspace<R>& general,
                RayCounts& counts);

/// The most children that one hit can have.
int most_children(const TraceSettings& settings);

}  // namespace zraka::general
