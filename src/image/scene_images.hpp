// SPDX-License-Identifier: Apache-2.0
// The pictures that a scene names, as linear light.
#pragma once

#include <cstdint>
#include <map>
#include <memory>
#include <string>
#include <utility>
#include <zraka/image.hpp>

#include "core/scene_folder.hpp"

namespace zraka {

/// Linear values of what was read: integers by the way back of `transfer`, floats as they are.
Image linear_image(ReadImage&& read, Transfer transfer);

/// Reads each file once, however often a scene names it.
class SceneImages {
 public:
  explicit SceneImages(SceneFolder folder, std::uint64_t max_pixels = kMaxPixels)
      : folder_(std::move(folder)), max_pixels_(max_pixels) {}

  /// The picture of a file that the scene names, for Texture::image. Fails where read_image() does,
  /// where the name leads out of the scene's folder, or where a number of the file is not finite.
  Result<std::shared_ptr<const Image>> load(const std::string& name,
                                            Transfer transfer = Transfer::srgb);

 private:
  Result<std::shared_ptr<const Image>> read(const std::string& path, Transfer transfer) const;

  SceneFolder folder_;
  std::uint64_t max_pixels_;
  std::map<std::pair<std::string, Transfer>, Result<std::shared_ptr<const Image>>> loaded_;
};

}  // namespace zraka
