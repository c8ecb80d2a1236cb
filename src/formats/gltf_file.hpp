// SPDX-License-Identifier: Apache-2.0
// The container of glTF 2.0: JSON, buffers, and numbers in them. Whatever a file says of sizes is
// held against the bytes that are there before memory is taken.
#pragma once

#include <cstddef>
#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <vector>
#include <zraka/formats.hpp>

#include "core/json.hpp"

namespace zraka {

/// Numbers of an accessor, `width` of them for each element; those of whole numbers that stand for
/// 0 to 1 or -1 to 1 are that already.
struct GltfNumbers {
  std::size_t count = 0, width = 1;
  std::vector<float> values;
  const float* at(std::size_t i) const { return values.data() + i * width; }
};

class GltfFile {
 public:
  GltfFile(const std::string& name, const ReadOptions& options) : name_(name), options_(options) {}

  /// Takes the JSON out of the bytes, which have to outlive this. False where it is none of glTF.
  bool open(std::string_view bytes);

  const Json& root() const { return root_; }
  /// A member of an object; nullptr where there is none, or `json` is no object.
  static const Json* member(const Json* json, std::string_view key);
  /// That of an extension.
  static const Json* extension(const Json* json, std::string_view key);
  /// The elements of an array; none where it is not there.
  const Json::Array& list(const Json* json, std::string_view key);
  /// Numbers with defaults; a member of another kind is a problem.
  double number(const Json* json, std::string_view key, double usual);
  std::string word(const Json* json, std::string_view key, std::string_view usual);
  bool flag(const Json* json, std::string_view key, bool usual);
  /// So many numbers, into values; the usual ones stay where nothing is said.
  void numbers(const Json* json, std::string_view key, std::size_t count, double* values);
  /// A whole number as an index into a list of the file; none where it is not there, and a problem
  /// where there is no such element.
  std::optional<std::size_t> index(const Json* json, std::string_view key, const char* list);
  /// An element of a list of the file.
  const Json* item(const char* list, std::size_t index);

  /// The bytes of a buffer view, or of a URI, which may be a file in the scene's folder.
  std::optional<std::string_view> view(std::size_t index);
  std::optional<std::string> bytes_of_uri(const std::string& uri);
  /// An accessor with elements of so many numbers; `other_width` is allowed, too. nullptr where
  /// there is a problem with it. Read once, for meshes share them.
  const GltfNumbers* accessor(std::size_t index, std::size_t width, std::size_t other_width = 0);
  /// One of whole numbers, for indices.
  std::optional<std::vector<std::uint32_t>> indices(std::size_t index);
  /// Bytes in the file and the buffers that were read.
  std::uint64_t size() const { return size_; }

  void fail(std::string message, std::string hint = {});
  /// Said once with the number of times.
  void warn(const std::string& message);
  bool good() const { return errors_.empty(); }
  Diagnostics& errors() { return errors_; }
  Diagnostics warnings() const;
  const std::string& name() const { return name_; }
  const ReadOptions& options() const { return options_; }

 private:
  struct Layout {
    std::size_t count = 0, width = 1, bytes = 4;
    int type = 0;
    bool normalized = false;
  };
  std::optional<Layout> layout_of(const Json& accessor, std::size_t index);
  bool open_binary(std::string_view bytes);
  bool read_extensions();
  std::optional<std::string_view> buffer(std::size_t index);
  /// `count` elements from a view, or false.
  bool read_elements(const Json& from, const Layout& layout, std::size_t index, bool has_stride,
                     std::vector<double>& values);
  bool read_sparse(const Json& accessor, const Layout& layout, std::size_t index,
                   std::vector<double>& values);
  std::optional<std::vector<double>> read_accessor(std::size_t index, Layout& layout);
  std::optional<GltfNumbers> read_numbers(std::size_t index);

  const std::string& name_;
  const ReadOptions& options_;
  Json root_;
  std::string_view binary_;  ///< GLB's own buffer
  bool has_binary_ = false;
  std::uint64_t size_ = 0;
  std::map<std::size_t, std::optional<std::string>> buffers_;
  std::map<std::size_t, std::optional<GltfNumbers>> accessors_;
  Diagnostics errors_;
  std::vector<std::pair<std::string, std::uint64_t>> warnings_;
};

}  // namespace zraka
