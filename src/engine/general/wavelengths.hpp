// SPDX-License-Identifier: Apache-2.0
// The visible spectrum in parts.
#pragma once

#include "engine/engine.hpp"

namespace zraka {

/// The visible spectrum in so many equal parts, with what each gives to linear sRGB's channels: of
/// light whose power is the same at all wavelengths, by the CIE 1931 observer, so that all parts
/// together are white.
Wavelengths wavelengths_in(int count);

}  // namespace zraka
