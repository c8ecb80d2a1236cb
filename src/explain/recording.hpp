// SPDX-License-Identifier: Apache-2.0
// Listening to the engine: memory for its terms, and a reader's functions as it calls them.
#pragma once

#include <vector>

#include "engine/engine.hpp"
#include "scene/frozen.hpp"

namespace zraka {

/// Terms of a batch, and the reader who is told when they are there. The reader has the functions
/// at_hits, at_light, at_children and at_fold that Recording asks for.
class RecordedTerms {
 public:
  /// With `paths` also the ways to what shadow rays hit, through instances and CSG.
  template <class Reader>
  RecordedTerms(std::int32_t batch, Reader& reader, bool paths = false)
      : stride_(static_cast<std::size_t>(batch) + kArrayPadding),
        values_((static_cast<std::size_t>(Quantity::count) + 1) * stride_),
        blockers_(stride_),
        blocker_paths_(paths ? stride_ : 0) {
    for (std::size_t i = 0; i < static_cast<std::size_t>(Quantity::count); ++i)
      recording_.terms[i] = values_.data() + i * stride_;
    recording_.blocker_t = values_.data() + static_cast<std::size_t>(Quantity::count) * stride_;
    recording_.blocker = blockers_.data();
    recording_.blocker_path = paths ? blocker_paths_.data() : nullptr;
    recording_.reader = &reader;
    recording_.at_hits = [](void* me, const Level<float>& level, const Scratch<float>& scratch) {
      static_cast<Reader*>(me)->at_hits(level, scratch);
    };
    recording_.at_light = [](void* me, std::int32_t light, std::size_t shadow_rays,
                             const Level<float>& level, const Scratch<float>& scratch) {
      static_cast<Reader*>(me)->at_light(light, shadow_rays, level, scratch);
    };
    recording_.at_children = [](void* me, const Level<float>& level, const Level<float>& next) {
      static_cast<Reader*>(me)->at_children(level, next);
    };
    recording_.at_fold = [](void* me, const Level<float>& level) {
      static_cast<Reader*>(me)->at_fold(level);
    };
  }
  RecordedTerms(const RecordedTerms&) = delete;
  RecordedTerms& operator=(const RecordedTerms&) = delete;

  Recording<float>& recording() { return recording_; }

  /// A term of hit h of the batch.
  float at(Quantity term, std::size_t h) const {
    return recording_.terms[static_cast<int>(term)][h];
  }
  std::array<float, 3> three_at(Quantity term, std::size_t h) const {
    const auto first = static_cast<std::size_t>(term);
    return {recording_.terms[first][h], recording_.terms[first + 1][h],
            recording_.terms[first + 2][h]};
  }

  /// While it is told of a light of the lean engine: whether a hit faces it outside of its cone.
  bool is_dark(const FrozenLight<float>& light, std::size_t h) const {
    return light.fading.has_cone && at(Quantity::l_n, h) >= 0 && !(at(Quantity::strength, h) > 0);
  }

  /// The shape that the i-th shadow ray hits before the light, as its slot; -1: none.
  std::int32_t blocker(std::size_t i, const Scratch<float>& scratch) const {
    return recording_.blocker_t[i] < scratch.sdistance[i] ? blockers_[i] : -1;
  }
  float blocker_distance(std::size_t i) const { return recording_.blocker_t[i]; }
  /// nullptr where a scene has no bodies: then a slot says all.
  const HitPath* blocker_path(std::size_t i, const FrozenScene<float>& scene) const {
    return scene.bodies.count > 0 && !blocker_paths_.empty() ? &blocker_paths_[i] : nullptr;
  }

 private:
  std::size_t stride_;
  std::vector<float> values_;
  std::vector<std::int32_t> blockers_;
  std::vector<HitPath> blocker_paths_;
  Recording<float> recording_{};
};

}  // namespace zraka
