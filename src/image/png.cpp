// SPDX-License-Identifier: Apache-2.0
// PNG through libpng, its rows deflated by several threads.
#include <fmt/format.h>
#include <png.h>

#include <algorithm>
#include <cerrno>
#include <csetjmp>
#include <cstdlib>
#include <cstring>
#include <exception>
#include <new>
#include <vector>
#include <zraka/image.hpp>

#include "core/new_file.hpp"
#include "core/phrase.hpp"
#include "image/deflate.hpp"
#include "image/readers.hpp"
#include "image/stored_pixels.hpp"
#include "image/writers.hpp"

namespace zraka {
namespace {

/// libpng's messages, kept until somebody can report them.
struct PngMessage {
  std::string text;
  int error = 0;  ///< errno, of whichever thread it was
};

[[noreturn]] void on_error(png_structp png, png_const_charp message) {
  *static_cast<PngMessage*>(png_get_error_ptr(png)) = {message, errno};
  png_longjmp(png, 1);
}
void on_warning(png_structp, png_const_charp) {}

/// Everything between setjmp and longjmp in functions that own nothing with a destructor.
bool start_file(png_structp png, png_infop info, std::FILE* stream, const Image& image, int bits,
                bool alpha) {
  if (setjmp(png_jmpbuf(png)) != 0) return false;  // NOLINT: libpng's way
  png_init_io(png, stream);
  png_set_user_limits(png, PNG_UINT_31_MAX, PNG_UINT_31_MAX);
  png_set_IHDR(png, info, image.width, image.height, bits,
               alpha ? PNG_COLOR_TYPE_RGB_ALPHA : PNG_COLOR_TYPE_RGB, PNG_INTERLACE_NONE,
               PNG_COMPRESSION_TYPE_DEFAULT, PNG_FILTER_TYPE_DEFAULT);
  png_write_info(png, info);
  return true;
}

bool write_chunk(png_structp png, const char* name, const unsigned char* bytes, std::size_t count) {
  if (setjmp(png_jmpbuf(png)) != 0) return false;  // NOLINT: libpng's way
  png_write_chunk(png, reinterpret_cast<png_const_bytep>(name), bytes, count);
  return true;
}

/// Rows as PNG stores them: the filter's number, then each byte less the one of the pixel to its
/// left ("Sub").
Rows filtered_rows(const Image& image, const StoredPixels& pixels) {
  const std::size_t pixel = pixels.bytes();
  const auto make = [&image, &pixels, pixel](std::uint32_t y, unsigned char* out) {
    constexpr std::size_t kAtOnce = 512;
    *out++ = PNG_FILTER_VALUE_SUB;
    unsigned char stored[8 * (1 + kAtOnce)] = {};  // of which the first is the pixel before
    for (std::size_t x = 0; x < image.width; x += kAtOnce) {
      const std::size_t count = std::min(kAtOnce, image.width - x);
      pixels.get(y, x, count, stored + pixel);
      for (std::size_t i = 0; i < pixel * count; ++i)
        *out++ = static_cast<unsigned char>(stored[pixel + i] - stored[i]);
      std::memcpy(stored, stored + pixel * count, pixel);
    }
  };
  return {image.height, 1 + pixel * image.width, make};
}

/// Empty where all went well, else the reason: that of the stream, where it has one, or libpng's.
std::string write_to(std::FILE* stream, const Image& image, const float* alpha,
                     const WriteOptions& options) {
  PngMessage message;
  png_structp png = png_create_write_struct(PNG_LIBPNG_VER_STRING, &message, on_error, on_warning);
  png_infop info = png == nullptr ? nullptr : png_create_info_struct(png);
  if (info == nullptr) {
    png_destroy_write_struct(&png, nullptr);
    return "not enough memory";
  }
  // Level 2 with this filter is 4 times as fast as libpng's defaults and hardly larger.
  constexpr int kLevel = 2;
  const StoredPixels pixels(image, alpha, options);
  const auto take = [png](const std::vector<unsigned char>& part) {
    constexpr std::size_t kLongest = std::size_t{1} << 30;  // PNG's chunks have 31 bits
    bool good = true;
    for (std::size_t at = 0; good && at < part.size(); at += kLongest)
      good = write_chunk(png, "IDAT", part.data() + at, std::min(kLongest, part.size() - at));
    return good;
  };
  bool good = false;
  try {
    const Rows rows = filtered_rows(image, pixels);
    good = start_file(png, info, stream, image, options.bits, alpha != nullptr) &&
           deflate_rows(rows, kLevel, options.threads, take) &&
           write_chunk(png, "IEND", nullptr, 0);
  } catch (const std::bad_alloc&) {
    message.text = "not enough memory";
  } catch (const std::exception& reason) {  // oneTBB's, where the system starts no more threads
    message.text = reason.what();
  }
  png_destroy_write_struct(&png, &info);
  if (good) return "";
  return std::ferror(stream) != 0 ? std::strerror(message.error) : message.text;
}

/// Where libpng reads from.
struct PngSource {
  const char* at;
  std::size_t left;
};

void read_bytes(png_structp png, png_bytep out, std::size_t count) {
  auto* source = static_cast<PngSource*>(png_get_io_ptr(png));
  if (source->left < count) png_error(png, "the file ends too early");
  std::memcpy(out, source->at, count);
  source->at += count;
  source->left -= count;
}

struct Header {
  std::uint32_t width, height;
  std::size_t stored_row_bytes;  ///< as they are in the file
  bool interlaced;
};

bool read_header(png_structp png, png_infop info, PngSource* source, Header& header) {
  if (setjmp(png_jmpbuf(png)) != 0) return false;  // NOLINT: libpng's way
  png_set_read_fn(png, source, read_bytes);
  // The caller judges the size; text, profiles and the like are passed over, whatever their size.
  png_set_user_limits(png, PNG_UINT_31_MAX, PNG_UINT_31_MAX);
  png_set_chunk_malloc_max(png, 0);
  png_set_keep_unknown_chunks(png, PNG_HANDLE_CHUNK_NEVER, nullptr, -1);
  png_read_info(png, info);
  header = {png_get_image_width(png, info), png_get_image_height(png, info),
            png_get_rowbytes(png, info), png_get_interlace_type(png, info) != PNG_INTERLACE_NONE};
  return true;
}

/// Makes RGBA rows of 8 or 16 bits a channel of everything that a PNG can hold.
bool start_rows(png_structp png, png_infop info, int& bits) {
  if (setjmp(png_jmpbuf(png)) != 0) return false;  // NOLINT: libpng's way
  png_set_expand(png);
  png_set_gray_to_rgb(png);
  png_set_add_alpha(png, 0xFFFF, PNG_FILLER_AFTER);
  png_set_interlace_handling(png);
  png_read_update_info(png, info);
  bits = png_get_bit_depth(png, info);
  return true;
}

/// Stored values, over black unless there is a place for alpha. True if a pixel is not opaque.
bool take_row(const unsigned char* in, int bits, std::uint32_t width, float* out,
              std::vector<float>* alphas) {
  bool see_through = false;
  const auto value = [&](std::size_t i) {
    return bits == 16 ? static_cast<float>(in[2 * i] * 256 + in[2 * i + 1]) / 65535.0f
                      : static_cast<float>(in[i]) / 255.0f;
  };
  for (std::size_t x = 0; x < width; ++x) {
    const float alpha = value(4 * x + 3);
    see_through = see_through || alpha < 1;
    if (alphas != nullptr) alphas->push_back(alpha);
    const float over_black = alphas != nullptr ? 1 : alpha;
    for (std::size_t c = 0; c < 3; ++c) out[3 * x + c] = over_black * value(4 * x + c);
  }
  return see_through;
}

/// An interlaced picture's rows come together in several passes, so `bytes` holds all of them; else
/// it holds one row.
bool read_rows(png_structp png, const Header& header, int bits, unsigned char* bytes,
               std::size_t row_bytes, ReadImage& read, std::vector<float>* alpha) {
  if (setjmp(png_jmpbuf(png)) != 0) return false;  // NOLINT: libpng's way
  for (int pass = 0; header.interlaced && pass < PNG_INTERLACE_ADAM7_PASSES; ++pass)
    for (std::size_t y = 0; y < header.height; ++y)
      png_read_row(png, bytes + y * row_bytes, nullptr);
  for (std::uint32_t y = 0; y < header.height; ++y) {
    if (!header.interlaced) png_read_row(png, bytes, nullptr);
    const unsigned char* row = header.interlaced ? bytes + y * row_bytes : bytes;
    if (take_row(row, bits, header.width, read.image.row(y), alpha)) read.alpha = true;
  }
  png_read_end(png, nullptr);
  return true;
}

/// What libpng keeps for a picture, until it is read.
class PngReader {
 public:
  PngReader()
      : png_(png_create_read_struct(PNG_LIBPNG_VER_STRING, &message_, on_error, on_warning)),
        info_(png_ == nullptr ? nullptr : png_create_info_struct(png_)) {}
  ~PngReader() { png_destroy_read_struct(&png_, &info_, nullptr); }
  PngReader(const PngReader&) = delete;
  PngReader& operator=(const PngReader&) = delete;

