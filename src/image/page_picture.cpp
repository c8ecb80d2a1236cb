// SPDX-License-Identifier: Apache-2.0
#include "image/page_picture.hpp"

#include "image/alter.hpp"

namespace zraka {

Result<std::string> png_for_page(const Image& stored) {
  return encode_png(reduced(stored, kPageSide));
}

}  // namespace zraka
