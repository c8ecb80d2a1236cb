// SPDX-License-Identifier: Apache-2.0
// Listening to whole tiles, whichever engine traces them.
#pragma once

#include <optional>
#include <vector>

#include "engine/general/general.hpp"
#include "explain/recording.hpp"
#include "render/tracer.hpp"

namespace zraka {

/// Listens to the general engine and tells a Recording what the other engine would: one shadow ray
/// for each hit that faces a light, with what stops it as the blocker; scratch.lit is 1 where any
/// light of it arrives. What it has besides, a reader may ask for.
class GeneralRecorder final : public general::Listener<float> {
 public:
  /// A body that shadow rays of a hit come through, or that stops one.
  struct Body {
    std::int32_t slot, sample;  ///< the first sample that hits it
    HitPath path;
    double distance;
    bool stops;
  };

  GeneralRecorder(const FrozenScene<float>& scene, const TraceSettings& settings,
                  std::int32_t batch, Recording<float>& recording);

  Workspace<float>& workspace() { return memory_.workspace(); }
  /// The rays through a tile's pixels.
  void trace(const TileRect& tile);

  /// While the reader is told of hits and children.
  const general::HitState<float>& state(std::size_t h) const { return states_[h]; }
  bool absorbs(std::size_t h) const;
  bool has_fresnel(std::size_t h) const {
    return scene_.optics->materials[states_[h].material].fresnel != Fresnel::off;
  }
  /// While it is told of a light: its sums, whether a hit is outside of its cone, and what its
  /// shadow rays come through.
  const general::LightSum<float>& sum(std::size_t h) const { return sums_[h]; }
  bool is_dark(std::size_t h) const;
  const std::vector<Body>& passed(std::size_t h) const { return passed_[h]; }
  /// While it is told of children: calls take(index in the next level, whether it is refracted).
  template <class Take>
  void each_child(std::size_t h, const Take& take) const {
    const general::HitState<float>& at = states_[h];
    for (std::int32_t c = at.first_child; c < at.first_child + at.child_count; ++c)
      take(c, children_[c].kind == general::RayKind::refracted);
  }

  void at_hits(const Level<float>& level, const Scratch<float>& scratch,
               const general::GeneralWorkspace<float>& workspace,
               const V3<float>* occlusion) override;
  void at_passed(const general::Passed<float>& passed) override;
  void at_light(std::int32_t light, const Level<float>& level,
                const general::LightSum<float>* sums) override;
  void at_children(const Level<float>& level, const Level<float>& next,
                   const general::GeneralWorkspace<float>& workspace) override;
  void at_fold(const Level<float>& level,
               const general::GeneralWorkspace<float>& workspace) override;

 private:
  std::size_t depth_of(const Level<float>& level) {
    return static_cast<std::size_t>(&level - workspace().levels);
  }

  const FrozenScene<float>& scene_;
  const TraceSettings& settings_;
  TracerMemory<float> memory_;
  Recording<float>& recording_;
  const general::HitState<float>* states_ = nullptr;
  const general::RayState<float>* children_ = nullptr;
  const general::LightSum<float>* sums_ = nullptr;
  std::int32_t light_ = 0;
  std::vector<std::vector<Body>> passed_;  ///< by hit, of the light at hand
};

/// Traces tiles by the engine that the scene needs, and tells a reader (RecordedTerms).
class TileRecorder {
 public:
  template <class Reader>
  TileRecorder(const FrozenScene<float>& scene, const TraceSettings& settings, std::int32_t batch,
               Reader& reader, bool paths = false)
      : scene_(scene),
        settings_(settings),
        terms_(batch, reader, paths),
        ignored_(3 * static_cast<std::size_t>(batch)) {
    if (scene.optics != nullptr)
      general_.emplace(scene, settings, batch, terms_.recording());
    else
      memory_.emplace(batch, settings.max_depth, true);
  }
  TileRecorder(const TileRecorder&) = delete;
  TileRecorder& operator=(const TileRecorder&) = delete;

  Workspace<float>& workspace() {
    return general_ ? general_->workspace() : memory_->workspace();
  }
  const RecordedTerms& terms() const { return terms_; }
  /// nullptr where the scene needs no more than the lab's engine.
  const GeneralRecorder* general() const { return general_ ? &*general_ : nullptr; }
  void trace(const TileRect& tile);

  /// Within at_children().
  template <class Take>
  void each_child(const Level<float>& level, std::size_t h, const Take& take) const {
    if (general_) return general_->each_child(h, take);
    if (level.hits.reflected[h] >= 0) take(level.hits.reflected[h], false);
    if (level.hits.refracted[h] >= 0) take(level.hits.refracted[h], true);
  }

 private:
  const FrozenScene<float>& scene_;
  const TraceSettings& settings_;
  RecordedTerms terms_;
  std::vector<float> ignored_;
  std::optional<WorkspaceMemory<float>> memory_;
  std::optional<GeneralRecorder> general_;
};

}  // namespace zraka
