// SPDX-License-Identifier: Apache-2.0
// JPEG through libjpeg.
#include <fmt/format.h>

// jpeglib.h wants FILE and size_t to be known.
#include <cstddef>
#include <cstdio>
//
#include <jerror.h>
#include <jpeglib.h>

#include <array>
#include <csetjmp>
#include <vector>

#include "core/phrase.hpp"
#include "image/readers.hpp"

namespace zraka {
namespace {

/// A progressive picture has about ten scans; each costs the time of a whole picture.
constexpr int kMostScans = 100;

struct Errors {
  jpeg_error_mgr manager;
  std::jmp_buf back;
  std::array<char, JMSG_LENGTH_MAX> text;
};

[[noreturn]] void on_error(j_common_ptr jpeg) {
  auto* errors = reinterpret_cast<Errors*>(jpeg->err);
  errors->manager.format_message(jpeg, errors->text.data());
  std::longjmp(errors->back, 1);  // NOLINT: libjpeg's way
}

/// What libjpeg would fill with grey and pass over with a warning is a damaged picture to us.
void on_message(j_common_ptr jpeg, int level) {
  if (level >= 0) return;
  switch (jpeg->err->msg_code) {
    case JWRN_EXTRANEOUS_DATA:  // harmless: bytes between the parts, odd version numbers
    case JWRN_ADOBE_XFORM:
    case JWRN_JFIF_MAJOR:
      return;
    default:
      on_error(jpeg);
  }
}
void print_nothing(j_common_ptr) {}

void on_progress(j_common_ptr jpeg) {
  const auto* decoder = reinterpret_cast<j_decompress_ptr>(jpeg);
  if (decoder->input_scan_number <= kMostScans) return;
  auto* errors = reinterpret_cast<Errors*>(jpeg->err);
  constexpr std::string_view kText = "it has more than 100 scans";
  kText.copy(errors->text.data(), kText.size());
  errors->text[kText.size()] = '\0';
  std::longjmp(errors->back, 1);  // NOLINT: libjpeg's way
}

/// As with libpng: what lies between setjmp and longjmp owns nothing with a destructor.
bool read_header(jpeg_decompress_struct& jpeg, Errors& errors, std::string_view bytes) {
  if (setjmp(errors.back) != 0) return false;  // NOLINT: libjpeg's way
  jpeg_create_decompress(&jpeg);
  jpeg_mem_src(&jpeg, reinterpret_cast<const unsigned char*>(bytes.data()), bytes.size());
  jpeg_read_header(&jpeg, TRUE);
  return true;
}

bool read_rows(jpeg_decompress_struct& jpeg, Errors& errors, unsigned char* row, Image& image) {
  if (setjmp(errors.back) != 0) return false;  // NOLINT: libjpeg's way
  jpeg.out_color_space = JCS_RGB;
  jpeg.dct_method = JDCT_ISLOW;
  jpeg_start_decompress(&jpeg);
  while (jpeg.output_scanline < jpeg.output_height) {
    float* out = image.row(jpeg.output_scanline);
    jpeg_read_scanlines(&jpeg, &row, 1);
    for (std::size_t i = 0; i < std::size_t{3} * image.width; ++i)
      out[i] = static_cast<float>(row[i]) / 255.0f;
  }
  jpeg_finish_decompress(&jpeg);
  return true;
}

Result<ReadImage> read(jpeg_decompress_struct& jpeg, Errors& errors, const ImageFile& file) {
  const auto problem = [&] {
    return failure(file.name, phrase(Word::image_no_jpeg, errors.text.data()));
  };
  if (!read_header(jpeg, errors, file.bytes)) return problem();
  if (const Result<void> fits = file.check_size(jpeg.image_width, jpeg.image_height); !fits)
    return tl::make_unexpected(fits.error());
  if (jpeg.jpeg_color_space == JCS_CMYK || jpeg.jpeg_color_space == JCS_YCCK)
    return failure(file.name, phrase(Word::image_cmyk), phrase(Word::image_rgb));
  jpeg_progress_mgr progress{};
  progress.progress_monitor = on_progress;
  jpeg.progress = &progress;
  ReadImage read;
  read.format = "JPEG";
  read.image = Image(jpeg.image_width, jpeg.image_height);
  std::vector<unsigned char> row(std::size_t{3} * jpeg.image_width);
  if (!read_rows(jpeg, errors, row.data(), read.image)) return problem();
  return read;
}

}  // namespace

Result<ReadImage> parse_jpeg(const ImageFile& file) {
  Errors errors{};
  jpeg_decompress_struct jpeg{};
  jpeg.err = jpeg_std_error(&errors.manager);
  errors.manager.error_exit = on_error;
  errors.manager.emit_message = on_message;
  errors.manager.output_message = print_nothing;
  Result<ReadImage> picture = read(jpeg, errors, file);
  jpeg_destroy_decompress(&jpeg);
  return picture;
}

}  // namespace zraka
