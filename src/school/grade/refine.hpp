// SPDX-License-Identifier: Apache-2.0
// Where a picture lies in a submission, to less than a tenth of a pixel: by its colours, once its
// outlines have told it to about one.
#pragma once

#include "school/grade/align.hpp"

namespace zraka {

/// Moves and scales an inexact fit until it lies on the right picture, where that brings it nearer.
void refine(Fitted& fitted, const Image& wanted);

}  // namespace zraka
