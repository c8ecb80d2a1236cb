// SPDX-License-Identifier: Apache-2.0
#include "picture_files.hpp"

#include <ImfChannelList.h>
#include <ImfFrameBuffer.h>
#include <ImfHeader.h>
#include <ImfIO.h>
#include <ImfOutputFile.h>
#include <ImfTiledOutputFile.h>
#include <half.h>
#include <png.h>

#include <cstdio>
#include <cstdlib>
#include <map>
#include <stdexcept>
//
#include <jpeglib.h>

namespace zraka {
namespace {

void append(png_structp png, png_bytep bytes, std::size_t count) {
  static_cast<std::string*>(png_get_io_ptr(png))->append(reinterpret_cast<char*>(bytes), count);
}

/// An OpenEXR in memory.
class Sink : public Imf::OStream {
 public:
  Sink() : OStream("memory") {}
  void write(const char* bytes, int count) override {
    const std::size_t end = at_ + static_cast<std::size_t>(count);
    if (text.size() < end) text.resize(end);
    text.replace(at_, static_cast<std::size_t>(count), bytes, static_cast<std::size_t>(count));
    at_ = end;
  }
  std::uint64_t tellp() override { return at_; }
  void seekp(std::uint64_t at) override { at_ = at; }
  std::string text;

 private:
  std::size_t at_ = 0;
};

}  // namespace

std::string png_file(std::uint32_t width, std::uint32_t height, const PngKind& kind,
                     const std::vector<std::vector<unsigned char>>& rows) {
  std::string text;
  png_structp png = png_create_write_struct(PNG_LIBPNG_VER_STRING, nullptr, nullptr, nullptr);
  png_infop info = png_create_info_struct(png);
  png_set_write_fn(png, &text, append, nullptr);
  png_set_IHDR(png, info, width, height, kind.bits, kind.color_type,
               kind.interlaced ? PNG_INTERLACE_ADAM7 : PNG_INTERLACE_NONE,
               PNG_COMPRESSION_TYPE_DEFAULT, PNG_FILTER_TYPE_DEFAULT);
  std::vector<png_color> palette;
  for (std::size_t i = 0; i + 2 < kind.palette.size(); i += 3)
    palette.push_back({kind.palette[i], kind.palette[i + 1], kind.palette[i + 2]});
  if (!palette.empty()) png_set_PLTE(png, info, palette.data(), static_cast<int>(palette.size()));
  if (!kind.transparency.empty())
    png_set_tRNS(png, info, kind.transparency.data(), static_cast<int>(kind.transparency.size()),
                 nullptr);
  png_write_info(png, info);
  std::vector<png_bytep> pointers;
  for (const auto& row : rows) pointers.push_back(const_cast<png_bytep>(row.data()));
  png_write_image(png, pointers.data());
  png_write_end(png, info);
  png_destroy_write_struct(&png, &info);
  return text;
}

std::string jpeg_file(std::uint32_t width, std::uint32_t height, const JpegKind& kind,
                      const std::vector<unsigned char>& pixels) {
  jpeg_compress_struct jpeg{};
  jpeg_error_mgr errors{};
  jpeg.err = jpeg_std_error(&errors);
  jpeg_create_compress(&jpeg);
  unsigned char* bytes = nullptr;
  unsigned long size = 0;
  jpeg_mem_dest(&jpeg, &bytes, &size);
  jpeg.image_width = width;
  jpeg.image_height = height;
  jpeg.input_components = kind.channels;
  jpeg.in_color_space = kind.channels == 1   ? JCS_GRAYSCALE
                        : kind.channels == 3 ? JCS_RGB
                                             : JCS_CMYK;
  jpeg_set_defaults(&jpeg);
  jpeg_set_quality(&jpeg, kind.quality, TRUE);
  if (kind.channels == 3 && !kind.subsampled)
    jpeg.comp_info[0].h_samp_factor = jpeg.comp_info[0].v_samp_factor = 1;
  if (kind.progressive) jpeg_simple_progression(&jpeg);
  std::vector<jpeg_scan_info> scans;
  if (kind.many_scans) {
    scans.push_back({3, {0, 1, 2, 0}, 0, 0, 0, 0});
    for (int channel = 0; channel < 3; ++channel)
      for (int k = 1; k < 64; ++k) scans.push_back({1, {channel, 0, 0, 0}, k, k, 0, 0});
    jpeg.scan_info = scans.data();
    jpeg.num_scans = static_cast<int>(scans.size());
  }
  jpeg_start_compress(&jpeg, TRUE);
  const std::size_t stride = std::size_t{width} * static_cast<std::size_t>(kind.channels);
  while (jpeg.next_scanline < height) {
    auto* row = const_cast<unsigned char*>(pixels.data() + jpeg.next_scanline * stride);
    jpeg_write_scanlines(&jpeg, &row, 1);
  }
  jpeg_finish_compress(&jpeg);
  jpeg_destroy_compress(&jpeg);
  std::string text(reinterpret_cast<char*>(bytes), size);
  std::free(bytes);  // NOLINT: libjpeg's memory
  return text;
}

std::string jpeg_file(const Image& image, int quality) {
  std::vector<unsigned char> bytes;
  for (const float v : image.pixels)
    bytes.push_back(static_cast<unsigned char>(quantize(v, Transfer::linear, 8)));
  return jpeg_file(image.width, image.height, {.quality = quality}, bytes);
}

std::string exr_file(const ExrKind& kind, const ExrValue& value) {
  const auto box = [](const int(&b)[4]) {
    return Imath::Box2i(Imath::V2i(b[0], b[1]), Imath::V2i(b[2], b[3]));
  };
  Imf::Header header(box(kind.display), box(kind.data));
  header.compression() = static_cast<Imf::Compression>(kind.compression);
  const int width = kind.data[2] - kind.data[0] + 1, height = kind.data[3] - kind.data[1] + 1;
  const Imf::PixelType type = kind.half ? Imf::HALF : Imf::FLOAT;
  const std::size_t size = kind.half ? 2 : 4;
  std::map<std::string, std::vector<char>> planes;
  Imf::FrameBuffer buffer;
  for (const std::string& name : kind.channels) {
    header.channels().insert(name, Imf::Channel(type));
    std::vector<char>& plane = planes[name];
    plane.resize(size * static_cast<std::size_t>(width) * static_cast<std::size_t>(height));
    for (int y = 0; y < height; ++y)
      for (int x = 0; x < width; ++x) {
        const float v = value(name, kind.data[0] + x, kind.data[1] + y);
        char* at = plane.data() + size * static_cast<std::size_t>(y * width + x);
        if (kind.half)
          *reinterpret_cast<Imath::half*>(at) = Imath::half(v);
        else
          *reinterpret_cast<float*>(at) = v;
      }
    const auto row_bytes = static_cast<std::ptrdiff_t>(size) * width;
    char* origin =
        plane.data() - kind.data[0] * static_cast<std::ptrdiff_t>(size) - kind.data[1] * row_bytes;
    buffer.insert(name, Imf::Slice(type, origin, size, static_cast<std::size_t>(row_bytes)));
  }
  Sink sink;
  if (kind.tiled) {
    header.setTileDescription(Imf::TileDescription(5, 4, Imf::ONE_LEVEL));
    Imf::TiledOutputFile file(sink, header);
    file.setFrameBuffer(buffer);
    file.writeTiles(0, file.numXTiles() - 1, 0, file.numYTiles() - 1);
  } else {
    Imf::OutputFile file(sink, header);
    file.setFrameBuffer(buffer);
    file.writePixels(height);
  }
  return sink.text;
}

float exr_sample(const std::string& channel, int x, int y) {
  return 0.25f * static_cast<float>(channel[0]) + static_cast<float>(x) -
         0.5f * static_cast<float>(y);
}

namespace {

/// Runs of three bytes and more, and what is between them.
void add_channel(std::string& file, const std::string& bytes) {
  for (std::size_t i = 0; i < bytes.size();) {
    const auto run_at = [&](std::size_t at) {
      std::size_t end = at;
      while (end < bytes.size() && end - at < 127 && bytes[end] == bytes[at]) ++end;
      return end - at;
    };
    if (const std::size_t run = run_at(i); run >= 3) {
      file += {static_cast<char>(128 + run), bytes[i]};
      i += run;
      continue;
    }
    std::size_t end = i;
    while (end < bytes.size() && end - i < 128 && run_at(end) < 3) ++end;
    file += static_cast<char>(end - i) + bytes.substr(i, end - i);
    i = end;
  }
}

/// Pixels that are like the one before, as one or two more of which red, green and blue are 1.
void add_pixels(std::string& file, const std::string& line) {
  for (std::size_t i = 0; i < line.size();) {
    const std::string pixel = line.substr(i, 4);
    file += pixel;
    std::size_t more = 0;
    for (i += 4; i < line.size() && line.compare(i, 4, pixel) == 0; i += 4) ++more;
    for (; more > 0; more >>= 8) file += std::string("\1\1\1", 3) + static_cast<char>(more & 255);
  }
}

}  // namespace

std::string hdr_file(std::uint32_t width, std::uint32_t height, HdrRuns runs,
                     const std::vector<unsigned char>& pixels, const std::string& header) {
  std::string file =
      header + "-Y " + std::to_string(height) + " +X " + std::to_string(width) + "\n";
  const std::string bytes(pixels.begin(), pixels.end());
  for (std::uint32_t y = 0; y < height; ++y) {
    const std::string line = bytes.substr(std::size_t{4} * width * y, std::size_t{4} * width);
    if (runs == HdrRuns::none) file += line;
    if (runs == HdrRuns::of_pixels) add_pixels(file, line);
    if (runs != HdrRuns::of_bytes) continue;
    file += {2, 2, static_cast<char>(width >> 8), static_cast<char>(width & 255)};
    for (std::size_t c = 0; c < 4; ++c) {
      std::string channel;
      for (std::size_t i = c; i < line.size(); i += 4) channel += line[i];
      add_channel(file, channel);
    }
  }
  return file;
}

std::string error_of(std::string_view bytes, std::uint64_t max_pixels) {
  const Result<ReadImage> read = parse_image(bytes, "a", max_pixels);
  return read ? "read" : to_string(read.error().front());
}

}  // namespace zraka
