// SPDX-License-Identifier: Apache-2.0
// JSON as a value: built like a literal, written, read. json.cpp alone includes the library that
// knows the format, which takes seconds to compile.
#pragma once

#include <array>
#include <concepts>
#include <cstddef>
#include <cstdint>
#include <initializer_list>
#include <string>
#include <string_view>
#include <type_traits>
#include <utility>
#include <variant>
#include <vector>
#include <zraka/diagnostic.hpp>

namespace zraka {

class Json {
 public:
  using Array = std::vector<Json>;
  using Object = std::vector<std::pair<std::string, Json>>;  ///< in the order of insertion

  Json() = default;  ///< null
  Json(std::nullptr_t) {}
  Json(bool value) : value_(value) {}
  template <std::signed_integral T>
  Json(T value) : value_(static_cast<std::int64_t>(value)) {}
  template <std::unsigned_integral T>
  requires(!std::same_as<T, bool>) Json(T value) : value_(static_cast<std::uint64_t>(value)) {}
  template <std::floating_point T>
  Json(T value) : value_(static_cast<double>(value)) {}
  Json(const char* value) : value_(std::string(value)) {}
  Json(std::string_view value) : value_(std::string(value)) {}
  Json(std::string value) : value_(std::move(value)) {}
  template <class T>
  Json(const std::vector<T>& values) : value_(Array(values.begin(), values.end())) {}
  template <class T, std::size_t N>
  Json(const std::array<T, N>& values) : value_(Array(values.begin(), values.end())) {}
  template <class T, std::size_t N>
  requires(!std::same_as<T, char>) Json(const T (&values)[N])
      : value_(Array(std::begin(values), std::end(values))) {}
  /// An object if all values are pairs that begin with a string, else an array.
  Json(std::initializer_list<Json> values);

  static Json array(std::initializer_list<Json> values = {});
  static Json object();

  bool is_null() const { return std::holds_alternative<std::nullptr_t>(value_); }
  bool is_array() const { return std::holds_alternative<Array>(value_); }
  bool is_object() const { return std::holds_alternative<Object>(value_); }
  const bool* if_bool() const { return std::get_if<bool>(&value_); }
  const std::string* if_string() const { return std::get_if<std::string>(&value_); }
  const Array* if_array() const { return std::get_if<Array>(&value_); }
  const Object* if_object() const { return std::get_if<Object>(&value_); }
  /// Any kind of number; false if it is none.
  bool get_number(double& value) const;

  /// Appends; null becomes an array.
  void push_back(Json value);
  /// The member, added if it is not there; null becomes an object.
  Json& operator[](std::string_view key);
  /// Of an array.
  Json& operator[](std::size_t index) { return std::get<Array>(value_)[index]; }
  const Json& front() const { return std::get<Array>(value_).front(); }
  std::size_t size() const;

  template <class Visitor>
  decltype(auto) visit(const Visitor& visitor) const {
    return std::visit(visitor, value_);
  }

  /// As text, on one line where `indent` is negative. What is no UTF-8 is replaced.
  std::string dump(int indent = -1) const;
  /// Fails with line and column, and where values are nested deeper than `most_depth`.
  static Result<Json> parse(std::string_view text, const std::string& file, int most_depth = 64);

 private:
  std::variant<std::nullptr_t, bool, std::int64_t, std::uint64_t, double, std::string, Array,
               Object>
      value_;
};

}  // namespace zraka
