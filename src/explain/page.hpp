// SPDX-License-Identifier: Apache-2.0
// An explanation as a page for browsers.
#pragma once

#include <string>
#include <zraka/explain.hpp>

#include "core/words.hpp"

namespace zraka {

/// The most rays that a page shows.
inline constexpr std::size_t kMaxPageRays = 2048;

struct PageOptions {
  Language language = Language::english;
  std::string scene{};  ///< its name
  std::optional<ProfileName> profile{};
};

/// What a page shows of the picture.
struct PagePictures {
  Image picture;  ///< of any size
  Neighbourhood neighbours;
};

/// A self-contained HTML page: the sentence, the picture with the pixel marked, the rays in space
/// to turn, the tree to fold and unfold with formulas set as such. Fails for trees of more than
/// kMaxPageRays.
Result<std::string> to_page(const Scene& scene, const Explanation& explanation,
                            const PagePictures& pictures, const PageOptions& options);

/// The picture of a scene for a page: not larger than a page shows it. The scene's size is as
/// before afterwards.
Result<Image> picture_for_page(Scene& scene, const RenderOptions& options);

}  // namespace zraka
