// SPDX-License-Identifier: Apache-2.0
// What there is of each kind of texture, in the file of its name.
#pragma once

#include "textures/prepared_texture.hpp"

namespace zraka {

struct TextureCode {
  /// The colour at a place.
  TextureValue (*value)(const PreparedTexture& texture, const TexturePlace& at);
  /// Makes what value() wants to have ready; the plain fields are in `texture` already. May be
  /// none.
  void (*prepare)(const Texture& described, PreparedTexture& texture);
  /// What people call it, in English and in Croatian.
  const char* nouns[2];
  /// May be none: what value() gives at `count` points with the footprint of a place, six at most.
  void (*values)(const PreparedTexture& texture, const TexturePlace& at, const V3<double>* points,
                 std::size_t count, TextureValue* values) = nullptr;
};

namespace texture_kinds {
#define ZRAKA_DECLARE(kind) extern const TextureCode kind;
ZRAKA_TEXTURES(ZRAKA_DECLARE)
#undef ZRAKA_DECLARE
}  // namespace texture_kinds

}  // namespace zraka
