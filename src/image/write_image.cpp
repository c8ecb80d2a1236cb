// SPDX-License-Identifier: Apache-2.0
// The list of formats that pictures are written in, and how a name finds its own.
#include <fmt/format.h>

#include <algorithm>
#include <cerrno>
#include <cmath>
#include <cstring>
#include <exception>
#include <filesystem>
#include <new>

#include "core/new_file.hpp"
#include "core/phrase.hpp"
#include "image/writers.hpp"

namespace zraka {
namespace {

struct Writer {
  PictureFormat format;
  WriteFunction* put;
};

const std::vector<Writer>& writers() {
  static const std::vector<Writer> all = {
      {{.name = "PNG", .endings = {".png"}, .bits = {8, 16}, .alpha = true}, put_png},
      {{.name = "OpenEXR",
        .endings = {".exr"},
        .bits = {16, 32},
        .floats = true,
        .alpha = true,
        .layers = true},
       put_exr},
      {{.name = "PPM", .endings = {".ppm"}, .bits = {8, 16}}, put_ppm},
      {{.name = "PFM", .endings = {".pfm"}, .bits = {32}, .floats = true}, put_pfm},
      {{.name = "JPEG", .endings = {".jpg", ".jpeg"}, .bits = {8}}, put_jpeg},
      {{.name = "Radiance HDR", .endings = {".hdr"}, .bits = {32}, .floats = true}, put_hdr},
  };
  return all;
}

/// Names without an ending, and those of devices and pipes, are anybody's.
const Writer* writer_of(const std::string& path) {
  std::string ending = std::filesystem::path(path).extension().string();
  for (char& c : ending) c = c >= 'A' && c <= 'Z' ? static_cast<char>(c + 32) : c;
  if (path == "-" || ending.empty() || path.starts_with("/dev/")) return &writers().front();
  for (const Writer& writer : writers())
    for (const std::string_view known : writer.format.endings)
      if (ending == known) return &writer;
  return nullptr;
}

std::string known_endings() {
  std::string all;
  for (const Writer& writer : writers())
    for (const std::string_view ending : writer.format.endings)
      all += fmt::format("{}{}", all.empty() ? "" : ", ", ending);
  return all;
}

/// Why a picture and its layers do not belong together, or "".
std::string problem_of(const Image& image, const Layers& layers) {
  if (image.width == 0 || image.height == 0) return "a picture without pixels";
  const std::uint64_t pixels = std::uint64_t{image.width} * image.height;
  if (image.pixels.size() != 3 * pixels) return "a picture with fewer values than pixels";
  for (const Channel& channel : layers.channels) {
    const std::size_t count =
        std::visit([](const auto& values) { return values.size(); }, channel.values);
    if (count != pixels || layers.width != image.width || layers.height != image.height)
      return fmt::format("the channel {} is of another size than the picture", channel.name);
    const auto same_name = [&](const Channel& other) { return other.name == channel.name; };
    if (channel.name.empty() || channel.name == "R" || channel.name == "G" || channel.name == "B" ||
        std::count_if(layers.channels.begin(), layers.channels.end(), same_name) > 1)
      return fmt::format("there are two channels called '{}'", channel.name);
    if (channel.name == "A" && channel.floats() == nullptr) return "alpha is no id";
  }
  return "";
}

/// What of the options or layers the format cannot hold, or "".
std::string problem_of(const PictureFormat& format, const Layers& layers,
                       const WriteOptions& options) {
  if (options.bits != 0 &&
      std::find(format.bits.begin(), format.bits.end(), options.bits) == format.bits.end())
    return fmt::format("{} has {} bits a value, not {}", format.name,
                       fmt::join(format.bits, " or "), options.bits);
  if (format.floats && options.tone != ToneMapping())
    return fmt::format("{} holds linear light, which is not tone-mapped", format.name);
  if (!std::isfinite(options.tone.exposure) || std::fabs(options.tone.exposure) > 100)
    return "the exposure is not from -100 to 100 stops";
  if (!std::isfinite(options.tone.white) || options.tone.white < 0) return "white is below 0";
  if (options.jpeg_quality < 1 || options.jpeg_quality > 100)
    return "a JPEG's quality is not from 1 to 100";
  for (const Channel& channel : layers.channels) {
    if (channel.name == "A" ? format.alpha : format.layers) continue;
    return fmt::format("{} holds no {}", format.name,
                       channel.name == "A" ? "alpha" : "layers beside the colours");
  }
  return "";
}

/// The writer's answer; what it throws is one, too.
std::string put(const Writer& writer, std::FILE* stream, const PictureToWrite& picture,
                const WriteOptions& options) {
  try {
    return writer.put(stream, picture, options);
  } catch (const std::bad_alloc&) {
    return "not enough memory";
  } catch (const std::exception& reason) {  // where the system starts no more threads
    return reason.what();
  }
}

}  // namespace

bool ByteStream::put(const void* bytes, std::size_t count) {
  if (error_ == 0 && std::fwrite(bytes, 1, count, stream_) != count) error_ = errno;
  return error_ == 0;
}

std::string ByteStream::problem() {
  if (error_ == 0 && std::fflush(stream_) != 0) error_ = errno;
  return error_ == 0 ? "" : std::strerror(error_);
}

std::vector<PictureFormat> picture_formats() {
  std::vector<PictureFormat> formats;
  for (const Writer& writer : writers()) formats.push_back(writer.format);
  return formats;
}

std::optional<PictureFormat> picture_format_of(const std::string& path) {
  const Writer* const writer = writer_of(path);
  if (writer == nullptr) return std::nullopt;
  return writer->format;
}

Result<void> write_image(const Image& image, const Layers& layers, const std::string& path,
                         const WriteOptions& options) {
  const Writer* const writer = writer_of(path);
  std::error_code ignored;
  if (std::filesystem::is_directory(path, ignored))
    return failure(path, phrase(Word::path_unwritable_folder));
  if (writer == nullptr)
    return failure(path, "its ending is none of a kind of picture that is written",
                   fmt::format("known are {}", known_endings()));
  std::string problem = problem_of(image, layers);
  if (problem.empty()) problem = problem_of(writer->format, layers, options);
  if (!problem.empty()) return failure(path, phrase(Word::path_unwritable, problem));
  WriteOptions all = options;
  if (all.bits == 0) all.bits = writer->format.bits.front();

  Result<NewFile> file = NewFile::create(path);
  if (!file) return tl::make_unexpected(file.error());
  problem = put(*writer, file->stream(), {image, layers}, all);
  if (!problem.empty()) return failure(file->name(), phrase(Word::path_unwritable, problem));
  return file->commit();
}

}  // namespace zraka
