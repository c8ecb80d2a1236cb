// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <gtest/gtest.h>

#include <zraka/zraka.hpp>

namespace zraka {

/// A test fails where there is none.
inline Image picture_of(const Scene& scene, const RenderOptions& options = {}) {
  const Result<Rendering> rendering = render(scene, options);
  if (!rendering) ADD_FAILURE() << to_string(rendering.error().front());
  return rendering ? rendering->image : Image();
}

}  // namespace zraka
