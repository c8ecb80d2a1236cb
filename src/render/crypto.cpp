// SPDX-License-Identifier: Apache-2.0
#include "render/crypto.hpp"

#include <fmt/format.h>

#include <bit>
#include <map>

#include "core/json.hpp"

namespace zraka {
namespace {

constexpr std::string_view kLayer = "CryptoObject";

/// Ids count over all kinds, from 1.
std::string name_of_object(const Scene& scene, std::uint32_t id) {
  std::size_t left = id - 1;
  std::int32_t kind = 0;
#define ZRAKA_IF(Type, plural)                                                           \
  if (left < scene.plural.size()) {                                                      \
    const auto name = scene.names.find(ShapeId{kind, static_cast<std::uint32_t>(left)}); \
    return name == scene.names.end() ? fmt::format("object {}", id) : name->second;      \
  }                                                                                      \
  left -= scene.plural.size();                                                           \
  ++kind;
  ZRAKA_SHAPES(ZRAKA_IF)
#undef ZRAKA_IF
  return fmt::format("object {}", id);
}

}  // namespace

std::uint32_t murmur_hash(std::string_view bytes) {
  const auto scrambled = [](std::uint32_t k) {
    return std::rotl(k * 0xCC9E2D51u, 15) * 0x1B873593u;
  };
  std::uint32_t hash = 0, block = 0;
  for (std::size_t i = 0; i < bytes.size(); ++i) {
    const std::size_t in_block = i % 4;
    block |= std::uint32_t{static_cast<unsigned char>(bytes[i])} << (8 * in_block);
    if (in_block != 3) continue;
    hash = std::rotl(hash ^ scrambled(block), 13) * 5 + 0xE6546B64u;
    block = 0;
  }
  hash ^= scrambled(block);
  hash ^= static_cast<std::uint32_t>(bytes.size());
  hash = (hash ^ hash >> 16) * 0x85EBCA6Bu;
  hash = (hash ^ hash >> 13) * 0xC2B2AE35u;
  return hash ^ hash >> 16;
}

std::uint32_t hash_for_float(std::string_view name) {
  const std::uint32_t hash = murmur_hash(name), exponent = hash >> 23 & 0xFF;
  return exponent == 0 || exponent == 0xFF ? hash ^ 1u << 23 : hash;
}

void add_cryptomatte(const Scene& scene, const std::vector<std::uint32_t>& ids, Layers& layers) {
  std::map<std::uint32_t, float> matte_of;  // by id: of those that are in the picture
  std::map<std::string, std::uint32_t> hashes;
  std::vector<float> matte(ids.size()), coverage(ids.size());
  for (std::size_t i = 0; i < ids.size(); ++i) {
    if (ids[i] == 0) continue;
    const auto [known, is_new] = matte_of.try_emplace(ids[i], 0.0f);
    if (is_new) {
      const std::string name = name_of_object(scene, ids[i]);
      const std::uint32_t hash = hash_for_float(name);
      known->second = std::bit_cast<float>(hash);
      hashes[name] = hash;
    }
    matte[i] = known->second;
    coverage[i] = 1;
  }
  const std::vector<float> none(ids.size());
  const auto add = [&](std::string_view channel, std::vector<float> values) {
    layers.channels.push_back({fmt::format("{}00.{}", kLayer, channel), std::move(values)});
  };
  add("R", std::move(matte));
  add("G", std::move(coverage));
  add("B", none);  // one ray a pixel: nothing of a second shape
  add("A", none);

  std::string manifest;
  for (const auto& [name, hash] : hashes)
    manifest +=
        fmt::format("{}{}:\"{:08x}\"", manifest.empty() ? "" : ",", Json(name).dump(), hash);
  const std::string key = fmt::format("{:08x}", murmur_hash(kLayer)).substr(0, 7);
  const auto note = [&](std::string_view name, std::string value) {
    layers.notes.emplace_back(fmt::format("cryptomatte/{}/{}", key, name), std::move(value));
  };
  note("name", std::string(kLayer));
  note("hash", "MurmurHash3_32");
  note("conversion", "uint32_to_float32");
  note("manifest", fmt::format("{{{}}}", manifest));
}

}  // namespace zraka
