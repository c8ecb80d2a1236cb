// SPDX-License-Identifier: Apache-2.0
// FreeType and Fontconfig, loaded when text is drawn.
#pragma once

#include <fontconfig/fontconfig.h>
#include <ft2build.h>
#include FT_FREETYPE_H

#include "school/late/late_function.hpp"

namespace zraka {

inline constexpr LateLibrary kFreetype(ZRAKA_LIBFREETYPE);
ZRAKA_LATE(kFreetype, FT_Done_Face)
ZRAKA_LATE(kFreetype, FT_Done_FreeType)
ZRAKA_LATE(kFreetype, FT_Get_Char_Index)
ZRAKA_LATE(kFreetype, FT_Get_Kerning)
ZRAKA_LATE(kFreetype, FT_Init_FreeType)
ZRAKA_LATE(kFreetype, FT_Load_Glyph)
ZRAKA_LATE(kFreetype, FT_New_Face)
ZRAKA_LATE(kFreetype, FT_Set_Pixel_Sizes)

inline constexpr LateLibrary kFontconfig(ZRAKA_LIBFONTCONFIG);
ZRAKA_LATE(kFontconfig, FcConfigDestroy)
ZRAKA_LATE(kFontconfig, FcConfigSubstitute)
ZRAKA_LATE(kFontconfig, FcDefaultSubstitute)
ZRAKA_LATE(kFontconfig, FcFontMatch)
ZRAKA_LATE(kFontconfig, FcInitLoadConfigAndFonts)
ZRAKA_LATE(kFontconfig, FcNameParse)
ZRAKA_LATE(kFontconfig, FcPatternDestroy)
ZRAKA_LATE(kFontconfig, FcPatternGetString)

}  // namespace zraka
