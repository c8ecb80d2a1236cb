// SPDX-License-Identifier: Apache-2.0
// Tachyon's scene files (docs/tachyon.md): the list of statements, values behind keywords, included
// files, and what is said of problems.
#include "formats/tachyon.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "core/file.hpp"
#include "formats/tachyon_reader.hpp"

namespace zraka {
namespace {

/// Of an included file or a list of polygons.
constexpr std::uint64_t kLargestFile = std::uint64_t{1} << 30;

bool is_utf16(std::string_view text) {
  return text.substr(0, 2) == "\xFF\xFE" || text.substr(0, 2) == "\xFE\xFF" ||
         text.substr(0, 200).find('\0') != std::string_view::npos;
}

}  // namespace

TachyonReader::TachyonReader(const ReadOptions& options, const TachyonSettings& settings)
    : options_(options),
      settings_(settings),
      images_(SceneFolder{options.folder.value_or(""), options.allow_outside}) {}

const TachyonReader::Statement* TachyonReader::statement_of(std::string_view word) {
  using Self = TachyonReader;
  // The ones first that large files are full of.
  static constexpr Statement kStatements[] = {
      {"SPHERE", &Self::read_sphere},
      {"FCYLINDER", &Self::read_fcylinder},
      {"STRI", &Self::read_smooth_triangle},
      {"TRI", &Self::read_triangle},
      {"VCSTRI", &Self::read_painted_triangle},
      {"RING", &Self::read_ring},
      {"TEXDEF", &Self::read_texdef},
      {"#", &Self::read_comment},
      {"VERTEXARRAY", &Self::read_vertex_array},
      {"BOX", &Self::read_box},
      {"PLANE", &Self::read_plane},
      {"CYLINDER", &Self::read_cylinder},
      {"POLYCYLINDER", &Self::read_polycylinder},
      {"TEXALIAS", &Self::read_texalias},
      {"IMAGEDEF", &Self::read_imagedef},
      {"LIGHT", &Self::read_light},
      {"DIRECTIONAL_LIGHT", &Self::read_directional_light},
      {"SPOTLIGHT", &Self::read_spotlight},
      {"SKY_LIGHT", &Self::read_sky_light},
      {"CAMERA", &Self::read_camera},
      {"RESOLUTION", &Self::read_resolution},
      {"SHADER_MODE", &Self::read_shader_mode},
      {"BACKGROUND", &Self::read_background},
      {"BACKGROUND_GRADIENT", &Self::read_gradient},
      {"FOG", &Self::read_fog},
      {"START_CLIPGROUP", &Self::read_clip_group},
      {"END_CLIPGROUP", &Self::end_clip_group},
      {"INCLUDE", &Self::read_include},
      {"SCAPE", &Self::read_scape},
      {"SCALARVOL", &Self::read_volume},
      {"TPOLYFILE", &Self::read_polygon_file},
      {"MGFFILE", &Self::read_mgf},
      {"END_SCENE", &Self::read_end},
  };
  for (const Statement& statement : kStatements)
    if (is_keyword(word, statement.keyword)) return &statement;
  return nullptr;
}

bool TachyonReader::fail(const char* at, std::string message, std::string hint) {
  if (!has_enough())
    errors_.push_back(in_->diagnostic(Severity::error, at, std::move(message), std::move(hint)));
  return false;
}

/// The first of each kind has its line, and in the end their number.
void TachyonReader::warn(const char* at, const std::string& message, const std::string& hint) {
  for (auto& [said, times] : warnings_)
    if (said.message == message) return static_cast<void>(++times);
  constexpr std::size_t kMost = 200;
  if (warnings_.size() < kMost)
    warnings_.emplace_back(in_->diagnostic(Severity::warning, at, message, hint), 1);
}

bool TachyonReader::expect(std::string_view keyword) {
  if (in_->take_keyword(keyword)) return true;
  const char* const at = in_->place();
  const std::string_view word = in_->peek();
  if (word.empty())
    return fail(at, fmt::format("the file ends: expected {} of {}", keyword, statement_));
  return fail(at, fmt::format("'{}' does not belong here: expected {} of {}", shown(word), keyword,
                              statement_));
}

bool TachyonReader::number(double& value, std::string_view what) {
  if (in_->take_number(value)) return true;
  const char* const at = in_->place();
  const std::string_view word = in_->peek();
  if (word.empty())
    return fail(at, fmt::format("the file ends: expected {} of {}", what, statement_));
  return fail(at, fmt::format("'{}' is not a finite number: expected {} of {}", shown(word), what,
                              statement_));
}

bool TachyonReader::number_of(std::string_view keyword, double& value) {
  return expect(keyword) && number(value, keyword);
}

bool TachyonReader::vector(Vec3& v, std::string_view what) {
  return number(v.x, what) && number(v.y, what) && number(v.z, what);
}

bool TachyonReader::vector_of(std::string_view keyword, Vec3& v) {
  return expect(keyword) && vector(v, keyword);
}

bool TachyonReader::color(Color& c, std::string_view what) {
  return number(c.r, what) && number(c.g, what) && number(c.b, what);
}

bool TachyonReader::color_of(std::string_view keyword, Color& c) {
  return expect(keyword) && color(c, keyword);
}

bool TachyonReader::count(std::size_t& n, std::string_view what, std::size_t least, double most) {
  const char* const at = in_->place();
  double value = 0;
  if (!number(value, what)) return false;
  if (value < 0 || value != std::floor(value) || value > most)
    return fail(at, fmt::format("{} of {} is {}: expected a whole number from 0 to {}", what,
                                statement_, value, most));
  if (value * static_cast<double>(least) > static_cast<double>(in_->left()) + 1)
    return fail(at, fmt::format("{} of {} is {}, more than the rest of the file can hold", what,
                                statement_, value));
  n = static_cast<std::size_t>(value);
  return true;
}

bool TachyonReader::file_name(std::string_view what, std::string& name) {
  const char* const at = in_->place();
  const std::string_view word = in_->take();
  constexpr std::size_t kLongest = 4096;
  if (word.empty())
    return fail(at, fmt::format("the file ends: expected {} of {}", what, statement_));
  if (word.size() > kLongest)
    return fail(at, fmt::format("{} of {} has {} characters: expected at most {}", what, statement_,
                                word.size(), kLongest));
  name = word;
  return true;
}

std::optional<std::string> TachyonReader::read_named(const char* at, const std::string& name) {
  const auto tell = [&](const Diagnostics& problems) {
    fail(at, fmt::format("{} cannot be read: {}", shown(name), problems[0].message),
         problems[0].hint);
  };
  if (!options_.folder) {
    fail(at, fmt::format("{} cannot be read: files beside the scene need a folder", shown(name)));
    return std::nullopt;
  }
  const Result<std::string> path =
      SceneFolder{*options_.folder, options_.allow_outside}.path_of(name);
  if (!path) return tell(path.error()), std::nullopt;
  Result<std::string> text = read_file(*path, kLargestFile);
  if (!text) return tell(text.error()), std::nullopt;
  return std::move(*text);
}

void TachyonReader::skip_statement() {
  while (!in_->ended() && statement_of(in_->peek()) == nullptr) in_->take();
}

void TachyonReader::read_statements() {
  while (!ended_ && !has_enough() && !in_->ended()) {
    const char* const at = in_->place();
    const std::string_view word = in_->peek();
    const Statement* const statement = statement_of(word);
    if (statement == nullptr) {
      statement_ = "the scene";
      fail(at, fmt::format("'{}' is no statement of Tachyon", shown(word)),
           word.starts_with('#') ? "a comment begins with a # that stands alone" : "");
      if (word.starts_with('#'))
        in_->skip_line();
      else
        in_->take();
      skip_statement();
      continue;
    }
    in_->take();
    statement_ = statement->keyword;
    if (!(this->*statement->read)()) skip_statement();
  }
}

bool TachyonReader::read_comment() {
  in_->skip_line();
  return true;
}

bool TachyonReader::read_end() {
  in_->stop();
  ended_ = includes_ == 0;
  return true;
}

bool TachyonReader::read_include() {
  const char* const at = in_->place();
  std::string name;
  if (!file_name("a file's name", name)) return false;
  if (includes_ >= kDeepest) {
    ended_ = true;  // all that follow would say the same
    return fail(at, fmt::format("files include each other more than {} deep", +kDeepest),
                "does one of them include itself?");
  }
  const std::optional<std::string> text = read_named(at, name);
  if (!text) return false;
  included_ += text->size() + 4096;
  if (included_ > kMostIncluded) {
    ended_ = true;
    return fail(at, fmt::format("included files have more than {} bytes in all", +kMostIncluded));
  }
  TachyonText included(*text, name);
  TachyonText* const outer = in_;
  in_ = &included;
  ++includes_;
  read_statements();
  --includes_;
  in_ = outer;
  return true;
}

void TachyonReader::read(std::string_view text, const std::string& name) {
  TachyonText file(text, name);
  in_ = &file;
  statement_ = "the scene";
  if (is_utf16(text)) {
    fail(text.data(), "this is no text in ASCII or UTF-8",
         "it looks like UTF-16: save it as UTF-8");
  } else {
    while (in_->take_keyword("#")) in_->skip_line();
    if (expect("BEGIN_SCENE")) read_statements();
  }
  if (has_enough()) {
    errors_.push_back({.file = name, .message = "too many problems; the rest is not read"});
  } else if (errors_.empty() && !has_camera_) {
    warn(in_->place(), "the scene has no CAMERA: it is seen from 0 0 0 along z");
  }
  in_ = nullptr;
}

Result<ReadScene> TachyonReader::finish() {
  if (!errors_.empty()) return tl::make_unexpected(std::move(errors_));
  set_camera();
  add_infinite_cylinders();
  set_materials();
  set_defaults();
  Diagnostics warnings;
  for (auto& [warning, times] : warnings_) {
    if (times > 1) warning.message += fmt::format(" ({} times)", times);
    warnings.push_back(std::move(warning));
  }
  return ReadScene{std::move(scene_), std::move(warnings)};
}

Likeness likeness_to_tachyon(std::string_view text) {
  // The beginning alone: a comment may be as long as it likes.
  constexpr std::size_t kBeginning = 1 << 16;
  TachyonText beginning(text.substr(0, kBeginning), "");
  while (beginning.take_keyword("#")) beginning.skip_line();
  return beginning.take_keyword("BEGIN_SCENE") ? Likeness::sure : Likeness::none;
}

Result<ReadScene> parse_tachyon(std::string_view text, const std::string& name,
                                const ReadOptions& options, const TachyonSettings& settings) {
  if (text.starts_with(kByteOrderMark)) text.remove_prefix(kByteOrderMark.size());
  TachyonReader reader(options, settings);
  reader.read(text, name);
  return reader.finish();
}

Result<ReadScene> parse_tachyon_scene(std::string_view text, const std::string& name,
                                      const ReadOptions& options) {
  return parse_tachyon(text, name, options, {});
}

}  // namespace zraka
