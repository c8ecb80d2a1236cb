// SPDX-License-Identifier: Apache-2.0
// OpenEXR through OpenEXRCore, whose C library adds a tenth of what the C++ one adds to the start
// of a program. What pictures are seldom made of (several parts, deep pixels, subsampled channels)
// is refused before the library decodes anything.
#include <fmt/format.h>
#include <openexr.h>

#include <algorithm>
#include <array>
#include <cstdlib>
#include <cstring>
#include <vector>

#include "core/text.hpp"
#include "image/readers.hpp"

namespace zraka {
namespace {

/// A block of 256 rows of 8K with 8 float channels has as many bytes.
constexpr std::uint64_t kMostBlockBytes = std::uint64_t{1} << 28;
constexpr int kLongestSide = 1 << 24;

/// What the library is given as its own, and gives back to the functions below.
struct ExrStream {
  std::string_view bytes;
  std::string message;
};

std::int64_t read_bytes(exr_const_context_t, void* stream, void* out, std::uint64_t count,
                        std::uint64_t offset, exr_stream_error_func_ptr_t) {
  const std::string_view bytes = static_cast<ExrStream*>(stream)->bytes;
  if (offset >= bytes.size()) return 0;
  const std::size_t got = std::min<std::uint64_t>(count, bytes.size() - offset);
  std::memcpy(out, bytes.data() + offset, got);
  return static_cast<std::int64_t>(got);
}

std::int64_t size_of(exr_const_context_t, void* stream) {
  return static_cast<std::int64_t>(static_cast<ExrStream*>(stream)->bytes.size());
}

void on_error(exr_const_context_t context, exr_result_t, const char* text) {
  void* stream = nullptr;
  if (exr_get_user_data(context, &stream) == EXR_ERR_SUCCESS && stream != nullptr)
    static_cast<ExrStream*>(stream)->message = text;
}

/// Memory that is 0: the library passes over blocks that unpack to less than they should, and what
/// is missing should be the same in every run, and nobody's secret.
void* zeroed(std::size_t size) {
  return std::calloc(1, size);  // NOLINT: the library's way
}

/// A window of pixels with its first and behind its last corner.
struct Window {
  std::int64_t x0, y0, x1, y1;
  std::uint64_t width() const { return x1 > x0 ? static_cast<std::uint64_t>(x1 - x0) : 0; }
  std::uint64_t height() const { return y1 > y0 ? static_cast<std::uint64_t>(y1 - y0) : 0; }
};
Window window_of(const exr_attr_box2i_t& box) {
  return {box.min.x, box.min.y, std::int64_t{box.max.x} + 1, std::int64_t{box.max.y} + 1};
}

class ExrReader {
 public:
  explicit ExrReader(const ImageFile& file) : file_(file), stream_{file.bytes, {}} {}
  ~ExrReader() {
    if (decoding_) exr_decoding_destroy(context_, &decoder_);
    if (context_ != nullptr) exr_finish(&context_);
  }
  ExrReader(const ExrReader&) = delete;
  ExrReader& operator=(const ExrReader&) = delete;

  Result<ReadImage> read();

 private:
  tl::unexpected<Diagnostics> problem(exr_result_t code) const;
  Result<void> check_header();
  Result<void> find_channels();
  Result<void> decode(const exr_chunk_info_t& chunk, std::int64_t left, std::int64_t top);
  Result<void> read_scan_lines();
  Result<void> read_tiles();

