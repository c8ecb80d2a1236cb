// SPDX-License-Identifier: Apache-2.0
#include <algorithm>

#include "explain/page.hpp"

namespace zraka {
namespace {

/// Longest side of the picture on the page.
constexpr std::uint32_t kPictureSide = 560;

}  // namespace

Result<Image> picture_for_page(Scene& scene, const RenderOptions& options) {
  const Resolution own = scene.resolution;
  const std::uint32_t longest = std::max(own.width, own.height);
  const auto reduced = [&](std::uint32_t side) {
    const std::uint64_t small = std::uint64_t{side} * kPictureSide / longest;
    return longest <= kPictureSide ? side : std::max(1u, static_cast<std::uint32_t>(small));
  };
  scene.resolution = {reduced(own.width), reduced(own.height)};
  Result<Rendering> rendering = render(scene, options);
  scene.resolution = own;
  if (!rendering) return tl::make_unexpected(rendering.error());
  return std::move(rendering->image);
}

}  // namespace zraka
