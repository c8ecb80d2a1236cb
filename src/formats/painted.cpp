// SPDX-License-Identifier: Apache-2.0
#include "formats/painted.hpp"

#include <cmath>
#include <utility>

namespace zraka {

Texture painted_texture(const std::vector<float>& colors,
                        const std::function<void(std::size_t, const CornerUvs&)>& put_uvs) {
  const std::size_t n = colors.size() / 9;
  const auto across = static_cast<std::size_t>(std::ceil(std::sqrt(static_cast<double>(n))));
  const std::size_t down = across == 0 ? 0 : (n + across - 1) / across;
  Image image(static_cast<std::uint32_t>(2 * across), static_cast<std::uint32_t>(2 * down));
  const double width = image.width, height = image.height;
  for (std::size_t i = 0; i < n; ++i) {
    const std::size_t x = i % across * 2, y = i / across * 2;
    const float* const c = colors.data() + 9 * i;
    float* const upper = image.row(static_cast<std::uint32_t>(y)) + 3 * x;
    float* const lower = image.row(static_cast<std::uint32_t>(y + 1)) + 3 * x;
    for (std::size_t k = 0; k < 3; ++k) {
      upper[k] = c[k], upper[3 + k] = c[3 + k], lower[k] = c[6 + k];
      lower[3 + k] = c[3 + k] + c[6 + k] - c[k];
    }
    const auto uv = [&](double column, double row) {
      return std::array<float, 2>{static_cast<float>(column / width),
                                  static_cast<float>(1 - row / height)};
    };
    const auto left = static_cast<double>(x) + 0.5, top = static_cast<double>(y) + 0.5;
    put_uvs(i, {uv(left, top), uv(left + 1, top), uv(left, top + 1)});
  }
  Texture t;
  t.kind = TextureKind::image;
  t.mapping = TextureMapping::uv;
  t.transfer = Transfer::linear;
  t.wrap = TextureWrap::clamp;
  t.filter = TextureFilter::bilinear;
  t.image = std::make_shared<const Image>(std::move(image));
  return t;
}

}  // namespace zraka