  Result<ReadImage> read(const ImageFile& file);

 private:
  PngMessage message_;
  png_structp png_;
  png_infop info_;
};

Result<ReadImage> PngReader::read(const ImageFile& file) {
  const auto problem = [&] {
    return failure(file.name, phrase(Word::image_no_png, message_.text));
  };
  if (info_ == nullptr) return failure(file.name, "cannot be read: not enough memory");
  PngSource source{file.bytes.data(), file.bytes.size()};
  Header header{};
  if (!read_header(png_, info_, &source, header)) return problem();
  if (const Result<void> fits = file.check_size(header.width, header.height); !fits)
    return tl::make_unexpected(fits.error());
  // Deflate makes at most 1032 bytes of one.
  if (std::uint64_t{header.stored_row_bytes} * header.height / 1032 > file.bytes.size())
    return failure(file.name,
                   phrase(Word::image_cut_off, file.bytes.size(), header.width, header.height));
  ReadImage read;
  read.format = "PNG";
  if (!start_rows(png_, info_, read.bits)) return problem();
  const std::size_t row_bytes = png_get_rowbytes(png_, info_);
  std::vector<unsigned char> bytes(header.interlaced ? row_bytes * header.height : row_bytes);
  read.image = Image(header.width, header.height);
  if (!read_rows(png_, header, read.bits, bytes.data(), row_bytes, read, file.alpha)) return problem();
  return read;
}

WriteOptions options_of(const PngOptions& options) {
  return {.bits = options.bits, .transfer = options.transfer, .threads = options.threads};
}

}  // namespace

std::string put_png(std::FILE* stream, const PictureToWrite& picture, const WriteOptions& options) {
  return write_to(stream, picture.image, picture.layers.alpha(), options);
}

Result<void> write_png(const Image& image, const std::string& path, const PngOptions& options) {
  Result<NewFile> file = NewFile::create(path);
  if (!file) return tl::make_unexpected(file.error());
  const std::string problem = write_to(file->stream(), image, nullptr, options_of(options));
  if (!problem.empty()) return failure(file->name(), phrase(Word::path_unwritable, problem));
  return file->commit();
}

Result<std::string> encode_png(const Image& image, const PngOptions& options) {
  char* bytes = nullptr;
  std::size_t size = 0;
  std::FILE* stream = ::open_memstream(&bytes, &size);
  if (stream == nullptr) return failure("", "a PNG cannot be made: not enough memory");
  const std::string problem = write_to(stream, image, nullptr, options_of(options));
  const bool closed = std::fclose(stream) == 0;
  std::string png(bytes, size);
  std::free(bytes);  // NOLINT: open_memstream's memory
  if (!problem.empty() || !closed)
    return failure("", fmt::format("a PNG cannot be made: {}", problem));
  return png;
}

Result<ReadImage> parse_png(const ImageFile& file) {
  return PngReader().read(file);
}

}  // namespace zraka
