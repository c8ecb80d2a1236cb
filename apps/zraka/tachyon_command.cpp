// SPDX-License-Identifier: Apache-2.0
// zraka-tachyon: the program by the name that says it is called as Tachyon is.
#include "tachyon_command.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <filesystem>
#include <zraka/zraka.hpp>

#include "command.hpp"
#include "core/file.hpp"
#include "core/new_file.hpp"
#include "image/writers.hpp"
#include "progress.hpp"
#include "tachyon_options.hpp"
#include "terminal.hpp"

namespace zraka::app {
namespace {

/// Bytes of a picture from the lowest row up, blue first, each row filled up to a multiple.
std::string rows_from_below(const Image& image, std::size_t multiple) {
  const std::size_t row = std::size_t{3} * image.width;
  const std::size_t stride = (row + multiple - 1) / multiple * multiple;
  std::string bytes(stride * image.height, '\0');
  for (std::uint32_t y = 0; y < image.height; ++y) {
    const float* const from = image.row(image.height - 1 - y);
    for (std::uint32_t x = 0; x < image.width; ++x)
      for (std::size_t k = 0; k < 3; ++k)
        bytes[stride * y + 3 * x + k] =
            static_cast<char>(quantize(from[3 * x + 2 - k], Transfer::linear, 8));
  }
  return bytes;
}

void put_number(std::string& bytes, std::uint64_t value, int count) {
  for (int i = 0; i < count; ++i) bytes += static_cast<char>(value >> (8 * i) & 0xFF);
}

std::string targa(const Image& image) {
  std::string bytes(2, '\0');
  bytes += '\2';  // colours as they are
  bytes.append(9, '\0');
  put_number(bytes, image.width, 2);
  put_number(bytes, image.height, 2);
  bytes += '\x18';
  bytes += '\0';
  return bytes + rows_from_below(image, 1);
}

std::string bmp(const Image& image) {
  const std::string rows = rows_from_below(image, 4);
  std::string bytes = "BM";
  put_number(bytes, 54 + rows.size(), 4);
  put_number(bytes, 0, 4);
  put_number(bytes, 54, 4);
  put_number(bytes, 40, 4);
  put_number(bytes, image.width, 4);
  put_number(bytes, image.height, 4);
  put_number(bytes, 1, 2);
  put_number(bytes, 24, 2);
  put_number(bytes, 0, 4);
  put_number(bytes, rows.size(), 4);
  put_number(bytes, 0, 16);
  return bytes + rows;
}

std::string ppm(const Image& image, int bits) {
  std::string bytes =
      fmt::format("P6\n{} {}\n{}\n", image.width, image.height, bits == 8 ? 255 : 65535);
  bytes.reserve(bytes.size() + image.pixels.size() * static_cast<std::size_t>(bits) / 8);
  for (const float value : image.pixels) {
    const std::uint16_t stored = quantize(value, Transfer::linear, bits);
    if (bits == 16) bytes += static_cast<char>(stored >> 8);
    bytes += static_cast<char>(stored & 0xFF);
  }
  return bytes;
}

Result<void> write(const Image& image, const TachyonArguments& arguments) {
  if (arguments.format == "PNG")
    return write_png(image, arguments.output,
                     {.transfer = Transfer::linear, .threads = arguments.threads});
  if (arguments.format == "JPEG") {
    Result<NewFile> file = NewFile::create(arguments.output);
    if (!file) return tl::make_unexpected(file.error());
    WriteOptions options;
    options.bits = 8;
    options.transfer = Transfer::linear;
    const Layers none;
    const std::string problem = put_jpeg(file->stream(), {image, none}, options);
    if (!problem.empty()) return failure(arguments.output, problem);
    return file->commit();
  }
  const bool small = image.width < 65536 && image.height < 65536;
  if (arguments.format == "TARGA" && !small)
    return failure(arguments.output, "a Targa has at most 65535 columns and rows");
  return write_text_file(arguments.output, arguments.format == "TARGA" ? targa(image)
                                           : arguments.format == "BMP"
                                               ? bmp(image)
                                               : ppm(image, arguments.format == "PPM48" ? 16 : 8));
}

/// -normalize divides by what is brightest, where that is more than 1; then -gamma.
void map_tones(Image& image, const TachyonArguments& arguments) {
  float most = 1;
  if (arguments.normalize)
    for (const float value : image.pixels)
      if (std::isfinite(value)) most = std::max(most, value);
  for (float& value : image.pixels) {
    value /= most;
    if (arguments.gamma > 0)
      value = std::pow(std::max(value, 0.0f), 1 / static_cast<float>(arguments.gamma));
  }
}

Result<ReadScene> read(const TachyonArguments& arguments) {
  const Result<std::string> text = read_file(arguments.scene, std::uint64_t{1} << 36);
  if (!text) return tl::make_unexpected(text.error());
  std::string_view begins = *text;
  if (begins.starts_with(kByteOrderMark)) begins.remove_prefix(kByteOrderMark.size());
  const std::filesystem::path path(arguments.scene);
  const bool is_nff = path.extension() == ".nff" && likeness_to_tachyon(begins) == Likeness::none;
  if (is_nff) return read_scene(arguments.scene);
  ReadOptions options;
  options.folder = path.parent_path().string();
  TachyonSettings settings = arguments.settings;
  if (arguments.samples) settings.samples = *arguments.samples;
  if (arguments.width > 0) settings.resolution = Resolution{arguments.width, arguments.height};
  return parse_tachyon(*text, arguments.scene == "-" ? "standard input" : arguments.scene, options,
                       settings);
}

int run(const TachyonArguments& arguments) {
  const auto start = std::chrono::steady_clock::now();
  if (const Result<void> good =
          check_outputs({arguments.scene}, {arguments.save ? arguments.output : ""});
      !good)
    return fail(good.error());
  Result<ReadScene> read_in = read(arguments);
  if (!read_in) return fail(read_in.error());
  Diagnostics warnings = std::move(read_in->warnings);
  for (const std::string& option : arguments.ignored)
    if (option.starts_with("-trans"))
      warnings.push_back(
          {.severity = Severity::warning, .message = fmt::format("{} is left out", option)});
  show(warnings);
  Scene& scene = read_in->scene;
  RenderOptions options;
  options.profile = profile_of(ProfileName::tachyon);
  options.max_depth =
      arguments.depth ? std::clamp(*arguments.depth - 1, 0, kMaxDepth) : scene.defaults.max_depth;
  options.shadows = scene.defaults.shadows;
  options.sampling = scene.defaults.sampling;
  options.threads = arguments.threads;
  options.bind_threads = true;
  Result<Rendering> rendering;
  {
    Progress progress(false);
    options.progress = progress.callback();
    rendering = render(std::move(scene), options);
  }
  if (!rendering) return fail(rendering.error());
  map_tones(rendering->image, arguments);
  if (arguments.save)
    if (const Result<void> written = write(rendering->image, arguments); !written)
      return fail(written.error());
  if (arguments.verbose)
    fmt::print("{:.3f} s in all, {:.3f} s of it drawing\n",
               std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count(),
               rendering->stats.render_seconds);
  return kDone;
}

}  // namespace

bool is_called_tachyon(const char* program) {
  return program != nullptr && std::filesystem::path(program).filename() == "zraka-tachyon";
}

int run_tachyon(int argc, char** argv) {
  TachyonArguments arguments;
  const std::string problem = arguments.read({argv + std::min(argc, 1), argv + argc});
  if (!problem.empty()) {
    fmt::print(stderr, "{}\nRun 'zraka-tachyon -help' for more information.\n", problem);
    return kWrongUsage;
  }
  if (arguments.help || arguments.version) {
    fmt::print("{}", arguments.help ? kTachyonHelp : "zraka-tachyon " ZRAKA_VERSION "\n");
    return kDone;
  }
  return run(arguments);
}

}  // namespace zraka::app
