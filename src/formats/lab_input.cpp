// SPDX-License-Identifier: Apache-2.0
// Reader of the course's input.txt (docs/input-txt.md).
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>

#include "core/phrase.hpp"
#include "core/text.hpp"
#include "formats/formats.hpp"
#include "formats/lab_tokens.hpp"
#include "formats/lab_values.hpp"
#include "math/frame.hpp"

namespace zraka {
namespace {

using lab::Token;

bool is_no_text(char c) {
  return static_cast<unsigned char>(c) < 0x20 && (c < '\t' || c > '\r');
}

/// A file with more problems than this is something else than the course's format.
constexpr std::size_t kEnoughErrors = 100;

class Reader {
 public:
  Reader(std::string_view text, const std::string& name)
      : text_(text), name_(name), tokens_(text), places_(text) {}

  Result<ReadScene> read();

 private:
  Diagnostic problem_at(std::size_t position, Severity severity, Phrase message, Phrase hint = {});
  void error(std::size_t position, Phrase message, Phrase hint = {});
  void warn(std::size_t position, Phrase message, Phrase hint = {});
  void report_strays();

  Phrase name_of_value() const;
  bool next_value(double& value);
  void watch_labels(const Token& token);
  void read_head();
  void read_count(double value);
  void take_name(std::size_t begin, std::size_t end);
  bool read_sphere();
  void check_rest();
  bool check_is_text();

  std::string_view text_;
  std::string name_;
  lab::Tokens tokens_;
  TextPositions places_;
  Scene scene_;
  Diagnostics errors_, warnings_;

