// SPDX-License-Identifier: Apache-2.0
// Radiance's pictures: three bytes and an exponent that they share (Ward, "Real pixels", Graphics
// Gems II, 1991), as they are or with runs of equal bytes or pixels.
#include <fmt/format.h>

#include <array>
#include <cmath>
#include <optional>

#include "core/text.hpp"
#include "image/readers.hpp"

namespace zraka {
namespace {

using Rgbe = std::array<unsigned char, 4>;

/// The order of pixels: lines run along one axis, and follow each other along the other one.
struct Order {
  std::uint32_t lines = 0, pixels = 0;  ///< of a line
  bool lines_are_columns = false;
  bool lines_backwards = false, pixels_backwards = false;  ///< from below, or from the right

  std::uint32_t width() const { return lines_are_columns ? lines : pixels; }
  std::uint32_t height() const { return lines_are_columns ? pixels : lines; }
};

class HdrReader {
 public:
  explicit HdrReader(const ImageFile& file) : file_(file) {}

  Result<ReadImage> read() {
    const Result<Order> order = read_header();
    if (!order) return tl::make_unexpected(order.error());
    if (const auto fits = file_.check_size(order->width(), order->height()); !fits)
      return tl::make_unexpected(fits.error());
    // A line has at least one pixel.
    if (bytes_left() / 4 < order->lines)
      return failure(file_.name, fmt::format("is cut off: {} bytes cannot hold {}×{} pixels",
                                             bytes_left(), order->width(), order->height()));
    ReadImage read;
    read.format = "Radiance HDR";
    read.bits = 32;
    read.floats = true;
    read.image = Image(order->width(), order->height());
    std::vector<Rgbe> line(order->pixels);
    for (line_ = 0; line_ < order->lines; ++line_) {
      if (const Result<void> done = read_line(line); !done)
        return tl::make_unexpected(done.error());
      put(line, *order, read.image);
    }
    return read;
  }

 private:
  std::uint64_t bytes_left() const { return file_.bytes.size() - at_; }

  /// Without its end; nothing where the file ends before it.
  std::optional<std::string_view> next_text() {
    const std::size_t end = file_.bytes.find('\n', at_);
    if (end == std::string_view::npos) return std::nullopt;
    std::string_view text = file_.bytes.substr(at_, end - at_);
    if (text.ends_with('\r')) text.remove_suffix(1);
    at_ = end + 1;
    ++text_line_;
    return text;
  }

  tl::unexpected<Diagnostics> problem_in_header(std::string message, std::string hint = {}) const {
    Diagnostic d;
    d.file = file_.name;
    d.line = text_line_;
    d.message = std::move(message);
    d.hint = std::move(hint);
    return tl::make_unexpected(Diagnostics{std::move(d)});
  }

  Result<Order> read_header() {
    constexpr std::string_view kFormat = "FORMAT=", kExpected = "32-bit_rle_rgbe";
    while (true) {
      const std::optional<std::string_view> text = next_text();
      if (!text) return failure(file_.name, "is cut off: its header does not end");
      if (text->empty()) break;
      if (text->starts_with(kFormat) && text->substr(kFormat.size()) != kExpected)
        return problem_in_header(fmt::format("the format '{}' cannot be read: expected {}",
                                             shown(text->substr(kFormat.size())), kExpected),
                                 "save it with red, green and blue");
    }
    const std::optional<std::string_view> text = next_text();
    if (!text) return failure(file_.name, "is cut off: it does not say its size");
    if (const std::optional<Order> order = order_of(*text)) return *order;
    return problem_in_header(
        fmt::format("'{}' is no size: expected something like -Y 480 +X 640", shown(*text)));
  }

  /// "-Y 480 +X 640": 480 lines from the top, of 640 pixels from the left.
  static std::optional<Order> order_of(std::string_view text) {
    struct HdrAxis {
      bool negative, is_x;
      std::uint32_t count;
    };
    std::array<HdrAxis, 2> axes{};
    for (HdrAxis& axis : axes) {
      if (text.size() < 4 || (text[0] != '-' && text[0] != '+') ||
          (text[1] != 'X' && text[1] != 'Y') || text[2] != ' ')
        return std::nullopt;
      axis.negative = text[0] == '-';
      axis.is_x = text[1] == 'X';
      text.remove_prefix(3);
      std::uint64_t count = 0;
      std::size_t digits = 0;
      for (; digits < text.size() && text[digits] >= '0' && text[digits] <= '9'; ++digits) {
        count = count * 10 + static_cast<std::uint64_t>(text[digits] - '0');
        if (count > 0x7FFFFFFF) return std::nullopt;
      }
      if (digits == 0) return std::nullopt;
      axis.count = static_cast<std::uint32_t>(count);
      text.remove_prefix(digits);
      if (&axis == axes.data()) {
        if (text.empty() || text[0] != ' ') return std::nullopt;
        text.remove_prefix(1);
      }
    }
    if (!text.empty() || axes[0].is_x == axes[1].is_x) return std::nullopt;
    // Y points up and X to the right.
    return Order{axes[0].count, axes[1].count, axes[0].is_x, axes[0].negative == axes[0].is_x,
                 axes[1].negative == axes[1].is_x};
  }

