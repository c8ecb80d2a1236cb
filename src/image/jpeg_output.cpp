// SPDX-License-Identifier: Apache-2.0
// JPEG through libjpeg, written.
// jpeglib.h wants FILE and size_t to be known.
#include <cstddef>
#include <cstdio>
//
#include <jpeglib.h>

#include <array>
#include <cerrno>
#include <csetjmp>
#include <cstring>
#include <vector>

#include "image/stored_pixels.hpp"
#include "image/writers.hpp"

namespace zraka {
namespace {

struct WriteErrors {
  jpeg_error_mgr manager;
  std::jmp_buf back;
  std::array<char, JMSG_LENGTH_MAX> text;
  int error;  ///< errno
};

[[noreturn]] void on_write_error(j_common_ptr jpeg) {
  auto* errors = reinterpret_cast<WriteErrors*>(jpeg->err);
  errors->error = errno;
  errors->manager.format_message(jpeg, errors->text.data());
  std::longjmp(errors->back, 1);  // NOLINT: libjpeg's way
}
void say_nothing(j_common_ptr, int) {}
void print_nothing_of_writing(j_common_ptr) {}

/// What lies between setjmp and longjmp owns nothing with a destructor.
bool put_rows(jpeg_compress_struct& jpeg, WriteErrors& errors, std::FILE* stream,
              const StoredPixels& pixels, const Image& image, int quality, unsigned char* row) {
  if (setjmp(errors.back) != 0) return false;  // NOLINT: libjpeg's way
  jpeg_create_compress(&jpeg);
  jpeg_stdio_dest(&jpeg, stream);
  jpeg.image_width = image.width;
  jpeg.image_height = image.height;
  jpeg.input_components = 3;
  jpeg.in_color_space = JCS_RGB;
  jpeg_set_defaults(&jpeg);
  jpeg_set_quality(&jpeg, quality, TRUE);
  for (int c = 0; c < 3; ++c) jpeg.comp_info[c].h_samp_factor = jpeg.comp_info[c].v_samp_factor = 1;
  jpeg.dct_method = JDCT_ISLOW;
  jpeg.optimize_coding = TRUE;
  jpeg_start_compress(&jpeg, TRUE);
  while (jpeg.next_scanline < jpeg.image_height) {
    pixels.get(jpeg.next_scanline, 0, image.width, row);
    jpeg_write_scanlines(&jpeg, &row, 1);
  }
  jpeg_finish_compress(&jpeg);
  return true;
}

}  // namespace

std::string put_jpeg(std::FILE* stream, const PictureToWrite& picture,
                     const WriteOptions& options) {
  WriteErrors errors{};
  jpeg_compress_struct jpeg{};
  jpeg.err = jpeg_std_error(&errors.manager);
  errors.manager.error_exit = on_write_error;
  errors.manager.emit_message = say_nothing;
  errors.manager.output_message = print_nothing_of_writing;
  const StoredPixels pixels(picture.image, nullptr, options);
  std::vector<unsigned char> row(pixels.bytes() * picture.image.width);
  const bool good =
      put_rows(jpeg, errors, stream, pixels, picture.image, options.jpeg_quality, row.data());
  jpeg_destroy_compress(&jpeg);
  if (good) return ByteStream(stream).problem();
  return std::ferror(stream) != 0 ? std::strerror(errors.error) : errors.text.data();
}

}  // namespace zraka
