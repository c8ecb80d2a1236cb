// SPDX-License-Identifier: Apache-2.0
#include "core/json.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <nlohmann/json.hpp>
#include <optional>

#include "core/phrase.hpp"
#include "core/text.hpp"

namespace zraka {
namespace {

using Library = nlohmann::ordered_json;

Json from_library(const Library& library) {
  switch (library.type()) {
    case Library::value_t::boolean:
      return library.get<bool>();
    case Library::value_t::number_integer:
      return library.get<std::int64_t>();
    case Library::value_t::number_unsigned:
      return library.get<std::uint64_t>();
    case Library::value_t::number_float:
      return library.get<double>();
    case Library::value_t::string:
      return library.get<std::string>();
    case Library::value_t::array: {
      Json json = Json::array();
      for (const Library& value : library) json.push_back(from_library(value));
      return json;
    }
    case Library::value_t::object: {
      Json json = Json::object();
      for (const auto& [key, value] : library.items()) json[key] = from_library(value);
      return json;
    }
    default:
      return {};
  }
}

/// Where brackets are nested deeper than `most`, if they are: the library's values are read, copied
/// and written by functions that call themselves for each level.
std::optional<std::size_t> too_deep_at(std::string_view text, int most) {
  int depth = 0;
  bool quoted = false;
  for (std::size_t i = 0; i < text.size(); ++i) {
    if (quoted && text[i] == '\\')
      ++i;
    else if (text[i] == '"')
      quoted = !quoted;
    else if (quoted)
      continue;
    else if (text[i] == '[' || text[i] == '{') {
      if (++depth > most) return i;
    } else if (text[i] == ']' || text[i] == '}')
      --depth;
  }
  return std::nullopt;
}

/// What steers a terminal becomes the number that JSON has for it, as the library does below
/// U+0020.
std::string without_controls(const std::string& json) {
  std::string out;
  for (std::size_t i = 0; i < json.size();) {
    if (const auto control = control_at(std::string_view(json).substr(i))) {
      out += fmt::format("\\u{:04x}", control->code);
      i += control->bytes;
    } else {
      out += json[i++];
    }
  }
  return out;
}

}  // namespace

Json::Json(std::initializer_list<Json> values) {
  const bool pairs = std::all_of(values.begin(), values.end(), [](const Json& value) {
    const Array* pair = value.if_array();
    return pair != nullptr && pair->size() == 2 && (*pair)[0].if_string() != nullptr;
  });
  if (!pairs) {
    value_ = Array(values);
    return;
  }
  Object object;
  for (const Json& value : values) {
    const Array& pair = std::get<Array>(value.value_);
    object.emplace_back(*pair[0].if_string(), pair[1]);
  }
  value_ = std::move(object);
}

Json Json::array(std::initializer_list<Json> values) {
  Json json;
  json.value_ = Array(values);
  return json;
}

Json Json::object() {
  Json json;
  json.value_ = Object();
  return json;
}

bool Json::get_number(double& value) const {
  if (const auto* i = std::get_if<std::int64_t>(&value_))
    return value = static_cast<double>(*i), true;
  if (const auto* u = std::get_if<std::uint64_t>(&value_))
    return value = static_cast<double>(*u), true;
  if (const auto* d = std::get_if<double>(&value_)) return value = *d, true;
  return false;
}

void Json::push_back(Json value) {
  if (is_null()) value_ = Array();
  std::get<Array>(value_).push_back(std::move(value));
}

Json& Json::operator[](std::string_view key) {
  if (is_null()) value_ = Object();
  Object& object = std::get<Object>(value_);
  for (auto& [name, value] : object)
    if (name == key) return value;
  return object.emplace_back(std::string(key), Json()).second;
}

std::size_t Json::size() const {
  if (const Array* array = if_array()) return array->size();
  const Object* object = if_object();
  return object == nullptr ? 0 : object->size();
}

namespace {

struct ToLibrary {
  template <class T>
  Library operator()(const T& value) const {
    return value;
  }
  Library operator()(const Json::Array& array) const {
    Library library = Library::array();
    for (const Json& value : array) library.push_back(value.visit(*this));
    return library;
  }
  Library operator()(const Json::Object& object) const {
    Library library = Library::object();
    // Its own emplace() would look for each key among all others.
    std::vector<Library::object_t::value_type>& members = library.get_ref<Library::object_t&>();
    for (const auto& [key, value] : object) members.emplace_back(key, value.visit(*this));
    return library;
  }
};

}  // namespace

std::string Json::dump(int indent) const {
  return without_controls(
      visit(ToLibrary{}).dump(indent, ' ', false, Library::error_handler_t::replace));
}

Result<Json> Json::parse(std::string_view text, const std::string& file, int most_depth) {
  const auto problem_at = [&](std::size_t at, Phrase message) {
    TextPositions positions(text);
    const TextPosition position = positions.at(at);
    Diagnostic found = problem(Severity::error, file, std::move(message));
    found.line = position.line;
    found.column = position.column;
    found.excerpt = positions.excerpt(at);
    return tl::make_unexpected(Diagnostics{std::move(found)});
  };
  if (const auto at = too_deep_at(text, most_depth))
    return problem_at(*at, phrase(Word::json_deep, most_depth));
  try {
    return from_library(Library::parse(text.begin(), text.end()));
  } catch (const Library::out_of_range&) {
    return problem_at(0, phrase(Word::json_number));
  } catch (const Library::parse_error& error) {
    return problem_at(std::min(error.byte > 0 ? error.byte - 1 : 0, text.size()),
                      phrase(Word::json_broken));
  }
}

}  // namespace zraka
