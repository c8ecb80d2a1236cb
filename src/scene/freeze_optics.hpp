// SPDX-License-Identifier: Apache-2.0
// The general engine's part of a scene.
#pragma once

#include <memory>
#include <vector>
#include <zraka/render.hpp>
#include <zraka/scene.hpp>

#include "math/frame.hpp"
#include "scene/frozen_optics.hpp"

namespace zraka {

class Whereabouts;

/// The memory behind FrozenOptics.
struct StoredOptics {
  FrozenOptics frozen{};
  std::vector<OpticalMaterial> materials;
  std::vector<OpticalLight> lights;
  std::vector<OpticalCut> cuts;
  std::vector<float> body_sizes;
};

OpticalLight freeze_light(const Light& light, const Frame& frame);

/// Whether a scene has anything that the lean engine has not.
bool has_optics(const Scene& scene);

/// Whether a scene has materials that throw no shadow.
bool has_shadowless(const Scene& scene);

std::unique_ptr<StoredOptics> freeze_optics(const Scene& scene, const Profile& profile,
                                            const Frame& frame);

/// How large bodies are that caps of cuts can close.
void find_body_sizes(const Scene& scene, const Whereabouts& where, const Frame& frame,
                     StoredOptics& optics);

/// Which depends on the view, if it is planar.
OpticalFog freeze_fog(const Scene& scene, const Frame& frame);

}  // namespace zraka
