// SPDX-License-Identifier: Apache-2.0
// glTF's JSON, and where its bytes are (Khronos Group, "glTF 2.0 Specification", 2021).
#include "formats/gltf_file.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstring>

#include "core/base64.hpp"
#include "core/file.hpp"
#include "core/scene_folder.hpp"
#include "core/text.hpp"

namespace zraka {
namespace {

constexpr std::uint64_t kLargestBuffer = std::uint64_t{1} << 33;

/// Extensions without which a file can be read, and those that are read.
constexpr std::array<std::string_view, 22> kKnownExtensions = {
    "KHR_lights_punctual",
    "KHR_materials_ior",
    "KHR_materials_transmission",
    "KHR_materials_volume",
    "KHR_materials_dispersion",
    "KHR_materials_emissive_strength",
    "KHR_materials_unlit",
    "KHR_materials_specular",
    "KHR_materials_clearcoat",
    "KHR_materials_sheen",
    "KHR_materials_iridescence",
    "KHR_materials_anisotropy",
    "KHR_materials_variants",
    "KHR_materials_pbrSpecularGlossiness",
    "KHR_texture_transform",
    "KHR_mesh_quantization",
    "KHR_animation_pointer",
    "KHR_node_visibility",
    "KHR_xmp_json_ld",
    "EXT_mesh_features",
    "EXT_structural_metadata",
    "KHR_materials_diffuse_transmission"};

std::uint32_t little(std::string_view bytes, std::size_t at) {
  std::uint32_t value = 0;
  for (std::size_t i = 0; i < 4; ++i)
    value |= static_cast<std::uint32_t>(static_cast<unsigned char>(bytes[at + i])) << (8 * i);
  return value;
}

/// %20 and the like.
std::string unescaped(std::string_view uri) {
  std::string text;
  const auto digit = [](char c) {
    return c >= '0' && c <= '9'   ? c - '0'
           : c >= 'a' && c <= 'f' ? c - 'a' + 10
           : c >= 'A' && c <= 'F' ? c - 'A' + 10
                                  : -1;
  };
  for (std::size_t i = 0; i < uri.size(); ++i) {
    const int high = uri[i] == '%' && i + 2 < uri.size() ? digit(uri[i + 1]) : -1;
    const int low = high >= 0 ? digit(uri[i + 2]) : -1;
    if (low < 0) {
      text += uri[i];
    } else {
      text += static_cast<char>(high * 16 + low);
      i += 2;
    }
  }
  return text;
}

}  // namespace

void GltfFile::fail(std::string message, std::string hint) {
  constexpr std::size_t kEnough = 20;
  if (errors_.size() < kEnough)
    errors_.push_back({.file = name_, .message = std::move(message), .hint = std::move(hint)});
}

void GltfFile::warn(const std::string& message) {
  for (auto& [said, times] : warnings_)
    if (said == message) return static_cast<void>(++times);
  constexpr std::size_t kMost = 50;
  if (warnings_.size() < kMost) warnings_.emplace_back(message, 1);
}

Diagnostics GltfFile::warnings() const {
  Diagnostics all;
  for (const auto& [message, times] : warnings_)
    all.push_back({.severity = Severity::warning,
                   .file = name_,
                   .message = times == 1 ? message : fmt::format("{} ({} times)", message, times)});
  return all;
}

const Json* GltfFile::member(const Json* json, std::string_view key) {
  const Json::Object* const object = json == nullptr ? nullptr : json->if_object();
  if (object == nullptr) return nullptr;
  for (const auto& [name, value] : *object)
    if (name == key) return &value;
  return nullptr;
}

const Json* GltfFile::extension(const Json* json, std::string_view key) {
  return member(member(json, "extensions"), key);
}

const Json::Array& GltfFile::list(const Json* json, std::string_view key) {
  static const Json::Array kNone;
  const Json* const found = member(json, key);
  if (found == nullptr) return kNone;
  if (const Json::Array* const array = found->if_array()) return *array;
  fail(fmt::format("'{}' is no list: expected [...]", key));
  return kNone;
}

double GltfFile::number(const Json* json, std::string_view key, double usual) {
  const Json* const found = member(json, key);
  double value = usual;
  if (found != nullptr && (!found->get_number(value) || !std::isfinite(value))) {
    fail(fmt::format("'{}' is no number", key));
    return usual;
  }
  return value;
}

std::string GltfFile::word(const Json* json, std::string_view key, std::string_view usual) {
  const Json* const found = member(json, key);
  if (found == nullptr) return std::string(usual);
  if (const std::string* const text = found->if_string()) return *text;
  fail(fmt::format("'{}' is no text: expected \"...\"", key));
  return std::string(usual);
}

bool GltfFile::flag(const Json* json, std::string_view key, bool usual) {
  const Json* const found = member(json, key);
  if (found == nullptr) return usual;
  if (const bool* const value = found->if_bool()) return *value;
  fail(fmt::format("'{}' is neither true nor false", key));
  return usual;
}

void GltfFile::numbers(const Json* json, std::string_view key, std::size_t count, double* values) {
  const Json* const found = member(json, key);
  if (found == nullptr) return;
  const Json::Array* const array = found->if_array();
  bool is_good = array != nullptr && array->size() == count;
  for (std::size_t i = 0; is_good && i < count; ++i) {
    double value = 0;
    is_good = (*array)[i].get_number(value) && std::isfinite(value);
    if (is_good) values[i] = value;
  }
  if (!is_good) fail(fmt::format("'{}' is no list of {} numbers", key, count));
}

std::optional<std::size_t> GltfFile::index(const Json* json, std::string_view key,
                                           const char* list_key) {
  const Json* const found = member(json, key);
  if (found == nullptr) return std::nullopt;
  const std::size_t count = list(&root_, list_key).size();
  double value = -1;
  if (found->get_number(value) && value >= 0 && value == std::floor(value) &&
      value < static_cast<double>(count))
    return static_cast<std::size_t>(value);
  fail(fmt::format("'{}' names none of the {} {} of the file", key, count, list_key));
  return std::nullopt;
}

const Json* GltfFile::item(const char* list_key, std::size_t index) {
  const Json::Array& all = list(&root_, list_key);
  return index < all.size() ? &all[index] : nullptr;
}

bool GltfFile::open_binary(std::string_view bytes) {
  constexpr std::size_t kHeader = 12, kChunkHeader = 8;
  constexpr std::uint32_t kJson = 0x4E4F534A, kBinary = 0x004E4942;
  if (bytes.size() < kHeader + kChunkHeader)
    return fail("this GLB file ends before its JSON begins: it is cut off"), false;
  if (little(bytes, 4) != 2)
    return fail(fmt::format("this is glTF {}: expected 2", little(bytes, 4))), false;
  std::string_view json;
  std::size_t at = kHeader;
  while (bytes.size() - at >= kChunkHeader) {
    const std::size_t length = little(bytes, at);
    const std::uint32_t kind = little(bytes, at + 4);
    at += kChunkHeader;
    if (length > bytes.size() - at)
      return fail(fmt::format("a part of this GLB file has {} bytes, and only {} are left: it is "
                              "cut off",
                              length, bytes.size() - at)),
             false;
    if (kind == kJson && json.empty()) json = bytes.substr(at, length);
    if (kind == kBinary && !has_binary_) binary_ = bytes.substr(at, length), has_binary_ = true;
    at += std::min(bytes.size() - at, (length + 3) / 4 * 4);
  }
  if (json.empty()) return fail("this GLB file has no JSON in it"), false;
  Result<Json> read = Json::parse(json, name_);
  if (!read) return errors_ = read.error(), false;
  root_ = std::move(*read);
  return true;
}

bool GltfFile::read_extensions() {
  for (const Json& needed : list(&root_, "extensionsRequired")) {
    const std::string* const name = needed.if_string();
    if (name == nullptr || std::find(kKnownExtensions.begin(), kKnownExtensions.end(), *name) ==
                               kKnownExtensions.end())
      fail(
          fmt::format("the file needs the extension {}, which is not read",
                      name != nullptr ? shown(*name) : "of no name"),
          "programs that convert glTF can write it without compression: for example gltf-transform "
          "copy");
  }
  return good();
}

bool GltfFile::open(std::string_view bytes) {
  size_ = bytes.size();
  if (bytes.starts_with("glTF")) {
    if (!open_binary(bytes)) return false;
  } else {
    Result<Json> read = Json::parse(bytes, name_);
    if (!read) return errors_ = read.error(), false;
    root_ = std::move(*read);
  }
  const Json* const asset = member(&root_, "asset");
  if (asset == nullptr) return fail("this JSON is none of glTF: it has no 'asset'"), false;
  const std::string version = word(asset, "version", "");
  if (good() && !version.starts_with("2."))
    return fail(fmt::format("this is glTF {}: expected 2.0", shown(version)),
                "programs that convert glTF 1.0 to 2.0 exist: for example gltf-pipeline"),
           false;
  return read_extensions();
}

std::optional<std::string> GltfFile::bytes_of_uri(const std::string& uri) {
  if (uri.starts_with("data:")) {
    const std::size_t comma = uri.find(',');
    const bool is_base64 =
        comma != std::string::npos && std::string_view(uri).substr(0, comma).ends_with(";base64");
    if (std::optional<std::string> bytes =
            is_base64 ? unbase64(std::string_view(uri).substr(comma + 1)) : std::nullopt)
      return bytes;
    fail("a data URI of the file holds no base 64");
    return std::nullopt;
  }
  const std::string file = unescaped(uri);
  if (!options_.folder) {
    fail(fmt::format("{} cannot be read: files beside the scene need a folder", shown(file)));
    return std::nullopt;
  }
  const Result<std::string> path =
      SceneFolder{*options_.folder, options_.allow_outside}.path_of(file);
  Result<std::string> bytes = path ? read_file(*path, kLargestBuffer) : path;
  if (!bytes) {
    fail(fmt::format("{}: {}", shown(file), bytes.error()[0].message),
         bytes.error()[0].hint);
    return std::nullopt;
  }
  size_ += bytes->size();
  return std::move(*bytes);
}

std::optional<std::string_view> GltfFile::buffer(std::size_t index) {
  const Json* const buffer = item("buffers", index);
  if (buffer == nullptr) return std::nullopt;
  if (member(buffer, "uri") == nullptr) {
    if (index == 0 && has_binary_) return binary_;
    fail(fmt::format("buffer {} has no 'uri', and the file no bytes of its own", index));
    return std::nullopt;
  }
  auto known = buffers_.find(index);
  if (known == buffers_.end())
    known = buffers_.emplace(index, bytes_of_uri(word(buffer, "uri", ""))).first;
  if (!known->second) return std::nullopt;
  return std::string_view(*known->second);
}

std::optional<std::string_view> GltfFile::view(std::size_t index) {
  const Json* const view = item("bufferViews", index);
  const std::optional<std::size_t> at = this->index(view, "buffer", "buffers");
  if (!at) {
    if (good()) fail(fmt::format("buffer view {} names no buffer", index));
    return std::nullopt;
  }
  const std::optional<std::string_view> bytes = buffer(*at);
  if (!bytes) return std::nullopt;
  const double offset = number(view, "byteOffset", 0), length = number(view, "byteLength", -1);
  if (!(offset >= 0) || !(length >= 0) || offset != std::floor(offset) ||
      length != std::floor(length) || offset + length > static_cast<double>(bytes->size())) {
    fail(fmt::format("buffer view {} is bytes {} to {} of a buffer that has {}", index, offset,
                     offset + length, bytes->size()));
    return std::nullopt;
  }
  return bytes->substr(static_cast<std::size_t>(offset), static_cast<std::size_t>(length));
}

}  // namespace zraka