  tl::unexpected<Diagnostics> cut_off() const {
    return failure(file_.name,
                   fmt::format("is cut off: the file ends in line {} of pixels", line_ + 1));
  }
  tl::unexpected<Diagnostics> problem(std::string_view what) const {
    return failure(file_.name, fmt::format("line {} of pixels {}", line_ + 1, what));
  }

  unsigned char next_byte() { return static_cast<unsigned char>(file_.bytes[at_++]); }
  Rgbe next_pixel() {
    const unsigned char r = next_byte(), g = next_byte(), b = next_byte();
    return {r, g, b, next_byte()};
  }

  Result<void> read_line(std::vector<Rgbe>& line) {
    if (bytes_left() < 4) return cut_off();
    const std::size_t begin = at_;
    const Rgbe first = next_pixel();
    const bool by_channels = line.size() >= 8 && line.size() < 0x8000 && first[0] == 2 &&
                             first[1] == 2 && first[2] < 128;
    if (by_channels) {
      if (std::size_t{first[2]} * 256 + first[3] != line.size())
        return problem(fmt::format("says that it has {} pixels, where {} were expected",
                                   first[2] * 256 + first[3], line.size()));
      for (std::size_t channel = 0; channel < 4; ++channel)
        if (Result<void> done = read_channel(line, channel); !done) return done;
      return {};
    }
    at_ = begin;
    return read_pixels(line);
  }

  /// Runs of equal bytes, and bytes that are no run, each behind their number.
  Result<void> read_channel(std::vector<Rgbe>& line, std::size_t channel) {
    std::size_t i = 0;
    while (i < line.size()) {
      if (bytes_left() < 2) return cut_off();
      const unsigned code = next_byte();
      const bool is_run = code > 128;
      const std::size_t count = is_run ? code - 128 : code;
      if (count == 0) return problem("has a run of no pixels");
      if (count > line.size() - i) return problem("has a run beyond its end");
      if (!is_run && bytes_left() < count) return cut_off();
      const unsigned char repeated = is_run ? next_byte() : static_cast<unsigned char>(0);
      for (std::size_t k = 0; k < count; ++k) line[i++][channel] = is_run ? repeated : next_byte();
    }
    return {};
  }

  /// Pixels one by one; red, green and blue of 1 stand for a number of pixels like the last, those
  /// that follow each other for the bytes of one number.
  Result<void> read_pixels(std::vector<Rgbe>& line) {
    unsigned shift = 0;
    for (std::size_t i = 0; i < line.size();) {
      if (bytes_left() < 4) return cut_off();
      const Rgbe pixel = next_pixel();
      if (pixel[0] != 1 || pixel[1] != 1 || pixel[2] != 1) {
        line[i++] = pixel;
        shift = 0;
        continue;
      }
      if (i == 0) return problem("begins with a run");
      const std::uint64_t count = shift < 32 ? std::uint64_t{pixel[3]} << shift : 0;
      if (count > line.size() - i) return problem("has a run beyond its end");
      for (std::uint64_t k = 0; k < count; ++k, ++i) line[i] = line[i - 1];
      shift += 8;
    }
    return {};
  }

  void put(const std::vector<Rgbe>& line, const Order& order, Image& image) const {
    const std::uint32_t l = order.lines_backwards ? order.lines - 1 - line_ : line_;
    for (std::uint32_t i = 0; i < order.pixels; ++i) {
      const std::uint32_t p = order.pixels_backwards ? order.pixels - 1 - i : i;
      float* out = order.lines_are_columns ? image.row(p) + std::size_t{3} * l
                                           : image.row(l) + std::size_t{3} * p;
      const float scale = line[i][3] == 0 ? 0.0f : std::ldexp(1.0f, line[i][3] - 136);
      for (std::size_t c = 0; c < 3; ++c) out[c] = static_cast<float>(line[i][c]) * scale;
    }
  }

  const ImageFile& file_;
  std::size_t at_ = 0, text_line_ = 0;
  std::uint32_t line_ = 0;  ///< of pixels
};

}  // namespace

Result<ReadImage> parse_hdr(const ImageFile& file) {
  return HdrReader(file).read();
}

}  // namespace zraka