  const ImageFile& file_;
  ExrStream stream_;
  exr_context_t context_ = nullptr;
  exr_decode_pipeline_t decoder_{};
  bool decoding_ = false;
  Window display_{}, data_{};
  std::array<int, 3> channels_ = {-1, -1, -1};  ///< the file's indices of red, green and blue
  std::vector<float> block_;
  ReadImage read_;
};

tl::unexpected<Diagnostics> ExrReader::problem(exr_result_t code) const {
  return failure(file_.name,
                 fmt::format("is no OpenEXR that can be read: {}",
                             stream_.message.empty() ? exr_get_default_error_message(code)
                                                     : shown(stream_.message)));
}

Result<void> ExrReader::check_header() {
  if (file_.bytes.size() < 8) return failure(file_.name, "is an OpenEXR that is cut off");
  const auto flags = static_cast<unsigned char>(file_.bytes[5]);
  if ((flags & 0x08) != 0)
    return failure(file_.name, "is an OpenEXR with deep pixels", "flatten it");
  if ((flags & 0x10) != 0)
    return failure(file_.name, "is an OpenEXR with several parts",
                   "save the one that counts alone");

  exr_context_initializer_t start = EXR_DEFAULT_CONTEXT_INITIALIZER;
  start.error_handler_fn = on_error;
  start.alloc_fn = zeroed;
  start.free_fn = std::free;
  start.user_data = &stream_;
  start.read_fn = read_bytes;
  start.size_fn = size_of;
  start.max_image_width = start.max_image_height = kLongestSide;
  start.max_tile_width = start.max_tile_height = 1 << 14;
  start.flags = EXR_CONTEXT_FLAG_DISABLE_CHUNK_RECONSTRUCTION;
  if (const exr_result_t code = exr_start_read(&context_, file_.name.c_str(), &start); code != 0)
    return problem(code);

  exr_attr_box2i_t display{}, data{};
  exr_result_t code = exr_get_display_window(context_, 0, &display);
  if (code == 0) code = exr_get_data_window(context_, 0, &data);
  if (code != 0) return problem(code);
  display_ = window_of(display);
  data_ = window_of(data);
  for (const Window& window : {display_, data_})
    if (Result<void> fits = file_.check_size(window.width(), window.height()); !fits) return fits;
  // Its old versions unpack these not at all, or wrongly.
  exr_compression_t compression{};
  if (code = exr_get_compression(context_, 0, &compression); code != 0) return problem(code);
  if (compression > EXR_COMPRESSION_PXR24)
    return failure(file_.name, "is an OpenEXR with lossy compression (B44 or DWA)",
                   "save it with ZIP or PIZ");
  std::uint64_t block_bytes = 0;
  if (code = exr_get_chunk_unpacked_size(context_, 0, &block_bytes); code != 0)
    return problem(code);
  if (block_bytes > kMostBlockBytes)
    return failure(file_.name, fmt::format("is too large: a block of it has {} bytes, where at "
                                           "most {} are read",
                                           block_bytes, kMostBlockBytes));
  return {};
}

Result<void> ExrReader::find_channels() {
  const exr_attr_chlist_t* list = nullptr;
  if (const exr_result_t code = exr_get_channels(context_, 0, &list); code != 0)
    return problem(code);
  std::string names;
  int grey = -1;
  for (int i = 0; i < list->num_channels; ++i) {
    const exr_attr_chlist_entry_t& entry = list->entries[i];
    const std::string_view name(entry.name.str, static_cast<std::size_t>(entry.name.length));
    names += fmt::format("{}{}", i == 0 ? "" : ", ", name);
    if (name == "R") channels_[0] = i;
    if (name == "G") channels_[1] = i;
    if (name == "B") channels_[2] = i;
    if (name == "Y") grey = i;
  }
  if (channels_ == std::array{-1, -1, -1} && grey >= 0) channels_ = {grey, grey, grey};
  if (*std::min_element(channels_.begin(), channels_.end()) < 0)
    return failure(file_.name, fmt::format("is an OpenEXR without R, G and B: it has {}",
                                           names.empty() ? "nothing" : shown(names)));
  for (const int i : channels_) {
    const exr_attr_chlist_entry_t& entry = list->entries[i];
    const auto refuse = [&](std::string_view what) {
      return failure(file_.name, fmt::format("is an OpenEXR whose channel {} {}",
                                             std::string_view(entry.name.str), what));
    };
    if (entry.x_sampling != 1 || entry.y_sampling != 1)
      return refuse("has fewer samples than the picture pixels");
    if (entry.pixel_type == EXR_PIXEL_UINT) return refuse("holds whole numbers, not light");
    read_.bits =
        std::max(entry.pixel_type == EXR_PIXEL_HALF ? 16 : 32, i == channels_[0] ? 0 : read_.bits);
  }
  return {};
}

Result<void> ExrReader::decode(const exr_chunk_info_t& chunk, std::int64_t left, std::int64_t top) {
  exr_result_t code = decoding_ ? exr_decoding_update(context_, 0, &chunk, &decoder_)
                                : exr_decoding_initialize(context_, 0, &chunk, &decoder_);
  if (code != 0) return problem(code);
  const auto width = static_cast<std::size_t>(chunk.width);
  const auto height = static_cast<std::size_t>(chunk.height);
  block_.resize(3 * width * height);
  for (int i = 0; i < decoder_.channel_count; ++i) {
    exr_coding_channel_info_t& channel = decoder_.channels[i];
    channel.decode_to_ptr = nullptr;
    const auto at = std::find(channels_.begin(), channels_.end(), i) - channels_.begin();
    if (at == 3) continue;
    channel.user_bytes_per_element = sizeof(float);
    channel.user_data_type = EXR_PIXEL_FLOAT;
    channel.user_pixel_stride = 3 * sizeof(float);
    channel.user_line_stride = static_cast<std::int32_t>(3 * sizeof(float) * width);
    channel.decode_to_ptr = reinterpret_cast<std::uint8_t*>(block_.data() + at);
  }
  if (!decoding_) code = exr_decoding_choose_default_routines(context_, 0, &decoder_);
  decoding_ = true;
  if (code == 0) code = exr_decoding_run(context_, 0, &decoder_);
  if (code != 0) return problem(code);

  // What lies within the display window, which is the picture.
  const std::int64_t x0 = std::max(left, display_.x0);
  const std::int64_t x1 = std::min(left + chunk.width, display_.x1);
  for (std::int64_t y = std::max(top, display_.y0); y < std::min(top + chunk.height, display_.y1);
       ++y) {
    if (x0 >= x1) break;
    const float* in = block_.data() + 3 * (static_cast<std::size_t>(y - top) * width +
                                           static_cast<std::size_t>(x0 - left));
    float* out = read_.image.row(static_cast<std::uint32_t>(y - display_.y0)) +
                 3 * static_cast<std::size_t>(x0 - display_.x0);
    const auto count = static_cast<std::size_t>(x1 - x0);
    for (std::size_t i = 0; i < 3 * count; ++i)
      out[i] = in[channels_[0] == channels_[1] ? i - i % 3 : i];
  }
  return {};
}

Result<void> ExrReader::read_scan_lines() {
  std::int32_t lines = 0;
  if (const exr_result_t code = exr_get_scanlines_per_chunk(context_, 0, &lines); code != 0)
    return problem(code);
  for (std::int64_t y = data_.y0; y < data_.y1; y += lines) {
    exr_chunk_info_t chunk{};
    if (const exr_result_t code =
            exr_read_scanline_chunk_info(context_, 0, static_cast<int>(y), &chunk);
        code != 0)
      return problem(code);
    if (Result<void> done = decode(chunk, data_.x0, y); !done) return done;
  }
  return {};
}

Result<void> ExrReader::read_tiles() {
  std::uint32_t width = 0, height = 0;
  exr_tile_level_mode_t levels{};
  exr_tile_round_mode_t rounding{};
  if (const exr_result_t code =
          exr_get_tile_descriptor(context_, 0, &width, &height, &levels, &rounding);
      code != 0)
    return problem(code);
  if (width == 0 || height == 0) return failure(file_.name, "is an OpenEXR with tiles of no size");
  for (std::int64_t y = 0; y * height < static_cast<std::int64_t>(data_.height()); ++y)
    for (std::int64_t x = 0; x * width < static_cast<std::int64_t>(data_.width()); ++x) {
      exr_chunk_info_t chunk{};
      if (const exr_result_t code = exr_read_tile_chunk_info(context_, 0, static_cast<int>(x),
                                                             static_cast<int>(y), 0, 0, &chunk);
          code != 0)
        return problem(code);
      if (Result<void> done = decode(chunk, data_.x0 + x * width, data_.y0 + y * height); !done)
        return done;
    }
  return {};
}

Result<ReadImage> ExrReader::read() {
  Result<void> good = check_header();
  if (good) good = find_channels();
  exr_storage_t storage{};
  if (good)
    if (const exr_result_t code = exr_get_storage(context_, 0, &storage); code != 0)
      good = problem(code);
  if (!good) return tl::make_unexpected(good.error());
  read_.format = "OpenEXR";
  read_.floats = true;
  read_.image = Image(static_cast<std::uint32_t>(display_.width()),
                      static_cast<std::uint32_t>(display_.height()));
  good = storage == EXR_STORAGE_TILED ? read_tiles() : read_scan_lines();
  if (!good) return tl::make_unexpected(good.error());
  return std::move(read_);
}

}  // namespace

Result<ReadImage> parse_exr(const ImageFile& file) {
  return ExrReader(file).read();
}

}  // namespace zraka