  std::size_t value_ = 0;        ///< index of the next value in the head or in its sphere
  std::uint64_t sphere_ = 0;     ///< which sphere, from 1; 0 in the head
  std::uint64_t announced_ = 0;  ///< how many spheres the file says it has
  bool count_known_ = false;
  bool ended_ = false;                 ///< no value is left in the file
  std::size_t line_end_ = 0;           ///< of the line of the last label
  std::size_t position_ = 0;           ///< of the last value
  std::optional<Diagnostic> suspect_;  ///< where a label has other values than it should
};

Diagnostic Reader::problem_at(std::size_t position, Severity severity, Phrase message,
                              Phrase hint) {
  Diagnostic found = problem(severity, name_, std::move(message), std::move(hint));
  const TextPosition place = places_.at(position);
  found.line = place.line;
  found.column = place.column;
  found.excerpt = places_.excerpt(position);
  return found;
}
void Reader::error(std::size_t position, Phrase message, Phrase hint) {
  errors_.push_back(problem_at(position, Severity::error, std::move(message), std::move(hint)));
}
void Reader::warn(std::size_t position, Phrase message, Phrase hint) {
  if (warnings_.size() == kEnoughErrors) message = phrase(Word::lab_enough_warnings), hint = {};
  if (warnings_.size() > kEnoughErrors) return;
  warnings_.push_back(problem_at(position, Severity::warning, std::move(message), std::move(hint)));
}

/// "radius of sphere 3": the value that comes next.
Phrase Reader::name_of_value() const {
  if (sphere_ == 0) {
    const auto [field, i] = lab::field_at(lab::kHead, value_);
    return phrase(field.names[i]);
  }
  const auto [field, i] = lab::field_at(lab::kSphere, value_);
  return phrase(Word::lab_of_sphere, phrase(field.names[i]), sphere_);
}

void Reader::report_strays() {
  for (const lab::StrayBracket& stray : tokens_.strays) {
    if (stray.bracket == '>')
      error(stray.position, phrase(Word::lab_stray_bracket, name_of_value()));
    else
      error(stray.position, phrase(Word::lab_open_bracket, name_of_value()));
  }
  tokens_.strays.clear();
}

/// Notes the first label behind which more or fewer values stand, on one line, than the course's
/// file has there. By itself that is nothing; where the file goes out of step, it is the likely
/// place.
void Reader::watch_labels(const Token& token) {
  if (!token.labelled || suspect_) return;
  const auto [field, i] =
      sphere_ == 0 ? lab::field_at(lab::kHead, value_) : lab::field_at(lab::kSphere, value_);
  if (i != 0) return;
  const std::size_t here = tokens_.position();
  const std::size_t strays = tokens_.strays.size();
  if (line_end_ < token.position)
    line_end_ = std::min(text_.find('\n', token.position), text_.size());
  std::size_t values = 1;
  Token ahead;
  while (values <= 2 * field.size && tokens_.next(ahead) && !ahead.labelled &&
         ahead.position < line_end_)
    ++values;
  const bool on_one_line = ahead.labelled || ahead.position >= line_end_;
  tokens_.rewind(here);
  tokens_.strays.resize(strays);
  if (values == field.size || values > 2 * field.size || !on_one_line || !parse_number(token.text))
    return;
  suspect_ =
      problem_at(token.position, Severity::note,
                 phrase(values == 1 ? Word::lab_one_here : Word::lab_several_here, values,
                        name_of_value(), field.size),
                 phrase(values > field.size ? Word::lab_decimal_comma : Word::lab_out_of_step));
}

/// The next value; 0, with an error, where there is something else. False at the end of the file.
bool Reader::next_value(double& value) {
  value = 0;
  Token token;
  const bool more = tokens_.next(token);
  const bool unclosed = !tokens_.strays.empty() && tokens_.strays.back().bracket == '<';
  report_strays();
  position_ = token.position;
  if (errors_.size() >= kEnoughErrors) {
    ended_ = true;
    error(token.position, phrase(Word::lab_enough_errors));
    return false;
  }
  if (!more) {
    ended_ = true;
    if (!unclosed && (sphere_ == 0 || count_known_)) {
      Phrase hint;
      if (sphere_ > 0)
        hint = phrase(Word::lab_complete, sphere_ - 1, announced_, value_, +lab::kSphereValues,
                      sphere_);
      error(token.position, phrase(Word::lab_ends, name_of_value()), hint);
    }
    return false;
  }
  watch_labels(token);
  const std::string_view text = token.text;
  const std::optional<double> number = parse_number(text);
  if (text.empty()) {
    error(token.position, phrase(Word::lab_nothing_there, name_of_value()));
  } else if (number && std::isfinite(*number)) {
    value = *number;
    ++value_;
    return true;
  } else if (number) {
    error(token.position, phrase(Word::lab_too_large, shown(text), name_of_value()));
  } else {
    const std::size_t space = text.find_first_of(" \t\r\n");
    std::string lower(text);
    std::transform(lower.begin(), lower.end(), lower.begin(),
                   [](char c) { return c >= 'A' && c <= 'Z' ? static_cast<char>(c + 32) : c; });
    const std::string_view bare = lower.starts_with('-') || lower.starts_with('+')
                                      ? std::string_view(lower).substr(1)
                                      : std::string_view(lower);
    if (bare == "nan" || bare == "inf" || bare == "infinity")
      error(token.position, phrase(Word::lab_not_finite, shown(text), name_of_value()));
    else if (space != std::string_view::npos && parse_number(text.substr(0, space)))
      error(token.position, phrase(Word::lab_more_there, shown(text), name_of_value()),
            phrase(Word::lab_separators));
    else
      error(token.position, phrase(Word::lab_no_number, shown(text), name_of_value()));
  }
  value = std::numeric_limits<double>::quiet_NaN();  // already reported
  ++value_;
  return true;
}

void Reader::read_count(double value) {
  count_known_ = false;
  if (std::isnan(value)) return;
  if (value < 0 || value != std::floor(value)) {
    error(position_, phrase(Word::lab_bad_count, value));
    return;
  }
  // 17 values and their separators take 34 bytes; the last separator may be missing.
  const std::size_t room = (text_.size() - tokens_.position() + 1) / (2 * lab::kSphereValues);
  if (value > static_cast<double>(room)) {
    error(position_, phrase(Word::lab_no_room, value, room));
    return;
  }
  announced_ = static_cast<std::uint64_t>(value);
  count_known_ = true;
}

void Reader::read_head() {
  double v[lab::kHeadValues];
  for (double& value : v) {
    const std::size_t place = value_;
    if (!next_value(value)) return;
    if (place == lab::kSize && value <= 0) error(position_, phrase(Word::lab_bad_size, value));
    if (place == lab::kResolution && !std::isnan(value)) {
      if (value < 1 || value != std::floor(value))
        error(position_, phrase(Word::lab_bad_resolution, value));
      else if (value * value > static_cast<double>(kMaxPixels))
        error(position_,
              phrase(Word::lab_large_resolution, value,
                     std::floor(std::sqrt(static_cast<double>(kMaxPixels)))),
              phrase(Word::lab_larger));
    }
    if (place == lab::kCount) read_count(value);
  }
  if (!errors_.empty()) return;
  scene_.camera.eye = {v[lab::kEye], v[lab::kEye + 1], v[lab::kEye + 2]};
  scene_.camera.window_right = {v[lab::kSize], 0, 0};
  scene_.camera.window_up = {0, v[lab::kSize], 0};
  const auto resolution = static_cast<std::uint32_t>(v[lab::kResolution]);
  scene_.resolution = {resolution, resolution};
  scene_.lights.push_back({{v[lab::kLight], v[lab::kLight + 1], v[lab::kLight + 2]}, {1, 1, 1}});
}

/// The name of the sphere whose first value ends at `end`: what stands behind the colon of a label
/// before it, as in "<parametri 2. kugle: zrcalo>".
void Reader::take_name(std::size_t begin, std::size_t end) {
  std::string_view rest = text_.substr(begin, end - begin);
  for (std::size_t open; (open = rest.find('<')) != std::string_view::npos;) {
    const std::size_t close = rest.find('>', open);
    if (close == std::string_view::npos) return;
    const std::string_view label = trimmed(rest.substr(open + 1, close - open - 1));
    rest.remove_prefix(close + 1);
    const std::size_t colon = label.find(':');
    if (colon == std::string_view::npos || label.ends_with('=')) continue;
    const std::string name = shown(trimmed(label.substr(colon + 1)));
    if (name.empty()) continue;
    scene_.names[{0, static_cast<std::uint32_t>(scene_.spheres.size())}] = name;
    return;
  }
}

/// False at the end of the file.
bool Reader::read_sphere() {
  ++sphere_;
  value_ = 0;
  double v[lab::kSphereValues];
  bool over_one_said = false;
  const std::size_t before = tokens_.position();
  for (double& value : v) {
    const std::size_t place = value_;
    if (!next_value(value)) return false;
    if (place == lab::kCenter) take_name(before, position_);
    if (place == lab::kRadius && value <= 0)
      error(position_, phrase(Word::lab_bad_radius, sphere_, value));
    // Shares and coefficients; real files break the rule, mostly with ks, so that is no error.
    if (place >= lab::kK1 && place < lab::kN && (value < 0 || value > 1) && !over_one_said) {
      over_one_said = true;
      --value_;
      warn(position_, phrase(Word::lab_out_of_range, name_of_value(), value));
      ++value_;
    }
  }
  if (v[lab::kK2] != 0 && v[lab::kNi] <= 0)
    warn(position_, phrase(Word::lab_bad_ni, sphere_, v[lab::kNi]));
  if (v[lab::kN] < 0) warn(position_, phrase(Word::lab_bad_n, sphere_, v[lab::kN]));
  if (!errors_.empty()) return true;
  const auto color = [&](std::size_t at) { return Color{v[at], v[at + 1], v[at + 2]}; };
  scene_.spheres.push_back(
      {{{v[lab::kCenter], v[lab::kCenter + 1], v[lab::kCenter + 2]}, v[lab::kRadius]},
       static_cast<std::uint32_t>(scene_.materials.size())});
  scene_.materials.push_back({.ambient = color(lab::kKa),
                              .diffuse = color(lab::kKd),
                              .specular = color(lab::kKs),
                              .shininess = v[lab::kN],
                              .reflection = v[lab::kK1],
                              .refraction = v[lab::kK2],
                              .ior = v[lab::kNi]});
  return true;
}

/// Text after the last value is ignored; but values there mean that the count came out wrong.
void Reader::check_rest() {
  const std::size_t strays = tokens_.strays.size();
  std::size_t extra = 0, first = 0;
  Token token;
  while (tokens_.next(token) && parse_number(token.text)) {
    if (extra++ == 0) first = token.position;
    if (token.last) break;
  }
  tokens_.strays.resize(strays);
  if (extra == 0) return;
  const Phrase message = phrase(
      Word::lab_left_over, phrase(extra == 1 ? Word::lab_value_is : Word::lab_values_are, extra),
      phrase(announced_ == 1 ? Word::lab_one_sphere : Word::lab_spheres, announced_));
  if (!suspect_)
    warn(first, message, phrase(Word::lab_count_right, phrase(Word::lab_decimal_comma)));
  else
    error(first, message, phrase(Word::lab_one_too_many));
}

/// Whether the file can be text at all; one clear answer is better than thousands.
bool Reader::check_is_text() {
  if (text_.empty()) {
    errors_.push_back(problem(Severity::error, name_, phrase(Word::lab_empty, name_of_value())));
    return false;
  }
  const auto binary = std::find_if(text_.begin(), text_.end(), is_no_text);
  if (binary == text_.end()) return true;
  const bool utf16 = text_.starts_with("\xFF\xFE") || text_.starts_with("\xFE\xFF");
  const bool gzip = text_.starts_with("\x1F\x8B");
  errors_.push_back(problem(Severity::error, name_,
                            phrase(Word::lab_no_text, binary - text_.begin() + 1,
                                   fmt::format("{:02x}", static_cast<unsigned char>(*binary))),
                            phrase(utf16  ? Word::lab_utf16
                                   : gzip ? Word::lab_gzip
                                          : Word::lab_format)));
  return false;
}

Result<ReadScene> Reader::read() {
  if (!check_is_text()) return tl::make_unexpected(std::move(errors_));
  if (text_.starts_with(kByteOrderMark)) tokens_.rewind(kByteOrderMark.size());
  scene_.defaults.profile = ProfileName::lab;
  read_head();
  while (!ended_ && !(count_known_ && sphere_ == announced_)) {
    // Where the count is no help, the spheres end where the file does.
    if (!read_sphere()) break;
  }
  if (!ended_ && count_known_) check_rest();
  // The cause first, then what came of it.
  if (!errors_.empty() && suspect_) errors_.insert(errors_.begin(), *suspect_);
  if (!errors_.empty()) return tl::make_unexpected(std::move(errors_));
  return ReadScene{std::move(scene_), std::move(warnings_)};
}

}  // namespace

Likeness likeness_to_lab_input(std::string_view text) {
  lab::Tokens tokens(text);
  Token first;
  if (!tokens.next(first)) return Likeness::possible;
  if (first.labelled || parse_number(first.text)) return Likeness::sure;
  const bool one_line = first.text.find_first_of("\r\n") == std::string::npos;
  return one_line || std::any_of(text.begin(), text.end(), is_no_text) ? Likeness::possible
                                                                       : Likeness::none;
}

Result<ReadScene> parse_lab_input(std::string_view text, const std::string& name,
                                  const ReadOptions&) {
  return Reader(text, name).read();
}

}  // namespace zraka
