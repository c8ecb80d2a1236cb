// SPDX-License-Identifier: Apache-2.0
// Pictures into files of all kinds.
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>
#include <zraka/api.hpp>
#include <zraka/diagnostic.hpp>
#include <zraka/image.hpp>
#include <zraka/layers.hpp>

namespace zraka {

/// How light without bounds becomes values of 0…1, for files that hold integers.
enum class ToneCurve {
  clamp,     ///< what is brighter than 1 is 1
  reinhard,  ///< Reinhard et al., "Photographic Tone Reproduction", 2002, equation 4
  filmic     ///< Hable, "Filmic Tonemapping Operators", 2010: the curve of Uncharted 2
};
inline constexpr std::array<std::string_view, 3> kToneCurveNames = {"clamp", "reinhard", "filmic"};
ZRAKA_API std::optional<ToneCurve> tone_curve_named(std::string_view name);

struct ToneMapping {
  ToneCurve curve = ToneCurve::clamp;
  double exposure = 0;  ///< in stops: light is multiplied by 2^exposure first
  /// The light that becomes 1, above 0: a luminance for Reinhard's curve, a value of each channel
  /// for the filmic one. 0: the usual one, kReinhardWhite or kFilmicWhite.
  double white = 0;
  friend bool operator==(const ToneMapping&, const ToneMapping&) = default;
};
inline constexpr double kReinhardWhite = 4, kFilmicWhite = 5.6;

struct WriteOptions {
  int bits = 0;                        ///< of a value; 0: what the format usually has
  Transfer transfer = Transfer::srgb;  ///< of integers; floats are linear light
  ToneMapping tone{};                  ///< of integers
  int jpeg_quality = 95;               ///< 1…100
  int threads = 0;  ///< 0: one for each processor; the file is the same from any number
};

/// A kind of file that write_image() writes.
struct PictureFormat {
  std::string_view name;                  ///< "PNG"
  std::vector<std::string_view> endings;  ///< ".png", small letters
  std::vector<int> bits;                  ///< of a value; the usual one first
  bool floats = false;                    ///< linear light without bounds; else integers
  bool alpha = false;
  bool layers = false;  ///< all channels of Layers, else at most alpha
};
/// In the order of the list of writers.
ZRAKA_API std::vector<PictureFormat> picture_formats();
/// By the ending of a name, in any case. A name without ending, a device and "-" are a PNG's.
ZRAKA_API std::optional<PictureFormat> picture_format_of(const std::string& path);

/// Writes a picture in the format that its name ends with, beside that name, then renamed: a
/// failure leaves an old file as it was. The same picture gives the same bytes, without dates.
/// The picture's colours are multiplied by the layers' alpha, if they have any: so OpenEXR stores
/// them, integers are divided by it. "-" is standard output. Fails where the format cannot hold
/// what is asked for.
ZRAKA_API Result<void> write_image(const Image& image, const Layers& layers,
                                   const std::string& path, const WriteOptions& options = {});

}  // namespace zraka
