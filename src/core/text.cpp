// SPDX-License-Identifier: Apache-2.0
#include "core/text.hpp"

#include <algorithm>
#include <array>
#include <bit>
#include <charconv>
#include <cstdint>
#include <cstdlib>
#include <cstring>

namespace zraka {
namespace {

constexpr std::string_view kReplacement = "\xEF\xBF\xBD";  // U+FFFD
constexpr std::string_view kLineEnd = "\xE2\x86\xB5";      // U+21B5, the key's arrow

/// Length of the character of UTF-8 that starts the text, 0 if none does.
std::size_t character_length(std::string_view text) {
  const auto byte = [&](std::size_t i) { return static_cast<unsigned char>(text[i]); };
  const unsigned char lead = byte(0);
  if (lead < 0x80) return 1;
  const std::size_t length = lead >= 0xF0 ? 4 : lead >= 0xE0 ? 3 : 2;
  if (lead < 0xC2 || lead > 0xF4 || text.size() < length) return 0;
  for (std::size_t i = 1; i < length; ++i)
    if ((byte(i) & 0xC0) != 0x80) return 0;
  if ((lead == 0xE0 && byte(1) < 0xA0) || (lead == 0xED && byte(1) > 0x9F)) return 0;
  if ((lead == 0xF0 && byte(1) < 0x90) || (lead == 0xF4 && byte(1) > 0x8F)) return 0;
  return length;
}

/// Characters that change how others are shown: line and paragraph separators, and what turns the
/// direction of writing around (Unicode Standard Annex 9, "explicit directional formatting").
bool steers_layout(std::string_view character) {
  const auto byte = [&](std::size_t i) { return static_cast<unsigned char>(character[i]); };
  if (character.size() == 2) return byte(0) == 0xD8 && byte(1) == 0x9C;  // U+061C
  if (character.size() != 3 || byte(0) != 0xE2) return false;
  if (byte(1) == 0x80)  // U+200E, U+200F, U+2028 to U+202E
    return byte(2) == 0x8E || byte(2) == 0x8F || (byte(2) >= 0xA8 && byte(2) <= 0xAE);
  return byte(1) == 0x81 && byte(2) >= 0xA6 && byte(2) <= 0xA9;  // U+2066 to U+2069
}

/// The first character of a text as it can be shown, and its bytes.
struct Shown {
  std::string_view text;
  std::size_t bytes;
};
Shown show_character(std::string_view text) {
  const std::size_t length = character_length(text);
  const auto first = static_cast<unsigned char>(text.front());
  if (text.starts_with("\r\n")) return {kLineEnd, 2};
  if (first == '\n') return {kLineEnd, 1};
  if (length == 0 || first == 0x7F || (first < 0x20 && first != '\t')) return {kReplacement, 1};
  if (first == 0xC2 && static_cast<unsigned char>(text[1]) < 0xA0)
    return {kReplacement, 2};  // C1 controls
  if (steers_layout(text.substr(0, length))) return {kReplacement, length};
  return {text.substr(0, length), length};
}

}  // namespace

std::string_view trimmed(std::string_view text) {
  constexpr std::string_view kSpace = " \t\r\n\v\f";
  const std::size_t first = text.find_first_not_of(kSpace);
  if (first == std::string_view::npos) return {};
  return text.substr(first, text.find_last_not_of(kSpace) - first + 1);
}

bool ends_with(std::string_view name, std::string_view ending) {
  const auto lower = [](char c) { return c >= 'A' && c <= 'Z' ? static_cast<char>(c + 32) : c; };
  return !ending.empty() && name.size() >= ending.size() &&
         std::equal(ending.begin(), ending.end(), name.end() - std::ssize(ending),
                    [&](char a, char b) { return a == lower(b); });
}

std::optional<double> parse_number(std::string_view text) {
  const bool plus = !text.empty() && text.front() == '+';
  if (plus) text.remove_prefix(1);
  const std::string_view digits = !plus && text.starts_with('-') ? text.substr(1) : text;
  if (digits.empty() || (digits.front() != '.' && (digits.front() < '0' || digits.front() > '9')))
    return std::nullopt;
  double value = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  if (end != text.data() + text.size()) return std::nullopt;
  if (error == std::errc::result_out_of_range)
    return std::strtod(std::string(text).c_str(), nullptr);
  if (error != std::errc()) return std::nullopt;
  return value;
}

namespace {

/// The value of eight digits, if eight digits follow: neighbours are joined to twos, fours and
/// eight in one word.
bool read_eight_digits(const char* at, const char* end, std::uint32_t& value) {
  if constexpr (std::endian::native != std::endian::little) return false;
  if (end - at < 8) return false;
  std::uint64_t word;
  std::memcpy(&word, at, sizeof(word));
  constexpr std::uint64_t kHigh = 0xF0F0F0F0F0F0F0F0u, kZeros = 0x3030303030303030u;
  if ((word & kHigh) != kZeros || ((word + 0x0606060606060606u) & kHigh) != kZeros) return false;
  word -= kZeros;
  word = 10 * word + (word >> 8);
  constexpr std::uint64_t kTwos = 0x000000FF000000FFu;
  constexpr std::uint64_t kFirst = 100 + (std::uint64_t{1000000} << 32),
                          kSecond = 1 + (std::uint64_t{10000} << 32);
  value = static_cast<std::uint32_t>(((word & kTwos) * kFirst + ((word >> 16) & kTwos) * kSecond) >>
                                     32);
  return true;
}

}  // namespace

const char* read_number(const char* begin, const char* end, double& value) {
  // Up to 15 digits are an exact double, and so is a power of ten up to 22: their quotient is
  // rounded once, hence right (Clinger, "How to read floating point numbers accurately", 1990).
  static constexpr std::array<double, 16> kPowers = {1e0, 1e1, 1e2,  1e3,  1e4,  1e5,  1e6,  1e7,
                                                     1e8, 1e9, 1e10, 1e11, 1e12, 1e13, 1e14, 1e15};
  const char* at = begin;
  const bool negative = at != end && *at == '-';
  if (negative) ++at;
  std::uint64_t digits = 0;
  const char* const first = at;
  for (; at != end && *at >= '0' && *at <= '9' && at - first < 16; ++at)
    digits = 10 * digits + static_cast<std::uint64_t>(*at - '0');
  std::ptrdiff_t count = at - first, behind = 0;
  if (at != end && *at == '.') {
    const char* const point = ++at;
    if (std::uint32_t eight = 0; read_eight_digits(at, end, eight)) {
      digits = 100000000 * digits + eight;
      at += 8;
    }
    for (; at != end && *at >= '0' && *at <= '9' && at - point < 16; ++at)
      digits = 10 * digits + static_cast<std::uint64_t>(*at - '0');
    behind = at - point;
    count += behind;
  }
  const bool ends =
      at == end || !((*at >= '0' && *at <= '9') || *at == 'e' || *at == 'E' || *at == '.');
  if (count > 0 && count <= 15 && ends) {
    const double whole = static_cast<double>(digits) / kPowers[static_cast<std::size_t>(behind)];
    value = negative ? -whole : whole;
    return at;
  }
  const auto [stop, error] = std::from_chars(begin, end, value);
  return error == std::errc() ? stop : nullptr;
}

bool is_utf8(std::string_view text) {
  while (!text.empty()) {
    const std::size_t length = character_length(text);
    if (length == 0) return false;
    text.remove_prefix(length);
  }
  return true;
}

TextPosition TextPositions::at(std::size_t position) {
  if (!utf8_) utf8_ = is_utf8(text_);
  position = std::min(position, text_.size());
  if (position < position_) position_ = 0, place_ = {};
  for (; position_ < position; ++position_) {
    if (text_[position_] == '\n')
      ++place_.line, place_.column = 1;
    else if (!*utf8_ || (text_[position_] & 0xC0) != 0x80)
      ++place_.column;
  }
  return place_;
}

std::string TextPositions::excerpt(std::size_t position) const {
  constexpr std::size_t kBefore = 60, kAfter = 40;
  position = std::min(position, text_.size());
  // Back to the line's start, but not too far; a cut character is left out.
  std::size_t begin = position;
  while (begin > 0 && text_[begin - 1] != '\n' && position - begin < kBefore) --begin;
  const bool cut_before = begin > 0 && text_[begin - 1] != '\n';
  while (cut_before && begin < position && (text_[begin] & 0xC0) == 0x80) ++begin;
  std::size_t end = position;
  while (end < text_.size() && text_[end] != '\n' && text_[end] != '\r' && end - position < kAfter)
    ++end;
  const bool cut_after = end < text_.size() && text_[end] != '\n' && text_[end] != '\r';
  while (cut_after && end > position && (text_[end] & 0xC0) == 0x80) --end;

  std::string line = cut_before ? "…" : "";
  std::string caret = cut_before ? " " : "";
  for (std::size_t i = begin; i < end;) {
    const Shown character = show_character(text_.substr(i, end - i));
    line += character.text;
    if (i < position) caret += character.text == "\t" ? '\t' : ' ';
    i += character.bytes;
  }
  if (cut_after) line += "…";
  return line + "\n" + caret + "^";
}

std::string shown(std::string_view text) {
  constexpr std::size_t kLongest = 60;
  std::string line;
  for (std::size_t count = 0; !text.empty(); ++count) {
    if (count == kLongest) return line + "…";
    const Shown character = show_character(text);
    line += character.text == "\t" ? " " : character.text;
    text.remove_prefix(character.bytes);
  }
  return line;
}

std::string shown_line(std::string_view text) {
  std::string line;
  while (!text.empty()) {
    const Shown character = show_character(text);
    line += character.text;
    text.remove_prefix(character.bytes);
  }
  return line;
}

std::string shown_text(std::string_view text) {
  std::string lines;
  while (!text.empty()) {
    const std::size_t end = std::min(text.find('\n'), text.size());
    lines += shown_line(text.substr(0, end));
    if (end < text.size()) lines += '\n';
    text.remove_prefix(std::min(end + 1, text.size()));
  }
  return lines;
}

std::optional<Control> control_at(std::string_view text) {
  if (text.starts_with('\x7F')) return Control{0x7F, 1};
  if (text.empty() || (text[0] & 0x80) == 0) return std::nullopt;
  const std::size_t length = character_length(text);
  if (length < 2 || length > 3 || show_character(text).text != kReplacement ||
      text.substr(0, length) == kReplacement)
    return std::nullopt;
  unsigned code = static_cast<unsigned char>(text[0]) & (length == 2 ? 0x1Fu : 0x0Fu);
  for (std::size_t i = 1; i < length; ++i)
    code = code << 6 | (static_cast<unsigned char>(text[i]) & 0x3Fu);
  return Control{code, length};
}

std::string html_text(std::string_view text) {
  std::string out;
  for (const char c : shown_text(text)) {
    switch (c) {
      case '&':
        out += "&amp;";
        break;
      case '<':
        out += "&lt;";
        break;
      case '>':
        out += "&gt;";
        break;
      case '"':
        out += "&quot;";
        break;
      default:
        out += c;
    }
  }
  return out;
}

std::string html_prose(std::string_view text) {
  const auto digit = [&](std::size_t i) {
    return i < text.size() && text[i] >= '0' && text[i] <= '9';
  };
  std::string together;
  for (std::size_t i = 0; i < text.size(); ++i)
    together += i > 0 && text[i] == ' ' && digit(i - 1) && digit(i + 1) ? "\u00A0"
                                                                        : std::string(1, text[i]);
  return html_text(together);
}

std::string grouped(unsigned long long number) {
  const std::string digits = std::to_string(number);
  std::string text;
  for (std::size_t i = 0; i < digits.size(); ++i) {
    if (i > 0 && (digits.size() - i) % 3 == 0) text += ' ';
    text += digits[i];
  }
  return text;
}

}  // namespace zraka
