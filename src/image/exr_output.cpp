// SPDX-License-Identifier: Apache-2.0
// OpenEXR through OpenEXRCore, written: all channels of a picture in one part.
#include <openexr.h>

#include <algorithm>
#include <cstring>
#include <string>
#include <vector>

#include "core/text.hpp"
#include "image/half.hpp"
#include "image/writers.hpp"

namespace zraka {
namespace {

/// A block of lines is deflated as a whole (EXR_COMPRESSION_ZIP).
constexpr std::uint32_t kBlockLines = 16;

/// The file as it comes into being, in memory: the library goes back for its table of blocks, which
/// standard output cannot.
struct Sink {
  std::string bytes;
  std::string message;
};

std::int64_t write_bytes(exr_const_context_t, void* sink, const void* from, std::uint64_t count,
                         std::uint64_t offset, exr_stream_error_func_ptr_t) {
  std::string& bytes = static_cast<Sink*>(sink)->bytes;
  if (bytes.size() < offset + count) bytes.resize(offset + count);
  std::memcpy(bytes.data() + offset, from, count);
  return static_cast<std::int64_t>(count);
}

void on_write_error(exr_const_context_t context, exr_result_t, const char* text) {
  void* sink = nullptr;
  if (exr_get_user_data(context, &sink) == EXR_ERR_SUCCESS && sink != nullptr)
    static_cast<Sink*>(sink)->message = text;
}

/// Where the values of a channel lie, four bytes each.
struct Source {
  std::string name;
  const void* values;
  std::size_t step;  ///< from one to the next, in values
  exr_pixel_type_t stored;
  std::vector<std::uint16_t> halves{};  ///< of a block of lines, where they are stored so

  const float* floats() const { return static_cast<const float*>(values); }
};

class ExrWriter {
 public:
  ExrWriter(const PictureToWrite& picture, bool halves);
  ~ExrWriter() {
    if (encoding_) exr_encoding_destroy(context_, &encoder_);
    if (context_ != nullptr) exr_finish(&context_);
  }
  ExrWriter(const ExrWriter&) = delete;
  ExrWriter& operator=(const ExrWriter&) = delete;

  /// The whole file; empty, and a message, where there is a problem.
  std::string write();
  const std::string& message() const { return sink_.message; }

 private:
  bool start();
  bool write_block(std::uint32_t y);
  bool good(exr_result_t code);

  const PictureToWrite& picture_;
  std::vector<Source> sources_;
  Sink sink_;
  exr_context_t context_ = nullptr;
  exr_encode_pipeline_t encoder_{};
  bool encoding_ = false;
};

ExrWriter::ExrWriter(const PictureToWrite& picture, bool halves) : picture_(picture) {
  const exr_pixel_type_t color = halves ? EXR_PIXEL_HALF : EXR_PIXEL_FLOAT;
  const float* const rgb = picture.image.pixels.data();
  sources_ = {{"R", rgb, 3, color}, {"G", rgb + 1, 3, color}, {"B", rgb + 2, 3, color}};
  for (const Channel& channel : picture.layers.channels)
    if (const auto* ids = channel.ids())
      sources_.push_back({channel.name, ids->data(), 1, EXR_PIXEL_UINT});
    else
      sources_.push_back({channel.name, channel.floats()->data(), 1,
                          halves && channel.half ? EXR_PIXEL_HALF : EXR_PIXEL_FLOAT});
}

bool ExrWriter::good(exr_result_t code) {
  if (code == EXR_ERR_SUCCESS) return true;
  if (sink_.message.empty()) sink_.message = exr_get_default_error_message(code);
  return false;
}

bool ExrWriter::start() {
  exr_context_initializer_t start = EXR_DEFAULT_CONTEXT_INITIALIZER;
  start.error_handler_fn = on_write_error;
  start.user_data = &sink_;
  start.write_fn = write_bytes;
  const Image& image = picture_.image;
  int part = 0;
  if (!good(exr_start_write(&context_, "picture", EXR_WRITE_FILE_DIRECTLY, &start)) ||
      !good(exr_add_part(context_, nullptr, EXR_STORAGE_SCANLINE, &part)) ||
      !good(exr_initialize_required_attr_simple(
          context_, part, static_cast<std::int32_t>(image.width),
          static_cast<std::int32_t>(image.height), EXR_COMPRESSION_ZIP)))
    return false;
  for (const Source& source : sources_)
    if (!good(exr_add_channel(context_, part, source.name.c_str(), source.stored,
                              EXR_PERCEPTUALLY_LOGARITHMIC, 1, 1)))
      return false;
  for (const auto& [name, value] : picture_.layers.notes)
    if (!good(exr_attr_set_string(context_, part, name.c_str(), value.c_str()))) return false;
  return good(exr_write_header(context_));
}

bool ExrWriter::write_block(std::uint32_t y) {
  exr_chunk_info_t chunk{};
  if (!good(exr_write_scanline_chunk_info(context_, 0, static_cast<int>(y), &chunk))) return false;
  if (!good(encoding_ ? exr_encoding_update(context_, 0, &chunk, &encoder_)
                      : exr_encoding_initialize(context_, 0, &chunk, &encoder_)))
    return false;
  const std::size_t width = picture_.image.width;
  const std::size_t first = width * y, count = width * static_cast<std::size_t>(chunk.height);
  for (int i = 0; i < encoder_.channel_count; ++i) {
    exr_coding_channel_info_t& channel = encoder_.channels[i];
    // The library has put them in the order of their names.
    Source& source = *std::find_if(sources_.begin(), sources_.end(),
                                   [&](const Source& s) { return s.name == channel.channel_name; });
    const auto lies_at = [&](const void* values, std::size_t size, std::size_t step) {
      channel.user_bytes_per_element = static_cast<std::int16_t>(size);
      channel.user_data_type = static_cast<std::uint16_t>(source.stored);
      channel.user_pixel_stride = static_cast<std::int32_t>(size * step);
      channel.user_line_stride = static_cast<std::int32_t>(size * step * width);
      channel.encode_from_ptr = static_cast<const std::uint8_t*>(values);
    };
    if (source.stored == EXR_PIXEL_HALF) {
      source.halves.resize(count);
      for (std::size_t k = 0; k < count; ++k)
        source.halves[k] = half_of(source.floats()[(first + k) * source.step]);
      lies_at(source.halves.data(), sizeof(std::uint16_t), 1);
    } else {
      lies_at(source.floats() + first * source.step, sizeof(float), source.step);
    }
  }
  if (!encoding_ && !good(exr_encoding_choose_default_routines(context_, 0, &encoder_)))
    return false;
  encoding_ = true;
  return good(exr_encoding_run(context_, 0, &encoder_));
}

std::string ExrWriter::write() {
  if (!start()) return "";
  for (std::uint32_t y = 0; y < picture_.image.height; y += kBlockLines)
    if (!write_block(y)) return "";
  exr_encoding_destroy(context_, &encoder_);
  encoding_ = false;
  if (!good(exr_finish(&context_))) return "";
  return std::move(sink_.bytes);
}

}  // namespace

std::string put_exr(std::FILE* stream, const PictureToWrite& picture, const WriteOptions& options) {
  ExrWriter writer(picture, options.bits == 16);
  const std::string bytes = writer.write();
  if (bytes.empty()) return shown(writer.message());
  ByteStream out(stream);
  out.put(bytes);
  return out.problem();
}

}  // namespace zraka
