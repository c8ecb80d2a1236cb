// SPDX-License-Identifier: Apache-2.0
// What hits of one shape have in common, and hits that wait until as many of their material are
// together as are worth a call.
#pragma once

#include "accel/body_surface.hpp"
#include "engine/shape_spaces.hpp"
#include "engine/texturing.hpp"
#include "shapes/primitive_uv.hpp"
#include "textures/texture_set.hpp"

namespace zraka {

/// Of the shape of a hit, which is mostly that of the hit before: Object::transform, and the
/// curvature in the frame of the group that it stands in.
template <class R>
class LastShape {
 public:
  void follow(const FrozenScene<R>& home, const HitPath& path) {
    if (path.slot == slot_ && path.body == body_ && &home == home_) return;
    home_ = &home, slot_ = path.slot, body_ = path.body;
#define ZRAKA_FIND(Type, plural) \
  if (is_of(home.plural)) return;
    ZRAKA_INLINED_KINDS(ZRAKA_FIND)
#undef ZRAKA_FIND
    transform_ = home.bodies.transform[body_];
    curvature_ = isa_oracle::curvature_of_body(home.bodies, body_);
  }
  std::int32_t transform() const { return transform_; }
  double curvature() const { return curvature_; }

 private:
  template <class Shape>
  bool is_of(const FrozenShapes<R, Shape>& shapes) {
    const std::int32_t at = slot_ - shapes.first_slot;
    if (at < 0 || at >= shapes.count) return false;
    const FrozenMapping& mapping = shapes.mapping;
    transform_ = mapping.transform == nullptr ? 0
                                              : mapping.transform[shapes.id[at] - shapes.first_id];
    double numbers[ShapeTraits<Shape>::kReals];
    for (int k = 0; k < ShapeTraits<Shape>::kReals; ++k)
      numbers[k] = static_cast<double>(shapes.column[k][at]);
    curvature_ = curvature_of(static_cast<const Shape*>(nullptr), numbers);
    return true;
  }

  const FrozenScene<R>* home_ = nullptr;
  std::int32_t slot_ = -1, body_ = -1, transform_ = 0;
  double curvature_ = 0;
};

/// Hits of a batch with MaterialTextures::in_lanes, on shapes that stand in no group.
template <class R>
class WaitingHits {
 public:
  WaitingHits(const FrozenScene<R>& scene, const Level<R>& level, Scratch<R>& scratch,
              ColorHits<R>* color_hits)
      : scene_(scene), level_(level), scratch_(scratch), color_hits_(color_hits), ways_(scene) {}

  void add(std::int32_t hit, std::int32_t material, std::int32_t transform) {
    Group& group = group_of(material, transform);
    group.hit[group.count++] = hit;
    if (group.count == kMost) color(group);
  }
  /// All that wait.
  void color() {
    for (std::size_t i = 0; i < groups_; ++i) color(group_[i]);
  }

 private:
  static constexpr std::size_t kMost = 256, kGroups = 8;
  struct Group {
    std::int32_t material, transform;
    std::size_t count;
    std::int32_t hit[kMost + kArrayPadding];
  };

  Group& group_of(std::int32_t material, std::int32_t transform) {
    const auto is_it = [&](const Group& g) {
      return g.material == material && g.transform == transform;
    };
    if (groups_ > 0 && is_it(group_[last_])) return group_[last_];
    for (last_ = 0; last_ < groups_; ++last_)
      if (is_it(group_[last_])) return group_[last_];
    if (groups_ < kGroups) {
      last_ = groups_++;
    } else {  // instead of one group after another
      last_ = next_;
      next_ = (next_ + 1) % kGroups;
      color(group_[last_]);
    }
    Group& group = group_[last_];
    group.material = material, group.transform = transform, group.count = 0;
    return group;
  }

  void color(Group& group) {
    if (group.count == 0) return;
    const FrozenTextures& textures = *scene_.textures;
    const std::int32_t* const hit = group.hit;
    color_hits_({hit, group.count, &textures.of_material[group.material], textures.set->all(),
                 &ways_.to_shape(group.transform), scene_.frame_scale},
                level_, scratch_);
    group.count = 0;
  }

  const FrozenScene<R>& scene_;
  const Level<R>& level_;
  Scratch<R>& scratch_;
  ColorHits<R>* color_hits_;
  ShapeSpaces<R> ways_;
  Group group_[kGroups];
  std::size_t groups_ = 0, last_ = 0, next_ = 0;
};

}  // namespace zraka
