// SPDX-License-Identifier: Apache-2.0
// Pictures of several samples a pixel, and of cameras that trace_tile() does not know.
#pragma once

#include "render/picture_job.hpp"

namespace zraka {

/// Renders the job's part into the image, which has its size, and the samples' numbers and
/// statistics. False if it was cancelled.
template <class R>
bool render_samples(const PictureJob<R>& job, Rendering& rendering);

}  // namespace zraka
