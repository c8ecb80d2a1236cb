// SPDX-License-Identifier: Apache-2.0
#include "school/glyphs/font.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "core/text.hpp"
#include "school/late/fonts.hpp"

namespace zraka {

struct Font::Face {
  FT_Library library = nullptr;
  FT_Face face = nullptr;
  std::string path;
  Face() = default;
  Face(const Face&) = delete;
  Face& operator=(const Face&) = delete;
  ~Face() {
    if (face != nullptr) FT_Done_Face(face);
    if (library != nullptr) FT_Done_FreeType(library);
  }
};

namespace {

/// File of the system's bold sans-serif; "" if there is none.
std::string find_font() {
  FcConfig* config = FcInitLoadConfigAndFonts();
  if (config == nullptr) return {};
  FcPattern* pattern =
      FcNameParse(reinterpret_cast<const FcChar8*>("DejaVu Sans:bold:lang=hr:scalable=true"));
  FcConfigSubstitute(config, pattern, FcMatchPattern);
  FcDefaultSubstitute(pattern);
  FcResult result = FcResultNoMatch;
  FcPattern* match = FcFontMatch(config, pattern, &result);
  std::string path;
  FcChar8* file = nullptr;
  if (match != nullptr && FcPatternGetString(match, FC_FILE, 0, &file) == FcResultMatch)
    path = reinterpret_cast<const char*>(file);
  if (match != nullptr) FcPatternDestroy(match);
  FcPatternDestroy(pattern);
  FcConfigDestroy(config);
  return path;
}

/// Code points of a text that is_utf8().
std::vector<char32_t> code_points(std::string_view text) {
  std::vector<char32_t> points;
  for (const char c : text) {
    const auto byte = static_cast<unsigned char>(c);
    if ((byte & 0xC0) == 0x80)
      points.back() = points.back() << 6 | (byte & 0x3F);
    else
      points.push_back(byte < 0x80 ? byte
                                   : byte & (byte >= 0xF0   ? 0x07
                                             : byte >= 0xE0 ? 0x0F
                                                            : 0x1F));
  }
  return points;
}

/// A glyph's picture and where it stands on the line.
struct Placed {
  int x, y;  // of its upper left corner, y upwards from the baseline
  Coverage ink;
};

}  // namespace

Result<Font> Font::open(const std::string& path) {
  for (const LateLibrary& library : {kFreetype, kFontconfig})
    if (Result<void> loaded = library.load(); !loaded) return tl::make_unexpected(loaded.error());
  auto face = std::make_shared<Face>();
  face->path = path.empty() ? find_font() : path;
  if (face->path.empty())
    return failure("", "no font was found on this system",
                   "install one (Debian: fonts-dejavu-core), or name a file with --font");
  if (FT_Init_FreeType(&face->library) != 0) return failure("", "FreeType cannot start");
  if (FT_New_Face(face->library, face->path.c_str(), 0, &face->face) != 0)
    return failure(face->path, "is no font file that can be read");
  if (!FT_IS_SCALABLE(face->face)) return failure(face->path, "has no outlines, only bitmaps");
  return Font(std::move(face));
}

Result<Coverage> Font::draw(std::string_view text, int pixels) const {
  if (!is_utf8(text)) return failure("", "the text is not UTF-8");
  const std::vector<char32_t> points = code_points(text);
  if (points.size() > kLongestText)
    return failure(
        "", fmt::format("the text has {} characters: {} at most", points.size(), +kLongestText));
  FT_Face face = face_->face;
  FT_Set_Pixel_Sizes(face, 0, static_cast<FT_UInt>(pixels));

  std::vector<Placed> glyphs;
  FT_Pos pen = 0;
  FT_UInt previous = 0;
  for (const char32_t point : points) {
    const FT_UInt index = FT_Get_Char_Index(face, point);
    if (index == 0 && point != U' ')
      return failure(face_->path,
                     fmt::format("has no glyph for U+{:04X}", static_cast<unsigned>(point)),
                     "name another font with --font");
    FT_Vector kerning{0, 0};
    if (previous != 0) FT_Get_Kerning(face, previous, index, FT_KERNING_DEFAULT, &kerning);
    previous = index;
    if (FT_Load_Glyph(face, index, FT_LOAD_RENDER | FT_LOAD_NO_HINTING | FT_LOAD_NO_BITMAP) != 0 ||
        face->glyph->bitmap.pixel_mode != FT_PIXEL_MODE_GRAY)
      return failure(face_->path,
                     fmt::format("cannot draw U+{:04X}", static_cast<unsigned>(point)));
    const FT_GlyphSlot slot = face->glyph;
    pen += kerning.x;
    Placed placed{static_cast<int>(pen >> 6) + slot->bitmap_left, slot->bitmap_top, {}};
    placed.ink.width = static_cast<int>(slot->bitmap.width);
    placed.ink.height = static_cast<int>(slot->bitmap.rows);
    for (int y = 0; y < placed.ink.height; ++y) {
      const unsigned char* row =
          slot->bitmap.buffer + static_cast<std::ptrdiff_t>(y) * slot->bitmap.pitch;
      placed.ink.values.insert(placed.ink.values.end(), row, row + placed.ink.width);
    }
    if (placed.ink.width > 0) glyphs.push_back(std::move(placed));
    pen += slot->advance.x;
  }
  if (glyphs.empty()) return Coverage{};

  int left = glyphs[0].x, top = glyphs[0].y, right = left, bottom = top;
  for (const Placed& g : glyphs) {
    left = std::min(left, g.x);
    right = std::max(right, g.x + g.ink.width);
    top = std::max(top, g.y);
    bottom = std::min(bottom, g.y - g.ink.height);
  }
  Coverage line{right - left, top - bottom, {}};
  const auto width = static_cast<std::size_t>(line.width);
  line.values.resize(width * static_cast<std::size_t>(line.height));
  for (const Placed& g : glyphs)
    for (int y = 0; y < g.ink.height; ++y)
      for (int x = 0; x < g.ink.width; ++x) {
        std::uint8_t& out = line.values[static_cast<std::size_t>(top - g.y + y) * width +
                                        static_cast<std::size_t>(g.x - left + x)];
        out = std::max(out, g.ink.at(x, y));
      }
  return line;
}

}  // namespace zraka
