// SPDX-License-Identifier: Apache-2.0
#include "image/jpeg_again.hpp"

// jpeglib.h wants FILE and size_t to be known.
#include <cstddef>
#include <cstdio>
//
#include <jpeglib.h>

#include <algorithm>
#include <cmath>
#include <csetjmp>
#include <cstdlib>
#include <string>

namespace zraka {
namespace {

struct AgainErrors {
  jpeg_error_mgr manager;
  std::jmp_buf back;
};

[[noreturn]] void leave_again(j_common_ptr jpeg) {
  std::longjmp(reinterpret_cast<AgainErrors*>(jpeg->err)->back, 1);  // NOLINT: libjpeg's way
}
void say_nothing_again(j_common_ptr, int) {}
void print_nothing_again(j_common_ptr) {}

void prepare_again(AgainErrors& errors) {
  jpeg_std_error(&errors.manager);
  errors.manager.error_exit = leave_again;
  errors.manager.emit_message = say_nothing_again;
  errors.manager.output_message = print_nothing_again;
}

/// What lies between setjmp and longjmp owns nothing with a destructor.
bool read_header_again(jpeg_decompress_struct& jpeg, AgainErrors& errors, std::string_view bytes) {
  if (setjmp(errors.back) != 0) return false;  // NOLINT: libjpeg's way
  jpeg_create_decompress(&jpeg);
  jpeg_mem_src(&jpeg, reinterpret_cast<const unsigned char*>(bytes.data()), bytes.size());
  return jpeg_read_header(&jpeg, TRUE) == JPEG_HEADER_OK;
}

struct Memory {
  unsigned char* bytes = nullptr;
  unsigned long size = 0;
};

bool compress_again(jpeg_compress_struct& jpeg, AgainErrors& errors, unsigned char* pixels,
                    const Image& image, const JpegTables& tables, Memory& memory) {
  if (setjmp(errors.back) != 0) return false;  // NOLINT: libjpeg's way
  jpeg_create_compress(&jpeg);
  jpeg_mem_dest(&jpeg, &memory.bytes, &memory.size);
  jpeg.image_width = image.width;
  jpeg.image_height = image.height;
  jpeg.input_components = 3;
  jpeg.in_color_space = JCS_RGB;
  jpeg_set_defaults(&jpeg);
  for (int c = 0; c < 3; ++c) {
    unsigned steps[64];
    for (std::size_t i = 0; i < 64; ++i) steps[i] = tables.steps[static_cast<std::size_t>(c)][i];
    jpeg_add_quant_table(&jpeg, c, steps, 100, FALSE);
    jpeg.comp_info[c].quant_tbl_no = c;
    jpeg.comp_info[c].h_samp_factor = tables.samples[static_cast<std::size_t>(c)][0];
    jpeg.comp_info[c].v_samp_factor = tables.samples[static_cast<std::size_t>(c)][1];
  }
  jpeg.dct_method = JDCT_ISLOW;
  jpeg_start_compress(&jpeg, TRUE);
  while (jpeg.next_scanline < jpeg.image_height) {
    unsigned char* row = pixels + std::size_t{3} * image.width * jpeg.next_scanline;
    jpeg_write_scanlines(&jpeg, &row, 1);
  }
  jpeg_finish_compress(&jpeg);
  return true;
}

bool decompress(jpeg_decompress_struct& jpeg, AgainErrors& errors, const Memory& memory,
                unsigned char* pixels) {
  if (!read_header_again(jpeg, errors, {reinterpret_cast<const char*>(memory.bytes), memory.size}))
    return false;
  if (setjmp(errors.back) != 0) return false;  // NOLINT: libjpeg's way
  jpeg.out_color_space = JCS_RGB;
  jpeg.dct_method = JDCT_ISLOW;
  jpeg_start_decompress(&jpeg);
  while (jpeg.output_scanline < jpeg.output_height) {
    unsigned char* row = pixels + std::size_t{3} * jpeg.output_width * jpeg.output_scanline;
    jpeg_read_scanlines(&jpeg, &row, 1);
  }
  jpeg_finish_decompress(&jpeg);
  return true;
}

}  // namespace

std::optional<JpegTables> jpeg_tables(std::string_view bytes) {
  AgainErrors errors{};
  jpeg_decompress_struct jpeg{};
  jpeg.err = &errors.manager;
  prepare_again(errors);
  std::optional<JpegTables> tables;
  if (read_header_again(jpeg, errors, bytes) && jpeg.num_components == 3 &&
      jpeg.jpeg_color_space == JCS_YCbCr) {
    tables.emplace();
    for (int c = 0; c < 3 && tables; ++c) {
      const jpeg_component_info& channel = jpeg.comp_info[c];
      const JQUANT_TBL* steps = jpeg.quant_tbl_ptrs[channel.quant_tbl_no];
      if (steps == nullptr) {
        tables.reset();
        break;
      }
      std::copy_n(steps->quantval, 64, tables->steps.emplace_back().begin());
      tables->samples.push_back({channel.h_samp_factor, channel.v_samp_factor});
    }
  }
  jpeg_destroy_decompress(&jpeg);
  return tables;
}

Image compressed_again(const Image& image, const JpegTables& tables) {
  std::vector<unsigned char> pixels(image.pixels.size());
  std::transform(image.pixels.begin(), image.pixels.end(), pixels.begin(), [](float value) {
    return static_cast<unsigned char>(std::lround(255 * std::clamp(value, 0.0F, 1.0F)));
  });
  AgainErrors errors{};
  prepare_again(errors);
  Memory memory;
  jpeg_compress_struct coder{};
  coder.err = &errors.manager;
  bool good = compress_again(coder, errors, pixels.data(), image, tables, memory);
  jpeg_destroy_compress(&coder);
  jpeg_decompress_struct decoder{};
  decoder.err = &errors.manager;
  good = good && decompress(decoder, errors, memory, pixels.data());
  jpeg_destroy_decompress(&decoder);
  std::free(memory.bytes);  // NOLINT: libjpeg has taken it by malloc
  if (!good) return image;
  Image out(image.width, image.height);
  std::transform(pixels.begin(), pixels.end(), out.pixels.begin(),
                 [](unsigned char value) { return static_cast<float>(value) / 255.0F; });
  return out;
}

}  // namespace zraka
