// SPDX-License-Identifier: Apache-2.0
// How large things may get; checked before memory is taken.
#pragma once

#include <cstdint>

namespace zraka {

/// The largest picture, in pixels.
inline constexpr std::uint64_t kMaxPixels = std::uint64_t{1} << 27;
/// The deepest ray trees: levels of rays after the first.
inline constexpr int kMaxDepth = 200;
/// The rays of a pixel's tree that can be explained, and its terms of light (rays times lights).
inline constexpr int kMaxExplainedRays = 1 << 14;
inline constexpr std::uint64_t kMaxExplainedTerms = std::uint64_t{1} << 18;
/// Rays that one splits into at a dispersive body; samples of a pixel, of a light, of ambient
/// occlusion.
inline constexpr int kMaxWavelengths = 64;
inline constexpr int kMaxSamples = 65536;
inline constexpr int kMaxGrid = 256;  ///< whose square they are
/// The largest side of a tile, in pixels.
inline constexpr int kMaxTile = 64;
/// The widest outlines, in pixels.
inline constexpr int kMaxOutlines = 64;
/// Instances of groups that hold instances: how many deep.
inline constexpr int kMostNested = 32;
/// More threads than any machine has, so a mistake.
inline constexpr int kMaxThreads = 4096;

}  // namespace zraka
