// SPDX-License-Identifier: Apache-2.0
// What cuts have taken away of shapes, and the caps that close what they have opened.
#pragma once

#include <cstdint>
#include <limits>
#include <vector>

#include "engine/general/steps.hpp"

namespace zraka::general {

/// The part of a ray where something is left, from `enter` to `leave` along it, and the cuts that
/// bound it; nothing where it leaves before it enters.
struct KeptPart {
  double enter = -std::numeric_limits<double>::infinity();
  double leave = std::numeric_limits<double>::infinity();
  std::int32_t at_enter = -1, at_leave = -1;
  bool is_empty() const { return !(enter < leave); }
};

/// Of a material; of nullptr, the part where not everything is taken away. Cuts for the eye only
/// count where a ray sees all of them.
KeptPart kept_part(const FrozenOptics& optics, const OpticalMaterial* material,
                   const V3<double>& origin, const V3<double>& direction, bool sees_all);

/// Whether a point of a surface is taken away.
bool is_cut(const FrozenOptics& optics, const OpticalMaterial& material, const V3<double>& point,
            bool sees_all);

/// Whether what has been hit is a body that caps close: one with an inside that does not reach
/// into infinity.
template <class R>
bool is_solid(const FrozenScene<R>& scene, const HitPath& path);

/// Copies hit `from` of one scratch to hit `to` of another.
template <class R>
void copy_hit(const Scratch<R>& source, std::size_t from, Scratch<R>& target, std::size_t to);

/// Lets rays go on, through what is cut away, to the first that is left of a surface, or to a cap.
///
/// Of a body that caps close, what is left is its inside without the half-spaces that are taken
/// away; the cap is the part of their planes that is in it. Whether the plane is in a body, the
/// body's next surface tells: seen from inside, it has been in there since the ray has come in. So
/// rays are followed behind the plane as far as the largest body reaches. Where several bodies
/// have a cap in one place, it is that of the highest priority, then of the smallest, then of the
/// first in the scene: onions show their layers, and it is no matter from where one looks.
template <class R>
class CutWalks {
 public:
  /// `rays` are the level's, and nullptr if all come from the eye.
  CutWalks(const FrozenScene<R>& scene, const Services<R>& services, Level<R>& level,
           Scratch<R>& scratch, GeneralWorkspace<R>& general, const RayState<R>* rays);

  /// A hit that has been found by shapes alone, or that of a ray that goes on behind it.
  void add_hit(std::size_t h);
  void add_onward(std::size_t h);
  /// Finds them all: hits, and in general.caps the cuts of those that are caps. Of rays that leave
  /// everything the slot becomes -1.
  void run();

 private:
  struct Entered {
    std::uint64_t body;
    double at;
  };
  struct Walk {
    std::size_t h, ray;  ///< the ray's index in the level
    V3<double> start, direction, origin;
    bool sees_all;
    double passed = 0;  ///< caps nearer than that are behind it
    double at = 0;      ///< how far it has been followed
    double nearest = std::numeric_limits<double>::infinity();  ///< what has been found
    // Of the cap that is nearest.
    bool is_cap = false;
    double size = 0;
    int priority = 0;
    std::int64_t id = 0;
    std::vector<Entered> entered{};
  };

  Walk walk_of(std::size_t h) const;
  bool goes_on(Walk& walk) const;
  void meet(Walk& walk, const Scratch<R>& found, std::size_t i, std::int32_t slot);
  void meet_solid(Walk& walk, const Scratch<R>& found, std::size_t i, std::int32_t slot);
  void take_cap(Walk& walk, const Scratch<R>& found, std::size_t i, std::int32_t slot,
                std::int32_t cut, double at, bool enters);
  double size_of(const HitPath& path) const;
  std::int64_t id_of(const HitPath& path) const;
  void follow(const std::vector<Walk*>& walks, std::vector<Walk*>& still);

  const FrozenScene<R>& scene_;
  const FrozenOptics& optics_;
  const Services<R>& services_;
  Level<R>& level_;
  Scratch<R>& scratch_;
  GeneralWorkspace<R>& general_;
  const RayState<R>* rays_;
  std::vector<Walk> walks_;
};

/// Leaves out the hits whose rays have none any more.
template <class R>
void drop_lost_hits(Level<R>& level, Scratch<R>& scratch, std::vector<std::int32_t>& caps);

/// Of rays that all come from the eye, the first hits that cuts leave. For a scene that has some.
template <class R>
void find_uncut_hits(const FrozenScene<R>& scene, const Services<R>& services, Level<R>& level,
                     Scratch<R>& scratch, GeneralWorkspace<R>& general);

}  // namespace zraka::general
