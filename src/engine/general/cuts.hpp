// SPDX-License-Identifier: Apache-2.0
// What cuts have taken away of shapes, and the caps that close what they have opened.
#pragma once

#include <cmath>
#include <limits>

#include "engine/general/steps.hpp"

namespace zraka::general {

inline bool concerns(const OpticalCut& cut, const OpticalMaterial& material, bool from_eye) {
  return (cut.group == 0 || cut.group == material.cut_group) && (from_eye || !cut.eye_only);
}

/// Whether a point of a surface is taken away for rays from the eye, or for others.
inline bool is_cut(const FrozenOptics& optics, const OpticalMaterial& material,
                   const V3<double>& point, bool from_eye) {
  for (int i = 0; i < optics.cut_count; ++i)
    if (concerns(optics.cuts[i], material, from_eye) &&
        dot(optics.cuts[i].normal, point) > optics.cuts[i].distance)
      return true;
  return false;
}

/// How far it is along a ray to where something is left, if its origin is where everything is
/// taken away: infinite where it never gets there, else 0.
inline double way_out(const FrozenOptics& optics, const V3<double>& origin,
                      const V3<double>& direction, bool from_eye) {
  double far = 0;
  for (int i = 0; i < optics.cut_count; ++i) {
    const OpticalCut& cut = optics.cuts[i];
    if (cut.group != 0 || (cut.eye_only && !from_eye)) continue;
    const double before = dot(cut.normal, origin) - cut.distance;
    if (!(before > 0)) continue;
    const double change = dot(cut.normal, direction);
    if (!(change < 0)) return std::numeric_limits<double>::infinity();
    far = std::fmax(far, before / -change);
  }
  return far;
}

/// A ray that was in what is taken away and meets a body's surface from inside has come into the
/// body where it left that: the hit moves there, if the cut is closed by a cap. What is left of a
/// scene is convex, so the last of the cuts' planes on the way is the one.
template <class R>
bool put_cap(const Batch<R>& batch, std::size_t h) {
  if (!batch.from_inside(h) || !has_inside(batch.scene, batch.scratch.paths[h])) return false;
  const FrozenOptics& optics = batch.optics();
  const auto ray = static_cast<std::size_t>(batch.level.done + batch.level.hits.ray[h]);
  const V3<double> origin =
      three(batch.level.rays.ox, batch.level.rays.oy, batch.level.rays.oz, ray);
  const V3<double> way = batch.point(h) - origin;
  const bool from_eye = batch.rays[ray].kind == RayKind::camera;
  const OpticalCut* last = nullptr;
  double share = 0;
  for (int i = 0; i < optics.cut_count; ++i) {
    const OpticalCut& cut = optics.cuts[i];
    if (!concerns(cut, batch.material(h), from_eye)) continue;
    const double before = dot(cut.normal, origin) - cut.distance, change = dot(cut.normal, way);
    if (!(before > 0) || !(change < 0)) continue;
    const double at = -before / change;
    if (at <= share) continue;
    share = at;
    last = &cut;
  }
  if (last == nullptr || !last->caps) return false;
  Scratch<R>& s = batch.scratch;
  const V3<double> point = origin + way * share;
  s.px[h] = static_cast<R>(point.x), s.py[h] = static_cast<R>(point.y);
  s.pz[h] = static_cast<R>(point.z);
  s.nx[h] = static_cast<R>(last->normal.x), s.ny[h] = static_cast<R>(last->normal.y);
  s.nz[h] = static_cast<R>(last->normal.z);
  s.inside[h] = R(0);
  s.t[batch.level.hits.ray[h]] = static_cast<R>(length(way) * share);
  return true;
}

}  // namespace zraka::general
