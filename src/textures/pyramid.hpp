// SPDX-License-Identifier: Apache-2.0
// An image in smaller and smaller sizes (Williams, "Pyramidal parametrics", 1983).
#pragma once

#include <cstddef>
#include <memory>
#include <vector>
#include <zraka/image.hpp>

namespace zraka {

class Pyramid {
 public:
  /// Down to one pixel, or the image alone. It has pixels.
  Pyramid(std::shared_ptr<const Image> image, bool smaller);
  /// The same with levels of whole 255ths, rounded down, of which each pixel is the mean of four;
  /// what is left over at odd sizes is left out.
  static Pyramid of_bytes(std::shared_ptr<const Image> image);

  std::size_t levels() const { return 1 + smaller_.size(); }
  /// 0 is the image itself; each level has half the width and height before, rounded down, 1 or
  /// more.
  const Image& level(std::size_t i) const { return i == 0 ? *image_ : smaller_[i - 1]; }

 private:
  std::shared_ptr<const Image> image_;
  std::vector<Image> smaller_;
};

/// Half as wide and high, rounded down: each pixel is the mean of what it covers, with the parts of
/// pixels that odd sizes make, so that all pixels have the image's mean.
Image halved(const Image& image);

}  // namespace zraka
